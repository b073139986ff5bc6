// The surface as an interactive page: sheets, curves at constant ratio, and the curve of cusps in which sheets meet.
#pragma once

#include <cmath>
#include <cstddef>
#include <equilibria/io/plotly.hpp>
#include <equilibria/io/results/json.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fold_surface/sheets.hpp"

namespace fold_surface {

using equilibria::Json;

inline double rounded(double value) { return std::round(value * 1e7) / 1e7; }

/// Alpha, the ratio and omega, as rows of a surface or as one line with gaps.
struct Coordinates {
    Json x = Json::array(), y = Json::array(), z = Json::array();

    void add(const Vertex& v, double ratio) {
        x.push_back(rounded(v.alpha)), y.push_back(rounded(ratio)), z.push_back(rounded(v.omega));
    }
    void gap() {
        for (Json* c : {&x, &y, &z}) c->push_back(nullptr);
    }
    Json trace(Json head) && {
        head["x"] = std::move(x), head["y"] = std::move(y), head["z"] = std::move(z);
        return head;
    }
};

/// The sheets, by their numbers, that are drawn lighter: of two that meet in cusps one.
inline std::set<std::size_t> lighter(const std::vector<Sheet>& sheets) {
    std::set<std::size_t> light;
    std::map<std::pair<double, int>, std::size_t> first;  // that ends at this cusp
    for (std::size_t k = 0; k < sheets.size(); ++k)
        for (const auto& row : sheets[k].rows)
            for (const auto& end : row.piece.ends)
                if (end.cusp >= 0)
                    if (const auto other = first.emplace(std::pair{row.ratio, end.cusp}, k).first->second;
                        other != k && !light.contains(other))
                        light.insert(k);
    return light;
}

inline Json sheet_trace(const Sheet& sheet, bool light, bool first) {
    const bool fold = sheet.kind() == SingularityKind::fold;
    const std::string name = fold ? "folds" : "pitchforks";
    const std::string colour = !fold ? "#0072b2" : light ? "#f0924c" : "#d55e00";
    Coordinates grid;
    for (const auto& [ratio, piece] : sheet.rows) {
        Coordinates row;
        for (const Vertex& v : piece.points) row.add(v, ratio);
        grid.x.push_back(row.x), grid.y.push_back(row.y), grid.z.push_back(row.z);
    }
    Json head{{"type", "surface"},
              {"name", name},
              {"legendgroup", name},
              {"showlegend", first},
              {"showscale", false},
              {"colorscale", {{0, colour}, {1, colour}}},
              {"lighting", {{"ambient", 0.85}, {"diffuse", 0.4}, {"specular", 0.05}, {"roughness", 0.9}}},
              {"opacity", fold ? 0.9 : 0.3}};
    if (!fold) head["visible"] = "legendonly";
    return std::move(grid).trace(head);
}

/// The curves of one kind in the planes that are drawn.
inline Json plane_trace(const Planes& planes, const Surface& surface, SingularityKind kind) {
    const bool fold = kind == SingularityKind::fold;
    Coordinates line;
    for (const double ratio : surface.slices)
        for (const Piece& piece : planes.all().at(ratio).pieces) {
            if (piece.kind != kind) continue;
            for (const Vertex& v : piece.points) line.add(v, ratio);
            line.gap();
        }
    Json head{{"type", "scatter3d"},
              {"mode", "lines"},
              {"name", fold ? "folds at constant <i>r</i>" : "pitchforks at constant <i>r</i>"},
              {"line", {{"width", 2}, {"color", fold ? "#7a3500" : "#00436b"}}}};
    if (!fold) head["visible"] = "legendonly";
    return std::move(line).trace(head);
}

/// Along the sheets that end at cusps, each step from plane to plane once.
inline Json cusp_trace(const Surface& surface) {
    Coordinates line;
    std::set<std::pair<double, int>> drawn;
    for (const Sheet& sheet : surface.sheets)
        for (const int end : {0, 1}) {
            const auto at = [&](const Sheet::Row& row) {
                return end == 0 ? row.piece.points.front() : row.piece.points.back();
            };
            for (std::size_t k = 0; k + 1 < sheet.rows.size(); ++k) {
                const auto &a = sheet.rows[k], &b = sheet.rows[k + 1];
                const int cusp = a.piece.ends[static_cast<std::size_t>(end)].cusp;
                if (cusp < 0 || !drawn.insert({a.ratio, cusp}).second) continue;
                line.add(at(a), a.ratio);
                line.add(at(b), b.ratio);
                line.gap();
            }
        }
    return std::move(line).trace(
        {{"type", "scatter3d"}, {"mode", "lines"}, {"name", "cusps"}, {"line", {{"width", 9}, {"color", "#000000"}}}});
}

inline std::string listed(const std::vector<double>& ratios) {
    std::ostringstream out;
    for (const double ratio : ratios) out << (out.str().empty() ? "" : ", ") << ratio;
    return out.str();
}

inline std::vector<double> incomplete(const Planes& planes) {
    std::vector<double> ratios;
    for (const auto& [ratio, plane] : planes.all())
        if (!plane.locus.evidence.complete()) ratios.push_back(ratio);
    return ratios;
}

inline equilibria::PlotlyView view(const Planes& planes, const Surface& surface) {
    const auto light = lighter(surface.sheets);
    Json traces = Json::array();
    for (const SingularityKind kind : {SingularityKind::fold, SingularityKind::pitchfork}) {
        bool first = true;
        for (std::size_t k = 0; k < surface.sheets.size(); ++k)
            if (const Sheet& sheet = surface.sheets[k]; sheet.kind() == kind && sheet.rows.size() > 1)
                traces.push_back(sheet_trace(sheet, light.contains(k), std::exchange(first, false)));
        if (kind == SingularityKind::fold) traces.push_back(cusp_trace(surface));
        traces.push_back(plane_trace(planes, surface, kind));
    }
    for (std::size_t k = traces.size(); k-- > 0;)
        if (traces[k]["x"].empty()) traces.erase(k);
    std::ostringstream subtitle;
    subtitle.precision(8);
    subtitle << "<i>α</i> = <i>m</i><sub>2</sub> / (<i>m</i><sub>1</sub> + <i>m</i><sub>2</sub>); traced in "
             << surface.ratios.size() << " planes of constant <i>r</i>";
    for (const auto& gap : surface.gaps)
        subtitle << (&gap == &surface.gaps.front() ? "; gaps, where curves end or join in another way: <i>r</i> = "
                                                   : ", ")
                 << gap.low << "–" << gap.high;
    if (const auto ratios = incomplete(planes); !ratios.empty())
        subtitle << "; <b>NOT COMPLETE at <i>r</i> = " << listed(ratios) << "</b>";
    return {"Folds of the rotating two-link chain, <i>r</i> = <i>l</i><sub>2</sub> / <i>l</i><sub>1</sub>",
            subtitle.str(),
            {"α"},
            {"r"},
            {"ω"},
            traces.dump()};
}

}  // namespace fold_surface
