/// \file
/// The parallel driver: all paths of a homotopy, tracked to one record each; a path that fails is tracked again more
/// carefully, and no two paths may end at one regular root.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/paths/detail/path_problem.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/storage/checkpoint_error.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>

namespace equilibria {

namespace detail {

PathSet track_paths(const PolynomialHomotopy& homotopy, PathProblem problem, const RunOptions& run,
                    const TrackerOptions& options, MoreDigits<> resort);

}  // namespace detail

/// Tracks all paths from `start` and ends them. Of a cancelled run the paths that are not finished count as cancelled.
/// Throws InvalidArgument where `run` names a checkpoint: it keeps the enumeration of a model. Homotopies of a type of
/// one's own: own_homotopy.hpp.
template <class StartSystem>
PathSet track(const PolynomialHomotopy& homotopy, const StartSystem& start, const RunOptions& run = {},
              const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    return detail::track_paths(homotopy, {.start = StartPoints(start)}, run, options, resort);
}

/// The same of a model's homotopy, whose paths are tracked by code for it alone; what is left of them, near t = 1 and
/// where it is hard, is left to the same homotopy as data. streamed: a checkpoint alone keeps the endpoints. Throws
/// CheckpointError where the checkpoint that `run` names cannot be used.
template <class H, class StartSystem>
requires requires(const H& homotopy) { homotopy.polynomials(); }
PathSet track(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
              const TrackerOptions& options = {}, MoreDigits<> resort = nullptr, bool streamed = false) {
    detail::PathProblem problem{.start = StartPoints(start), .streamed = streamed};
    if (!run.checkpoint.empty()) problem.model = detail::model_fields<typename H::System>(homotopy.parameters());
    if constexpr (H::unrolls)
        problem.track_block = [&](std::span<const std::uint64_t> paths, detail::PathProblem::Ends ends) {
            track_lanes<Lanes<native_lanes>, false>(
                homotopy, options, paths, [&](std::uint64_t k) { return start.point(k); }, ends);
        };
    return detail::track_paths(homotopy.polynomials(), std::move(problem), run, options, resort);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/track_definitions.hpp>
#endif
