/// \file
/// See start/total_degree_start.hpp.
#pragma once

#include <utility>

#include <equilibria/start/total_degree_start.hpp>

namespace equilibria {

EQUILIBRIA_INLINE TotalDegreeStart::TotalDegreeStart(TotalDegreeKind kind, const RuntimeSizes& sizes,
                                                     std::span<const int> degrees, std::span<const double> scale,
                                                     Generator& generator)
    : sizes_(sizes), system_(kind, sizes, degrees, scale, generator) {
    std::vector<std::uint64_t> radices;
    std::uint64_t paths = 1;
    for (int i = 0; i < sizes.unknowns; ++i) {
        radices.push_back(system_.points(i).size());
        paths *= radices.back();
    }
    numbering_ =
        kind == TotalDegreeKind::reflected ? PathNumbering::mirrored(std::move(radices)) : PathNumbering::all(paths);
}

EQUILIBRIA_INLINE RuntimePoint<double> TotalDegreeStart::point_of(std::uint64_t path) const {
    auto q = point_of_zeros<RuntimeUnknowns, double>(sizes_);
    for (int i = 0; i < sizes_.unknowns; ++i) {
        const auto& points = system_.points(i);
        const StartCoordinate& at = points[path % points.size()];
        path /= points.size();
        if (i < sizes_.angles) {
            set_lane(q.c[i], 0, at.c);
            set_lane(q.s[i], 0, at.s);
        } else {
            set_lane(q.x[i - sizes_.angles], 0, at.c);
        }
    }
    return q;
}

}  // namespace equilibria
