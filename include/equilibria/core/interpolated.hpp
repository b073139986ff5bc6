/// \file
/// Polynomial interpolation of numbers or vectors by Neville's scheme.
/// Source: Stoer and Bulirsch, Introduction to Numerical Analysis (Springer, 2002), section 2.1.2.
#pragma once

#include <cstddef>
#include <vector>

namespace equilibria {

/// The value at x of the polynomial of degree n - 1 through n values at n distinct places, n at least 1. T: a number,
/// or an Eigen vector; all of one size.
template <class T>
T interpolated(double x, const std::vector<double>& places, std::vector<T> values) {
    for (std::size_t level = 1; level < values.size(); ++level)
        for (std::size_t k = 0; k + level < values.size(); ++k) {
            const double share = (x - places[k]) / (places[k + level] - places[k]);
            values[k] += share * (values[k + 1] - values[k]);
        }
    return values[0];
}

}  // namespace equilibria
