/// \file
/// The front door: every equilibrium of a model, by homotopy continuation, with every path accounted for.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/enumerate/path_solver.hpp>
#include <equilibria/enumerate/root_set.hpp>

namespace equilibria {

namespace detail {

/// The start points of a total-degree start system, numbered in mixed radix: digit i chooses the start of unknown i.
template <Model M>
class StartPoints {
public:
    explicit StartPoints(const TotalDegreeStart<M>& start) : start_(&start) {}

    int radix(int i) const { return static_cast<int>(start_->points(i).size()); }

    Point<M, double> operator()(std::uint64_t path) const {
        Point<M, double> q;
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto size = static_cast<std::uint64_t>(radix(i));
            const StartCoordinate& at = start_->points(i)[path % size];
            path /= size;
            if (i < n_angles<M>) {
                set_lane(q.c[i], 0, at.c);
                set_lane(q.s[i], 0, at.s);
            } else {
                set_lane(q.x[i - n_angles<M>], 0, at.c);
            }
        }
        return q;
    }

    /// The path of the mirror image theta -> -theta, with a reflected start: digits 0 and 1 rest, 2k and 2k+1 change.
    std::uint64_t mirror(std::uint64_t path) const {
        std::uint64_t image = 0, weight = 1;
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto size = static_cast<std::uint64_t>(radix(i)), digit = path % size;
            path /= size;
            image += weight * (digit < 2 ? digit : digit ^ 1);
            weight *= size;
        }
        return image;
    }

private:
    const TotalDegreeStart<M>* start_;
};

