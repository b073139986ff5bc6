/// \file
/// The bifurcation locus of a model in a window of the plane of two of its parameters: fold and pitchfork curves,
/// cusps, and the regions between the curves with their equilibria counted by index.
///
/// Completeness. A curve that meets the window crosses its border, whose lines are solved for all their folds and
/// pitchforks, or is closed within; then it has a cusp, a degenerate pitchfork, or points at which a parameter is
/// extremal, and all of these are solved for (plane_solver.hpp). Every point solved for must lie on a curve, and every
/// special point of a curve must have been solved for. Lines inside the window are a further check, as are the numbers
/// of equilibria, enumerated at the points of a grid, which must be those of their regions. Models without a potential
/// have the lines alone.
#pragma once

#include <span>
#include <utility>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/locus/plane/locus_options.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// The locus of a model whose numbers of unknowns and parameters are known at run time; active: the numbers of x and y.
/// Arguments, result and errors as of the function for a model below.
Locus<RuntimeUnknowns> trace_locus(const SearchedModel& model, const RuntimeArray<double>& p,
                                   std::span<const int> active, const Window& window, const RunOptions& run = {},
                                   const LocusOptions& options = {});

/// The bifurcation locus of the model in the plane of its parameters number X and Y, the others being those of p.
/// resort: more_digits (enumerate/more_digits.hpp) tracks paths that fail in double with
/// more digits, instead of all paths from another start system; that saves time where there are thousands.
///
/// Throws InvalidArgument for a window that is empty, reversed or not finite, for parameters that are not finite for
/// options out of range, and for a run with a checkpoint or a cancel.
template <Model M, int X, int Y>
Locus<M> trace_locus(const Parameters<M>& p, const Window& window, const RunOptions& run = {},
                     const LocusOptions& options = {}, MoreDigits<> resort = nullptr) {
    static_assert(X != Y, "equilibria: a plane needs two different parameters");
    detail::check_active<M, X, Y>();
    constexpr int active[] = {X, Y};
    SearchedModel model = searched_model<M>();
    model.more_digits = resort;
    return typed<M>(trace_locus(model, runtime_array(p), active, window, run, options));
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/plane/detail/trace_locus_definitions.hpp>
#endif
