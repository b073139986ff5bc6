/// \file
/// Curves of cusps over three parameters as JSON and CSV.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/io/results/singular_point_output.hpp>
#include <equilibria/locus/space/cusp_locus_result.hpp>

namespace equilibria {

/// The three parameters by their names, then the singularity.
template <PotentialModel M>
Json json_of(const CuspTransition<M>& t, const AxisNames& names) {
    Json out{{"kind", kind_name(t.at.kind)},
             {names.z, json_of(t.at.z())},
             {names.x, json_of(t.at.x())},
             {names.y, json_of(t.at.y())}};
    add_keys(out, json_of(t.at));
    return out;
}

/// "points", each with the three parameters by their names, and "ends": why the curve has its first and its last one.
template <PotentialModel M>
Json json_of(const CuspCurve<M>& curve, const AxisNames& names) {
    Json points = Json::array();
    for (const auto& p : curve.points)
        points.push_back({{names.z, json_of(p.z())}, {names.x, json_of(p.x())}, {names.y, json_of(p.y())}});
    const auto name = [](CurveEnd end) { return end == CurveEnd::border ? "box" : to_string(end); };
    return {{"points", std::move(points)}, {"ends", {name(curve.ends[0]), name(curve.ends[1])}}};
}

/// The third parameter by its name, "cusps", "cusps_outside", "degenerate", "paths", "solutions", "attempts",
/// "given_up".
template <PotentialModel M>
Json json_of(const CuspPlane<M>& plane, const AxisNames& names) {
    Json cusps = Json::array(), given_up = Json::array();
    for (const auto& c : plane.cusps) cusps.push_back(point_json(c, names));
    for (const auto& g : plane.given_up)
        given_up.push_back({{names.z, json_of(g.z)}, {"failed", g.failed_paths}, {"solutions", g.solutions}});
    return {{names.z, json_of(plane.z)},
            {"cusps", std::move(cusps)},
            {"cusps_outside", plane.outside},
            {"degenerate", plane.degenerate},
            {"paths", json_of(plane.counts.paths)},
            {"solutions", plane.counts.solutions},
            {"attempts", plane.counts.attempts},
            {"given_up", std::move(given_up)}};
}

/// The ranges of the three parameters by their names, "cusp_curves", "transitions" (of all curves), "planes",
/// "argument", "complete", "seconds": see docs/output.md.
template <PotentialModel M>
Json json_of(const CuspLocus<M>& locus, const AxisNames& names) {
    const auto& box = locus.box;
    Json out{{names.z, json_range(box.z.low, box.z.high)},
             {names.x, json_range(box.x.low, box.x.high)},
             {names.y, json_range(box.y.low, box.y.high)}};
    for (const char* key : {"cusp_curves", "transitions", "planes"}) out[key] = Json::array();
    for (const auto& curve : locus.curves) {
        out["cusp_curves"].push_back(json_of(curve, names));
        for (const auto& t : curve.transitions) out["transitions"].push_back(json_of(t, names));
    }
    for (const auto& plane : locus.planes) out["planes"].push_back(json_of(plane, names));
    out["argument"] = locus.argument();
    out["complete"] = locus.complete();
    out["seconds"] = locus.evidence.seconds;
    return out;
}

/// A line a point of a curve: curve (from 0), the three parameters by their names, q1, .. (angles in radians, then
/// coordinates), fourth_derivative.
template <PotentialModel M>
CsvTable cusp_curves_csv(const CuspLocus<M>& locus, const AxisNames& names) {
    std::vector<std::string> columns{"curve", names.z, names.x, names.y};
    add_columns(columns, "q", n_unknowns<M>);
    columns.emplace_back("fourth_derivative");
    CsvTable table(columns);
    for (std::size_t k = 0; k < locus.curves.size(); ++k)
        for (const auto& p : locus.curves[k].points)
            table.add(CsvRow().add(k).add(p.z()).add(p.x()).add(p.y()).add_all(p.q).add(p.derivative(4)));
    return table;
}

}  // namespace equilibria
