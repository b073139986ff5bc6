/// \file
/// Stability of an equilibrium by its potential energy. Source: the theorem of Lagrange and Dirichlet and its converse
/// for nondegenerate equilibria, with Sylvester's criterion.
#pragma once

#include <type_traits>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/stability/inertia.hpp>

namespace equilibria {

/// The leading principal minors Delta_1 .. Delta_n of a square matrix: Sylvester's criterion asks of a symmetric one
/// that all are positive.
template <class Matrix>
auto leading_principal_minors(const Matrix& a) {
    Eigen::Matrix<typename Matrix::Scalar, Matrix::RowsAtCompileTime, 1> minors(a.rows());
    for (Eigen::Index k = 1; k <= a.rows(); ++k) {
        const Eigen::MatrixX<typename Matrix::Scalar> leading = a.topLeftCorner(k, k);
        if constexpr (std::is_same_v<typename Matrix::Scalar, double>)
            minors[k - 1] = detail::determinant(leading);
        else
            minors[k - 1] = leading.determinant();
    }
    return minors;
}

/// What the potential says of an equilibrium.
enum class PotentialVerdict {
    stable,     ///< a strict minimum: stable, and asymptotically so where damping is complete
    unstable,   ///< a direction in which the potential falls
    undecided,  ///< the Hessian is singular and has no negative eigenvalue: terms of higher order decide
};

/// Both ways to read a Hessian of the potential, n x n.
template <class Matrix>
struct LagrangeDirichlet {
    Matrix hessian;                                                               ///< symmetric, n x n
    Eigen::Matrix<typename Matrix::Scalar, Matrix::RowsAtCompileTime, 1> minors;  ///< Delta_1 .. Delta_n
    Inertia inertia;                                                              ///< by its eigenvalues

    /// By the inertia.
    PotentialVerdict verdict() const {
        if (inertia.negative > 0) return PotentialVerdict::unstable;
        return inertia.zero > 0 ? PotentialVerdict::undecided : PotentialVerdict::stable;
    }
    /// Whether Sylvester's criterion says the same as the inertia: all minors positive or not.
    bool agree() const {
        return (minors.minCoeff() > 0) == (verdict() == PotentialVerdict::stable) || inertia.zero > 0;
    }
};

/// hessian: of the potential at an equilibrium, symmetric.
template <class Derived>
auto lagrange_dirichlet(const Eigen::MatrixBase<Derived>& hessian) {
    using Matrix = typename Derived::PlainObject;
    return LagrangeDirichlet<Matrix>{hessian, leading_principal_minors<Matrix>(hessian), inertia<Matrix>(hessian)};
}

}  // namespace equilibria
