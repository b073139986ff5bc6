// The folds of the rotating chain of two links over alpha, omega and the ratio of its lengths: planes of constant
// ratio side by side, and the surface through them as an interactive page.
//
//   fold_surface --planes 1.1,1.2,1.5,1.7,1.9,2.2 --svg planes.svg --png planes.png
//   fold_surface --ratio 1.2:2.4 --slices 25 --html surface.html --plotly "$(scripts/plotly)"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/gnuplot.hpp>
#include <equilibria/io/plotly.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/torus.hpp>
#include <nlohmann/json.hpp>

#include "instances/locus/two_link_locus.hpp"
#include "support/command_line.hpp"
#include "support/locus_figure.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;
using equilibria::CurveEnd;
using equilibria::PlaneWindow;
using equilibria::SingularityKind;
using Json = nlohmann::ordered_json;

struct Vertex {
    double alpha, omega;
    std::array<double, 2> theta;
};

/// With the window as the unit of length and the half turn as that of angles. The mirror image of `b` where mirror is
/// -1.
double distance(const Vertex& a, const Vertex& b, const PlaneWindow& window, double mirror = 1) {
    const auto turn = [&](int i) {
        return equilibria::wrap(a.theta[i] - mirror * b.theta[i]) / std::numbers::pi;
    };
    return std::hypot(std::hypot((a.alpha - b.alpha) / window.width(), (a.omega - b.omega) / window.height()),
                      std::hypot(turn(0), turn(1)));
}

/// What of a curve of a plane lies between two of its cusps, or between a cusp and an end.
struct Piece {
    struct End {
        CurveEnd why;
        int cusp = -1;  ///< its number in the plane; -1: none, the curve itself ends
        bool like(const End& b) const { return cusp >= 0 || b.cusp >= 0 ? cusp >= 0 && b.cusp >= 0 : why == b.why; }
    };
    SingularityKind kind;
    std::array<End, 2> ends;
    std::vector<Vertex> points;

    bool closed() const { return ends[0].cusp < 0 && ends[0].why == CurveEnd::closed; }
    Piece reversed() const { return {kind, {ends[1], ends[0]}, {points.rbegin(), points.rend()}}; }
};

/// `points`, of which there are at least two, as `count` at equal distances.
std::vector<Vertex> resampled(const std::vector<Vertex>& points, int count, const PlaneWindow& window) {
    std::vector<double> length{0};
    for (std::size_t k = 1; k < points.size(); ++k)
        length.push_back(length.back() + distance(points[k - 1], points[k], window));
    std::vector<Vertex> y;
    std::size_t at = 0;
    for (int k = 0; k < count; ++k) {
        const double target = length.back() * k / (count - 1);
        while (at + 2 < points.size() && length[at + 1] < target) ++at;
        const double step = length[at + 1] - length[at];
        const double part = step > 0 ? std::clamp((target - length[at]) / step, 0., 1.) : 0;
        const Vertex &a = points[at], &b = points[at + 1];
        const auto mix = [&](double u, double v) { return u + part * (v - u); };
        const auto turned = [&](int i) {
            return a.theta[i] + part * equilibria::wrap(b.theta[i] - a.theta[i]);
        };
        y.push_back({mix(a.alpha, b.alpha), mix(a.omega, b.omega), {turned(0), turned(1)}});
    }
    return y;
}

/// The cusps of a locus by the points of the curve that they are.
std::map<std::size_t, int> cusps_on(const equilibria::LocusCurve<Chain>& curve, const Locus& locus) {
    constexpr double tolerance = 1e-8;
    std::map<std::size_t, int> found;
    if (curve.kind != SingularityKind::fold) return found;
    const auto cusps = locus.of(SingularityKind::cusp);
    for (std::size_t c = 0; c < cusps.size(); ++c)
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const auto &p = curve.points[k], &q = cusps[c];
            if (std::hypot((p.x() - q.x()) / locus.window.width(), (p.y() - q.y()) / locus.window.height()) <
                    tolerance &&
                (equilibria::same_unknowns<Chain>(p.q, q.q, 1e-6) ||
                 equilibria::same_unknowns<Chain>(p.q, equilibria::mirrored<Chain>(q.q), 1e-6))) {
                found.emplace(k, static_cast<int>(c));
                break;
            }
        }
    return found;
}

