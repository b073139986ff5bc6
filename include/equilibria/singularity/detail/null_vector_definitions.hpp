/// \file
/// See singularity/null_vector.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <equilibria/core/singular_values.hpp>
#include <equilibria/singularity/null_vector.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE bool all_finite(const RuntimeMatrix<double>& a) {
    for (int r = 0; r < a.size(); ++r)
        for (int c = 0; c < a.size(); ++c)
            if (!std::isfinite(a[r][c])) return false;
    return true;
}
/// Of a square matrix of finite entries.
EQUILIBRIA_INLINE SingularValues singular_values(const RuntimeMatrix<double>& a) {
    SingularValues::Vector entries;
    for (int c = 0; c < a.size(); ++c)
        for (int r = 0; r < a.size(); ++r) entries.emplace_back(a[r][c]);
    return SingularValues(a.size(), a.size(), std::move(entries));
}

}  // namespace detail

EQUILIBRIA_INLINE std::vector<RuntimeArray<double>> null_vectors(const RuntimeMatrix<double>& j, int count) {
    const int n = j.size();
    std::vector<RuntimeArray<double>> y(static_cast<std::size_t>(count), RuntimeArray<double>(n));
    if (!detail::all_finite(j)) {
        for (auto& v : y) std::fill(v.begin(), v.end(), std::numeric_limits<double>::quiet_NaN());
        return y;
    }
    const SingularValues values = detail::singular_values(j);
    for (int c = 0; c < count; ++c) {
        const auto v = values.right(n - 1 - c);
        for (int i = 0; i < n; ++i) y[static_cast<std::size_t>(c)][i] = v[static_cast<std::size_t>(i)].real();
    }
    return y;
}

EQUILIBRIA_INLINE RuntimeArray<double> null_vector(const RuntimeMatrix<double>& j) { return null_vectors(j, 1)[0]; }

EQUILIBRIA_INLINE RuntimeArray<double> left_null_vector(const RuntimeMatrix<double>& j, const RuntimeArray<double>& v,
                                                        bool symmetric) {
    if (symmetric) return v;
    RuntimeMatrix<double> transposed(j.size());
    for (int r = 0; r < j.size(); ++r)
        for (int c = 0; c < j.size(); ++c) transposed[c][r] = j[r][c];
    RuntimeArray<double> u = null_vector(transposed);
    double along = 0;
    for (int i = 0; i < u.size(); ++i) along += u[i] * v[i];
    if (along < 0)
        for (double& x : u) x = -x;
    return u;
}

EQUILIBRIA_INLINE int nullity(const RuntimeMatrix<double>& j, double scale) {
    if (!detail::all_finite(j)) return 0;
    const SingularValues values = detail::singular_values(j);
    int y = 0;
    for (int k = 0; k < values.size(); ++k) y += values[k] <= 1e-8 * std::max(scale, values[0]);
    return y;
}

}  // namespace equilibria
