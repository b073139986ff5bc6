/// \file
/// Relative equilibria of a body with a continuous beam: the boundary value problem (2.7) of Baillieul, "Parametric
/// dependence in the equilibrium dynamics of rotating structures", with (2.5) and (2.6), by Chebyshev collocation.
///
/// With the angular velocity omega n, |n| = 1, r = (u1, u2, z + u3), the common centre of mass C and
/// f = omega^2 (r - C - n (n . (r - C))), on [0, l]:
///
///     mu_i u_i'''' - (N u_i')' = f_i     u_i = u_i' = 0 at 0, u_i'' = 0, mu_i u_i''' - N u_i' = 0 at l     i = 1, 2
///                          -N' = f_3     u_3 = 0 at 0, N = 0 at l
///                   J(u) n = lambda n,   |n|^2 = 1
///
/// N = mu_3 u_3' and without (N u_i')' for the linear strain; N = mu_3 (u_3' + (u_1'^2 + u_2'^2) / 2) for the coupled.
///
/// The unknowns are u_1'''', u_2'''' and N' / mu_3 at the points; integrated from the ends at which each derivative
/// vanishes they fulfil all boundary conditions. With displacements as unknowns the matrices of the fourth derivative
/// have condition numbers like m^8 for m points; here the tangent is the identity and integrals, and errors of 1e-13
/// are reached with 16 (linear) to 24 points (coupled).
#pragma once

#include <cmath>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/studies/rotating_body_beam/beam_collocation.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// Why Newton's method ended.
using BeamSolveStatus = CorrectionStatus;

/// What RotatingBodyBeamBoundary::solve reached.
struct BeamSolution {
    BeamSolveStatus status = BeamSolveStatus::steps;
    Eigen::VectorXd q;    ///< the last iterate
    double p = 0;         ///< the parameter
    double residual = 0;  ///< |g|, the largest entry
    int steps = 0;        ///< of Newton's method
    bool converged() const { return status == BeamSolveStatus::converged; }
};

/// The boundary value problem as a ContinuationProblem in the speed or the momentum. With m points q is n (3), u_1'''',
/// u_2'''' and N' / mu_3 at the points (m each), lambda: the moment of inertia about n. The residual is (2.7) over the
/// stiffnesses at the points, J n - lambda n and (|n|^2 - 1) / 2. K is not symmetric.
class RotatingBodyBeamBoundary {
public:
    static constexpr bool symmetric = false;
    using Beam = RotatingBodyBeam<1>;  ///< names the parameters
    using Values = Beam::Values;

    /// parameters: as of RotatingBodyBeam, whose speed is not used. Throws InvalidArgument where
    /// RotatingBodyBeam::validate does, and unless points is from 4 to 256.
    RotatingBodyBeamBoundary(const Values& parameters, BeamStrain strain, int points = 24,
                             BeamControl control = BeamControl::speed)
        : p_(parameters), coupled_(strain == BeamStrain::coupled), m_(checked(points)), control_(control),
          beam_(parameters, coupled_, m_) {
        Beam::validate(parameters);
    }

    int points() const { return m_; }
    Eigen::Index n_unknowns() const { return 3 * m_ + 4; }
    const Eigen::VectorXd& places() const { return beam_.chebyshev.places; }  ///< z of the points, rising from 0 to l
    const Values& parameters() const { return p_; }
    BeamStrain strain() const { return coupled_ ? BeamStrain::coupled : BeamStrain::linear; }
    BeamControl control_by() const { return control_; }

    Eigen::Vector3d axis(const Eigen::VectorXd& q) const { return sized(q).head<3>(); }
    double moment(const Eigen::VectorXd& q) const { return sized(q)(3 * m_ + 3); }  ///< lambda
    /// omega
    double speed(const Eigen::VectorXd& q, double p) const {
        return control_ == BeamControl::speed ? p : p / moment(q);
    }
    /// A = lambda omega
    double momentum(const Eigen::VectorXd& q, double p) const {
        return control_ == BeamControl::momentum ? p : p * moment(q);
    }

    /// Unknowns of the undeformed beam turning about an axis. Throws InvalidArgument unless it has a direction.
    Eigen::VectorXd undeformed(const Eigen::Vector3d& axis) const {
        const double size = axis.norm();
        require(std::isfinite(size) && size > 0, "axis", size, "must be finite and not 0");
        Eigen::VectorXd q = Eigen::VectorXd::Zero(n_unknowns());
        const Eigen::Vector3d n = axis / size;
        q.head<3>() = n;
        q(3 * m_ + 3) = n.dot(state(q).inertia * n);
        return q;
    }