std::vector<Piece> pieces(const Locus& locus) {
    constexpr int samples = 61;
    std::vector<Piece> all;
    for (const auto& curve : locus.curves) {
        if (curve.points.size() < 2) continue;
        const auto cusps = cusps_on(curve, locus);
        std::vector<Piece> own{{curve.kind, {Piece::End{curve.ends[0]}, Piece::End{curve.ends[1]}}, {}}};
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const auto& p = curve.points[k];
            own.back().points.push_back({p.x(), p.y(), {p.q[0], p.q[1]}});
            const auto cusp = cusps.find(k);
            if (cusp == cusps.end() || k == 0 || k + 1 == curve.points.size()) continue;
            own.push_back({curve.kind,
                           {Piece::End{curve.ends[0], cusp->second}, own.back().ends[1]},
                           {own.back().points.back()}});
            own[own.size() - 2].ends[1].cusp = cusp->second;
        }
        if (const auto first = cusps.find(0); first != cusps.end() && curve.ends[0] == CurveEnd::closed) {
            own.front().ends[0].cusp = own.back().ends[1].cusp = first->second;
        } else if (own.size() > 1 && curve.ends[0] == CurveEnd::closed) {  // begins within a piece
            Piece& last = own.back();
            last.points.insert(last.points.end(), own.front().points.begin() + 1, own.front().points.end());
            last.ends[1] = own.front().ends[1];
            own.erase(own.begin());
        }
        for (Piece& piece : own) {
            piece.points = resampled(piece.points, samples, locus.window);
            all.push_back(std::move(piece));
        }
    }
    return all;
}

struct Plane {
    double ratio;
    Locus locus;
    std::vector<Piece> pieces;
};

/// The planes by their ratios, each traced when it is first asked for.
class Planes {
public:
    Planes(const PlaneWindow& window, const equilibria::RunOptions& run, const equilibria::LocusOptions& options)
        : window_(window), run_(run), options_(options) {}

    void trace(const std::vector<double>& ratios, const std::string& label) {
        support::ProgressBar bar(label);
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            bar.update(k, ratios.size());
            at(ratios[k]);
        }
    }
    const Plane& at(double ratio) {
        const auto known = planes_.find(ratio);
        if (known != planes_.end()) return known->second;
        Locus locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, ratio, 1}, window_, run_, options_);
        auto own = pieces(locus);
        return planes_.emplace(ratio, Plane{ratio, std::move(locus), std::move(own)}).first->second;
    }
    const PlaneWindow& window() const { return window_; }
    const std::map<double, Plane>& all() const { return planes_; }

private:
    PlaneWindow window_;
    equilibria::RunOptions run_;
    equilibria::LocusOptions options_;
    std::map<double, Plane> planes_;
};

/// `b`, turned and, where it is closed, begun so that its points are next to those of `a`; and how far they are at
/// most, which is infinite for pieces of different kinds or ends.
std::pair<double, Piece> fitted(const Piece& a, const Piece& b, const PlaneWindow& window) {
    std::pair<double, Piece> best{std::numeric_limits<double>::infinity(), b};
    if (a.kind != b.kind) return best;
    for (const bool reversed : {false, true}) {
        const Piece turned = reversed ? b.reversed() : b;
        if (!a.ends[0].like(turned.ends[0]) || !a.ends[1].like(turned.ends[1])) continue;
        const std::size_t n = turned.points.size() - 1, begins = a.closed() ? n : 1;
        for (std::size_t begin = 0; begin < begins; ++begin)
            for (const double mirror : {1., -1.}) {
                Piece candidate = turned;
                double most = 0;
                for (std::size_t k = 0; k <= n; ++k) {
                    if (begins > 1) candidate.points[k] = turned.points[(begin + k) % n];
                    most = std::max(most, distance(a.points[k], candidate.points[k], window, mirror));
                }
                if (most < best.first) best = {most, std::move(candidate)};
            }
    }
    return best;
}

