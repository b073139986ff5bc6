/// \file
/// What became of a path.
#pragma once

#include <cstdint>
#include <string_view>

namespace equilibria {

/// What became of a path.
enum class PathStatus : std::uint8_t {
    finite,       ///< a regular solution
    at_infinity,  ///< a coordinate, or the imaginary part of an angle, diverges: no equilibrium
    singular,     ///< a finite solution with a singular Jacobian, reached with a winding number or by several paths
    failed        ///< not finished; the reason says why
};

/// Why a path failed.
enum class FailureReason : std::uint8_t {
    none,              ///< the path did not fail
    step_too_small,    ///< the step control refused every step
    too_many_steps,    ///< as many as TrackerOptions::most_steps
    endgame_undecided  ///< near t = 1, neither finite, nor at infinity, nor singular could be shown
};

/// What polishing tells of an endpoint, measured where the last correction began.
struct PolishedEvidence {
    double residual = 0;    ///< max_i |F_i| / (largest coefficient of F_i)
    double condition = 0;   ///< of the Jacobian: equations against their terms, coordinates against 1 + |x|
    double correction = 0;  ///< the last Newton correction, largest change of an unknown
};

/// In words.
/// \{
constexpr std::string_view to_string(PathStatus status) {
    switch (status) {
        case PathStatus::finite: return "finite";
        case PathStatus::at_infinity: return "at infinity";
        case PathStatus::singular: return "singular";
        default: return "failed";
    }
}
constexpr std::string_view to_string(FailureReason reason) {
    switch (reason) {
        case FailureReason::none: return "none";
        case FailureReason::step_too_small: return "step too small";
        case FailureReason::too_many_steps: return "too many steps";
        default: return "endgame undecided";
    }
}
/// \}

}  // namespace equilibria
