/// \file
/// What solving a system from a start will take, foretold by a sample of its paths: their number, time and memory.
///
/// Up to 128 paths of the total degree are tracked, spread over all of them, and their time is multiplied. Of a
/// polyhedral start, whose paths end at finite roots, the time of a step is taken instead; its search for cells is left
/// out. The prediction is good to a factor of about 5: it tells seconds from minutes, and minutes from hours.
#pragma once

#include <cstdint>
#include <optional>

#include <equilibria/core/compiled.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Paths, time and memory of a run.
struct PredictedWork {
    PathCount paths;                ///< to be tracked
    std::optional<double> seconds;  ///< of tracking with the executor of the run; nothing: not sampled
    double bytes = 0;               ///< of the endpoints and the start
};

/// The work of solve_from_start. fewest_sampled: with fewer paths no sample is tracked, and no time is predicted.
PredictedWork predicted_work(const SparseSystem& system, const StartChoice& start, const RunOptions& run = {},
                             std::int64_t fewest_sampled = 5000);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/predicted_work_definitions.hpp>
#endif
