/// \file
/// The null vectors of the Jacobian J at a degenerate equilibrium: the right singular vectors of its smallest singular
/// values, by one-sided Jacobi rotations (core/singular_values.hpp). J is symmetric or not, and not squared, so that a
/// vector is as exact as J is. What the sign is, and which basis of a plane, is left to the rotations.
/// Where it fails: away from degenerate equilibria the vector is the direction that J shortens most, no more.
/// Source: Golub and Van Loan, Matrix Computations, 8.6.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

namespace detail {

/// Of a square matrix of finite entries.
template <class Matrix>
SingularValues singular_values(const Matrix& a) {
    SingularValues::Vector entries;
    for (Eigen::Index c = 0; c < a.cols(); ++c)
        for (Eigen::Index r = 0; r < a.rows(); ++r) entries.emplace_back(a(r, c));
    return SingularValues(static_cast<int>(a.rows()), static_cast<int>(a.cols()), std::move(entries));
}

}  // namespace detail

/// The unit vectors, orthogonal to each other, that J shortens most, the most shortened one first; NaN where an entry
/// of J is not finite. n x n; Count at most n.
template <int Count, Model M>
Array<Unknowns<M>, Count> null_vectors(const UnknownMatrix<M>& j) {
    constexpr int n = n_unknowns<M>;
    static_assert(Count <= n, "equilibria: no more null vectors than unknowns");
    Array<Unknowns<M>, Count> y;
    if (!j.allFinite()) {
        for (auto& v : y)
            for (double& x : v) x = std::numeric_limits<double>::quiet_NaN();
        return y;
    }
    const SingularValues values = detail::singular_values(j);
    for (int c = 0; c < Count; ++c) {
        const auto v = values.right(n - 1 - c);
        for (int i = 0; i < n; ++i) y[c][i] = v[static_cast<std::size_t>(i)].real();
    }
    return y;
}

/// The unit vector v of least |J v|: the null vector where J is singular. J is n x n.
template <Model M>
Unknowns<M> null_vector(const UnknownMatrix<M>& j) {
    return null_vectors<1, M>(j)[0];
}

/// The unit vector u of least |u^T J| on the side of the null vector v, u . v >= 0: v itself where there is a
/// potential.
template <Model M>
Unknowns<M> left_null_vector(const UnknownMatrix<M>& j, const Unknowns<M>& v) {
    if constexpr (PotentialModel<M>) {
        return v;
    } else {
        Unknowns<M> u = null_vector<M>(j.transpose());
        double along = 0;
        for (int i = 0; i < n_unknowns<M>; ++i) along += u[i] * v[i];
        if (along < 0)
            for (double& x : u) x = -x;
        return u;
    }
}

/// The number of singular values of J that are 0 to 1e-8 of `scale`, or of the largest one.
template <Model M>
int nullity(const UnknownMatrix<M>& j, double scale) {
    if (!j.allFinite()) return 0;
    const SingularValues values = detail::singular_values(j);
    int y = 0;
    for (int k = 0; k < values.size(); ++k) y += values[k] <= 1e-8 * std::max(scale, values[0]);
    return y;
}

}  // namespace equilibria