/// For each of the pieces below the number of the one above that continues it, or -1. Two pieces belong together where
/// they are near, and every other piece is at least twice as far from either.
std::vector<int> matched(const std::vector<const Piece*>& below, const std::vector<Piece>& above,
                         const PlaneWindow& window) {
    constexpr double largest = 0.25;
    std::vector<std::vector<double>> far(below.size());
    for (std::size_t i = 0; i < below.size(); ++i)
        for (const Piece& piece : above) far[i].push_back(fitted(*below[i], piece, window).first);
    std::vector<int> found(below.size(), -1);
    for (std::size_t i = 0; i < below.size(); ++i)
        for (std::size_t j = 0; j < above.size(); ++j) {
            bool alone = far[i][j] < largest;
            for (std::size_t k = 0; k < below.size(); ++k) alone = alone && (k == i || 2 * far[i][j] <= far[k][j]);
            for (std::size_t k = 0; k < above.size(); ++k) alone = alone && (k == j || 2 * far[i][j] <= far[i][k]);
            if (alone) found[i] = static_cast<int>(j);
        }
    return found;
}

std::vector<const Piece*> pointers(const std::vector<Piece>& pieces) {
    std::vector<const Piece*> all;
    for (const Piece& piece : pieces) all.push_back(&piece);
    return all;
}

bool all_matched(const Plane& a, const Plane& b, const PlaneWindow& window) {
    const auto found = matched(pointers(a.pieces), b.pieces, window);
    return a.pieces.size() == b.pieces.size() && std::find(found.begin(), found.end(), -1) == found.end();
}

/// A sheet of the surface: pieces of successive planes.
struct Sheet {
    struct Row {
        double ratio;
        Piece piece;
    };
    std::vector<Row> rows;
    SingularityKind kind() const { return rows.front().piece.kind; }
};

struct Surface {
    std::vector<double> ratios;  ///< of all its planes
    std::vector<double> slices;  ///< of those whose curves are drawn: all but the ones that only make a gap smaller
    std::vector<Sheet> sheets;
    std::vector<support::Range> gaps;  ///< between planes some of whose curves do not continue each other
};

/// The neighbouring planes some of whose curves do not continue each other.
std::vector<support::Range> unmatched(Planes& planes, const std::vector<double>& ratios) {
    std::vector<support::Range> found;
    for (std::size_t k = 0; k + 1 < ratios.size(); ++k)
        if (!all_matched(planes.at(ratios[k]), planes.at(ratios[k + 1]), planes.window()))
            found.push_back({ratios[k], ratios[k + 1]});
    return found;
}

/// Joins the pieces of each plane to those of the last; what continues none begins a sheet.
std::vector<Sheet> joined(Planes& planes, const std::vector<double>& ratios) {
    std::vector<Sheet> sheets;
    std::vector<std::size_t> open;  // those that the last plane has reached
    for (const double ratio : ratios) {
        const auto& next = planes.at(ratio).pieces;
        std::vector<const Piece*> last;
        for (const std::size_t sheet : open) last.push_back(&sheets[sheet].rows.back().piece);
        const auto found = matched(last, next, planes.window());
        std::vector<std::size_t> reached;
        for (std::size_t j = 0; j < next.size(); ++j) {
            const auto at = std::find(found.begin(), found.end(), static_cast<int>(j));
            if (at == found.end()) {
                reached.push_back(sheets.size());
                sheets.push_back({{{ratio, next[j]}}});
            } else {
                reached.push_back(open[static_cast<std::size_t>(at - found.begin())]);
                auto& rows = sheets[reached.back()].rows;
                rows.push_back({ratio, fitted(rows.back().piece, next[j], planes.window()).second});
            }
        }
        open = std::move(reached);
    }
    return sheets;
}

