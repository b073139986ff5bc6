/// \file
/// Elementary functions that also work in constant expressions, where the models' supports are computed at generic
/// parameter values. At run time they are the standard library's. Accuracy at compile time: a few 1e-15 relative for
/// arguments of order 1, enough to tell a coefficient that is zero from one that is not. There, sqrt and log of a
/// negative number are those of its absolute value: the generic values are not the user's, and the support is the same.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

namespace equilibria::constant_math {

constexpr double abs(double x) { return x < 0 ? -x : x; }  ///< |x|, in constant expressions as at run time

/// Square root by Heron's iteration, after scaling to [1, 4).
constexpr double sqrt(double x) {
    if (!std::is_constant_evaluated()) return std::sqrt(x);
    if (x == 0) return 0;
    x = abs(x);
    double scale = 1;
    while (x >= 4) x /= 4, scale *= 2;
    while (x < 1) x *= 4, scale /= 2;
    double r = 1.5;
    for (int k = 0; k < 7; ++k) r = 0.5 * (r + x / r);
    return scale * r;
}

/// e^x by its series, after halving x.
constexpr double exp(double x) {
    if (!std::is_constant_evaluated()) return std::exp(x);
    int halvings = 0;
    while (abs(x) > 0.5) x /= 2, ++halvings;
    double term = 1, sum = 1;
    for (int k = 1; k < 20; ++k) sum += term *= x / k;
    for (; halvings > 0; --halvings) sum *= sum;
    return sum;
}

/// Natural logarithm; that of 0 does not compile in a constant expression.
constexpr double log(double x) {
    if (!std::is_constant_evaluated()) return std::log(x);
    if (x == 0) throw "equilibria: log of 0 at the generic parameters";
    x = abs(x);
    double y = 0;
    while (x > 1.5) x /= 2, y += std::numbers::ln2;
    while (x < 0.75) x *= 2, y -= std::numbers::ln2;
    const double q = (x - 1) / (x + 1);
    double power = q, sum = 0;
    for (int k = 1; k < 50; k += 2) sum += power / k, power *= q * q;
    return y + 2 * sum;
}

namespace detail {
constexpr double reduced(double x) {  // to [-pi, pi]
    const double turns = x / (2 * std::numbers::pi);
    return x - 2 * std::numbers::pi * static_cast<double>(static_cast<long long>(turns + (turns < 0 ? -0.5 : 0.5)));
}
}  // namespace detail

/// Of an angle in radians.
constexpr double sin(double x) {
    if (!std::is_constant_evaluated()) return std::sin(x);
    x = detail::reduced(x);
    double term = x, sum = x;
    for (int k = 1; k < 16; ++k) sum += term *= -x * x / ((2 * k) * (2 * k + 1));
    return sum;
}

/// Of an angle in radians.
constexpr double cos(double x) {
    if (!std::is_constant_evaluated()) return std::cos(x);
    x = detail::reduced(x);
    double term = 1, sum = 1;
    for (int k = 1; k < 16; ++k) sum += term *= -x * x / ((2 * k - 1) * (2 * k));
    return sum;
}

/// x^y, for x > 0.
constexpr double pow(double x, double y) {
    if (!std::is_constant_evaluated()) return std::pow(x, y);
    return exp(y * log(x));
}

/// Of other scalars: what their own library has. (Without these, a long double would become a double.)
/// \{
template <class S>
requires(!std::is_integral_v<S>)
auto sqrt(const S& x) {
    using std::sqrt;
    return sqrt(x);
}
template <class S>
requires(!std::is_integral_v<S>)
auto exp(const S& x) {
    using std::exp;
    return exp(x);
}
template <class S>
requires(!std::is_integral_v<S>)
auto log(const S& x) {
    using std::log;
    return log(x);
}
template <class S>
requires(!std::is_integral_v<S>)
auto sin(const S& x) {
    using std::sin;
    return sin(x);
}
template <class S>
requires(!std::is_integral_v<S>)
auto cos(const S& x) {
    using std::cos;
    return cos(x);
}
template <class S>
requires(!std::is_integral_v<S>)
auto pow(const S& x, double y) {
    using std::pow;
    return pow(x, y);
}
/// \}

}  // namespace equilibria::constant_math