/// Merges endpoints into distinct roots and counts the paths. `mirror(path)` is the number of the mirror image, the
/// path itself where there is none.
template <Model M, class Mirror>
void collect(RootSet<M>& set, std::span<const std::uint64_t> paths, const std::vector<Endpoint<M>>& ends,
             std::span<const std::uint64_t> resting_paths, const std::vector<Endpoint<M>>& resting, bool symmetric,
             Mirror&& mirror) {
    const std::size_t size = ends.size() + resting.size();
    const auto end = [&](std::size_t k) -> const Endpoint<M>& { return k < ends.size() ? ends[k] : resting[k - ends.size()]; };
    const auto path = [&](std::size_t k) { return k < ends.size() ? paths[k] : resting_paths[k - ends.size()]; };
    // the number of paths that an entry stands for
    const auto weight = [&](std::size_t k) { return symmetric && k < ends.size() ? 2 : 1; };
    for (std::size_t k = 0; k < size; ++k) {
        const auto w = static_cast<std::uint64_t>(weight(k));
        set.paths.total += w;
        switch (end(k).status) {
            case PathStatus::finite: set.paths.finite += w; break;
            case PathStatus::at_infinity: set.paths.at_infinity += w; break;
            case PathStatus::singular: set.paths.singular += w; break;
            case PathStatus::failed:
                set.paths.failed += w;
                set.failures.push_back({path(k), end(k).reason});
                if (w == 2) set.failures.push_back({mirror(path(k)), end(k).reason});
        }
    }
    const CoincidenceFinder<M> finder(symmetric);
    std::vector<std::uint8_t> merged(size);
    std::vector<std::int32_t> others(size), winding(size);
    for (std::size_t k = 0; k < size; ++k) winding[k] = end(k).winding_number;
    const auto merge = [&](PathStatus status, double tolerance) {
        const auto groups = finder.groups(
            size, [&](std::size_t k) { return end(k).status == status ? &end(k).q : nullptr; }, tolerance);
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
        if (merged[k] || (end(k).status != PathStatus::finite && end(k).status != PathStatus::singular)) continue;
        Root<M> root = root_of(end(k), path(k));
        root.paths += others[k];
        root.winding_number = winding[k];
        set.roots.push_back(root);
        if (weight(k) == 2) set.roots.push_back(reflected(root, mirror(path(k))));
    }
    std::sort(set.roots.begin(), set.roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    std::sort(set.failures.begin(), set.failures.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
}

template <Model M, StartKind Kind>
RootSet<M> enumerate_total_degree(const Parameters<M>& p, const EnumerateOptions& options,
                                  Rescue<M, Kind, double> rescue = nullptr) {
    constexpr bool symmetric = Kind == StartKind::reflected;
    const auto begin = std::chrono::steady_clock::now();
    RootSet<M> set;
    set.parameters = p;
    set.seed = options.seed;
    Generator generator(options.seed);
    const auto target = coefficients<M, double>(p);
    const auto scale = equation_scales<M, double>(target);
    const TotalDegreeStart<M> start(Kind, scale, generator);
    const StartPoints<M> points(start);
    PathSolver<M, Kind, double> solver(Homotopy<M, Kind, double>::total_degree(target, start), p, scale, options, rescue);

    std::vector<std::uint64_t> paths, resting_paths;
    for (std::uint64_t path = 0; path < static_cast<std::uint64_t>(total_degree<M>()); ++path) {
        if (!symmetric) {
            paths.push_back(path);
            continue;
        }
        const std::uint64_t image = points.mirror(path);
        if (image == path) resting_paths.push_back(path);
        if (image > path) paths.push_back(path);
    }
    std::vector<Endpoint<M>> resting(resting_paths.size());
    for (std::size_t k = 0; k < resting.size(); ++k) {
        resting[k].q = points(resting_paths[k]);
        resting[k].arrival = Arrival::end;
        solver.polisher().assess(resting[k].q, &resting[k].evidence);
        resting[k].status =
            resting[k].evidence.condition < regular_condition ? PathStatus::finite : PathStatus::singular;
    }
    const auto ends = solver.run(paths, points, resting, symmetric, set.paths);
    set.tracking_seconds = solver.tracking_seconds();
    collect(set, paths, ends, resting_paths, resting, symmetric, [&](std::uint64_t path) { return points.mirror(path); });
    find_families(set, solver.polisher(), options.threads);
    find_equilibria(set, options.threads);
    set.alarms = check_alarms(set, options.threads);
    set.seconds = seconds_since(begin);
    return set;
}

template <Model M, StartKind Kind>
void check_arguments(const Parameters<M>& p, const EnumerateOptions& options) {
    static_assert(Kind != StartKind::reflected || Formulation<M>::reflection_symmetric,
                  "equilibria: the reflected start needs equations that are odd under theta -> -theta");
    require_finite(p, "parameters");
    options.validate();
}

/// Follows regular roots at parameters `from` to the roots at p, along a line in the space of coefficients.
template <Model M>
RootSet<M> enumerate_from(const std::vector<Root<M>>& roots, const Parameters<M>& from, const Parameters<M>& p,
                          const EnumerateOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    RootSet<M> set;
    set.parameters = p;
    set.seed = options.seed;
    Generator generator(options.seed);
    const auto target = coefficients<M, double>(p);
    const auto scale = equation_scales<M, double>(target);
    using H = Homotopy<M, StartKind::parameter, double>;
    PathSolver<M, StartKind::parameter, double> solver(
        H::parameter(coefficients<M, double>(from), target, unit_complex(generator)), p, scale, options);
    std::vector<std::uint64_t> paths(roots.size());
    for (std::size_t k = 0; k < paths.size(); ++k) paths[k] = k;
    const auto start = [&](std::uint64_t path) {
        Point<M, double> q;
        const auto& root = roots[path].q;
        for (int i = 0; i < n_angles<M>; ++i) {
            set_lane(q.c[i], 0, std::cos(root[i]));
            set_lane(q.s[i], 0, std::sin(root[i]));
        }
        for (int j = 0; j < n_coordinates<M>; ++j) set_lane(q.x[j], 0, root[n_angles<M> + j]);
        return q;
    };
    const auto ends = solver.run(paths, start, {}, false, set.paths);
    set.tracking_seconds = solver.tracking_seconds();
    collect<M>(set, paths, ends, {}, {}, false, [](std::uint64_t path) { return path; });
    find_families(set, solver.polisher(), options.threads);
    find_equilibria(set, options.threads);
    set.alarms = check_alarms(set, options.threads);
    set.seconds = seconds_since(begin);
    return set;
}

}  // namespace detail

/// The start system that suits the model: reflected where it has the symmetry theta -> -theta (a model may decline
/// with `static constexpr bool use_reflection = false`, or insist with `true`, which is checked).
template <Model M>
constexpr StartKind natural_start() {
    if constexpr (requires { M::use_reflection; }) {
        static_assert(!M::use_reflection || Formulation<M>::reflection_symmetric,
                      "equilibria: the model declares use_reflection, but its equations are not odd under "
                      "theta -> -theta (or it has plain coordinates, with which the library does not use it)");
        return M::use_reflection ? StartKind::reflected : StartKind::general;
    }
    return Formulation<M>::reflection_symmetric ? StartKind::reflected : StartKind::general;
}

/// Every isolated equilibrium of the model at the parameters p, from a total-degree start.
///
/// Reaches every isolated solution of the polynomial system with probability one over the seed; paths at infinity,
/// singular and failed ones are counted, not hidden. Kind: the start system, if not the natural one (`parameter`: the
/// general one, compiled together with the parameter homotopies).
/// Throws InvalidArgument for parameters that are not finite and for options out of range.
template <Model M, StartKind Kind = natural_start<M>()>
RootSet<M> enumerate(const Parameters<M>& p, const EnumerateOptions& options = {}) {
    detail::check_arguments<M, Kind>(p, options);
    return detail::enumerate_total_degree<M, Kind>(p, options);
}

/// The equilibria at p, from those of a solved instance: as many paths as `solved` has roots, not the whole bound.
///
/// The homotopy is a line in the space of coefficients. Complete if `solved` has as many regular roots as a generic
/// instance: certainly where it reaches the bound, as the chain does. Throws InvalidArgument where `solved` has failed
/// or singular paths.
template <Model M>
RootSet<M> enumerate(const RootSet<M>& solved, const Parameters<M>& p, const EnumerateOptions& options = {}) {
    require_finite(p, "parameters");
    options.validate();
    require(solved.paths.failed == 0 && solved.paths.singular == 0, "solved.paths",
            std::to_string(solved.paths.failed) + " failed, " + std::to_string(solved.paths.singular) + " singular",
            "a start instance must have regular roots only");
    return detail::enumerate_from<M>(solved.roots, solved.parameters, p, options);
}

}  // namespace equilibria
