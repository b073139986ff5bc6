/// \file
/// Why a curve of singularities ends, in a plane of parameters or in a space of three.
#pragma once

namespace equilibria {

/// Why a curve of folds, pitchforks or cusps has no more points.
enum class CurveEnd {
    border,      ///< at the border of the window, or on a face of the box
    closed,      ///< where it began
    symmetric,   ///< on a symmetric branch, where it meets its mirror image
    degenerate,  ///< next to the border where the step control gave up: the model is degenerate on it (in space alone)
    infinity,    ///< a coordinate is a million times its usual size, 1e-3 of the window from a curve at infinity
    continuum,   ///< the unknowns move by .1, the parameters do not: equilibria are not isolated at this point
    step,        ///< the step control gave up elsewhere
    length       ///< too many points
};

/// The name, as above.
constexpr const char* to_string(CurveEnd end) {
    switch (end) {
        case CurveEnd::border: return "border";
        case CurveEnd::closed: return "closed";
        case CurveEnd::symmetric: return "symmetric";
        case CurveEnd::degenerate: return "degenerate";
        case CurveEnd::infinity: return "infinity";
        case CurveEnd::continuum: return "continuum";
        case CurveEnd::step: return "step";
        case CurveEnd::length: return "length";
    }
    return "unknown";
}

}  // namespace equilibria
