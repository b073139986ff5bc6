/// \file
/// See paths/track.hpp.
#pragma once

#include <utility>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/paths/detail/path_solver.hpp>
#include <equilibria/paths/track.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE PathSet track_paths(const PolynomialHomotopy& homotopy, PathProblem problem, const RunOptions& run,
                                      const TrackerOptions& options, MoreDigits<> resort) {
    return PathSolver<PolynomialHomotopy>(homotopy, std::move(problem), run, options, resort).track();
}

}  // namespace equilibria::detail
