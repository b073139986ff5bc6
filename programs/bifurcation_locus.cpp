// The bifurcation locus of the rotating chain of two links: Baillieul's Figure 3.2 and his tables 3.3.
//
//   bifurcation_locus --ratio 1.5 --alpha 0:1 --omega 0:5 --svg figure.svg --table tables
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "instances/locus/two_link_locus.hpp"
#include "instances/locus/two_link_proofs.hpp"
#include "support/command_line.hpp"
#include "support/locus_figure.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;
using Json = nlohmann::ordered_json;
using Kind = equilibria::SingularityKind;

/// Of the curve on which a point lies.
std::string_view name(Kind kind) { return to_string(curve_of(kind)); }

Json polygons(const equilibria::LocusRegion& region) {
    Json y = Json::array();
    for (const auto& polygon : region.polygons) {
        y.push_back(Json::array());
        for (const auto& p : polygon) y.back().push_back({p.x, p.y});
    }
    return y;
}

Json json(const equilibria::ProvedShare& share) { return {{"proved", share.proved}, {"of", share.of}}; }

std::string json(const Locus& locus, const std::optional<equilibria::LocusProof>& proof, double ratio) {
    Json out{{"ratio", ratio},
             {"alpha", {locus.window.x_low, locus.window.x_high}},
             {"omega", {locus.window.y_low, locus.window.y_high}},
             {"cusps", Json::array()},
             {"degenerate_pitchforks", Json::array()},
             {"curves", Json::array()},
             {"regions", Json::array()}};
    for (const auto& c : locus.of(Kind::cusp))
        out["cusps"].push_back({{"alpha", c.x()},
                                {"omega", c.y()},
                                {"residual", c.residual},
                                {"angles", {c.q[0], c.q[1]}},
                                {"fourth_derivative", c.derivative(4)}});
    for (const auto& p : locus.of(Kind::tricritical_pitchfork))
        out["degenerate_pitchforks"].push_back({{"alpha", p.x()}, {"omega", p.y()}, {"angles", {p.q[0], p.q[1]}}});
    for (const auto& curve : locus.curves) {
        Json points = Json::array();
        for (const auto& p : curve.points) points.push_back({p.x(), p.y()});
        out["curves"].push_back({{"kind", name(curve.kind)}, {"points", std::move(points)}});
    }
    for (const auto& r : locus.regions)
        out["regions"].push_back({{"count", r.count},
                                  {"by_index", r.by_index},
                                  {"point", {r.point.x, r.point.y}},
                                  {"area", r.area},
                                  {"confirmed", r.confirmed && r.clean},
                                  {"polygons", polygons(r)}});
    out["borders"] = Json::array();
    for (const auto& b : locus.borders)
        out["borders"].push_back(
            {{"regions", {b.below, b.above}}, {"curve", b.curve}, {"kind", name(locus.curves[b.curve].kind)}});
    const auto& e = locus.evidence;
    out["extremal"] = Json::array();
    for (const auto& p : locus.of(Kind::extremal_fold, Kind::extremal_pitchfork))
        out["extremal"].push_back({{"kind", name(p.kind)},
                                   {"of", p.extremal == Chain::alpha ? "alpha" : "omega"},
                                   {"alpha", p.x()},
                                   {"omega", p.y()},
                                   {"angles", {p.q[0], p.q[1]}}});
    out["argument"] = locus.argument();
    out["evidence"] = {{"lines", e.lines},
                       {"seeds", e.seeds},
                       {"failed_paths", e.all_failed_paths()},
                       {"unsolved_points", e.unsolved_points},
                       {"untraced_seeds", e.untraced_seeds},
                       {"unseeded_crossings", e.unseeded_crossings},
                       {"broken_curves", e.broken_curves},
                       {"checked_points", e.checked_points},
                       {"wrong_counts", e.wrong_counts},
                       {"complete", e.complete()},
                       {"seconds", e.seconds}};
    if (proof)
        out["proof"] = {{"folds", json(proof->folds)},
                        {"pitchforks", json(proof->pitchforks)},
                        {"cusps", json(proof->cusps)},
                        {"extremal", json(proof->extremal)},
                        {"degenerate_pitchforks", json(proof->degenerate_pitchforks)},
                        {"regions", json(proof->regions)},
                        {"largest_radius", proof->largest_radius},
                        {"seconds", proof->seconds}};
    return out.dump(1) + "\n";
}

