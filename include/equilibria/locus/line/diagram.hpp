/// \file
/// Equilibria against one parameter: between two neighbouring events (folds, pitchforks and all others of the line) the
/// number of equilibria and their indices are constant, so each interval is enumerated at one point, and every
/// equilibrium is followed by arc length to both ends. The equilibria at a second point of the interval must lie on
/// these branches. Those that do not are followed as well; a branch that is not followed to its end is counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch_options.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/line/searched_model.hpp>

namespace equilibria {

/// Why a piece of a branch has no more points.
enum class PieceEnd {
    range,     ///< at an end of the parameter's range
    event,     ///< at an event
    infinity,  ///< far out, on its way to infinity: the equilibria at the event come from there
    stopped    ///< not followed to its end
};
/// The name, as above.
constexpr const char* to_string(PieceEnd end) {
    constexpr const char* names[] = {"range", "event", "infinity", "stopped"};
    return names[static_cast<int>(end)];
}

/// A piece of a branch between two events. M: the model, or RuntimeUnknowns.
template <class M>
struct BranchPiece {
    int index;  ///< of its equilibria
    /// An equilibrium of the piece.
    struct Point {
        double parameter;           ///< the active one's value
        UnknownArray<M, double> q;  ///< angles (radians), then coordinates
    };
    std::vector<Point> points;       ///< the parameter increases
    std::array<PieceEnd, 2> ends{};  ///< why it has its first point, and its last one
};

namespace detail {
std::string diagram_argument(std::size_t pieces, std::uint64_t unfollowed, std::uint64_t unplaced, std::uint64_t unmet);
}

/// The equilibria against one parameter: pieces of branches, and the events at which they begin and end.
template <class M>
struct BifurcationDiagram {
    std::vector<BranchPiece<M>> pieces;  ///< one for each equilibrium of each interval
    std::vector<LineEvent<M>> events;    ///< by parameter
    std::uint64_t failed_paths = 0;      ///< of the search for events
    EventSearch search;                  ///< the evidence for the events
    // what follows must be 0
    std::uint64_t unfollowed = 0;  ///< ends of pieces that are not ends of branches: PieceEnd::stopped
    std::uint64_t unplaced = 0;    ///< equilibria at the second points of the intervals that lay on no piece
    std::uint64_t unmet = 0;       ///< pieces that pass a second point where no equilibrium was enumerated

    /// Whether nothing speaks against all branches being there, from end to end.
    bool complete() const { return search.complete() && unfollowed + unplaced + unmet == 0; }
    /// What speaks for it, or against it, in words.
    std::string argument() const {
        return detail::diagram_argument(pieces.size(), unfollowed, unplaced, unmet) +
               "; events: " + search.argument(events.size());
    }
};

/// The equilibria of a model at p.
using EquilibriaAt =
    std::function<std::vector<Equilibrium<RuntimeUnknowns>>(const RuntimeArray<double>& p, const RunOptions& run)>;

/// Steps of the pieces, in radians, parts of the largest value of each coordinate, and parts of the range.
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
    y.search = found.search;
    y.unfollowed = found.unfollowed, y.unplaced = found.unplaced, y.unmet = found.unmet;
    for (const auto& event : found.events) y.events.push_back(detail::typed_event<M>(event));
    for (const auto& piece : found.pieces) {
        BranchPiece<M> typed{piece.index, {}, piece.ends};
        for (const auto& point : piece.points) typed.points.push_back({point.parameter, unknowns_from<M>(point.q)});
        y.pieces.push_back(std::move(typed));
    }
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/line/detail/diagram_definitions.hpp>
#endif
