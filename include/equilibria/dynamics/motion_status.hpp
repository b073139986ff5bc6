/// \file
/// How a motion ended, whatever was integrated.
#pragma once

namespace equilibria {

/// How a motion ended, or why its equations could not be solved.
enum class MotionStatus {
    finished,
    singular_mass_matrix,  ///< M(q) is not positive definite
    singular_constraints,  ///< the constraints' gradients are linearly dependent
    not_finite,            ///< a force or a state is not a finite number
    step_too_small,        ///< no step is small enough for the tolerance
    too_many_steps,        ///< `most_steps` were not enough
    cancelled,             ///< RunOptions::cancel was set
};

/// In words.
inline const char* to_string(MotionStatus status) {
    switch (status) {
        case MotionStatus::finished: return "finished";
        case MotionStatus::singular_mass_matrix: return "the mass matrix is singular";
        case MotionStatus::singular_constraints: return "the constraints are linearly dependent";
        case MotionStatus::not_finite: return "a number is not finite";
        case MotionStatus::step_too_small: return "no step is small enough";
        case MotionStatus::cancelled: return "cancelled";
        case MotionStatus::too_many_steps: break;
    }
    return "too many steps";
}

}  // namespace equilibria