void print(const Locus& locus, const std::optional<equilibria::LocusProof>& proof) {
    for (const auto& c : locus.of(Kind::cusp))
        std::printf("cusp       alpha %.14f  omega %.14f  residual %.1e\n", c.x(), c.y(), c.residual);
    for (const auto& p : locus.of(Kind::tricritical_pitchfork))
        std::printf("degenerate pitchfork  alpha %.12f  omega %.12f\n", p.x(), p.y());
    for (const auto& c : locus.curves)
        std::printf("%-9s  %4zu points  (%.6f, %.6f) to (%.6f, %.6f)\n", std::string(name(c.kind)).c_str(),
                    c.points.size(), c.points.front().x(), c.points.front().y(), c.points.back().x(),
                    c.points.back().y());
    for (const auto& r : locus.regions) {
        std::printf("region     %2llu equilibria, by index", static_cast<unsigned long long>(r.count));
        for (const auto k : r.by_index) std::printf(" %lld", static_cast<long long>(k));
        std::printf("  around (%.4f, %.4f)%s\n", r.point.x, r.point.y, r.clean && r.confirmed ? "" : "  NOT CONFIRMED");
    }
    const auto& e = locus.evidence;
    std::printf("%llu lines solved, %llu events on them, %llu counts checked: %s\n",
                static_cast<unsigned long long>(e.lines), static_cast<unsigned long long>(e.seeds),
                static_cast<unsigned long long>(e.checked_points),
                e.complete() ? "all explained" : "NOT ALL EXPLAINED");
    std::printf("argument: %s\n", locus.argument().c_str());
    if (proof) {
        std::ostringstream shares;
        shares << *proof;
        std::printf("proved: %s; within %.1e of the window, in %.2f s\n", shares.str().c_str(), proof->largest_radius,
                    proof->seconds);
    }
    std::printf("%.2f s\n", e.seconds);
}

/// A window around a cusp that shows both branches of its fold curve, and no further than the nearest border is.
equilibria::PlaneWindow around(const equilibria::Singularity<Chain>& c, const Locus& locus) {
    const auto& w = locus.window;
    const double x_reach = std::min({0.011 * w.width(), c.x() - w.x_low, w.x_high - c.x()});
    const double y_reach = std::min({0.055 * w.height(), c.y() - w.y_low, w.y_high - c.y()});
    equilibria::PlaneWindow box{c.x(), c.x(), c.y(), c.y()};
    for (const auto& curve : locus.curves) {
        const auto at = std::find_if(curve.points.begin(), curve.points.end(),
                                     [&](const auto& p) { return p.x() == c.x() && p.y() == c.y(); });
        if (at == curve.points.end()) continue;
        const auto add = [&](const auto& p) {
            const bool near = std::abs(p.x() - c.x()) <= x_reach && std::abs(p.y() - c.y()) <= y_reach;
            if (near)
                box = {std::min(box.x_low, p.x()), std::max(box.x_high, p.x()), std::min(box.y_low, p.y()),
                       std::max(box.y_high, p.y())};
            return !near;
        };
        std::find_if(at, curve.points.end(), add);
        std::find_if(std::make_reverse_iterator(at), curve.points.rend(), add);
    }
    const double dx = 0.15 * box.width() + 1e-9 * w.width(), dy = 0.15 * box.height() + 1e-9 * w.height();
    return {std::max(w.x_low, box.x_low - dx), std::min(w.x_high, box.x_high + dx), std::max(w.y_low, box.y_low - dy),
            std::min(w.y_high, box.y_high + dy)};
}

/// For an axis from `low` to `high`: `set format` and `set tics` with two to four round numbers, as powers of ten where
/// they are small.
std::string tics(char axis, double low, double high) {
    const double least = (high - low) / 3.5, power = std::pow(10, std::floor(std::log10(least)));
    const double step = power * (least <= 2 * power ? 2 : least <= 5 * power ? 5 : 10);
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    std::ostringstream out;
    out << "set format " << axis << " '";
    if (std::max(std::abs(low), std::abs(high)) < 1e-3)
        out << "%.0t×10^{%T}'\nset " << axis << "tics " << step << "\nset " << axis << "tics add ('0' 0)\n";
    else
        out << "%." << digits << "f'\nset " << axis << "tics " << step << '\n';
    return out.str();
}

