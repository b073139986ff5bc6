/// \file
/// The Stumpff functions c_k(x) = sum_j (-x)^j / (2 j + k)!, in which everything about a rotation vector of length psi,
/// x = psi^2, is smooth: c_0 = cos psi, c_1 = sin psi / psi, c_2 = (1 - cos psi) / psi^2, c_3 = (psi - sin psi) /
/// psi^3.
///
///     c_k = 1/k! - x c_(k+2)              2 dc_k/dx = k c_(k+2) - c_(k+1)
///
/// No branch loses digits to cancellation: up to psi = 2 pi the two highest come from their series and others from the
/// recurrence downwards; c_3 and c_4 from x = 10 on, and all beyond 2 pi, come from the recurrence upwards.
/// Source: Danby, Fundamentals of Celestial Mechanics, section 6.9.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <equilibria/core/array.hpp>

namespace equilibria {

namespace detail {

/// The number without its derivatives.
template <class T>
const auto& without_derivatives(const T& x) {
    if constexpr (requires { x.derivative; })
        return without_derivatives(x.value);
    else
        return x;
}

/// c_k(x) by its series, for x not above 10, or 45 where k is 5 or more.
template <class T>
T stumpff_series(const T& x, int k) {
    using Plain = std::remove_cvref_t<decltype(without_derivatives(x))>;
    // terms until they are below rounding, and three more for derivatives
    int terms = 3;
    double factorial = 1;
    for (int j = 1; j <= k; ++j) factorial *= j;
    const double size = static_cast<double>(without_derivatives(x)),
                 least = 0.01 * static_cast<double>(std::numeric_limits<Plain>::epsilon());
    double term = 1;
    for (int j = 0; term > least; ++j, ++terms) term *= size / ((2 * j + k + 1) * (2 * j + k + 2));
    T y(1.0);
    for (int j = terms; j-- > 0;) y = T(1.0) - x * y / T(static_cast<double>((2 * j + k + 1) * (2 * j + k + 2)));
    return y / T(factorial);
}

}  // namespace detail

/// c_0(x) to c_Most(x), x = psi^2 >= 0, within a few units in the last place of the largest of |c_k(x)| and what a
/// rounding of x changes. T: a floating-point number, a multiprecision one, or a Dual of these.
template <int Most, class T>
Array<T, Most + 1> stumpff(const T& x) {
    static_assert(Most >= 2);
    using std::cos, std::sin, std::sqrt;
    Array<T, Most + 1> c;
    const double size = static_cast<double>(detail::without_derivatives(x));
    if (!(size < 1)) {
        const T psi = sqrt(x), half = T(0.5) * psi, s = sin(half);
        c[0] = cos(psi);
        c[1] = sin(psi) / psi;
        c[2] = T(2.0) * s * s / x;
    }
    // upwards to `up`, then downwards from the top two by their series
    const int up = size < 1 ? -1 : size < 10 ? 2 : size < 45 ? 4 : Most;
    double factorial = 1;
    for (int k = 1; k + 2 <= std::min(up, Most); ++k) {
        factorial *= k;
        c[k + 2] = (T(1.0) / T(factorial) - c[k]) / x;
    }
    factorial = 1;
    for (int k = 2; k <= Most - 2; ++k) factorial *= k;
    for (int k = Most; k > up; --k) {
        if (k > Most - 2) {
            c[k] = detail::stumpff_series(x, k);
        } else {
            c[k] = T(1.0) / T(factorial) - x * c[k + 2];
            if (k > 0) factorial /= k;
        }
    }
    return c;
}

}  // namespace equilibria
