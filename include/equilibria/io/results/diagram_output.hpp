/// \file
/// All equilibria against one parameter as JSON and CSV.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/line_events_output.hpp>
#include <equilibria/locus/line/diagram.hpp>

namespace equilibria {

/// "failed_paths", "unfollowed", "unplaced", "unmet", "argument", "complete", "events" (as of a line), "branches": each
/// with its "index", its "points", [parameter, q1, ..], and its "ends".
template <class M>
Json json_of(const BifurcationDiagram<M>& diagram, const std::string& parameter, const Sizes<M>& sizes = {}) {
    Json events = Json::array(), branches = Json::array();
    for (const auto& e : diagram.events) events.push_back(json_of(e, parameter, sizes));
    for (const auto& piece : diagram.pieces) {
        Json points = Json::array();
        for (const auto& p : piece.points) {
            points.push_back(json_list(p.q));
            points.back().insert(points.back().begin(), json_of(p.parameter));
        }
        branches.push_back({{"index", piece.index},
                            {"points", std::move(points)},
                            {"ends", {to_string(piece.ends[0]), to_string(piece.ends[1])}}});
    }
    return {{"failed_paths", diagram.failed_paths}, {"unfollowed", diagram.unfollowed},
            {"unplaced", diagram.unplaced},         {"unmet", diagram.unmet},
            {"argument", diagram.argument()},       {"complete", diagram.complete()},
            {"events", std::move(events)},          {"branches", std::move(branches)}};
}

/// A line a point: branch (from 0), index, the parameter by its name, q1, .. (angles in radians, then coordinates).
template <class M>
CsvTable diagram_csv(const BifurcationDiagram<M>& diagram, const std::string& parameter, const Sizes<M>& sizes = {}) {
    std::vector<std::string> columns{"branch", "index", parameter};
    add_columns(columns, "q", sizes.unknowns);
    CsvTable table(columns);
    for (std::size_t k = 0; k < diagram.pieces.size(); ++k)
        for (const auto& p : diagram.pieces[k].points)
            table.add(CsvRow().add(k).add(diagram.pieces[k].index).add(p.parameter).add_all(p.q));
    return table;
}

}  // namespace equilibria
