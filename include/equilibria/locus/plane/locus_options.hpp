/// \file
/// How a locus is searched for and traced.
#pragma once

#include <limits>

#include <equilibria/continuation/branch_options.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// How finely a locus is searched and traced.
struct LocusOptions {
    int lines = 12;   ///< lines in each direction that are solved beside the borders of the window, at least 2
    int checks = 20;  ///< points in each direction whose count is compared with their region's; 0: none
    /// Of the curves, in angles and in parts of the window; parameter_weight is set by it.
    BranchOptions branch{.first_step = 1e-3,
                         .largest_step = 0.006,
                         .largest_angle = 0.15,
                         .largest_miss = std::numeric_limits<double>::infinity()};
    int most_points = 20000;  ///< of one curve

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(lines >= 2 && lines <= 10000, "lines", lines, "must be 2 to 10000");
        require(checks >= 0 && checks <= 10000, "checks", checks, "must be 0 to 10000");
        require(most_points > 1, "most_points", most_points, "must be more than 1");
        branch.validate();
    }
};

}  // namespace equilibria
