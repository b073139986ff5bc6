/// \file
/// What the step controls of all steppers have in common.
#pragma once

#include <equilibria/core/error.hpp>

namespace equilibria::detail {

/// Throws InvalidArgument that names the option unless 0 < smallest_step <= first_step <= largest_step,
/// 0 < largest_angle < most_angle (radians), most_corrections >= 2 and tolerance > 0.
template <class Options>
void require_step_control(const Options& o, double most_angle) {
    require(o.smallest_step > 0, "smallest_step", o.smallest_step, "must be positive");
    require(o.first_step >= o.smallest_step, "first_step", o.first_step, "must be at least smallest_step");
    require(o.largest_step >= o.first_step, "largest_step", o.largest_step, "must be at least first_step");
    require(o.largest_angle > 0 && o.largest_angle < most_angle, "largest_angle", o.largest_angle,
            "must be in (0, " + to_text(most_angle) + ")");
    require(o.most_corrections >= 2, "most_corrections", o.most_corrections, "must be at least 2");
    require(o.tolerance > 0, "tolerance", o.tolerance, "must be positive");
}

}  // namespace equilibria::detail
