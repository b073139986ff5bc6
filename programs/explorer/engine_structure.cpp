#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <equilibria/fem/structure.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/structure/structure_output.hpp>

#include "engine.hpp"
#include "support/buckling_cases.hpp"
#include "support/tracing.hpp"

namespace explorer {

namespace {

using equilibria::Json;
using equilibria::fem::StructureState;

/// A length for a picture: seven digits.
Json drawn(double x) {
    if (x == 0 || !std::isfinite(x)) return equilibria::json_of(x);
    const double unit = std::pow(10, 6 - std::floor(std::log10(std::abs(x))));
    return equilibria::json_of(std::round(x * unit) / unit);
}
/// Three numbers a node.
Json drawn(const std::vector<double>& places) {
    Json y = Json::array();
    for (std::size_t k = 0; k + 2 < places.size(); k += 3)
        y.push_back({drawn(places[k]), drawn(places[k + 1]), drawn(places[k + 2])});
    return y;
}

}  // namespace

std::string structure_document(Structure which) {
    support::CaseData data;
    data.elements = 12;  // as many as a picture needs
    const bool dome = which == Structure::star_dome;
    const support::BucklingCase buckling = dome ? support::star_dome(data) : support::right_angle_frame(data);
    const auto& structure = buckling.structure;
    support::Tracing<equilibria::fem::Structure> t{.name = dome ? "star_dome" : "right_angle_frame",
                                                   .how = {.parameter = buckling.parameter,
                                                           .names = {},
                                                           .measure =
                                                               [](const StructureState& q) {
                                                                   std::vector<double> y;
                                                                   for (const auto& frame : q.frames)
                                                                       y.insert(y.end(), frame.x.begin(),
                                                                                frame.x.end());
                                                                   return y;
                                                               },
                                                           .value = buckling.value}};
    equilibria::ContinuationOptions options = buckling.options;
    options.branch.largest_step = std::max(options.branch.first_step, 0.3 * options.branch.largest_step);
    trace(t, structure, {structure.initial(), options, buckling.amplitude, true, buckling.both_ways});

    // of the dome how far the apex comes down, of the frame how far the loaded end leaves its plane
    const std::size_t watched = 3 * static_cast<std::size_t>(buckling.tip) + 2;
    const std::vector<double> unloaded = t.how.measure(structure.initial());
    const auto displacement = [&](const std::vector<double>& places) {
        const double z = places[watched] - unloaded[watched];
        return equilibria::json_of(dome ? -z : z);
    };
    Json branches = Json::array();
    for (const auto& branch : t.branches) {
        Json points = Json::array();
        for (const auto& point : branch.points)
            points.push_back({{"load", equilibria::json_of(point.parameter)},
                              {"displacement", displacement(point.measures)},
                              {"stable", equilibria::json_or_null(point.stable)},
                              {"shape", drawn(point.measures)}});
        branches.push_back({{"parent", equilibria::json_or_null(branch.parent)},
                            {"end", branch.end},
                            {"points", std::move(points)},
                            {"events", Json::array()}});
    }
    std::vector<std::size_t> next(t.branches.size());  // a closed branch comes by the same loads again
    for (const auto& event : t.critical_points) {
        const auto number = event.json["branch"].get<std::size_t>();
        const double load = event.json["parameter"].get<double>();
        const auto& points = t.branches[number].points;
        std::size_t at = next[number];
        while (at + 1 < points.size() && points[at].parameter != load) ++at;
        branches[number]["events"].push_back({{"kind", event.json["kind"]}, {"load", load}, {"point", at}});
        next[number] = at + 1;
    }
    return Json{{"case", t.name},
                {"parameter", buckling.parameter},
                {"displacement", dome ? "of the apex, down" : "of the loaded end, out of the plane"},
                {"nodes", drawn(unloaded)},
                {"elements", equilibria::fem::element_lines(structure.model())},
                {"branches", std::move(branches)}}
        .dump();
}

}  // namespace explorer
