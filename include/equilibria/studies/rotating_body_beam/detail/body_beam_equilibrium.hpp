/// \file
/// A root of BodyBeamEitherStrain as the relative equilibrium that it is: which of several points stands for it, and
/// its index at fixed momentum. See body_beam_solver.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_equilibria.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms::detail {

/// Turning about the third axis changes nothing.
inline bool turns(const RotatingBodyBeam<1>::Values& p) {
    using Base = RotatingBodyBeam<1>;
    return p[Base::bending_1] == p[Base::bending_2] && p[Base::inertia_1] == p[Base::inertia_2] &&
           p[Base::centre_1] == 0 && p[Base::centre_2] == 0;
}

/// One of n and -n, and of the two points that a circle has in its plane for each.
inline bool represents(const Eigen::Vector3d& axis, bool circle) {
    if (circle) return axis(2) > 1e-9 ? axis(0) >= -1e-9 : std::abs(axis(2)) <= 1e-9 && axis(0) > 0;
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    return axis(largest) > 0;
}

/// The relative equilibrium q, with the unknowns of RotatingBodyBeam<K, Strain>, at the parameters p. circles: turning
/// p about the third axis changes nothing.
template <int K, BeamStrain Strain>
BodyBeamEquilibrium body_beam_equilibrium(const Array<double, 4 + 3 * K>& q, double speed,
                                          const RotatingBodyBeam<1>::Values& p, bool circles) {
    using M = RotatingBodyBeam<K, Strain>;
    BodyBeamEquilibrium y;
    y.axis = Eigen::Vector3d(q[0], q[1], q[2]);
    y.modes.assign(q.begin() + M::first_mode, q.begin() + M::multiplier);
    y.moment = q[M::multiplier];
    y.speed = speed;
    y.momentum = y.moment * speed;
    Array<double, 3 * K> u;
    std::copy(y.modes.begin(), y.modes.end(), u.begin());
    const auto j = M::inertia(u, p);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) y.inertia(a, b) = j[a][b];
    y.energy = M::strain_energy(u, p) + 0.5 * y.moment * speed * speed;
    Eigen::MatrixXd hessian = momentum_hessian<K, Strain>(q, y.momentum, p);
    // by modes in the unit length^(3/2) all entries are energies, and what counts as 0 does not depend on units
    const double unit = p[M::length] * std::sqrt(p[M::length]);
    hessian.bottomRows(3 * K) *= unit;
    hessian.rightCols(3 * K) *= unit;
    const auto inertia = equilibria::inertia(hessian);
    y.index = inertia.negative;
    y.nullity = inertia.zero;
    const auto far = [](double x) { return std::abs(x) > 1e-9; };
    y.circle = circles && (far(q[0]) || far(q[1]) || std::any_of(u.begin(), u.begin() + 2 * K, far));
    return y;
}

}  // namespace equilibria::mechanisms::detail
