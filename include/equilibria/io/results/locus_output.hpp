/// \file
/// A bifurcation locus in a plane of two parameters as JSON and CSV.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/io/results/singular_point_output.hpp>
#include <equilibria/locus/plane/locus_result.hpp>

namespace equilibria {

/// The word for it in JSON and CSV.
constexpr std::string_view end_name(CurveEnd end) { return end == CurveEnd::border ? "window" : to_string(end); }

/// "kind", "points" ([x, y] each) and "ends": why the curve has its first and its last point.
template <class M>
Json json_of(const LocusCurve<M>& curve) {
    Json points = Json::array();
    for (const auto& p : curve.points) points.push_back({json_of(p.x()), json_of(p.y())});
    return {{"kind", kind_name(curve.kind)},
            {"points", std::move(points)},
            {"ends", {end_name(curve.ends[0]), end_name(curve.ends[1])}}};
}

/// "points" ([x, y] each) and "ends".
inline Json json_of(const InfinityCurve& curve) {
    Json points = Json::array();
    for (const auto& p : curve.points) points.push_back({json_of(p.x), json_of(p.y)});
    return {{"points", std::move(points)}, {"ends", {end_name(curve.ends[0]), end_name(curve.ends[1])}}};
}

/// "count", "by_index", "point" (well inside), "area", "confirmed", "polygons": whose union is the region.
inline Json json_of(const LocusRegion& r) {
    Json polygons = Json::array();
    for (const auto& polygon : r.polygons) {
        polygons.push_back(Json::array());
        for (const auto& p : polygon) polygons.back().push_back({json_of(p.x), json_of(p.y)});
    }
    return {{"count", r.count},
            {"by_index", r.by_index},
            {"point", {json_of(r.point.x), json_of(r.point.y)}},
            {"area", r.area},
            {"confirmed", r.confirmed && r.clean},
            {"polygons", std::move(polygons)}};
}

/// What speaks against the locus being complete: "kind" and "point", [x, y], each.
inline Json faults_json(const LocusEvidence& e) {
    Json faults = Json::array();
    for (const auto& fault : e.faults)
        faults.push_back(
            {{"kind", to_string(fault.kind)}, {"point", {json_of(fault.point.x), json_of(fault.point.y)}}});
    return faults;
}

/// What speaks for the locus being complete, each by its count.
template <class M>
Json evidence_json(const Locus<M>& locus) {
    const auto& e = locus.evidence;
    return {{"lines", e.lines},
            {"seeds", e.seeds},
            {"failed_paths", e.all_failed_paths()},
            {"unsolved_points", e.unsolved_points},
            {"untraced_seeds", e.untraced_seeds},
            {"unseeded_crossings", e.unseeded_crossings},
            {"broken_curves", e.broken_curves},
            {"checked_points", e.checked_points},
            {"wrong_counts", e.wrong_counts},
            {"wrong_borders", e.wrong_borders},
            {"degenerate_lines", e.degenerate_lines},
            {"seeds_from_infinity", e.seeds_from_infinity},
            {"lines_from_infinity", e.lines_from_infinity},
            {"from_infinity", e.from_infinity},
            {"faults", faults_json(e)},
            {"complete", e.complete()},
            {"seconds", e.seconds}};
}

/// The ranges of both parameters by their names, "cusps", "degenerate_pitchforks", "curves", "from_infinity",
/// "regions", "borders", "extremal", "argument", "evidence": see docs/output.md.
template <class M>
Json json_of(const Locus<M>& locus, const AxisNames& names, const Sizes<M>& sizes = {}) {
    const auto& w = locus.window;
    Json out{{names.x, json_range(w.x.low, w.x.high)}, {names.y, json_range(w.y.low, w.y.high)}};
    for (const char* key :
         {"cusps", "degenerate_pitchforks", "curves", "from_infinity", "regions", "borders", "extremal"})
        out[key] = Json::array();
    for (const auto& cusp : locus.of(SingularityKind::cusp)) out["cusps"].push_back(cusp_json(cusp, names, sizes));
    for (const auto& p : locus.of(SingularityKind::tricritical_pitchfork))
        out["degenerate_pitchforks"].push_back(point_json(p, names, sizes));
    for (const auto& curve : locus.curves) out["curves"].push_back(json_of(curve));
    for (const auto& curve : locus.from_infinity) out["from_infinity"].push_back(json_of(curve));
    for (const auto& region : locus.regions) out["regions"].push_back(json_of(region));
    for (const auto& b : locus.borders)
        out["borders"].push_back(
            {{"regions", {b.below, b.above}},
             {"curve", b.curve},
             {"kind", b.curve < locus.curves.size() ? kind_name(locus.curves[b.curve].kind) : "from infinity"}});
    for (const auto& p : locus.of(SingularityKind::extremal_fold, SingularityKind::extremal_pitchfork))
        out["extremal"].push_back(extremal_json(p, names, sizes));
    out["argument"] = locus.argument();
    out["evidence"] = evidence_json(locus);
    return out;
}

/// A line a point of a curve: curve (from 0), kind, the parameters by their names, q1, .. (angles in radians, then
/// coordinates).
template <class M>
CsvTable curves_csv(const Locus<M>& locus, const AxisNames& names, const Sizes<M>& sizes = {}) {
    std::vector<std::string> columns{"curve", "kind", names.x, names.y};
    add_columns(columns, "q", sizes.unknowns);
    CsvTable table(columns);
    for (std::size_t k = 0; k < locus.curves.size(); ++k)
        for (const auto& p : locus.curves[k].points)
            table.add(CsvRow().add(k).add(kind_name(locus.curves[k].kind)).add(p.x()).add(p.y()).add_all(p.q));
    return table;
}

/// A line a region: region (from 0), the parameters of a point well inside by their names, area, count, confirmed,
/// index_0 to index_n.
template <class M>
CsvTable regions_csv(const Locus<M>& locus, const AxisNames& names, const Sizes<M>& sizes = {}) {
    std::vector<std::string> columns{"region", names.x, names.y, "area", "count", "confirmed"};
    add_index_columns(columns, sizes.unknowns);
    CsvTable table(columns);
    for (std::size_t k = 0; k < locus.regions.size(); ++k) {
        const auto& r = locus.regions[k];
        table.add(CsvRow()
                      .add(k)
                      .add(r.point.x)
                      .add(r.point.y)
                      .add(r.area)
                      .add(r.count)
                      .add(r.confirmed && r.clean)
                      .add_all(r.by_index));
    }
    return table;
}

}  // namespace equilibria