    /// Unknowns near those of the beam with K modes, q of RotatingBodyBeam<K, Strain> at the same parameters, p the
    /// problem's parameter there: the shape that the modes' loads bend a beam to. (The modes' own fourth derivatives
    /// mean nothing: a single mode has none.) Throws InvalidArgument where an entry is not finite or lambda not
    /// positive.
    template <int Size>
    Eigen::VectorXd start_from(const Array<double, Size>& q, double p) const {
        static_assert(Size >= 7 && Size % 3 == 1, "equilibria: the unknowns of a RotatingBodyBeam<K>, 4 + 3 K");
        constexpr int K = (Size - 4) / 3;
        require_finite(q, "q");
        require(std::isfinite(p), "p", p, "must be finite");
        require(q[Size - 1] > 0, "q's lambda", q[Size - 1], "must be positive");
        static constexpr BeamModes<K> modes{};
        const double l = p_[Beam::length], root = std::sqrt(l);
        State at;
        at.n = Eigen::Vector3d(q[0], q[1], q[2]);
        at.r = Eigen::MatrixXd::Zero(m_, 3);
        at.slope = at.curvature = Eigen::MatrixXd::Zero(m_, 2);
        for (int j = 0; j < m_; ++j) {
            const double z = places()(j);
            const auto phi = modes.bending(z / l), psi = modes.stretching(z / l);
            at.r(j, 2) = z;
            for (int i = 0; i < K; ++i) {
                for (int a = 0; a < 2; ++a) {
                    const double u = q[3 + a * K + i] / root;
                    at.r(j, a) += u * phi.value[i];
                    at.slope(j, a) += u / l * phi.first[i];
                    at.curvature(j, a) += u / (l * l) * phi.second[i];
                }
                at.r(j, 2) += q[3 + 2 * K + i] / root * psi.value[i];
            }
        }
        beam_.place(at);
        const double square = square_of_speed(q[Size - 1], p);
        const Eigen::MatrixXd f = square * BeamCollocation::load(at);
        Eigen::VectorXd y(n_unknowns());
        y.head<3>() = at.n;
        at.w = Eigen::MatrixXd(m_, 3);
        at.w.col(2) = -f.col(2) / p_[Beam::stretching];
        at.tension = beam_.tension_at * at.w.col(2);
        for (int a = 0; a < 2; ++a) at.w.col(a) = (f.col(a) + stiffening(at, a)) / bending(a);
        for (int a = 0; a < 3; ++a) y.segment(3 + a * m_, m_) = at.w.col(a);
        y(3 * m_ + 3) = q[Size - 1];
        return y;
    }

    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        const State at = state(q);
        const double square = square_of_speed(moment(q), p);
        const Eigen::MatrixXd f = scaled_load(at);
        Eigen::VectorXd y(n_unknowns());
        for (int a = 0; a < 3; ++a) {
            y.segment(3 + a * m_, m_) = at.w.col(a) + square * f.col(a);
            if (a < 2) y.segment(3 + a * m_, m_) -= stiffening(at, a) / bending(a);
        }
        y.head<3>() = at.inertia * at.n - moment(q) * at.n;
        y(3 * m_ + 3) = 0.5 * (at.n.squaredNorm() - 1);
        return y;
    }

    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const {
        const State at = state(q);
        const double lambda = moment(q), square = square_of_speed(lambda, p), mu3 = p_[Beam::stretching];
        const Eigen::Index last = 3 * m_ + 3;
        const auto r_w = beam_.displacement_derivative(at);
        Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n_unknowns(), n_unknowns());
        k.middleRows(3, 3 * m_) = square * load_derivative(at, r_w);
        k.block(3, 3, 3 * m_, 3 * m_).diagonal().array() += 1;
        if (control_ == BeamControl::momentum) {
            const Eigen::MatrixXd f = scaled_load(at);
            for (int a = 0; a < 3; ++a) k.block(3 + a * m_, last, m_, 1) = -2 * square / lambda * f.col(a);
        }
        if (coupled_)
            for (int a = 0; a < 2; ++a) {
                const double c = mu3 / bending(a);
                auto own = k.block(3 + a * m_, 3 + a * m_, m_, m_);
                own -= c * at.w.col(2).asDiagonal() * beam_.slope_at;
                own -= c * at.tension.asDiagonal() * beam_.curvature_at;
                auto other = k.block(3 + a * m_, 3 + 2 * m_, m_, m_);
                other -= c * at.curvature.col(a).asDiagonal() * beam_.tension_at;
                other.diagonal() -= c * at.slope.col(a);
            }
        // J n - lambda n: with rho = r - C, dP = int rho dr^T + dr rho^T and dJ = tr(dP) - dP
        Eigen::MatrixXd along = Eigen::MatrixXd::Zero(m_, 3 * m_);
        Eigen::RowVectorXd trace = Eigen::RowVectorXd::Zero(3 * m_);
        for (int b = 0; b < 3; ++b) {
            along += at.n(b) * r_w[b];
            trace += 2 * at.rho.col(b).cwiseProduct(beam_.chebyshev.quadrature).transpose() * r_w[b];
        }
        for (int a = 0; a < 3; ++a) {
            k.block(a, 3, 1, 3 * m_) = at.n(a) * trace;
            k.block(a, 3, 1, 3 * m_) -= at.rho.col(a).cwiseProduct(beam_.chebyshev.quadrature).transpose() * along;
            k.block(a, 3, 1, 3 * m_) -= at.along.cwiseProduct(beam_.chebyshev.quadrature).transpose() * r_w[a];
        }
        k.topLeftCorner<3, 3>() = at.inertia - lambda * Eigen::Matrix3d::Identity();
        k.block(0, last, 3, 1) = -at.n;
        k.block(last, 0, 1, 3) = at.n.transpose();
        return k;
    }

    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return 2 * p * second_share(q) * load_vector(state(q));
    }
    Eigen::VectorXd second_parameter_derivative(const Eigen::VectorXd& q, double) const {
        return 2 * second_share(q) * load_vector(state(q));
    }
    Eigen::VectorXd parameter_derivative_along(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        const State at = state(q);
        const double slope = 2 * p * second_share(q);
        Eigen::VectorXd y = Eigen::VectorXd::Zero(n_unknowns());
        y.segment(3, 3 * m_) = slope * load_derivative(at, beam_.displacement_derivative(at)) * v;
        if (control_ == BeamControl::momentum) y -= 2 * slope / moment(q) * v(3 * m_ + 3) * load_vector(at);
        return y;
    }

    /// Of increments: the axis by radians, u_i'''' and N' / mu_3 by the root mean square of the tip's displacement that
    /// they would cause if uniform, over the length, and lambda over the sum of the body's moments and l^3 / 3. So
    /// lengths depend neither on units nor on the number of points.
    Eigen::VectorXd weights(const Eigen::VectorXd&) const {
        const double l = p_[Beam::length], bend = l * l * l / 8, stretch = l / 2;
        const double moments = p_[Beam::inertia_1] + p_[Beam::inertia_2] + p_[Beam::inertia_3] + l * l * l / 3;
        Eigen::VectorXd y = Eigen::VectorXd::Ones(n_unknowns());
        for (int a = 0; a < 3; ++a)
            y.segment(3 + a * m_, m_) = (a < 2 ? bend * bend : stretch * stretch) / l * beam_.chebyshev.quadrature;
        y(3 * m_ + 3) = 1 / (moments * moments);
        return y;
    }

    /// Newton's method at the parameter p. Throws InvalidArgument unless q has n_unknowns() finite entries, p is finite
    /// and most_steps at least 1.
    BeamSolution solve(Eigen::VectorXd q, double p, int most_steps = 30) const {
        require_finite(sized(q), "q");
        require(std::isfinite(p), "p", p, "must be finite");
        const double length = std::sqrt(q.dot(weights(q).cwiseProduct(q)));
        const auto correction =
            correct_at(*this, q, p, {.most_steps = most_steps, .tolerance = 1e-13 * (1 + length), .rounding = 1e4});
        BeamSolution y;
        y.status = correction.status;
        y.steps = correction.steps;
        y.p = p;
        y.residual = residual(q, p).lpNorm<Eigen::Infinity>();
        y.q = std::move(q);
        return y;
    }

    /// The beam at z. Throws InvalidArgument unless z is in [0, l].
    BeamPlace shape(const Eigen::VectorXd& q, double z) const {
        require(z >= 0 && z <= p_[Beam::length], "z", z, "must lie on the beam: in [0, length]");
        return beam_.shape(state(q), z);
    }

    /// What is left of (2.7) at z, left sides minus right ones, for the functions of shape(): the error of the
    /// collocation as a force per length. Throws InvalidArgument unless z is in [0, l].
    Eigen::Vector3d defect(const Eigen::VectorXd& q, double p, double z) const {
        const BeamPlace at = shape(q, z);
        const State all = state(q);
        const Eigen::RowVectorXd t = beam_.chebyshev.polynomials(z).head(m_) * beam_.chebyshev.coefficients;
        const Eigen::Vector3d rho = at.u + Eigen::Vector3d(0, 0, z) - all.centre,
                              f = square_of_speed(moment(q), p) * (rho - all.n * all.n.dot(rho));
        const double mu3 = p_[Beam::stretching], on = coupled_ ? 1 : 0;
        const Eigen::Vector2d slope = at.first.head<2>(), curvature = at.second.head<2>();
        const double n = mu3 * (at.first(2) + on * 0.5 * slope.squaredNorm()),
                     n_z = mu3 * (at.second(2) + on * slope.dot(curvature));
        Eigen::Vector3d y;
        for (int a = 0; a < 2; ++a)
            y(a) = bending(a) * t.dot(all.w.col(a)) - on * (n_z * slope(a) + n * curvature(a)) - f(a);
        y(2) = -n_z - f(2);
        return y;
    }

    /// J(u), (2.5), about the common centre of mass.
    Eigen::Matrix3d inertia(const Eigen::VectorXd& q) const { return state(q).inertia; }
    /// V(u).
    double strain_energy(const Eigen::VectorXd& q) const {
        const State at = state(q);
        return 0.5 * (bending(0) * beam_.chebyshev.quadrature.dot(at.curvature.col(0).cwiseAbs2()) +
                      bending(1) * beam_.chebyshev.quadrature.dot(at.curvature.col(1).cwiseAbs2()) +
                      p_[Beam::stretching] * beam_.chebyshev.quadrature.dot(at.tension.cwiseAbs2()));
    }

