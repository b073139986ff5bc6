/// \file
/// All events on a line of the parameter space, and the equilibria between them, as JSON and CSV.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/io/results/singular_point_output.hpp>
#include <equilibria/locus/line/line_events.hpp>

namespace equilibria {

/// One event; `parameter` names the active parameter, and is the key of its value.
template <class M>
Json json_of(const LineEvent<M>& e, const std::string& parameter, const Sizes<M>& sizes = {}) {
    Json out{{parameter, json_of(e.value)}, {"kind", kind_name(e.kind)}};
    add_unknowns<M>(out, e.q, sizes);
    add_keys(out, {{"null_vector", json_list(e.v)},
                   {"index", e.index},
                   {"change_by_index", e.change},
                   {"change_in_number", e.change_in_number ? Json(*e.change_in_number) : Json()},
                   {"interval", e.interval},
                   {"to_infinity", e.at_infinity[0]},
                   {"from_infinity", e.at_infinity[1]},
                   {"residual", json_of(e.residual)},
                   {"correction", json_of(e.correction)},
                   {"third_derivative", json_of(e.reduced.third)},
                   {"fourth_derivative", json_of(e.reduced.fourth)},
                   {"slope", json_of(e.slope)}});
    return out;
}

/// "low", "high", "at", "also_at", "count", "by_index", "clean", "confirmed".
inline Json json_of(const EventGap& i) {
    return {{"low", i.low},     {"high", i.high},         {"at", i.at},       {"also_at", i.also_at},
            {"count", i.count}, {"by_index", i.by_index}, {"clean", i.clean}, {"confirmed", i.confirmed}};
}

namespace detail {
template <class M>
Sizes<M> model_sizes(const LineEvents<M>& found) {
    if constexpr (std::is_same_v<M, RuntimeUnknowns>)
        return found.sizes;
    else
        return {};
}
}  // namespace detail

/// "low", "high", "events" (each with the tables "before" and "after", null beyond an end of the line), "intervals",
/// "paths", the counts of LineEvents, "argument", "complete", "solve_seconds", "seconds": see docs/output.md.
template <class M>
Json json_of(const LineEvents<M>& found, const std::string& parameter) {
    Json events = Json::array(), intervals = Json::array(), paths = json_of(found.paths);
    const auto table = [&](std::size_t k) {
        return k < found.intervals.size() ? Json(found.intervals[k].by_index) : Json(nullptr);
    };
    for (const auto& e : found.events) {
        events.push_back(json_of(e, parameter, detail::model_sizes(found)));
        events.back()["before"] = table(e.interval - 1);
        events.back()["after"] = table(e.interval);
    }
    for (const auto& i : found.intervals) intervals.push_back(json_of(i));
    paths["attempts"] = found.attempts;
    return {{"low", found.range.low},
            {"high", found.range.high},
            {"events", std::move(events)},
            {"intervals", std::move(intervals)},
            {"paths", std::move(paths)},
            {"complex_solutions", found.complex_solutions},
            {"regular_solutions", found.regular_solutions},
            {"pitchfork_paths", found.pitchfork_paths},
            {"other_singular", found.other_singular},
            {"unexplained", found.unexplained},
            {"compared", found.compared},
            {"wrong_tables", found.wrong_tables},
            {"unclean", found.unclean},
            {"unconfirmed", found.unconfirmed},
            {"bisected", found.bisected},
            {"unnamed", found.unnamed},
            {"infinity_paths", json_of(found.infinity_paths)},
            {"infinity_values", found.infinity_values},
            {"argument", found.argument()},
            {"complete", found.complete()},
            {"solve_seconds", found.solve_seconds},
            {"seconds", found.seconds}};
}

/// A line an event: its parameter by its name, kind, q1, .. (angles in radians, then coordinates), v1, .. (the unit
/// null vector), index, interval, residual, correction, third_derivative, fourth_derivative, slope.
template <class M>
CsvTable events_csv(const std::vector<LineEvent<M>>& events, const std::string& parameter, const Sizes<M>& sizes = {}) {
    std::vector<std::string> columns{parameter, "kind"};
    add_columns(columns, "q", sizes.unknowns);
    add_columns(columns, "v", sizes.unknowns);
    for (const char* column :
         {"index", "interval", "residual", "correction", "third_derivative", "fourth_derivative", "slope"})
        columns.emplace_back(column);
    CsvTable table(columns);
    for (const auto& e : events)
        table.add(CsvRow()
                      .add(e.value)
                      .add(kind_name(e.kind))
                      .add_all(e.q)
                      .add_all(e.v)
                      .add(e.index)
                      .add(e.interval)
                      .add(e.residual)
                      .add(e.correction)
                      .add(e.reduced.third)
                      .add(e.reduced.fourth)
                      .add(e.slope));
    return table;
}

/// A line an interval: low, high, at, count, clean, index_0, index_1, ..
template <class M>
CsvTable intervals_csv(const LineEvents<M>& found) {
    std::vector<std::string> columns{"low", "high", "at", "count", "clean"};
    add_index_columns(columns, detail::model_sizes(found).unknowns);
    CsvTable table(columns);
    for (const auto& i : found.intervals)
        table.add(CsvRow().add(i.low).add(i.high).add(i.at).add(i.count).add(i.clean).add_all(i.by_index));
    return table;
}

}  // namespace equilibria
