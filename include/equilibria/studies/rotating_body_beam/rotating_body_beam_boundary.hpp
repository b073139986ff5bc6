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
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/studies/rotating_body_beam/beam_collocation.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// Why Newton's method ended.
using BeamSolveStatus = CorrectionStatus;

/// What RotatingBodyBeamBoundary::solve reached.
struct BeamSolution {
    BeamSolveStatus status = BeamSolveStatus::steps;                         ///< why Newton's method ended
    Eigen::VectorXd q;                                                       ///< the last iterate
    double p = 0;                                                            ///< the parameter
    double residual = 0;                                                     ///< |g|, the largest entry
    int steps = 0;                                                           ///< of Newton's method
    bool converged() const { return status == BeamSolveStatus::converged; }  ///< the last iterate is a solution
};

/// The boundary value problem as a ContinuationProblem in the speed or the momentum. With m points q is n (3), u_1'''',
/// u_2'''' and N' / mu_3 at the points (m each), lambda: the moment of inertia about n. The residual is (2.7) over the
/// stiffnesses at the points, J n - lambda n and (|n|^2 - 1) / 2. K is not symmetric.
class RotatingBodyBeamBoundary {
public:
    static constexpr bool symmetric = false;  ///< the equations are no gradient
    using Beam = RotatingBodyBeam<1>;         ///< names the parameters
    using Values = Beam::Values;              ///< one of each parameter

    /// parameters: as of RotatingBodyBeam, whose speed is not used. Throws InvalidArgument where
    /// RotatingBodyBeam::validate does, and unless points is from 4 to 256.
    RotatingBodyBeamBoundary(const Values& parameters, BeamStrain strain, int points = 24,
                             BeamControl control = BeamControl::speed)
        : p_(parameters), coupled_(strain == BeamStrain::coupled), m_(checked(points)), control_(control),
          beam_(parameters, coupled_, m_) {
        Beam::validate(parameters);
    }

    int points() const { return m_; }                                         ///< of the collocation
    Eigen::Index n_unknowns() const { return 3 * m_ + 4; }                    ///< 3 m + 4 of m points
    const Eigen::VectorXd& places() const { return beam_.chebyshev.places; }  ///< z of the points, rising from 0 to l
    const Values& parameters() const { return p_; }                           ///< as they were given
    BeamStrain strain() const { return coupled_ ? BeamStrain::coupled : BeamStrain::linear; }  ///< linear or coupled
    BeamControl control_by() const { return control_; }  ///< whether p is omega or A

    /// The axis n, of length 1 at a solution.
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
    Eigen::VectorXd undeformed(const Eigen::Vector3d& axis) const;

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
        return bent(std::move(at), q[Size - 1], p);
    }

    /// A function of a continuation problem (continuation/problem.hpp).
    /// \{
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const;

    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const;

    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const;
    Eigen::VectorXd second_parameter_derivative(const Eigen::VectorXd& q, double) const;
    Eigen::VectorXd parameter_derivative_along(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const;
    /// \}

    /// Of increments: the axis by radians, u_i'''' and N' / mu_3 by the root mean square of the tip's displacement that
    /// they would cause if uniform, over the length, and lambda over the sum of the body's moments and l^3 / 3. So
    /// lengths depend neither on units nor on the number of points.
    Eigen::VectorXd weights(const Eigen::VectorXd&) const;

    /// Newton's method at the parameter p. Throws InvalidArgument unless q has n_unknowns() finite entries, p is finite
    /// and most_steps at least 1.
    BeamSolution solve(Eigen::VectorXd q, double p, int most_steps = 30) const;

    /// The beam at z. Throws InvalidArgument unless z is in [0, l].
    BeamPlace shape(const Eigen::VectorXd& q, double z) const;

    /// What is left of (2.7) at z, left sides minus right ones, for the functions of shape(): the error of the
    /// collocation as a force per length. Throws InvalidArgument unless z is in [0, l].
    Eigen::Vector3d defect(const Eigen::VectorXd& q, double p, double z) const;

    /// J(u), (2.5), about the common centre of mass.
    Eigen::Matrix3d inertia(const Eigen::VectorXd& q) const { return state(q).inertia; }
    /// V(u).
    double strain_energy(const Eigen::VectorXd& q) const;

private:
    using BeamCollocation = detail::BeamCollocation;
    using State = BeamCollocation::State;

    /// The unknowns of a beam bent by the loads on it in a shape and at an axis: at n, r, slope and curvature.
    Eigen::VectorXd bent(State at, double lambda, double p) const;

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
    Eigen::MatrixXd scaled_load(const State& at) const;
    Eigen::VectorXd load_vector(const State& at) const;
    double load_factor(int a) const { return a < 2 ? -1 / bending(a) : 1 / p_[Beam::stretching]; }
    /// (N u_i')', 0 for the linear strain.
    Eigen::VectorXd stiffening(const State& at, int a) const;
    /// d(scaled_load) by all unknowns, 3 m x n_unknowns().
    Eigen::MatrixXd load_derivative(const State& at, const Array<Eigen::MatrixXd, 3>& r_w) const;

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

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_boundary_definitions.hpp>
#endif
