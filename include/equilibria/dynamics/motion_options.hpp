/// \file
/// How exactly a motion is integrated, by whatever equations.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// Of an integration: what a step may err by, and how far it may go.
struct MotionOptions {
    double relative_tolerance = 1e-12;      ///< of a step, for each number of the state
    double absolute_tolerance = 1e-12;      ///< the same where a number is near 0
    double largest_step = 0;                ///< in the model's unit of time; 0: no bound
    std::uint64_t most_steps = 10'000'000;  ///< tried in all

    /// Throws InvalidArgument.
    void validate() const {
        require(relative_tolerance >= 1e-15 && relative_tolerance < 1, "relative_tolerance", relative_tolerance,
                "must be from 1e-15 to 1");
        require(absolute_tolerance > 0 && std::isfinite(absolute_tolerance), "absolute_tolerance", absolute_tolerance,
                "must be positive");
        require(largest_step >= 0 && std::isfinite(largest_step), "largest_step", largest_step, "must be 0 or more");
        require(most_steps > 0, "most_steps", most_steps, "must be positive");
    }
};

namespace detail {

/// Throws InvalidArgument unless all times at which a motion is asked for are finite, none below start_time, none below
/// the one before it.
inline void require_rising_times(const std::vector<double>& times, double start_time) {
    double before = start_time;
    for (std::size_t k = 0; k < times.size(); ++k) {
        require(std::isfinite(times[k]) && times[k] >= before, "times[" + std::to_string(k) + "]", times[k],
                "must be finite, " + to_text(before) + " or more");
        before = times[k];
    }
}

}  // namespace detail

}  // namespace equilibria
