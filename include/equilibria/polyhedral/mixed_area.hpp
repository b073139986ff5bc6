/// \file
/// Mixed areas of lattice polygons: the mixed volume of two equations, from areas alone, beside which that by mixed
/// cells (mixed_cells.hpp) can be held.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace equilibria::detail {

using LatticePoint = std::array<std::int64_t, 2>;

/// Twice the area of the convex hull of these points, not empty.
inline std::int64_t twice_hull_area(std::vector<LatticePoint> points) {
    const auto turn = [](const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    std::sort(points.begin(), points.end());
    std::int64_t area = 0;
    for (int side = 0; side < 2; ++side) {  // lower chain from the left, upper chain from the right
        std::vector<LatticePoint> chain;
        for (const auto& p : points) {
            while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
            chain.push_back(p);
        }
        for (std::size_t k = 1; k < chain.size(); ++k)
            area += chain[k - 1][0] * chain[k][1] - chain[k - 1][1] * chain[k][0];
        std::reverse(points.begin(), points.end());
    }
    return area;
}

/// area(P + Q) - area(P) - area(Q).
inline std::int64_t mixed_area(const std::vector<LatticePoint>& p, const std::vector<LatticePoint>& q) {
    std::vector<LatticePoint> sum;
    for (const auto& a : p)
        for (const auto& b : q) sum.push_back({a[0] + b[0], a[1] + b[1]});
    return (twice_hull_area(sum) - twice_hull_area(p) - twice_hull_area(q)) / 2;
}

}  // namespace equilibria::detail
