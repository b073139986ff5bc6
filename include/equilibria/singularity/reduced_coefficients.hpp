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

namespace detail {

/// The first n unknowns of [A, column; row^T, 0] [x; tau] = [right; last]: regular where A has a simple null space that row
/// is not orthogonal to, and column not to the left one.
template <int n>
Eigen::Matrix<double, n, 1> bordered_solve(const Eigen::Matrix<double, n, n>& a,
                                           const Eigen::Matrix<double, n, 1>& column,
                                           const Eigen::Matrix<double, n, 1>& row,
                                           const Eigen::Matrix<double, n, 1>& right, double last) {
    Eigen::Matrix<double, n + 1, n + 1> m;
    m << a, column, row.transpose(), 0.0;
    Eigen::Matrix<double, n + 1, 1> b;
    b << right, last;
    return m.partialPivLu().solve(b).template head<n>();
}

/// The unit left null vector of J, v being its null vector.
template <Model M>
Eigen::Matrix<double, n_unknowns<M>, 1> left_null_vector(const UnknownMatrix<M>& j,
                                                         const Eigen::Matrix<double, n_unknowns<M>, 1>& v) {
    if constexpr (PotentialModel<M>) return v;
    constexpr int n = n_unknowns<M>;
    return bordered_solve<n>(j.transpose(), v, v, Eigen::Matrix<double, n, 1>::Zero(), 1).normalized();
}

}  // namespace detail

template <Model M>
ReducedCoefficients reduced_coefficients(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    using Vector = Eigen::Matrix<double, n, 1>;
    const UnknownMatrix<M> j = jacobian<M, double>(q, p);
    Vector null;
    for (int i = 0; i < n; ++i) null(i) = v[i];
    const Vector left = detail::left_null_vector<M>(j, null);
    const auto second = directional_derivative<2, M, double>(q, v, p);
    const auto third = directional_derivative<3, M, double>(q, v, p);
    Vector f2, f3;
    for (int i = 0; i < n; ++i) f2(i) = second[i], f3(i) = third[i];
    const Vector projected = f2 - left.dot(f2) / left.squaredNorm() * left;
    const Vector z = detail::bordered_solve<n>(j, left, null, projected, 0);  // J z = f2 in the range, z orthogonal to v
    const UnknownMatrix<M> jv = jacobian_derivative<M, double>(q, v, p);
    return {left.dot(f2), left.dot(f3) - 3 * left.dot(jv * z)};
}

}  // namespace equilibria
