/// \file
/// The stability of a relative equilibrium of a body with a beam: the second variation of the energy at fixed angular
/// momentum, by dual numbers. Source: Simo, Lewis and Marsden, Stability of relative equilibria. Part I: the reduced
/// energy-momentum method, Arch. Rational Mech. Anal. 115 (1991), for the reduction to the momentum's direction.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// The Hessian of the energy V(u) + A^2/2 d^T J(u)^-1 d at a given angular momentum of size A, over the momentum's
/// direction d on the unit sphere (two tangents at n) and the modes u: (2 + 3 K) square. At a relative equilibrium,
/// where d is the axis n and A is lambda omega, its index decides the stability: damping leads to the minima of this
/// energy. q: as of the model, its multiplier unused. Throws InvalidArgument unless it begins with a unit vector.
template <int K, BeamStrain Strain>
Eigen::Matrix<double, 2 + 3 * K, 2 + 3 * K> momentum_hessian(const Unknowns<RotatingBodyBeam<K, Strain>>& q,
                                                             double momentum,
                                                             const Parameters<RotatingBodyBeam<K, Strain>>& p) {
    using M = RotatingBodyBeam<K, Strain>;
    constexpr int size = 2 + 3 * K;
    using D = Dual<Dual<double, size>, size>;
    const auto variable = [](double value, int k) {
        D y(Dual<double, size>::variable(value, k));
        y.derivative[k] = 1.0;
        return y;
    };
    const Eigen::Vector3d axis(q[0], q[1], q[2]);
    require(std::abs(axis.norm() - 1) < 1e-6, "q", axis.norm(), "must begin with a unit vector");
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d t1 = axis.cross(Eigen::Vector3d::Unit(least)).normalized(), t2 = axis.cross(t1);
    const D s1 = variable(0, 0), s2 = variable(0, 1), scale = 1.0 / sqrt(s1 * s1 + s2 * s2 + D(1.0));
    Array<D, 3> d;
    for (int i = 0; i < 3; ++i) d[i] = (D(axis[i]) + t1[i] * s1 + t2[i] * s2) * scale;
    Array<D, 3 * K> u;
    for (int i = 0; i < u.size(); ++i) u[i] = variable(q[M::first_mode + i], 2 + i);
    Parameters<M, D> lifted;
    for (int k = 0; k < p.size(); ++k) lifted[k] = D(p[k]);
    const auto j = M::Base::inertia(u, lifted);
    // d^T adj(J) d / det J
    const auto cofactor = [&](int a, int b) {
        const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
        return j[a1][b1] * j[a2][b2] - j[a1][b2] * j[a2][b1];
    };
    D form, determinant;
    for (int a = 0; a < 3; ++a) {
        determinant += j[0][a] * cofactor(0, a);
        for (int b = 0; b < 3; ++b) form += d[a] * d[b] * cofactor(a, b);
    }
    const D energy = M::Base::strain_energy(u, lifted) + 0.5 * momentum * momentum * form / determinant;
    Eigen::Matrix<double, size, size> y;
    for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b) y(a, b) = energy.derivative[a].derivative[b];
    return y;
}

}  // namespace equilibria::mechanisms
