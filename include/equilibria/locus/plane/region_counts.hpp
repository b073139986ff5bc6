/// \file
/// The equilibria of the regions of a traced locus: one enumeration well inside each, and others that must agree.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <equilibria/core/sized_array.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/locus/regions/regions.hpp>

namespace equilibria::detail {

/// A point of each region, as far from the curves and the border as a search over the cells and a grid finds.
inline void place_points(Locus<RuntimeUnknowns>& locus, const PlaneDecomposition& plane) {
    const Window& w = locus.window;
    // some thousand points of all curves tell how far they are
    std::size_t size = 0;
    for (const auto& curve : locus.curves) size += curve.points.size();
    for (const auto& curve : locus.from_infinity) size += curve.points.size();
    const std::size_t step = 1 + size / 4000;
    std::vector<PlanePoint> points;
    for (const auto& curve : locus.curves)
        for (std::size_t k = 0; k < curve.points.size(); k += step)
            points.push_back({curve.points[k].x(), curve.points[k].y()});
    for (const auto& curve : locus.from_infinity)
        for (std::size_t k = 0; k < curve.points.size(); k += step) points.push_back(curve.points[k]);
    std::vector<double> best(locus.regions.size(), -1);
    const auto consider = [&](double x, double y, int number) {
        if (number < 0) return;
        double clearance =
            std::min(std::min(x - w.x.low, w.x.high - x) / w.width(), std::min(y - w.y.low, w.y.high - y) / w.height());
        const auto region = static_cast<std::size_t>(number);
        for (const PlanePoint& p : points) {
            if (clearance <= best[region]) return;
            clearance = std::min(clearance, std::hypot((p.x - x) / w.width(), (p.y - y) / w.height()));
        }
        if (clearance > best[region]) best[region] = clearance, locus.regions[region].point = {x, y};
    };
    for (const auto& cell : plane.cells()) {
        LocusRegion& region = locus.regions[static_cast<std::size_t>(cell.region)];
        region.area += plane.area(cell);
        region.polygons.push_back(plane.polygon(cell));
        consider(cell.center.x, cell.center.y, cell.region);
    }
    constexpr int grid = 32;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const double x = w.x.low + w.width() * (i + 0.5) / grid, y = w.y.low + w.height() * (j + 0.5) / grid;
            consider(x, y, plane.region_of(x, y));
        }
}

/// Whether two tables by index differ, and by pairs of neighbouring indices alone, as on both sides of a fold or
/// pitchfork.
inline bool differ_by_pairs(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
    std::int64_t alternating = 0;
    for (std::size_t k = 0; k < a.size(); ++k) alternating += (k % 2 == 0 ? 1 : -1) * (a[k] - b[k]);
    return a != b && alternating == 0;
}

/// Whether a region is more than a sliver below the resolution of the curves' points, where two curves touch or lie
/// over each other: with the window as the unit, an area of 1e-13 and a mean width (twice the area over the outline) of
/// 1e-6, which is less than the 4e-6 that a chord of the largest step by default, 0.006, is off a curve of radius 1. A
/// region that is thinner than that everywhere is left out. The outline is that of all its polygons, so never too
/// short.
inline bool is_resolved(const LocusRegion& region, const Window& window) {
    const double area = region.area / (window.width() * window.height());
    double outline = 0;
    for (const auto& polygon : region.polygons)
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const PlanePoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            outline += std::hypot((b.x - a.x) / window.width(), (b.y - a.y) / window.height());
        }
    return area > 1e-13 && !(2 * area < 1e-6 * outline);
}

/// Decomposes the window, enumerates each region at its point, and compares with enumerations elsewhere in it: in its
/// other cells, and at checks x checks points of a grid.
inline void count_regions(Locus<RuntimeUnknowns>& locus, const SearchedModel& model, std::span<const int> active,
                          int checks, const RunOptions& run) {
    const auto count_at = [&](double x, double y) {
        RuntimeArray<double> p = locus.parameters;
        p[active[0]] = x;
        p[active[1]] = y;
        return model.count(p, run);
    };
    std::vector<std::vector<PlanePoint>> lines;
    for (const auto& curve : locus.curves) {
        lines.emplace_back();
        for (const auto& p : curve.points) lines.back().push_back({p.x(), p.y()});
    }
    for (const auto& curve : locus.from_infinity) lines.push_back(curve.points);
    const PlaneDecomposition plane(locus.window, lines);
    locus.regions.resize(static_cast<std::size_t>(plane.regions()));
    place_points(locus, plane);
    const auto is_region = [&](const LocusRegion& region) { return is_resolved(region, locus.window); };
    for (LocusRegion& region : locus.regions) {
        if (!is_region(region)) continue;
        const auto found = count_at(region.point.x, region.point.y);
        region.count = found.real;
        region.by_index = found.by_index;
        region.clean = found.clean;
    }
    const auto check = [&](double x, double y) {
        const int number = plane.region_of(x, y);
        if (number < 0) return;
        LocusRegion& region = locus.regions[static_cast<std::size_t>(number)];
        if (!is_region(region)) return;
        const auto found = count_at(x, y);
        ++locus.evidence.checked_points;
        if (found.real != region.count || found.by_index != region.by_index) {
            region.confirmed = false;
            locus.evidence.add(LocusFaultKind::wrong_count, {x, y});
        }
    };
    for (const auto& cell : plane.cells())
        if (plane.clearance(cell) > 1e-4) check(cell.center.x, cell.center.y);
    const Window& w = locus.window;
    for (int i = 0; i < checks; ++i)
        for (int j = 0; j < checks; ++j)
            check(w.x.low + w.width() * (i + 0.5) / checks, w.y.low + w.height() * (j + 0.5) / checks);
    // without the slivers, numbered anew
    std::vector<int> number(locus.regions.size(), -1);
    int kept = 0;
    for (std::size_t k = 0; k < locus.regions.size(); ++k)
        if (is_region(locus.regions[k])) number[k] = kept++;
    for (const RegionBorder& border : plane.borders()) {
        const int below = number[static_cast<std::size_t>(border.below)],
                  above = number[static_cast<std::size_t>(border.above)];
        if (below < 0 || above < 0) continue;
        locus.borders.push_back({below, above, border.curve});
        const auto &a = locus.regions[static_cast<std::size_t>(border.below)].by_index,
                   &b = locus.regions[static_cast<std::size_t>(border.above)].by_index;
        // what comes from infinity may have any index, and as many may go there
        if (border.curve < locus.curves.size() && !differ_by_pairs(a, b))
            locus.evidence.add(LocusFaultKind::wrong_border,
                               locus.regions[static_cast<std::size_t>(border.below)].point);
    }
    std::erase_if(locus.regions, [&](const LocusRegion& region) { return !is_region(region); });
}

}  // namespace equilibria::detail
