/// \file
/// A curve of a plane on which equilibria come from infinity, or go there.
#pragma once

#include <array>
#include <vector>

#include <equilibria/locus/plane/curve_end.hpp>
#include <equilibria/locus/regions/plane_point.hpp>

namespace equilibria {

/// A curve on which equilibria are infinitely far away. Between its points it is a straight line to within 1e-4 of the
/// window where its radius of curvature is a tenth of that or more.
struct InfinityCurve {
    std::vector<PlanePoint> points;                                ///< in order, neighbours a step apart
    std::array<CurveEnd, 2> ends{CurveEnd::step, CurveEnd::step};  ///< why it has its first and its last point
};

}  // namespace equilibria
