/// \file
/// The relative equilibria of a body with a beam at a given momentum as a continuation problem in the momentum, with
/// its symmetries, and as a family of such problems in a second parameter.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/member_derivatives.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_equilibria.hpp>
#include <equilibria/studies/rotating_body_beam/detail/body_beam_equilibrium.hpp>

namespace equilibria::mechanisms::detail {

/// How far apart two equilibria are, over their size; n and -n are one.
inline double distance(const BodyBeamEquilibrium& a, const BodyBeamEquilibrium& b) {
    double y = std::abs(a.moment - b.moment) / b.moment + std::min((a.axis - b.axis).norm(), (a.axis + b.axis).norm()) +
               std::abs(a.momentum - b.momentum) / b.momentum;
    for (std::size_t i = 0; i < a.modes.size(); ++i) y += std::abs(a.modes[i] - b.modes[i]);
    return y;
}
/// Of one point, however it was found.
inline bool same(const BodyBeamEquilibrium& a, const BodyBeamEquilibrium& b) { return distance(a, b) < 1e-6; }

/// The equations of BodyBeamEitherStrain in the momentum.
template <int K>
class BodyBeamProblem : public ModelProblem<BodyBeamEitherStrain<K, BeamControl::momentum>,
                                            BodyBeamEitherStrain<K, BeamControl::momentum>::momentum> {
public:
    using Model = BodyBeamEitherStrain<K, BeamControl::momentum>;
    using Values = typename Model::Values;
    using Vector = Eigen::VectorXd;

    explicit BodyBeamProblem(const Values& p) : ModelProblem<Model, Model::momentum>(p), p_(p) {}

    /// Mirror images in the planes of the body's symmetry, and those with -w.
    std::vector<Vector> images(const Vector& q) const {
        std::vector<Vector> y = mirror_images(q);
        const std::size_t mirrored = y.size();
        for (std::size_t k = 0; k < mirrored; ++k) y.push_back(reversed(y[k]));
        y.push_back(reversed(q));
        return y;
    }
    std::vector<Vector> mirror_images(const Vector& q) const {
        std::vector<Vector> y;
        for (int planes = 1; planes < 4; ++planes) {
            Vector image = q;
            bool there = true;
            for (int a = 0; a < 2; ++a) {
                if ((planes >> a & 1) == 0) continue;
                there = there && p_[Model::centre_1 + a] == 0;
                image(a) *= -1;
                image.segment(Model::first_mode + a * K, K) *= -1;
            }
            if (there) y.push_back(image);
        }
        return y;
    }

    BodyBeamEquilibrium equilibrium(const Vector& q, double momentum) const {
        Array<double, 4 + 3 * K> at;
        const double sign = represents(q.head<3>(), false) ? 1 : -1;
        for (int i = 0; i < at.size(); ++i) at[i] = i < 3 ? sign * q(i) / q(Model::omega) : q(i);
        auto y = p_[Model::coupling] == 0
                     ? body_beam_equilibrium<K, BeamStrain::linear>(at, q(Model::omega), p_, false)
                     : body_beam_equilibrium<K, BeamStrain::coupled>(at, q(Model::omega), p_, false);
        y.momentum = momentum;
        y.residual = this->residual(q, momentum).cwiseAbs().maxCoeff();
        return y;
    }
    static Vector unknowns(const BodyBeamEquilibrium& e) {
        Vector q(Model::n_coordinates);
        q.template head<3>() = e.speed * e.axis;
        for (int i = 0; i < 3 * K; ++i) q(Model::first_mode + i) = e.modes[static_cast<std::size_t>(i)];
        q(Model::multiplier) = e.moment;
        q(Model::omega) = e.speed;
        return q;
    }

    /// The equilibrium at a momentum between those of two neighbours on a branch.
    std::optional<BodyBeamEquilibrium> between(const BodyBeamEquilibrium& a, const BodyBeamEquilibrium& b,
                                               double momentum) const {
        const double share = (momentum - a.momentum) / (b.momentum - a.momentum);
        Vector q = (1 - share) * unknowns(a) + share * unknowns(b);
        if (!equilibria::correct_at(*this, q, momentum).converged()) return std::nullopt;
        return equilibrium(q, momentum);
    }

private:
    static Vector reversed(Vector q) {
        q.head<3>() *= -1;
        return q;
    }

    Values p_;
};

/// The same for each value of a second parameter.
template <int K>
struct BodyBeamProblems {
    typename BodyBeamProblem<K>::Values p;
    int second;

    using Member = ModelProblem<typename BodyBeamProblem<K>::Model, BodyBeamProblem<K>::Model::momentum>;
    Member operator()(double y) const {
        auto values = p;
        values[second] = y;
        return Member(values);
    }
    MemberDerivatives member_derivatives(const Eigen::VectorXd& q, double momentum, double y,
                                         const Eigen::VectorXd& v) const {
        const auto [residual, tangent] = (*this)(y).derivatives(second, q, momentum);
        return {residual, tangent * v};
    }
};

}  // namespace equilibria::mechanisms::detail
