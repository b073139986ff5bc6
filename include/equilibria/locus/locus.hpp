/// \file
/// The bifurcation locus of a model in a window of the plane of two of its parameters: fold and pitchfork curves, cusps,
/// and the regions between the curves with their equilibria counted by index.
///
/// Completeness. Every line of a grid is solved for all its folds and pitchforks (line_events.hpp), and every one of
/// these events is a seed that some curve must pass: a component of the locus is missed only if no line meets it, that
/// is, if it is smaller than the spacing of the lines in both directions. The curves are checked in turn: where they
/// cross a line the line must have an event. And the counts of equilibria, enumerated at the points of another grid,
/// must be those of their regions: a missed component that contains such a point is reported.
#pragma once

#include <equilibria/locus/locus_result.hpp>
#include <equilibria/locus/locus_tracer.hpp>

namespace equilibria {

/// The bifurcation locus of the model in the plane of its parameters number X and Y, the others being those of p.
///
/// Throws InvalidArgument for a window that is empty, reversed or not finite, for parameters that are not finite and for
/// options out of range.
template <Model M, int X, int Y>
Locus<M> trace_locus(const Parameters<M>& p, const PlaneWindow& window, const LocusOptions& options = {}) {
    static_assert(X != Y, "equilibria: a plane needs two different parameters");
    require_finite(p, "parameters");
    window.validate();
    options.validate();
    return detail::LocusTracer<M, X, Y>(p, window, options).run();
}

}  // namespace equilibria
