/// \file
/// Values at equal distances that are round where people expect round ones: 1 of -3:3:7, 0.3 of 0:1:11.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// The value with number k, from 0, of n from low to high at equal distances, both ends among them exactly; of one the
/// low end. A decimal of 14 digits, counted from the larger end's first, replaces a value that is within rounding
/// errors of it. Throws InvalidArgument for k that is not below n.
inline double grid_value(double low, double high, std::uint64_t k, std::uint64_t n) {
    require(k < n, "number of a value", k, "must be below the number of values, " + std::to_string(n));
    if (k == 0) return low;
    if (k + 1 == n) return high;
    const double part = static_cast<double>(k) / static_cast<double>(n - 1);
    const double value = low + part * (high - low);
    const double most = std::max(std::abs(low), std::abs(high));
    if (!(most > 1e-280 && most < 1e280)) return value;
    const int digits = 14 - static_cast<int>(std::ceil(std::log10(most)));
    if (std::abs(digits) > 22) return value;  // 1e22 is the last power of ten that is a double
    double power = 1;
    for (int j = 0; j < std::abs(digits); ++j) power *= 10;
    // both the number of units and the power are exact: one division or product makes the nearest double
    const double round = digits >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return std::abs(round - value) <= 4 * std::numeric_limits<double>::epsilon() * most ? round : value;
}

}  // namespace equilibria
