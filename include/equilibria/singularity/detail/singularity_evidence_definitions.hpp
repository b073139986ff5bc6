/// \file
/// See singularity/singularity_evidence.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria::detail {

template <class S>
double scale_of(const ModelFunctions<S>& functions, const RuntimeSingularity<S>& at) {
    const auto j = rounded_jacobian(functions, at.q, at.p);
    double y = 0, factorial = 2;
    for (int r = 0; r < j.size(); ++r)
        for (int c = 0; c < j.size(); ++c) y = std::max(y, std::abs(j[r][c]));
    for (int k = 3; k <= 8; ++k) {
        factorial *= k;
        y = std::max(y, std::abs(to_double(at.derivative(k))) / factorial);
    }
    return y;
}

template <class S>
bool decides(const RuntimeSingularity<S>& at, int k, double scale) {
    double factorial = 1;
    for (int j = 2; j <= k; ++j) factorial *= j;
    return std::abs(to_double(at.derivative(k))) > 1e-6 * factorial * scale;
}

template <class S>
std::optional<ReducedSeries<S>> fill_evidence(const ModelFunctions<S>& functions, RuntimeSingularity<S>& at,
                                              const RuntimeArray<double>& near) {
    const auto j = rounded_jacobian(functions, at.q, at.p);
    const auto along = [&](const RuntimeArray<S>& v) {
        const auto left = functions.has_potential() ? v : in_digits_of<S>(left_null_vector(j, to_double(v), false));
        return reduced_series<S, S>(functions, evidence_order, at.q, v, left, at.p);
    };
    at.v = in_digits_of<S>(near);
    auto series = along(at.v);
    if (series.regular) {
        at.v = normalized(series.curve[1]);
        series = along(at.v);
        for (int k = 3; k <= 8; ++k) at.derivatives[k - 3] = series.derivative(k);
    }
    at.nullity = nullity(j, scale_of(functions, at));
    if (!series.regular) return std::nullopt;
    return series;
}

}  // namespace equilibria::detail
