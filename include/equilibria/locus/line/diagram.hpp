/// \file
/// Equilibria against one parameter: between two neighbouring events (folds and pitchforks, all of the line's) the
/// number of equilibria and their indices are constant, so each interval is enumerated once, in its middle, and every
/// equilibrium is followed by arc length to both ends.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch_options.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/line/searched_model.hpp>

namespace equilibria {

/// A piece of a branch between two events. M: the model, or RuntimeUnknowns.
template <class M>
struct BranchPiece {
    int index;  ///< of its equilibria
    /// An equilibrium of the piece.
    struct Point {
        double parameter;           ///< the active one's value
        UnknownArray<M, double> q;  ///< angles (radians), then coordinates
    };
    std::vector<Point> points;  ///< the parameter increases
};

/// The equilibria against one parameter: pieces of branches, and the events at which they begin and end.
template <class M>
struct BifurcationDiagram {
    std::vector<BranchPiece<M>> pieces;  ///< one for each equilibrium of each interval
    std::vector<LineEvent<M>> events;    ///< by parameter
    std::uint64_t failed_paths = 0;      ///< of the search for events
};

/// The equilibria of a model at p.
using EquilibriaAt =
    std::function<std::vector<Equilibrium<RuntimeUnknowns>>(const RuntimeArray<double>& p, const RunOptions& run)>;

/// Steps of the pieces, in radians, the coordinates' units and parts of the range.
inline constexpr BranchOptions diagram_steps{.first_step = 1e-3, .largest_step = 0.02};

/// The diagram of a model whose numbers of unknowns and parameters are known at run time; active: the number of the
/// parameter, equilibria: their enumeration. Arguments, result and errors as of the function for a model below.
BifurcationDiagram<RuntimeUnknowns> trace_diagram(const SearchedModel& model, const EquilibriaAt& equilibria,
                                                  const RuntimeArray<double>& p, int active, const Interval& range,
                                                  const RunOptions& run = {}, BranchOptions branch = diagram_steps);

/// The equilibria for all values in [low, high] of the parameter number Active.
///
/// Throws InvalidArgument as find_events does.
template <Model M, int Active>
BifurcationDiagram<M> trace_diagram(const Parameters<M>& p, const Interval& range, const RunOptions& run = {},
                                    const BranchOptions& branch = diagram_steps) {
    static_assert(Active >= 0 && Active < n_parameters<M>, "equilibria: no such parameter");
    const auto equilibria = [](const RuntimeArray<double>& at, const RunOptions& how) {
        std::vector<Equilibrium<RuntimeUnknowns>> y;
        for (const auto& e : enumerate<M>(parameters_from<M>(at), how).equilibria) {
            Equilibrium<RuntimeUnknowns> one;
            one.q = runtime_array(e.q);
            one.index = e.index;
            y.push_back(std::move(one));
        }
        return y;
    };
    const auto found = trace_diagram(searched_model<M>(), equilibria, runtime_array(p), Active, range, run, branch);
    BifurcationDiagram<M> y;
    y.failed_paths = found.failed_paths;
    for (const auto& event : found.events) y.events.push_back(detail::typed_event<M>(event));
    for (const auto& piece : found.pieces) {
        BranchPiece<M> typed{piece.index, {}};
        for (const auto& point : piece.points) typed.points.push_back({point.parameter, unknowns_from<M>(point.q)});
        y.pieces.push_back(std::move(typed));
    }
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/line/detail/diagram_definitions.hpp>
#endif
