/// \file
/// Whether a traced curve is another one again: each curve of a locus is to be there once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <equilibria/core/window.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/model/torus.hpp>

namespace equilibria::detail {

/// The square of the distance of a point from a curve, in parts of the window and in the unknowns; beyond `most`
/// anything larger.
inline double distance2_from(const RuntimeSizes& sizes, const Window& window, const RuntimeSingularity<>& at,
                             const LocusCurve<RuntimeUnknowns>& curve, double most) {
    const int n = at.q.size();
    double nearest = 2 * most * most;
    std::vector<double> to(static_cast<std::size_t>(n) + 2), chord(to.size());
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
        const auto &a = curve.points[k], &b = curve.points[k + 1];
        chord[0] = (b.x() - a.x()) / window.width();
        chord[1] = (b.y() - a.y()) / window.height();
        to[0] = (at.x() - a.x()) / window.width();
        to[1] = (at.y() - a.y()) / window.height();
        const double reach = 1.5 * std::hypot(chord[0], chord[1]) + most;
        if (std::abs(to[0]) > reach || std::abs(to[1]) > reach) continue;
        const auto step = displacement(sizes, a.q, b.q), away = displacement(sizes, a.q, at.q);
        double along = 0, length2 = 0;
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (i >= 2) chord[i] = step[static_cast<int>(i) - 2], to[i] = away[static_cast<int>(i) - 2];
            along += to[i] * chord[i];
            length2 += chord[i] * chord[i];
        }
        const double part = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
        double rest = 0;
        for (std::size_t i = 0; i < to.size(); ++i) rest += (to[i] - part * chord[i]) * (to[i] - part * chord[i]);
        nearest = std::min(nearest, rest);
    }
    return nearest;
}

/// Whether points all along a curve lie on curves of its kind, or their mirror images do. Two curves that are not one
/// meet in points alone, unknowns included.
inline bool is_copy(const RuntimeSizes& sizes, const Window& window, bool reflection_symmetric,
                    const LocusCurve<RuntimeUnknowns>& curve, const std::vector<LocusCurve<RuntimeUnknowns>>& others) {
    constexpr std::size_t samples = 9;
    // a chord of the largest step by default, 0.006, is off a curve of radius 0.05 by 1e-4
    constexpr double most = 3e-4;
    for (std::size_t k = 0; k < samples; ++k) {
        auto at = curve.points[(2 * k + 1) * curve.points.size() / (2 * samples)];
        bool found = false;
        for (const bool mirror : {false, true}) {
            if (found || (mirror && !reflection_symmetric)) break;
            if (mirror) at.q = mirrored(sizes, at.q);
            for (const auto& other : others)
                found =
                    found || (other.kind == curve.kind && distance2_from(sizes, window, at, other, most) < most * most);
        }
        if (!found) return false;
    }
    return true;
}

}  // namespace equilibria::detail
