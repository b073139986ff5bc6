/// \file
/// The inertia of a symmetric matrix, and with it the index of an equilibrium.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <equilibria/core/symmetric_eigen.hpp>

namespace equilibria {

/// Numbers of negative, zero and positive eigenvalues, and how safe they are.
struct Inertia {
    int negative = 0;  ///< negative eigenvalues
    int zero = 0;      ///< those that count as zero, see zero_eigenvalue
    int positive = 0;  ///< positive ones
    /// The smallest |eigenvalue| over the largest: what decided. 0 for the zero matrix.
    double margin = 0;
};

/// An eigenvalue counts as zero when its size is below this share of the largest one.
inline constexpr double zero_eigenvalue = 1e-7;

namespace detail {

/// The same, with the matrix overwritten.
template <class Matrix>
Inertia inertia_in_place(Matrix& symmetric) {
    diagonalize<Matrix>(symmetric, nullptr);
    const auto values = symmetric.diagonal();
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

}  // namespace detail

/// The inertia by the eigenvalues; backward stability makes `margin` honest: an eigenvalue is wrong by a few
/// roundings of the largest one at most.
template <class Matrix>
Inertia inertia(Matrix symmetric) {
    return detail::inertia_in_place(symmetric);
}

}  // namespace equilibria
