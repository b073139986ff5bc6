/// \file
/// From endpoints to roots: counted, told apart, merged.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/storage/endpoint_store.hpp>

namespace equilibria::detail {

/// The complex angle of the point (c, s): c + i s = exp(i theta).
inline std::complex<double> angle_of(const Complex<double>& c, const Complex<double>& s) {
    const std::complex<double> z(c.re - s.im, c.im + s.re), w(c.re + s.im, c.im - s.re);  // exp(i theta), exp(-i theta)
    // the larger of the two has the digits
    const double z2 = std::norm(z), w2 = std::norm(w);
    return z2 >= w2 ? std::complex<double>(std::arg(z), -0.5 * std::log(z2))
                    : std::complex<double>(-std::arg(w), 0.5 * std::log(w2));
}

template <Model M>
Root<M> root_of(const Endpoint<M>& end, std::uint64_t path) {
    Root<M> root;
    for (int i = 0; i < n_angles<M>; ++i) root.q[i] = angle_of(end.q.c[i], end.q.s[i]);
    for (int j = 0; j < n_coordinates<M>; ++j) root.q[n_angles<M> + j] = {end.q.x[j].re, end.q.x[j].im};
    root.residual = end.evidence.residual;
    root.condition = end.evidence.condition;
    root.path = path;
    root.winding_number = end.winding_number;
    root.status = end.status;
    return root;
}

/// theta -> -theta.
template <Model M>
Root<M> reflected(Root<M> root, std::uint64_t path) {
    for (int i = 0; i < n_angles<M>; ++i) {
        const double angle = -root.q[i].real();
        root.q[i] = {angle <= -std::numbers::pi ? std::numbers::pi : angle, -root.q[i].imag()};
    }
    root.path = path;
    return root;
}

/// The start point of a path that begins at a solved instance's root q.
template <Model M>
Point<M, double> start_point(const Array<std::complex<double>, n_unknowns<M>>& q) {
    Point<M, double> y;
    for (int i = 0; i < n_angles<M>; ++i) {
        set_lane(y.c[i], 0, std::cos(q[i]));
        set_lane(y.s[i], 0, std::sin(q[i]));
    }
    for (int j = 0; j < n_coordinates<M>; ++j) set_lane(y.x[j], 0, q[n_angles<M> + j]);
    return y;
}

/// Counts the paths, merges endpoints into distinct roots and calls take(root) for each, in the order of the tracked
/// paths, a mirror image after its original; those that rest come last. path_of(k) is the number of path k,
/// `mirror(path)` that of its mirror image, the path itself where there is none.
template <Model M, class PathOf, class RestingPath, class Mirror, class Take>
void collect(PathCounts& paths, std::vector<FailedPath<M>>& failures, EndpointStore<M>& ends, PathOf&& path_of,
             const std::vector<Endpoint<M>>& resting, RestingPath&& resting_path, bool symmetric, Mirror&& mirror,
             Take&& take) {
    const std::size_t size = ends.size() + resting.size();
    const auto end = [&](std::size_t k) -> const Endpoint<M>& {
        return k < ends.size() ? ends[k] : resting[k - ends.size()];
    };
    const auto path = [&](std::size_t k) { return k < ends.size() ? path_of(k) : resting_path(k - ends.size()); };
    const auto finished = [&](std::size_t k) { return k >= ends.size() || ends.finished(k); };
    // the number of paths that an entry stands for
    const auto weight = [&](std::size_t k) { return symmetric && k < ends.size() ? 2 : 1; };
    for (std::size_t k = 0; k < size; ++k) {
        const auto w = static_cast<std::uint64_t>(weight(k));
        paths.total += w;
        if (!finished(k)) {
            paths.cancelled += w;
            continue;
        }
        switch (end(k).status) {
            case PathStatus::finite: paths.finite += w; break;
            case PathStatus::at_infinity: paths.at_infinity += w; break;
            case PathStatus::singular: paths.singular += w; break;
            case PathStatus::failed:
                paths.failed += w;
                failures.push_back({path(k), end(k).reason, root_of(end(k), path(k)).q});
                if (w == 2)
                    failures.push_back({mirror(path(k)), end(k).reason,
                                        reflected(root_of(end(k), path(k)), mirror(path(k))).q});
        }
    }
    std::sort(failures.begin(), failures.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    const CoincidenceFinder<M> finder(symmetric);
    std::vector<std::uint8_t> merged(size);
    std::vector<std::int32_t> others(size), winding(size);
    for (std::size_t k = 0; k < size; ++k)
        if (finished(k)) winding[k] = end(k).winding_number;
    const auto merge = [&](PathStatus status, double tolerance) {
        const auto groups = finder.groups(
            size, [&](std::size_t k) { return finished(k) && end(k).status == status ? &end(k).q : nullptr; },
            tolerance);
        for (const auto& group : groups) {
            // a resting root, its own mirror image, stands for the group; else the first path
            const std::size_t leader = group.back() >= ends.size() ? group.back() : group.front();
            for (const std::size_t k : group)
                if (k != leader) {
                    merged[k] = 1;
                    others[leader] += leader >= ends.size() ? weight(k) : 1;
                    winding[leader] = std::max(winding[leader], winding[k]);
                }
        }
    };
    merge(PathStatus::finite, 1e-9);
    merge(PathStatus::singular, 1e-5);
    for (std::size_t k = 0; k < size; ++k) {
        if (merged[k] || !finished(k)) continue;
        if (end(k).status != PathStatus::finite && end(k).status != PathStatus::singular) continue;
        Root<M> root = root_of(end(k), path(k));
        root.paths += others[k];
        root.winding_number = winding[k];
        take(root);
        if (weight(k) == 2) take(reflected(root, mirror(path(k))));
    }
}

template <Model M>
void sort_by_path(std::vector<Root<M>>& roots) {
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
}

}  // namespace equilibria::detail
