/// \file
/// The parallel driver: all paths of a homotopy, tracked to one record each; a path that fails is tracked again more
/// carefully, and no two paths may end at one regular root.
#pragma once

#include <concepts>
#include <utility>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/endpoint.hpp>
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

/// What a run tracks of a model at p. streamed: a checkpoint alone keeps the endpoints.
template <Model M, class StartSystem>
PathProblem model_problem(const StartSystem& start, const Parameters<M>& p, const RunOptions& run,
                          bool streamed = false) {
    PathProblem problem{.start = StartPoints(start), .streamed = streamed};
    if (run.is_told_apart()) problem.model = model_fields<M>(p);
    return problem;
}

/// Throws CheckpointError where the checkpoint that `run` names cannot be used.
PathSet track_paths(const PolynomialHomotopy& homotopy, PathProblem problem, const RunOptions& run,
                    const TrackerOptions& options, MoreDigits<> resort);

}  // namespace detail

/// Tracks all paths from `start` and ends them. Of a cancelled run the paths that are not finished count as cancelled.
/// Throws InvalidArgument where `run` names a checkpoint: it keeps the enumeration of a model. Homotopies of a type of
/// one's own: own_homotopy.hpp.
template <std::same_as<PolynomialHomotopy> H, class StartSystem>
PathSet track(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
              const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    return detail::track_paths(homotopy, {.start = StartPoints(start)}, run, options, resort);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/track_definitions.hpp>
#endif
