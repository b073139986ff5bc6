/// \file
/// What is proved of a plane of two parameters as JSON and CSV: points of a locus, and cells of constant count.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/singular_point_output.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/locus/proof/prove_region.hpp>

namespace equilibria {

/// "proved", "of".
inline Json json_of(const ProvedShare& share) { return {{"proved", share.proved}, {"of", share.of}}; }

/// Shares of "folds", "pitchforks", "cusps", "extremal", "degenerate_pitchforks", "regions"; "largest_radius" (of the
/// parameters, in parts of the window), "seconds".
inline Json json_of(const LocusProof& proof) {
    return {{"folds", json_of(proof.folds)},
            {"pitchforks", json_of(proof.pitchforks)},
            {"cusps", json_of(proof.cusps)},
            {"extremal", json_of(proof.extremal)},
            {"degenerate_pitchforks", json_of(proof.degenerate_pitchforks)},
            {"regions", json_of(proof.regions)},
            {"largest_radius", proof.largest_radius},
            {"seconds", proof.seconds}};
}

/// The ranges of both parameters by their names, "count", "by_index", "argument".
inline Json json_of(const ProvedCell& cell, const AxisNames& names) {
    const auto& w = cell.window;
    return {{names.x, json_range(w.x.low, w.x.high)},
            {names.y, json_range(w.y.low, w.y.high)},
            {"count", cell.count},
            {"by_index", cell.by_index},
            {"argument", to_string(cell.argument)}};
}

/// The ranges of both parameters by their names, "proved_area_share", "undecided" (how many cells), "tested",
/// "enumerations", "seconds", "cells".
inline Json json_of(const RegionProof& proof, const AxisNames& names) {
    const auto& w = proof.window;
    Json out{{names.x, json_range(w.x.low, w.x.high)},
             {names.y, json_range(w.y.low, w.y.high)},
             {"proved_area_share", proof.proved_area_share},
             {"undecided", proof.undecided.size()},
             {"tested", proof.tested},
             {"enumerations", proof.enumerations},
             {"seconds", proof.seconds},
             {"cells", Json::array()}};
    for (const auto& cell : proof.cells) out["cells"].push_back(json_of(cell, names));
    return out;
}

/// A line a proved cell: the range of each parameter, x_low, x_high, y_low, y_high with their names for x and y; count,
/// argument, index_0, index_1, .. up to index_n.
inline CsvTable cells_csv(const RegionProof& proof, const AxisNames& names) {
    std::vector<std::string> columns;
    for (const std::string& name : {names.x, names.y})
        for (const char* end : {"_low", "_high"}) columns.push_back(name + end);
    columns.insert(columns.end(), {"count", "argument"});
    if (!proof.cells.empty()) add_index_columns(columns, static_cast<int>(proof.cells.front().by_index.size()) - 1);
    CsvTable table(columns);
    for (const auto& cell : proof.cells) {
        const auto& w = cell.window;
        table.add(CsvRow()
                      .add(w.x.low)
                      .add(w.x.high)
                      .add(w.y.low)
                      .add(w.y.high)
                      .add(cell.count)
                      .add(to_string(cell.argument))
                      .add_all(cell.by_index));
    }
    return table;
}

}  // namespace equilibria
