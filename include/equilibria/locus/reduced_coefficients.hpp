/// \file
/// The normal-form coefficients that tell what kind a degenerate equilibrium is.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The Taylor coefficients of the reduced potential along the null vector v at a degenerate equilibrium (splitting
/// lemma): third = V'''[v,v,v], fourth = V''''[v^4] - 3 <V'''[v,v,.], J^+ V'''[v,v,.]>. For models with equations
/// only, the same with F and the left null vector in place of the last v.
///
/// third != 0: fold (A2). third = 0, fourth != 0: cusp (A3), or pitchfork where v is odd on a symmetric branch.
struct ReducedCoefficients {
    double third = 0, fourth = 0;
};

template <Model M>
ReducedCoefficients reduced_coefficients(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    using Vector = Eigen::Matrix<double, n, 1>;
    const UnknownMatrix<M> j = jacobian<M, double>(q, p);
    Vector null, left;
    for (int i = 0; i < n; ++i) null(i) = v[i];
    // the bordered matrix [J, l; v^T, 0] is regular at a simple null space
    const auto bordered_solve = [&](const UnknownMatrix<M>& matrix, const Vector& l, const Vector& r, const Vector& b,
                                    double last) {
        Eigen::Matrix<double, n + 1, n + 1> m;
        m.template topLeftCorner<n, n>() = matrix;
        m.template topRightCorner<n, 1>() = l;
        m.template bottomLeftCorner<1, n>() = r.transpose();
        m(n, n) = 0;
        Eigen::Matrix<double, n + 1, 1> right;
        right << b, last;
        const Eigen::Matrix<double, n + 1, 1> y = m.partialPivLu().solve(right);
        return Vector(y.template head<n>());
    };
    if constexpr (PotentialModel<M>)
        left = null;
    else
        left = bordered_solve(j.transpose(), null, null, Vector::Zero(), 1).normalized();
    const auto second = directional_derivative<2, M, double>(q, v, p);
    const auto third = directional_derivative<3, M, double>(q, v, p);
    Vector f2, f3;
    for (int i = 0; i < n; ++i) f2(i) = second[i], f3(i) = third[i];
    const Vector projected = f2 - left.dot(f2) / left.squaredNorm() * left;
    const Vector z = bordered_solve(j, left, null, projected, 0);  // J z = f2 in the range, z orthogonal to v
    const UnknownMatrix<M> jv = jacobian_derivative<M, double>(q, v, p);
    return {left.dot(f2), left.dot(f3) - 3 * left.dot(jv * z)};
}

}  // namespace equilibria