/// The figure: curves, cusps, regions with their counts, and insets around the first two cusps.
std::string script(const Locus& locus, double ratio) {
    std::ostringstream out;
    out.precision(10);
    out << support::locus_blocks(locus);
    const auto& w = locus.window;
    const auto cusps = locus.of(Kind::cusp);
    const std::size_t insets = std::min<std::size_t>(2, cusps.size());
    const char* curves =
        "$pitchforks with lines lw 1.8 lc rgb '#0072b2' title 'pitchforks', "
        "$folds with lines lw 2.2 lc rgb '#d55e00' title 'folds', "
        "$cusps with points pt 7 ps 0.9 lc rgb 'black' title 'cusps'\n";
    out << "set multiplot title 'Bifurcation locus of the rotating two-link chain, {/:Italic l}_2 / {/:Italic l}_1 = "
        << ratio << "'\nset tics out nomirror\nset border 31 lw 0.8\n"
        << "set key at screen 0.5,0.02 center bottom horizontal samplen 2.5\n"
        << "set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)'\n"
        << "set ylabel '{/:Italic ω}' rotate by 0\n"
        << "set lmargin at screen 0.09\nset rmargin at screen " << (insets > 0 ? 0.64 : 0.96)
        << "\nset bmargin at screen 0.16\nset tmargin at screen 0.92\n";
    for (const auto& r : locus.regions)
        if (r.area > 1e-3 * w.width() * w.height())
            out << "set label '" << r.count << "' at " << r.point.x << ',' << r.point.y << " center font ',"
                << (support::crowded(r.point, locus, 0.022, 0.02) ? 12 : 17) << "'\n";
    for (std::size_t k = 0; k < insets; ++k) {  // a frame large enough to be seen, and the letter of the inset
        const auto& c = cusps[k];
        const auto box = around(cusps[k], locus);
        const double x_low = std::max(w.x_low, std::min(box.x_low, c.x() - 0.013 * w.width()));
        const double x_high = std::min(w.x_high, std::max(box.x_high, c.x() + 0.013 * w.width()));
        const double y_low = std::max(w.y_low, std::min(box.y_low, c.y() - 0.013 * w.height()));
        const double y_high = std::min(w.y_high, std::max(box.y_high, c.y() + 0.013 * w.height()));
        out << "set object " << k + 1 << " rectangle from " << x_low << ',' << y_low << " to " << x_high << ','
            << y_high << " front fillstyle empty border lc rgb 'gray40' lw 0.8\nset label '"
            << "ab"[k] << "' at " << x_low << ',' << y_high << " left offset 0.2,0.8 font ',13' tc rgb 'gray30'\n";
    }
    out << "plot [" << w.x_low << ':' << w.x_high << "][" << w.y_low << ':' << w.y_high << "] " << curves;
    out << "unset object\nunset label\nunset xlabel\nunset ylabel\nunset key\n"
        << "set lmargin at screen 0.75\nset rmargin at screen 0.97\nset tics font ',11'\n";
    for (std::size_t k = 0; k < insets; ++k) {
        const auto& c = cusps[k];
        const auto box = around(cusps[k], locus);
        const double top = insets == 1 ? 0.72 : k == 0 ? 0.87 : 0.45, bottom = top - (insets == 1 ? 0.36 : 0.29);
        std::ostringstream place;
        place.precision(4);
        if (c.x() > 0 && c.x() < 1e-3) {
            const double power = std::floor(std::log10(c.x()));
            place << c.x() / std::pow(10, power) << "·10^{" << power << '}';
        } else {
            place << c.x();
        }
        place.precision(6);
        place << ", {/:Italic ω} = " << c.y();
        out << "set tmargin at screen " << top << "\nset bmargin at screen " << bottom << "\nset label 1 '"
            << "ab"[k] << ": {/:Italic α} = " << place.str() << "' at graph 0.5,1.07 center font ',12'\n"
            << tics('x', box.x_low, box.x_high) << tics('y', box.y_low, box.y_high) << "plot [" << box.x_low << ':'
            << box.x_high << "][" << box.y_low << ':' << box.y_high << "] " << curves;
    }
    out << "unset multiplot\n";
    return out.str();
}

