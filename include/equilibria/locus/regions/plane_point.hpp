/// \file
/// Points of a plane of two parameters, and borders between its regions.
#pragma once

#include <cstddef>

namespace equilibria {

/// A point of a plane of two parameters.
struct PlanePoint {
    double x = 0;  ///< the first parameter
    double y = 0;  ///< the second parameter
};

/// Two regions with a common piece of a curve between them.
struct RegionBorder {
    int below;          ///< region with the smaller y
    int above;          ///< region with the larger y
    std::size_t curve;  ///< the number of the curve
    /// The same pair at the same curve.
    friend constexpr bool operator==(const RegionBorder&, const RegionBorder&) = default;
};

}  // namespace equilibria
