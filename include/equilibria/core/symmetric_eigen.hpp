/// \file
/// Eigenvalues and eigenvectors of small symmetric matrices by Jacobi's rotations: each sweep over the pairs (i, j)
/// makes a(i, j) zero in turn, and the sum of squares outside the diagonal falls quadratically (Golub and Van Loan,
/// 8.5). As accurate as tridiagonalisation, and better on graded matrices (Demmel and Veselic). Eigen's solver takes
/// seconds to compile for each size, and its sweeps are no faster below n = 10.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace equilibria {

namespace detail {

/// Makes a diagonal; turns the columns of *vectors along, if given.
template <class Matrix>
void diagonalize(Matrix& a, Matrix* vectors) {
    using std::abs, std::sqrt;
    using Scalar = typename Matrix::Scalar;
    // squares of entries must neither overflow nor vanish
    const Scalar size = a.rows() > 0 ? a.cwiseAbs().maxCoeff() : Scalar(0);
    const bool extreme =
        (size > 1e100 && size < std::numeric_limits<Scalar>::infinity()) || (size > 0 && size < 1e-100);
    if (extreme) a /= size;
    const Scalar negligible = std::numeric_limits<Scalar>::epsilon();
    const auto n = a.rows();
    for (int sweep = 0; sweep < 50; ++sweep) {
        bool rotated = false;
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = i + 1; j < n; ++j) {
                const Scalar square = a(i, j) * a(i, j);
                if (square <= negligible * negligible * abs(a(i, i) * a(j, j))) continue;
                rotated = true;
                const Scalar difference = (a(j, j) - a(i, i)) / 2;
                const Scalar longer = abs(difference) + sqrt(difference * difference + square);
                const Scalar t =
                    difference < 0 ? Scalar(-a(i, j) / longer) : Scalar(a(i, j) / longer);  // tan, |t| <= 1
                const Scalar c = 1 / sqrt(1 + t * t), s = t * c;
                const Scalar shift = t * a(i, j);
                const auto turn = [&](Scalar& x, Scalar& y) {
                    const Scalar before = x;
                    x = c * before - s * y;
                    y = s * before + c * y;
                };
                for (Eigen::Index k = 0; k < n; ++k) {
                    if (vectors) turn((*vectors)(k, i), (*vectors)(k, j));
                    if (k == i || k == j) continue;
                    turn(a(k, i), a(k, j));
                    a(i, k) = a(k, i);
                    a(j, k) = a(k, j);
                }
                a(i, i) -= shift;
                a(j, j) += shift;
                a(i, j) = a(j, i) = 0;
            }
        }
        if (!rotated) break;
    }
    if (extreme) a *= size;
}

}  // namespace detail

/// The eigenvalues of a symmetric matrix, in no order.
template <class Matrix>
auto symmetric_eigenvalues(Matrix a) {
    detail::diagonalize<Matrix>(a, nullptr);
    return a.diagonal().eval();
}

/// Q with orthonormal columns and values with a = Q diag(values) Q^T, to rounding.
template <class Matrix>
struct SymmetricEigen {
    Matrix vectors;  ///< Q, column k belonging to values(k)
    Eigen::Matrix<typename Matrix::Scalar, Matrix::RowsAtCompileTime, 1> values;  ///< in no order

    /// Only for symmetric a; at most 50 sweeps.
    explicit SymmetricEigen(Matrix a) : vectors(Matrix::Identity(a.rows(), a.cols())) {
        detail::diagonalize<Matrix>(a, &vectors);
        values = a.diagonal();
    }
};

}  // namespace equilibria
