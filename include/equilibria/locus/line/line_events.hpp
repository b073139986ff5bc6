/// \file
/// All events on a line of the parameter space: the values of one parameter at which the number or the indices of the
/// equilibria change, and the equilibria between them.
///
/// Folds are the solutions of the critical system (critical_system.hpp), all complex ones, real ones kept and refined.
/// Pitchforks of symmetric branches are singular solutions of it; they are roots of one polynomial a branch
/// (symmetric_branches.hpp), which accounts for their paths. Other singular solutions are refined and named. What comes
/// from infinity is solved for by itself (infinity_search.hpp). Between each two events the equilibria are enumerated
/// at two points: their tables must be the same, and must differ from the next ones exactly by what the events say.
/// Where the two points of an interval disagree an event was missed: it is found by bisection, and named where that can
/// be.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/line/line_event.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// Parameter values between neighbouring events.
struct EventGap : Interval {
    double at = 0;                       ///< where the equilibria were enumerated
    double also_at = 0;                  ///< where they were enumerated again
    std::uint64_t count = 0;             ///< real equilibria there
    std::vector<std::int64_t> by_index;  ///< those of index 0, 1, .. n
    bool clean = false;                  ///< nothing speaks against the enumerations (RootSet::clean)
    bool confirmed = false;              ///< both have the same table
};

/// A search for events, whatever the model: its evidence.
struct EventSearch {
    RuntimeSizes sizes;               ///< of the model's unknowns
    Interval range;                   ///< of the active parameter
    std::vector<EventGap> intervals;  ///< one more than there are different values of events
    bool has_potential =
        true;  ///< the model: without one numbers of equilibria are compared with the events, not tables

    PathCounts paths;                     ///< of the critical system, in the last attempt
    std::string start;                    ///< the start system of these paths
    std::uint64_t attempts = 0;           ///< start systems tried until no path failed
    std::uint64_t complex_solutions = 0;  ///< of the critical system, distinct ones
    std::uint64_t regular_solutions = 0;  ///< of those: folds, real or not, in the segment or not
    std::uint64_t pitchfork_paths = 0;    ///< singular paths that end at pitchforks of symmetric branches
    std::uint64_t other_singular = 0;     ///< singular paths that end elsewhere, on no real event of the segment
    std::uint64_t unexplained = 0;   ///< real singular solutions in the segment that Newton's method did not confirm
    std::uint64_t compared = 0;      ///< values of events at which the tables were compared
    std::uint64_t wrong_tables = 0;  ///< values at which the tables do not differ by what the events say
    std::uint64_t unclean = 0;       ///< intervals whose enumerations are not clean
    std::uint64_t unconfirmed = 0;   ///< intervals whose two tables differ: an event in them is missing
    std::uint64_t bisected = 0;      ///< events that no path ended at: found since two tables of an interval differed
    std::uint64_t unnamed = 0;       ///< of those: not explained
    PathCounts infinity_paths;       ///< to infinity; none of a model without coordinates
    std::uint64_t infinity_values = 0;  ///< complex values of the parameter at which solutions come from there
    double solve_seconds = 0;           ///< for the critical system
    double seconds = 0;                 ///< for everything

    /// Whether nothing speaks against the list of events being complete.
    bool complete() const {
        return paths.failed + infinity_paths.failed + unexplained + wrong_tables + unclean + unconfirmed + unnamed == 0;
    }
    /// Why nothing is missing, or what speaks against it, in words; of so many events.
    std::string argument(std::size_t events) const;
};

/// All events on a line, with the evidence.
template <class M>
struct LineEvents : EventSearch {
    std::vector<LineEvent<M>> events;  ///< by value

    /// Why nothing is missing, or what speaks against it, in words.
    std::string argument() const { return EventSearch::argument(events.size()); }
};

namespace detail {

template <Model M>
LineEvent<M> typed_event(const LineEvent<RuntimeUnknowns>& e) {
    return {e.kind,
            e.value,
            unknowns_from<M>(e.q),
            unknowns_from<M>(e.v),
            e.residual,
            e.correction,
            e.reduced,
            e.slope,
            e.index,
            e.change,
            e.change_in_number,
            e.interval,
            e.at_infinity};
}

}  // namespace detail

/// The same search for a model whose numbers of unknowns and parameters are known at run time; active: the number of
/// the parameter. Arguments, result and errors as of the function for a model below.
LineEvents<RuntimeUnknowns> find_events(const SearchedModel& model, const RuntimeArray<double>& p, int active,
                                        const Interval& range, const RunOptions& run = {});

/// All events with the parameter number Active in `range`, the others those of p. The model must be polynomial in
/// that parameter.
///
/// Throws InvalidArgument for an interval that is empty, reversed or not finite, for parameters that are not finite,
/// and for a run with a checkpoint or a cancel: these are of one enumeration, and here are many.
template <Model M, int Active>
LineEvents<M> find_events(const Parameters<M>& p, const Interval& range, const RunOptions& run = {}) {
    static_assert(Active >= 0 && Active < n_parameters<M>, "equilibria: no such parameter");
    auto found = find_events(searched_model<M>(), runtime_array(p), Active, range, run);
    LineEvents<M> y{std::move(static_cast<EventSearch&>(found)), {}};
    for (const auto& event : found.events) y.events.push_back(detail::typed_event<M>(event));
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/line/detail/line_events_definitions.hpp>
#endif
