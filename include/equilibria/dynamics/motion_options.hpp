/// \file
/// How exactly a motion is integrated, by whatever equations.
#pragma once

#include <cmath>
#include <cstdint>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// Of an integration: what a step may err by, and how far it may go.
struct MotionOptions {
    double relative_tolerance = 1e-12, absolute_tolerance = 1e-12;  ///< of a step, for each number of the state
    double largest_step = 0;                                        ///< in units of time; 0: no bound
    std::uint64_t most_steps = 10'000'000;

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

}  // namespace equilibria
