/// \file
/// See polyhedral/supports.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria {

EQUILIBRIA_INLINE Supports::Supports(int unknowns, std::vector<std::vector<Point>> equations)
    : unknowns_(unknowns), equations_(std::move(equations)) {
    require(unknowns >= 1 && unknowns <= 1024, "unknowns", unknowns, "must be from 1 to 1024");
    const auto n = static_cast<std::size_t>(unknowns);
    require(equations_.size() == n, "equations.size()", equations_.size(),
            "must be the number of unknowns, " + std::to_string(n) + ": the system is square");
    constexpr int largest = 1 << 30;
    std::size_t columns = 0;
    first_column_.push_back(0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto& points = equations_[i];
        const std::string name = "equations[" + std::to_string(i) + "]";
        require(!points.empty(), name + ".size()", points.size(),
                "must be at least 1: an equation without a term is none");
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::string point = name + "[" + std::to_string(k) + "]";
            require(points[k].size() == n, point + ".size()", points[k].size(),
                    "must be the number of unknowns, " + std::to_string(n));
            for (const int x : points[k])
                require(x >= -largest && x <= largest, point, x, "must have exponents from -2^30 to 2^30");
        }
        std::vector<std::size_t> sorted(points.size());
        for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = k;
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
        for (std::size_t k = 1; k < sorted.size(); ++k)
            require(points[sorted[k - 1]] != points[sorted[k]], name + "[" + std::to_string(sorted[k]) + "]",
                    "the same point as number " + std::to_string(sorted[k - 1]),
                    "must be another one: add their coefficients");
        columns += points.size();
        require(columns <= static_cast<std::size_t>(std::numeric_limits<int>::max() / 4), "equations", columns,
                "must have fewer than 2^29 points together");
        first_column_.push_back(static_cast<int>(columns));
    }
}

}  // namespace equilibria
