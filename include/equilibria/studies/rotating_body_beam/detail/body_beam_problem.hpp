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

/// An equilibrium as the unknowns of BodyBeamEitherStrain at a given momentum, in other units.
template <int K>
Eigen::VectorXd body_beam_unknowns(const BodyBeamEquilibrium& e,
                                   const typename BodyBeamEitherStrain<K, BeamControl::momentum>::Units& units) {
    using Model = BodyBeamEitherStrain<K, BeamControl::momentum>;
    Eigen::VectorXd q(Model::n_coordinates);
    q.template head<3>() = e.speed / units.speed * e.axis;
    for (int i = 0; i < 3 * K; ++i) q(Model::first_mode + i) = e.modes[static_cast<std::size_t>(i)] / units.modes;
    q(Model::multiplier) = e.moment / units.moments;
    q(Model::omega) = e.speed / units.speed;
    return q;
}

/// The equations of BodyBeamEitherStrain in the momentum, both in the units that suit the body p: lengths of steps and
/// tolerances mean the same for bodies of any size and stiffness. Equilibria are in p's own.
template <int K>
class BodyBeamProblem : public ModelProblem<BodyBeamEitherStrain<K, BeamControl::momentum>,
                                            BodyBeamEitherStrain<K, BeamControl::momentum>::momentum> {
public:
    using Model = BodyBeamEitherStrain<K, BeamControl::momentum>;
    using Values = typename Model::Values;
    using Vector = Eigen::VectorXd;

    using Units = typename Model::Units;

    explicit BodyBeamProblem(const Values& p) : BodyBeamProblem(p, Model::units(p)) {}

    const Units& units() const { return units_; }

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

    /// momentum: in the problem's units, as q.
    BodyBeamEquilibrium equilibrium(const Vector& q, double momentum) const {
        Array<double, 4 + 3 * K> at;
        const double sign = represents(q.head<3>(), false) ? 1 : -1, speed = q(Model::omega) * units_.speed;
        for (int i = 0; i < 3; ++i) at[i] = sign * q(i) / q(Model::omega);
        for (int i = Model::first_mode; i < Model::multiplier; ++i) at[i] = q(i) * units_.modes;
        at[Model::multiplier] = q(Model::multiplier) * units_.moments;
        auto y = p_[Model::coupling] == 0 ? body_beam_equilibrium<K, BeamStrain::linear>(at, speed, p_, false)
                                          : body_beam_equilibrium<K, BeamStrain::coupled>(at, speed, p_, false);
        y.momentum = momentum * units_.momentum();
        y.residual = this->residual(q, momentum).cwiseAbs().maxCoeff();
        return y;
    }

    /// The equilibrium at a momentum between those of two neighbours on a branch, all in p's units.
    std::optional<BodyBeamEquilibrium> between(const BodyBeamEquilibrium& a, const BodyBeamEquilibrium& b,
                                               double momentum) const {
        const double share = (momentum - a.momentum) / (b.momentum - a.momentum), own = momentum / units_.momentum();
        Vector q = (1 - share) * body_beam_unknowns<K>(a, units_) + share * body_beam_unknowns<K>(b, units_);
        if (!equilibria::correct_at(*this, q, own).converged()) return std::nullopt;
        return equilibrium(q, own);
    }

    /// One point, however it was found; n and -n are one.
    bool same(const BodyBeamEquilibrium& a, const BodyBeamEquilibrium& b) const {
        double away = std::abs(a.moment - b.moment) / b.moment + std::abs(a.momentum - b.momentum) / b.momentum +
                      std::min((a.axis - b.axis).norm(), (a.axis + b.axis).norm());
        for (std::size_t i = 0; i < a.modes.size(); ++i) away += std::abs(a.modes[i] - b.modes[i]) / units_.modes;
        return away < 1e-6;
    }

private:
    BodyBeamProblem(const Values& p, const Units& units)
        : ModelProblem<Model, Model::momentum>(units.scaled), p_(p), units_(units) {}
    static Vector reversed(Vector q) {
        q.head<3>() *= -1;
        return q;
    }

    Values p_;
    Units units_;
};

/// The same equations for each value of a second parameter, in units that do not change with it.
template <int K>
struct BodyBeamProblems {
    typename BodyBeamProblem<K>::Values p;  ///< in these units
    int second;                             ///< its number

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