private:
    using BeamCollocation = detail::BeamCollocation;
    using State = BeamCollocation::State;

    const Eigen::VectorXd& sized(const Eigen::VectorXd& q) const {
        require(q.size() == n_unknowns(), "q's size", q.size(), "must be n_unknowns()");
        return q;
    }
    double bending(int a) const { return p_[Beam::bending_1 + a]; }
    double square_of_speed(double lambda, double p) const {
        const double omega = control_ == BeamControl::speed ? p : p / lambda;
        return omega * omega;
    }
    /// omega^2 over p^2.
    double second_share(const Eigen::VectorXd& q) const {
        return control_ == BeamControl::speed ? 1 : 1 / (moment(q) * moment(q));
    }

    State state(const Eigen::VectorXd& q) const { return beam_.state(axis(q), sized(q).segment(3, 3 * m_)); }
    /// The derivative of the residual by omega^2: -f_i / (mu_i omega^2), and for i = 3 with the other sign.
    Eigen::MatrixXd scaled_load(const State& at) const {
        Eigen::MatrixXd y = BeamCollocation::load(at);
        for (int a = 0; a < 3; ++a) y.col(a) *= load_factor(a);
        return y;
    }
    Eigen::VectorXd load_vector(const State& at) const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(n_unknowns());
        y.segment(3, 3 * m_) = scaled_load(at).reshaped();
        return y;
    }
    double load_factor(int a) const { return a < 2 ? -1 / bending(a) : 1 / p_[Beam::stretching]; }
    /// (N u_i')', 0 for the linear strain.
    Eigen::VectorXd stiffening(const State& at, int a) const {
        if (!coupled_) return Eigen::VectorXd::Zero(m_);
        return p_[Beam::stretching] *
               (at.w.col(2).cwiseProduct(at.slope.col(a)) + at.tension.cwiseProduct(at.curvature.col(a)));
    }
    /// d(scaled_load) by all unknowns, 3 m x n_unknowns().
    Eigen::MatrixXd load_derivative(const State& at, const Array<Eigen::MatrixXd, 3>& r_w) const {
        const double mass = p_[Beam::body_mass] + p_[Beam::length];
        Array<Eigen::MatrixXd, 3> rho_w = r_w;
        Eigen::MatrixXd along = Eigen::MatrixXd::Zero(m_, 3 * m_), y = Eigen::MatrixXd::Zero(3 * m_, n_unknowns());
        for (int a = 0; a < 3; ++a) {
            const Eigen::RowVectorXd centre = beam_.chebyshev.quadrature.transpose() * r_w[a] / mass;
            rho_w[a].rowwise() -= centre;
            along += at.n(a) * rho_w[a];
        }
        for (int a = 0; a < 3; ++a) {
            const double c = load_factor(a);
            y.block(a * m_, 3, m_, 3 * m_) = c * (rho_w[a] - at.n(a) * along);
            y.block(a * m_, 0, m_, 3) = -c * at.n(a) * at.rho;
            y.block(a * m_, a, m_, 1) -= c * at.along;
        }
        return y;
    }

    static int checked(int points) {
        require(points >= 4 && points <= 256, "points", points, "must be from 4 to 256");
        return points;
    }

    Values p_;
    bool coupled_;
    int m_;
    BeamControl control_;
    BeamCollocation beam_;
};

}  // namespace equilibria::mechanisms