/// Through planes at equal distances, and through more where two do not match: the one between, `bisections` times.
Surface surface(Planes& planes, const support::Range& range, int slices, int bisections) {
    Surface y;
    for (int k = 0; k < slices; ++k) y.slices.push_back(range.low + (range.high - range.low) * k / (slices - 1));
    planes.trace(y.slices, "planes");
    y.ratios = y.slices;
    y.gaps = unmatched(planes, y.ratios);
    for (int round = 0; round < bisections && !y.gaps.empty(); ++round) {
        std::vector<double> middle;
        for (const auto& gap : y.gaps) middle.push_back((gap.low + gap.high) / 2);
        planes.trace(middle, "planes in gaps, " + std::to_string(round + 1) + " of " + std::to_string(bisections));
        y.ratios.insert(y.ratios.end(), middle.begin(), middle.end());
        std::sort(y.ratios.begin(), y.ratios.end());
        y.gaps = unmatched(planes, y.ratios);
    }
    for (const auto& gap : y.gaps) y.slices.insert(y.slices.end(), {gap.low, gap.high});
    std::sort(y.slices.begin(), y.slices.end());
    y.slices.erase(std::unique(y.slices.begin(), y.slices.end()), y.slices.end());
    y.sheets = joined(planes, y.ratios);
    return y;
}

