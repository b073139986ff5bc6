/// \file
/// Points of a plane of two parameters, and borders between its regions.
#pragma once

#include <cstddef>

namespace equilibria {

struct PlanePoint {
    double x = 0, y = 0;
};

/// Two regions with a common piece of a curve between them.
struct RegionBorder {
    int below, above;   ///< regions; `below` has the smaller y
    std::size_t curve;  ///< the number of the curve
    friend constexpr bool operator==(const RegionBorder&, const RegionBorder&) = default;
};

}  // namespace equilibria
