/// \file
/// See paths/coincidence.hpp.
#pragma once

#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/detail/coincidence_finder.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE std::vector<std::vector<std::size_t>> coincident(std::span<const RuntimePoint<double>> points,
                                                                   double tolerance) {
    if (points.empty()) return {};
    const RuntimeSizes sizes(points.front().c.size(), points.front().x.size());
    return CoincidenceFinder(false, sizes)
        .groups(points.size(), [&](std::size_t k) { return PointView(points[k]); }, tolerance);
}

}  // namespace equilibria::detail
