/// \file
/// The inertia of a symmetric matrix, and with it the index of an equilibrium.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace equilibria {

/// Numbers of negative, zero and positive eigenvalues, and how safe they are.
struct Inertia {
    int negative = 0, zero = 0, positive = 0;
    /// The smallest |eigenvalue| over the largest: what decided. 0 for the zero matrix.
    double margin = 0;
};

/// An eigenvalue counts as zero when its size is below this share of the largest one.
inline constexpr double zero_eigenvalue = 1e-7;

namespace detail {

/// Eigenvalues of a small symmetric matrix, in no order, by Jacobi's rotations: each sweep over the pairs (i, j) makes
/// a(i, j) zero in turn, and the sum of squares outside the diagonal falls quadratically (Golub and Van Loan, 8.5). As
/// accurate as tridiagonalisation, and better on graded matrices; Eigen's solver takes seconds to compile for each
/// size.
template <class Matrix>
auto symmetric_eigenvalues(Matrix a) {
    using std::abs, std::hypot, std::sqrt;
    using Scalar = typename Matrix::Scalar;
    const Scalar negligible = std::numeric_limits<Scalar>::epsilon();
    const auto n = a.rows();
    for (int sweep = 0; sweep < 50; ++sweep) {
        bool rotated = false;
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = i + 1; j < n; ++j) {
                if (abs(a(i, j)) <= negligible * sqrt(abs(a(i, i))) * sqrt(abs(a(j, j)))) continue;
                rotated = true;
                const Scalar difference = (a(j, j) - a(i, i)) / 2;
                const Scalar longer = abs(difference) + hypot(difference, a(i, j));
                const Scalar t = difference < 0 ? -a(i, j) / longer : a(i, j) / longer;  // tan of the angle, |t| <= 1
                const Scalar c = 1 / hypot(Scalar(1), t), s = t * c;
                const Scalar shift = t * a(i, j);
                for (Eigen::Index k = 0; k < n; ++k) {
                    if (k == i || k == j) continue;
                    const Scalar ki = a(k, i), kj = a(k, j);
                    a(k, i) = a(i, k) = c * ki - s * kj;
                    a(k, j) = a(j, k) = s * ki + c * kj;
                }
                a(i, i) -= shift;
                a(j, j) += shift;
                a(i, j) = a(j, i) = 0;
            }
        }
        if (!rotated) break;
    }
    return a.diagonal().eval();
}

}  // namespace detail

/// The inertia by the eigenvalues; backward stability makes `margin` honest: an eigenvalue is wrong by a few
/// roundings of the largest one at most.
template <class Matrix>
Inertia inertia(const Matrix& symmetric) {
    const auto values = detail::symmetric_eigenvalues(symmetric);
    const double largest = static_cast<double>(values.cwiseAbs().maxCoeff());
    Inertia y;
    for (int k = 0; k < values.size(); ++k) {
        const double v = static_cast<double>(values[k]);
        if (!(std::abs(v) > zero_eigenvalue * largest))
            ++y.zero;
        else
            ++(v < 0 ? y.negative : y.positive);
    }
    if (largest > 0) y.margin = static_cast<double>(values.cwiseAbs().minCoeff()) / largest;
    return y;
}

}  // namespace equilibria
