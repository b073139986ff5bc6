/// \file
/// See paths/solve_along.hpp.
#pragma once

#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/paths/detail/path_solver.hpp>
#include <equilibria/paths/solve_along.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PathSet detail::track_paths(const ArcHomotopy& homotopy, PathProblem problem, const RunOptions& run,
                                              const TrackerOptions& options, MoreDigits<ArcHomotopy> resort) {
    return PathSolver<ArcHomotopy>(homotopy, std::move(problem), run, options, resort).track();
}

EQUILIBRIA_INLINE PathSet track(const ArcHomotopy& homotopy, const KnownRoots& start, const RunOptions& run,
                                const TrackerOptions& options, MoreDigits<ArcHomotopy> resort) {
    return detail::track_paths(homotopy, {.start = StartPoints(start)}, run, options, resort);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_along(const std::vector<Root<RuntimeUnknowns>>& roots,
                                             const SystemFamily& family, std::span<const std::complex<double>> from,
                                             std::span<const std::complex<double>> to, const RunOptions& run,
                                             const TrackerOptions& options, MoreDigits<ArcHomotopy> resort) {
    options.validate();
    KnownRoots::Points points;
    for (const auto& root : roots) {
        require(root.q.size() == family.sizes().unknowns, "unknowns of a root", root.q.size(),
                "must be as many as the family's");
        points.push_back(root.q);
    }
    Generator generator(run.seed);
    ComplexRoots<> y;
    for (int attempt = 0; attempt < 3; ++attempt) {
        const CoefficientPath path = CoefficientPath::between(family, from, to, generator);
        auto found = complex_roots(track(ArcHomotopy(path), KnownRoots(family.sizes(), points), run, options, resort));
        if (attempt == 0 || found.paths.failed < y.paths.failed) y = std::move(found);
        if (y.paths.failed == 0 || run.cancelled_anywhere()) break;
    }
    return y;
}

}  // namespace equilibria