double rounded(double value) { return std::round(value * 1e7) / 1e7; }

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
std::set<std::size_t> lighter(const std::vector<Sheet>& sheets) {
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

Json sheet_trace(const Sheet& sheet, bool light, bool first) {
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
Json plane_trace(const Planes& planes, const Surface& surface, SingularityKind kind) {
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
Json cusp_trace(const Surface& surface) {
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

std::string listed(const std::vector<double>& ratios) {
    std::ostringstream out;
    for (const double ratio : ratios) out << (out.str().empty() ? "" : ", ") << ratio;
    return out.str();
}

std::vector<double> incomplete(const Planes& planes) {
    std::vector<double> ratios;
    for (const auto& [ratio, plane] : planes.all())
        if (!plane.locus.evidence.complete()) ratios.push_back(ratio);
    return ratios;
}

equilibria::PlotlyView view(const Planes& planes, const Surface& surface) {
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

/// How the panels of a figure lie, in pixels of the SVG.
struct Layout {
    static constexpr double panel_width = 300, panel_height = 250, across = 26, down = 48;
    static constexpr double left = 74, right = 22, top = 86, bottom = 134;
    std::size_t columns, rows;

    explicit Layout(std::size_t count)
        : columns(count <= 3   ? count
                  : count == 4 ? 2
                  : count <= 9 ? 3
                               : 4),
          rows((count + columns - 1) / columns) {}
    double width() const { return left + right + static_cast<double>(columns) * (panel_width + across) - across; }
    double height() const { return top + bottom + static_cast<double>(rows) * (panel_height + down) - down; }
    std::string terminal_size(int scale) const {
        return std::to_string(static_cast<int>(scale * width())) + ',' +
               std::to_string(static_cast<int>(scale * height()));
    }
    std::string margins(std::size_t column, std::size_t row) const {
        const double x = left + static_cast<double>(column) * (panel_width + across);
        const double y = height() - top - static_cast<double>(row) * (panel_height + down);
        std::ostringstream out;
        out << "set lmargin at screen " << x / width() << "\nset rmargin at screen " << (x + panel_width) / width()
            << "\nset tmargin at screen " << y / height() << "\nset bmargin at screen " << (y - panel_height) / height()
            << '\n';
        return out.str();
    }
};

std::string cusp_count(const Locus& locus) {
    const std::size_t n = locus.of(SingularityKind::cusp).size();
    return n == 0 ? "no cusp" : n == 1 ? "1 cusp" : std::to_string(n) + " cusps";
}

struct Part {
    const char *block, *style;
};
constexpr std::array<Part, 3> parts{{{"pitchforks", "lines lw 1.6 lc rgb '#0072b2'"},
                                     {"folds", "lines lw 2 lc rgb '#d55e00'"},
                                     {"cusps", "points pt 7 ps 0.7 lc rgb 'black'"}}};

std::string panel(const Plane& plane, std::size_t k, std::size_t count) {
    const Layout layout(count);
    const auto& locus = plane.locus;
    const auto& w = locus.window;
    const bool leftmost = k % layout.columns == 0, lowest = k + layout.columns >= count;
    std::ostringstream out;
    out.precision(10);
    out << layout.margins(k % layout.columns, k / layout.columns) << "set title '{/:Italic r} = " << plane.ratio << ", "
        << cusp_count(locus) << (locus.evidence.complete() ? "" : ", NOT COMPLETE") << "' offset 0,-0.6 font ',13'\n"
        << (lowest
                ? "set format x '%g'\nset xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)'\n"
                : "set format x ''\nunset xlabel\n")
        << (leftmost ? "set format y '%g'\nset ylabel '{/:Italic ω}' rotate by 0\n"
                     : "set format y ''\nunset ylabel\n");
    for (const auto& r : locus.regions)
        if (const auto digits = static_cast<double>(std::to_string(r.count).size());
            r.area > 0.01 * w.width() * w.height() && !support::crowded(r.point, locus, 0.01 + 0.012 * digits, 0.027))
            out << "set label '" << r.count << "' at " << r.point.x << ',' << r.point.y
                << " center font ',12' tc rgb 'gray30'\n";
    out << "plot [" << w.x_low << ':' << w.x_high << "][" << w.y_low << ':' << w.y_high << "] ";
    for (const Part& part : parts)
        out << (&part == &parts.front() ? "$" : ", $") << part.block << k << " with " << part.style;
    out << "\nunset label\n";
    return out.str();
}

/// One panel for each plane, all with the same axes, and a key for all.
std::string script(const std::vector<const Plane*>& planes) {
    const Layout layout(planes.size());
    std::ostringstream out;
    out.precision(10);
    for (std::size_t k = 0; k < planes.size(); ++k) out << support::locus_blocks(planes[k]->locus, std::to_string(k));
    out << "set multiplot\nset tics out nomirror font ',11'\nset border 31 lw 0.8\nunset key\n"
        << "set label 1 'Bifurcation loci of the rotating two-link chain, {/:Italic r} = {/:Italic l}_2 / {/:Italic "
           "l}_1' "
        << "at screen 0.5," << 1 - 28 / layout.height() << " center font ',16'\n";
    for (std::size_t k = 0; k < planes.size(); ++k) out << panel(*planes[k], k, planes.size());
    out << "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen "
        << 84 / layout.height() << "\nunset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\n"
        << "set label 'numbers: equilibria' at screen 0.5," << 16 / layout.height()
        << " center font ',12' tc rgb 'gray30'\n"
        << "set key center center horizontal Left reverse samplen 2.5\nplot [0:1][0:1] ";
    for (const Part& part : parts)
        out << (&part == &parts.front() ? "" : ", ") << "NaN with " << part.style << " title '" << part.block << '\'';
    out << "\nunset multiplot\n";
    return out.str();
}

std::string json(const Planes& planes, const std::optional<Surface>& surface) {
    const auto& w = planes.window();
    Json out{{"alpha", {w.x_low, w.x_high}}, {"omega", {w.y_low, w.y_high}}, {"planes", Json::array()}};
    for (const auto& [ratio, plane] : planes.all()) {
        Json cusps = Json::array();
        for (const auto& c : plane.locus.of(SingularityKind::cusp))
            cusps.push_back(
                {{"alpha", c.x()}, {"omega", c.y()}, {"residual", c.residual}, {"angles", {c.q[0], c.q[1]}}});
        out["planes"].push_back({{"ratio", ratio},
                                 {"cusps", std::move(cusps)},
                                 {"complete", plane.locus.evidence.complete()},
                                 {"argument", plane.locus.argument()},
                                 {"seconds", plane.locus.evidence.seconds}});
    }
    if (surface) {
        out["gaps"] = Json::array();
        for (const auto& gap : surface->gaps) out["gaps"].push_back({gap.low, gap.high});
    }
    return out.dump(1) + "\n";
}

void print(const Planes& planes, const std::optional<Surface>& surface) {
    for (const auto& [ratio, plane] : planes.all()) {
        const auto& e = plane.locus.evidence;
        std::printf("ratio %-10.10g  %-8s  %s  %.1f s\n", ratio, cusp_count(plane.locus).c_str(),
                    e.complete() ? "complete" : "NOT COMPLETE", e.seconds);
        for (const auto& c : plane.locus.of(SingularityKind::cusp))
            std::printf("  cusp  alpha %.14f  omega %.14f\n", c.x(), c.y());
        if (!e.complete()) std::printf("  %s\n", plane.locus.argument().c_str());
    }
    if (surface)
        for (const auto& gap : surface->gaps)
            std::printf("gap    ratio %.10g to %.10g: curves end there, or join in another way\n", gap.low, gap.high);
}

std::vector<double> plane_list(const std::string& text) {
    const auto count = 1 + std::count(text.begin(), text.end(), ',');
    const auto values = count <= 12 ? support::parsed_positive_list(text, static_cast<int>(count)) : std::nullopt;
    if (!values)
        support::fail("--planes", support::shown(text), "must be 1 to 12 positive numbers, with commas between");
    return *values;
}

/// The library's text, found to be usable before the long computation.
std::string library(const std::string& name) {
    std::string text;
    if (std::ifstream file(name, std::ios::binary); file && !std::filesystem::is_directory(name))
        text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    if (text.empty())
        support::fail("--plotly", support::shown(name),
                      "cannot be read; must be the file whose path scripts/plotly prints");
    try {
        equilibria::plotly_page({.title = "", .x = {""}, .y = {""}, .z = {""}, .traces = "[]"}, text);
    } catch (const std::exception& error) {
        support::fail("--plotly", name, error.what());
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    std::string planes_text = "1.1,1.2,1.5,1.7,1.9,2.2", ratio_text = "1.2:2.4", slices_text = "25",
                bisections_text = "4";
    std::string alpha_text = "0:1", omega_text = "0:5", lines_text = "4", seed_text = "1";
    std::string svg_name, png_name, html_name, plotly_name, json_name;
    CLI::App app{
        "The surface of folds of the rotating chain of two links over alpha = m2 / (m1 + m2), omega and ratio = "
        "l2 / l1: planes of constant ratio in one figure, and an interactive page."};
    app.add_option("--planes", planes_text, "the ratios of the figure's planes (default 1.1,1.2,1.5,1.7,1.9,2.2)");
    app.add_option("--svg", svg_name, "draw the planes to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the planes to this PNG file (needs gnuplot)");
    app.add_option("--ratio", ratio_text, "the surface's range of l2 / l1; slow below 1.15 (default 1.2:2.4)");
    app.add_option("--slices", slices_text, "planes of constant ratio of the surface, 2 to 1000 (default 25)");
    app.add_option("--bisections", bisections_text,
                   "how often the gap between planes whose curves do not match is halved, 0 to 20 (default 4)");
    app.add_option("--html", html_name, "write the surface as a page to this file");
    app.add_option("--plotly", plotly_name, "the library for the page: the file whose path scripts/plotly prints");
    app.add_option("--alpha", alpha_text, "the window's range of alpha, within 0:1 (default 0:1)");
    app.add_option("--omega", omega_text, "the window's range of omega (default 0:5)");
    app.add_option("--lines", lines_text, "lines in each direction that are solved for seeds, 2 to 1000 (default 4)");
    app.add_option("--seed", seed_text, "of the random start systems, an integer (default 1)");
    app.add_option("--json", json_name, "write the planes and their cusps to this file, or to stdout for -");
    support::parse(app, "fold_surface", argc, argv);

    const auto ratios = plane_list(planes_text);
    const auto ratio = support::range("--ratio", ratio_text, "must be LOW:HIGH, finite, with 0 < LOW < HIGH",
                                      std::numeric_limits<double>::min(), 1e6);
    const auto slices = support::integer("--slices", slices_text, 2, 1000);
    const auto bisections = support::integer("--bisections", bisections_text, 0, 20);
    const auto alpha = support::range("--alpha", alpha_text, "must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1);
    const auto omega = support::range("--omega", omega_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::LocusOptions options;
    options.checks = 0;
    options.lines = support::integer("--lines", lines_text, 2, 1000);
    run.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
    const bool with_surface = app.count("--html") > 0;
    if (with_surface != (app.count("--plotly") > 0))
        support::fail(with_surface ? "--html" : "--plotly", "",
                      with_surface ? "needs --plotly" : "has no use without --html");
    const std::string library_text = with_surface ? library(plotly_name) : "";
    std::optional<support::OutputFile> svg_file, png_file, html_file, json_file;
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);
    if (with_surface) html_file.emplace("--html", html_name);
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    try {
        Planes planes({alpha.low, alpha.high, omega.low, omega.high}, run, options);
        if (svg_file || png_file || !with_surface) {
            planes.trace(ratios, "planes");
            std::vector<const Plane*> shown;
            for (const double r : ratios) shown.push_back(&planes.at(r));
            const Layout layout(shown.size());
            const auto draw = [&](const std::string& terminal) { return equilibria::gnuplot(terminal, script(shown)); };
            if (svg_file)
                svg_file->write(
                    draw("svg size " + layout.terminal_size(1) + " font 'Helvetica,14' background 'white'"));
            if (png_file)
                png_file->write(
                    draw("pngcairo size " + layout.terminal_size(2) + " fontscale 1.8 linewidth 2 pointscale 2"));
        }
        std::optional<Surface> found;
        if (with_surface) {
            found = surface(planes, ratio, slices, bisections);
            html_file->write(equilibria::plotly_page(view(planes, *found), library_text));
        }
        if (json_file) json_file->write(json(planes, found));
        const auto to_stdout = [](const auto& file) { return file && file->to_stdout(); };
        if (!to_stdout(json_file) && !to_stdout(html_file) && !to_stdout(svg_file) && !to_stdout(png_file))
            print(planes, found);
        if (const auto wrong = incomplete(planes); !wrong.empty())
            std::fprintf(stderr, "fold_surface: NOT COMPLETE: ratio %s\n", listed(wrong).c_str());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fold_surface: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--planes 0
    fold_surface: --planes 0: must be 1 to 12 positive numbers, with commas between
--planes 1.5,
    fold_surface: --planes 1.5,: must be 1 to 12 positive numbers, with commas between
--planes 1.5,0
    fold_surface: --planes 1.5,0: must be 1 to 12 positive numbers, with commas between
--planes 1,2,3,4,5,6,7,8,9,10,11,12,13
    fold_surface: --planes 1,2,3,4,5,6,7,8,9,10,11,12,13: must be 1 to 12 positive numbers, with commas between
--ratio 0:3
    fold_surface: --ratio 0:3: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--ratio 3:1
    fold_surface: --ratio 3:1: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--ratio 1.5
    fold_surface: --ratio 1.5: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--slices 1
    fold_surface: --slices 1: must be an integer from 2 to 1000
--slices 9.5
    fold_surface: --slices 9.5: must be an integer from 2 to 1000
--bisections -1
    fold_surface: --bisections -1: must be an integer from 0 to 20
--alpha 0:1.5
    fold_surface: --alpha 0:1.5: must be LOW:HIGH with 0 <= LOW < HIGH <= 1
--omega 5:5
    fold_surface: --omega 5:5: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--lines 1
    fold_surface: --lines 1: must be an integer from 2 to 1000
--seed -1
    fold_surface: --seed -1: must be an integer from 0 to 18446744073709551615
--html good.html
    fold_surface: --html: needs --plotly
--plotly missing.js
    fold_surface: --plotly: has no use without --html
--html good.html --plotly missing.js
    fold_surface: --plotly missing.js: cannot be read; must be the file whose path scripts/plotly prints
--html good.html --plotly .
    fold_surface: --plotly .: cannot be read; must be the file whose path scripts/plotly prints
--svg missing/folder.svg
    fold_surface: --svg missing/folder.svg: cannot be written (No such file or directory); must be a file that can, or -
--svg good.svg --png .
    fold_surface: --png .: is a folder; must be a file that can be written
--json
    fold_surface: --json: must be followed by a value
--digits 12
    fold_surface: --digits: is not an option; --help lists them
*/