/// Tables 3.3: the numbers of equilibria by index wherever they differ, for alpha ratio > 1 and below.
struct Tables {
    std::string markdown, csv;
};
Tables tables(const Locus& locus, double ratio) {
    std::map<std::uint64_t, std::vector<std::int64_t>> found[2];  // above, below
    const auto& w = locus.window;
    for (const auto& r : locus.regions) found[r.point.x * ratio > 1 ? 0 : 1][r.count] = r.by_index;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 60; ++j) {
            const double alpha = w.x_low + w.width() * (i + 0.5) / 12, omega = w.y_low + w.height() * (j + 0.5) / 60;
            const auto set = equilibria::enumerate<Chain>({alpha, ratio, omega});
            if (set.clean()) found[alpha * ratio > 1 ? 0 : 1][set.real()] = set.by_index();
        }
    std::ostringstream markdown, csv;
    csv << "table,count,index_0,index_1,index_2\n";
    markdown
        << "# The rotating chain of two links, l2/l1 = " << ratio
        << ": equilibria by index\n\nAs in Baillieul's Figure 3.3; each column is a number of equilibria that occurs "
           "in the window alpha "
        << w.x_low << " to " << w.x_high << ", omega " << w.y_low << " to " << w.y_high << ".\n";
    for (int t = 0; t < 2; ++t) {
        if (found[t].empty()) continue;
        const char letter = t == 0 ? 'a' : 'b';
        markdown << "\n## Table 3.3(" << letter << "): alpha r " << (t == 0 ? "> 1" : "< 1") << "\n\n| index |";
        for (std::size_t k = 1; k <= found[t].size(); ++k) markdown << " C" << k << " |";
        markdown << "\n|---|";
        for (std::size_t k = 0; k < found[t].size(); ++k) markdown << "---|";
        for (std::size_t index = 0; index < 3; ++index) {
            markdown << "\n| " << index << " |";
            for (const auto& [count, by_index] : found[t]) markdown << ' ' << by_index[index] << " |";
        }
        markdown << "\n| total |";
        for (const auto& [count, by_index] : found[t]) markdown << ' ' << count << " |";
        markdown << '\n';
        for (const auto& [count, by_index] : found[t])
            csv << "3.3(" << letter << ")," << count << ',' << by_index[0] << ',' << by_index[1] << ',' << by_index[2]
                << '\n';
    }
    return {markdown.str(), csv.str()};
}

}  // namespace

int main(int argc, char** argv) {
    std::string ratio_text = "1.5", alpha_text = "0:1", omega_text = "0:5", lines_text = "12", seed_text = "1";
    std::string json_name, svg_name, png_name, table_name;
    CLI::App app{
        "Folds, pitchforks and cusps of the rotating chain of two links in the plane of alpha = m2 / (m1 + m2) and "
        "omega, "
        "and the regions between them with their equilibria by index (Baillieul, Figures 3.2 and 3.3)."};
    app.add_option("--ratio", ratio_text, "l2 / l1, positive (default 1.5)");
    app.add_option("--alpha", alpha_text, "the window's range of alpha, within 0:1 (default 0:1)");
    app.add_option("--omega", omega_text, "the window's range of omega (default 0:5)");
    app.add_option("--lines", lines_text, "lines in each direction that are solved for seeds, 2 to 1000 (default 12)");
    app.add_option("--seed", seed_text, "of the random start systems, an integer (default 1)");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--svg", svg_name, "draw the figure to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the figure to this PNG file (needs gnuplot)");
    bool prove = false;
    app.add_flag("--prove", prove,
                 "prove the points of curves, the cusps and the regions' equilibria (interval Newton, Krawczyk)");
    app.add_option("--table", table_name, "write tables 3.3 to NAME.md and NAME.csv");
    support::parse(app, "bifurcation_locus", argc, argv);

    const double ratio =
        support::number("--ratio", ratio_text, "must be a positive number", [](double r) { return r > 0; });
    const auto alpha = support::range("--alpha", alpha_text, "must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1);
    const auto omega = support::range("--omega", omega_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::LocusOptions options;
    options.lines = support::integer("--lines", lines_text, 2, 1000);
    run.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
    std::optional<support::OutputFile> json_file, svg_file, png_file, markdown_file, csv_file;
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);
    if (app.count("--table") > 0) {
        markdown_file.emplace("--table", table_name + ".md");
        csv_file.emplace("--table", table_name + ".csv");
    }
    try {
        const Locus locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>(
            {0.5, ratio, 1}, {alpha.low, alpha.high, omega.low, omega.high}, run, options);
        std::optional<equilibria::LocusProof> proof;
        if (prove) proof = equilibria::prove_locus<Chain, Chain::alpha, Chain::omega>(locus, run);
        if (svg_file)
            svg_file->write(
                equilibria::gnuplot("svg size 1000,760 font 'Helvetica,14' background 'white'", script(locus, ratio)));
        if (png_file)
            png_file->write(equilibria::gnuplot("pngcairo size 2000,1520 fontscale 1.8 linewidth 2 pointscale 2",
                                                script(locus, ratio)));
        if (markdown_file) {
            const Tables t = tables(locus, ratio);
            markdown_file->write(t.markdown);
            csv_file->write(t.csv);
        }
        if (json_file) json_file->write(json(locus, proof, ratio));
        if (!json_file || !json_file->to_stdout()) print(locus, proof);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bifurcation_locus: %s\n", error.what());
        return 1;
    }
}
