/// \file
/// The shape of a continuous beam on a rigid body by Chebyshev collocation: displacements, places and the moment of
/// inertia that follow from u_1, u_2 and N' / mu_3 at the points, for the linear and the coupled strain. Integrated
/// from the ends at which each derivative vanishes, the shape fulfils all boundary conditions. Source: Baillieul,
/// "Parametric dependence in the equilibrium dynamics of rotating structures", section 2; see
/// rotating_body_beam_boundary.hpp.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/studies/rotating_body_beam/chebyshev_integrals.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// The beam at a place z: displacements u and their derivatives by z.
struct BeamPlace {
    Eigen::Vector3d u;       ///< displacements, in the body frame
    Eigen::Vector3d first;   ///< first derivatives by z
    Eigen::Vector3d second;  ///< second derivatives by z
};

namespace detail {

/// With m points on [0, l]; lengths, masses and stiffnesses in the units of the parameters.
class BeamCollocation {
public:
    using Beam = RotatingBodyBeam<1>;  ///< names the parameters

    /// Values at the points, one a row.
    struct State {
        Eigen::Vector3d n, centre;
        Eigen::MatrixXd w, r, rho, slope, curvature;  ///< unknowns, places, places from C; u_i', u_i'' (two columns)
        Eigen::VectorXd tension, stretch, along;      ///< N / mu_3, u_3', n . rho
        Eigen::Matrix3d inertia;
    };

    /// parameters: as of RotatingBodyBeam; m: the number of points.
    BeamCollocation(const Beam::Values& parameters, bool coupled, int m);

    ChebyshevIntegrals chebyshev;
    /// Integrals at the points, from values there.
    Eigen::MatrixXd tension_at, curvature_at, slope_at, deflection_at, stretch_at;

    /// n: the axis; w: u_1'''', u_2'''' and N' / mu_3 at the points, m each.
    State state(const Eigen::Vector3d& n, const Eigen::VectorXd& w) const;
    /// What follows from n and r.
    void place(State& y) const;
    /// f / omega^2.
    static Eigen::MatrixXd load(const State& at);
    /// dr_a by all w, m x 3 m each.
    Array<Eigen::MatrixXd, 3> displacement_derivative(const State& at) const;
    /// The beam at z, in [0, l].
    BeamPlace shape(const State& at, double z) const;

private:
    Beam::Values p_;
    bool coupled_;
    int m_;
    // Chebyshev coefficients from values at the points: of the interpolant's derivative and its integrals
    Eigen::MatrixXd steepening_, third_, curvature_, slope_, deflection_, stretch_;
};

}  // namespace detail

}  // namespace equilibria::mechanisms

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/rotating_body_beam/detail/beam_collocation_definitions.hpp>
#endif
