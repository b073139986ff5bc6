// The cusps of the rotating chain of two links as curves over alpha, ratio and omega, with what they meet in:
// swallowtails, lips, beak-to-beak, umbilics.
//
//   cusp_locus --ratio 1:3 --alpha 0:1 --omega 0:20 --svg figure.svg --json cusps.json
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/space/cusp_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <nlohmann/json.hpp>

#include "instances/locus/two_link_cusps.hpp"
#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::CuspLocus<Chain>;
using Transition = equilibria::CuspTransition<Chain>;
using Json = nlohmann::ordered_json;

/// With '_' for what is no letter.
std::string identifier(equilibria::SingularityKind kind) {
    std::string name = to_string(kind);
    for (char& c : name)
        if (c == ' ' || c == '-') c = '_';
    return name;
}

/// Here the border is a box's.
const char* name(equilibria::CurveEnd end) { return end == equilibria::CurveEnd::border ? "box" : to_string(end); }

Json json(const Transition& t) {
    Json out{{"kind", identifier(t.at.kind)},
             {"ratio", t.at.z()},
             {"alpha", t.at.x()},
             {"omega", t.at.y()},
             {"residual", t.at.residual},
             {"nullity", t.at.nullity},
             {"angles", {t.at.q[0], t.at.q[1]}}};
    // of the reduced potential, from the third; with two null vectors the cubic on their plane
    out["derivatives"] = Json::array();
    if (t.at.nullity == 2)
        for (const double c : t.at.cubic) out["derivatives"].push_back(c);
    else
        for (const double d : t.at.derivatives) out["derivatives"].push_back(d);
    if (t.at.kind == equilibria::SingularityKind::lips || t.at.kind == equilibria::SingularityKind::beak_to_beak)
        out["form"] = {t.at.form[0], t.at.form[1]};
    return out;
}

std::string json(const Locus& locus) {
    const auto& box = locus.box;
    Json out{{"ratio", {box.z_low, box.z_high}}, {"alpha", {box.x_low, box.x_high}}, {"omega", {box.y_low, box.y_high}},
             {"cusp_curves", Json::array()},     {"transitions", Json::array()},     {"planes", Json::array()}};
    for (const auto& curve : locus.curves) {
        Json points = Json::array();
        for (const auto& p : curve.points) points.push_back({{"ratio", p.z()}, {"alpha", p.x()}, {"omega", p.y()}});
        out["cusp_curves"].push_back(
            {{"points", std::move(points)}, {"ends", {name(curve.ends[0]), name(curve.ends[1])}}});
        for (const auto& t : curve.transitions) out["transitions"].push_back(json(t));
    }
    for (const auto& plane : locus.planes) {
        Json cusps = Json::array(), given_up = Json::array();
        for (const auto& c : plane.cusps)
            cusps.push_back({{"alpha", c.x()}, {"omega", c.y()}, {"angles", {c.q[0], c.q[1]}}});
        for (const auto& g : plane.given_up)
            given_up.push_back({{"ratio", g.z}, {"failed", g.failed_paths}, {"solutions", g.solutions}});
        const auto& paths = plane.counts.paths;
        out["planes"].push_back({{"ratio", plane.z},
                                 {"cusps", std::move(cusps)},
                                 {"cusps_outside", plane.outside},
                                 {"degenerate", plane.degenerate},
                                 {"paths",
                                  {{"total", paths.total},
                                   {"finite", paths.finite},
                                   {"at_infinity", paths.at_infinity},
                                   {"singular", paths.singular},
                                   {"failed", paths.failed}}},
                                 {"solutions", plane.counts.solutions},
                                 {"attempts", plane.counts.attempts},
                                 {"given_up", std::move(given_up)}});
    }
    out["argument"] = locus.argument();
    out["complete"] = locus.complete();
    out["seconds"] = locus.evidence.seconds;
    return out.dump(1) + "\n";
}

void print(const Locus& locus) {
    for (const auto& curve : locus.curves) {
        std::printf("curve of cusps, %zu points\n", curve.points.size());
        const std::pair<const char*, const equilibria::Singularity<Chain>&> ends[] = {
            {name(curve.ends[0]), curve.points.front()}, {name(curve.ends[1]), curve.points.back()}};
        for (const auto& [why, at] : ends)
            std::printf("  end           ratio %.15g  alpha %.15g  omega %.15g  (%s)\n", at.z(), at.x(), at.y(), why);
        for (const auto& t : curve.transitions)
            std::printf("  %-12s  ratio %.15g  alpha %.15g  omega %.15g  residual %.1e\n", to_string(t.at.kind),
                        t.at.z(), t.at.x(), t.at.y(), t.at.residual);
    }
    for (const auto& plane : locus.planes) {
        std::printf("plane ratio = %.15g: %zu cusps\n", plane.z, plane.cusps.size());
        for (const auto& c : plane.cusps)
            std::printf("  cusp          alpha %.15g  omega %.15g  angles %.12f %.12f\n", c.x(), c.y(), c.q[0], c.q[1]);
    }
    std::printf("%s\nargument: %s\n%.2f s\n", locus.complete() ? "all explained" : "NOT ALL EXPLAINED",
                locus.argument().c_str(), locus.evidence.seconds);
}

/// An axis of the figure: how far along it a value is drawn, and where ticks can be.
struct Axis {
    double (*scaled)(double);
    std::vector<double> ticks;
};
const Axis alpha_axis{[](double a) { return std::pow(std::max(a, 0.0), 0.25); },
                      {0, 1e-4, 0.002, 0.01, 0.04, 0.1, 0.2, 0.4, 0.6, 0.8, 1}};
const Axis omega_axis{[](double w) { return std::cbrt(w - 1); },
                      {0, 0.5, 0.9, 1, 1.01, 1.1, 1.4, 2, 3, 5, 10, 20, 50, 100, 1000}};

/// The argument of `set xtics`. Where the axis has too few ticks in the range there are five at equal distances.
std::string ticks(const Axis& axis, double low, double high) {
    std::vector<double> values;
    for (const double tick : axis.ticks)
        if (tick >= low && tick <= high) values.push_back(tick);
    if (values.size() < 3) {
        values.clear();
        for (int k = 0; k < 5; ++k) values.push_back(low + (high - low) * k / 4);
    }
    std::ostringstream out;
    for (const double value : values) {
        out << (out.str().empty() ? "('" : ", '");
        if (value == 1e-4)
            out << "10^{−4}";
        else
            out << value;
        out << "' " << axis.scaled(value);
    }
    return out.str() + ')';
}

/// The data of one panel, for `value`, which gives the place along its axis of what has alpha x and omega y.
std::string data(const Locus& locus, const std::string& panel, double ratio_low, double ratio_high, const auto& value) {
    std::ostringstream curves, planes, cusps, at_window, degenerate, other_ends, transitions;
    for (auto* s : {&curves, &planes, &cusps, &at_window, &degenerate, &other_ends, &transitions}) s->precision(12);
    for (const auto& plane : locus.planes) {
        if (plane.z >= ratio_low && plane.z <= ratio_high)
            planes << "-1e3 " << plane.z << "\n1e3 " << plane.z << "\n\n";
        for (const auto& c : plane.cusps) cusps << value(c) << ' ' << plane.z << '\n';
    }
    for (const auto& curve : locus.curves) {
        for (const auto& p : curve.points) curves << value(p) << ' ' << p.z() << '\n';
        curves << "\n\n";
        for (std::size_t k = 0; k < 2; ++k) {
            using End = equilibria::CurveEnd;
            if (curve.ends[k] == End::closed) continue;
            const auto& p = k == 0 ? curve.points.front() : curve.points.back();
            (curve.ends[k] == End::border       ? at_window
             : curve.ends[k] == End::degenerate ? degenerate
                                                : other_ends)
                << value(p) << ' ' << p.z() << '\n';
        }
        for (const auto& t : curve.transitions) transitions << value(t.at) << ' ' << t.at.z() << '\n';
    }
    std::string out;
    const std::pair<const char*, std::string> blocks[] = {
        {"curves", curves.str()},          {"planes", planes.str()},         {"cusps", cusps.str()},
        {"window", at_window.str()},       {"degenerate", degenerate.str()}, {"other", other_ends.str()},
        {"transitions", transitions.str()}};
    for (const auto& [name, rows] : blocks)
        out += equilibria::gnuplot_block(name + panel, rows.empty() ? "nan nan\n" : rows);
    return out;
}

/// Two panels over the ratio: alpha and omega. In their scales, the fourth root of alpha and the cube root of omega -
/// 1, the curve runs straight into its end at ratio 1.
std::string script(const Locus& locus) {
    using End = equilibria::CurveEnd;
    const auto& box = locus.box;
    // of the range of the ratio the part that the curves take, and a third of that above and below
    double low = box.z_high, high = box.z_low, slowest = box.y_high;
    bool at_window = false, at_degenerate = false, at_other = false;
    for (const auto& curve : locus.curves) {
        for (const auto& p : curve.points)
            low = std::min(low, p.z()), high = std::max(high, p.z()), slowest = std::min(slowest, p.y());
        for (const End end : curve.ends) {
            at_window = at_window || end == End::border;
            at_degenerate = at_degenerate || end == End::degenerate;
            at_other = at_other || (end != End::border && end != End::degenerate && end != End::closed);
        }
    }
    const bool any = low <= high;
    const double margin = any ? (high - low) / 3 : 0;
    low = any ? std::max(box.z_low, low - margin) : box.z_low;
    high = any ? std::min(box.z_high, high + margin) : box.z_high;
    // no pendulum leaves the vertical below omega = 1
    const double omega_low = slowest >= 1 && box.y_low < 1 && box.y_high > 1 ? 1 : box.y_low;

    std::ostringstream out, not_shown;
    out.precision(12);
    not_shown.precision(4);
    for (const auto& plane : locus.planes)
        if (plane.z < low || plane.z > high) not_shown << (not_shown.str().empty() ? "" : ", ") << plane.z;
    out << "set multiplot\nset tics out nomirror\nset border 31 lw 0.8\nset bmargin at screen 0.22\n"
        << "set tmargin at screen 0.9\nunset key\nset clip two\n"
        << "set label 'Cusps of the rotating two-link chain' at screen 0.5,0.965 center font ',16'\n";
    if (!not_shown.str().empty())
        out << "set label 'no cusps in planes at {/:Italic r} = " << not_shown.str()
            << "' at screen 0.97,0.925 right font ',11' tc rgb 'gray40'\n";
    struct Part {
        const char *block, *style, *title;
    };
    std::vector<Part> parts{{"planes", "lines dt 2 lw 0.8 lc rgb 'gray60'", "plane solved for all cusps"},
                            {"curves", "lines lw 2.6 lc rgb '#0072b2'", "cusps"},
                            {"cusps", "points pt 6 ps 0.9 lw 1.4 lc rgb 'black'", "solution in a plane"}};
    if (at_window) parts.push_back({"window", "points pt 5 ps 0.9 lc rgb '#0072b2'", "end: window"});
    if (at_degenerate) parts.push_back({"degenerate", "points pt 13 ps 1.3 lc rgb '#009e73'", "end: model degenerate"});
    if (at_other) parts.push_back({"other", "points pt 9 ps 1.2 lc rgb 'black'", "other end"});
    if (any) parts.push_back({"transitions", "points pt 7 ps 1 lc rgb '#d55e00'", "transition"});
    for (int panel = 0; panel < 2; ++panel) {
        const Axis& axis = panel == 0 ? alpha_axis : omega_axis;
        const auto value = [&](const auto& at) { return axis.scaled(panel == 0 ? at.x() : at.y()); };
        const double from = panel == 0 ? box.x_low : omega_low, to = panel == 0 ? box.x_high : box.y_high;
        const double left = axis.scaled(from), right = axis.scaled(to);
        const std::string number = std::to_string(panel);
        out << data(locus, number, low, high, value) << "set xtics " << ticks(axis, from, to) << '\n';
        for (const auto& curve : locus.curves)
            for (const auto& t : curve.transitions) {
                const double place = (value(t.at) - left) / (right - left);
                out << "set label \"" << to_string(t.at.kind) << "\\n{/:Italic r} = ";
                out.precision(7);
                out << t.at.z() << (panel == 0 ? ", {/:Italic α} = " : ", {/:Italic ω} = ")
                    << (panel == 0 ? t.at.x() : t.at.y());
                out.precision(12);
                out << "\" at " << value(t.at) << ',' << t.at.z()
                    << (place < 0.3   ? " left offset -3,2.2\n"
                        : place > 0.7 ? " right offset 3,2.2\n"
                                      : " center offset 0,2.2\n");
            }
        out << (panel == 0 ? "set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2),  scale of "
                             "{/:Italic α}^{ 1/4}'\nset ylabel '{/:Italic r} = {/:Italic l}_2 / {/:Italic l}_1'\n"
                             "set lmargin at screen 0.09\nset rmargin at screen 0.53\n"
                           : "set xlabel '{/:Italic ω},  scale of ({/:Italic ω} − 1)^{1/3}'\nunset ylabel\n"
                             "set lmargin at screen 0.58\nset rmargin at screen 0.97\n")
            << "plot [" << left << ':' << right << "][" << low << ':' << high << "] ";
        for (const Part& part : parts)
            out << (&part == &parts.front() ? "$" : ", $") << part.block << number << " with " << part.style;
        out << "\nunset label\n";
    }
    // the key in a frame of its own: in a panel it would be no wider than that
    out << "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen 0\nset tmargin at screen "
           "0.1\n"
        << "unset border\nunset tics\nunset xlabel\nset key center center horizontal Left reverse samplen 2\nplot "
           "[0:1][0:1] ";
    for (const Part& part : parts)
        out << (&part == &parts.front() ? "" : ", ") << "NaN with " << part.style << " title '" << part.title << '\'';
    out << "\nunset multiplot\n";
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    std::string ratio_text = "1:3", alpha_text = "0:1", omega_text = "0:20", planes_text = "9", seed_text = "1";
    std::string json_name, svg_name, png_name;
    CLI::App app{
        "All cusps of the rotating chain of two links, as curves over alpha = m2 / (m1 + m2), ratio = l2 / l1 and "
        "omega, "
        "with their swallowtails, lips, beak-to-beak and umbilics, and what could be missed."};
    app.add_option("--ratio", ratio_text, "the range of l2 / l1 (default 1:3)");
    app.add_option("--alpha", alpha_text, "the range of alpha, within 0:1 (default 0:1)");
    app.add_option("--omega", omega_text, "the range of omega (default 0:20)");
    app.add_option("--planes", planes_text,
                   "planes of constant ratio that are solved for all cusps, 2 to 1000 (default 9)");
    app.add_option("--seed", seed_text, "of the random start systems, an integer (default 1)");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--svg", svg_name, "draw the figure to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the figure to this PNG file (needs gnuplot)");
    support::parse(app, "cusp_locus", argc, argv);

    const auto ratio = support::range("--ratio", ratio_text, "must be LOW:HIGH, finite, with 0 < LOW < HIGH",
                                      std::numeric_limits<double>::min(), 1e6);
    const auto alpha = support::range("--alpha", alpha_text, "must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1);
    const auto omega = support::range("--omega", omega_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::CuspLocusOptions options;
    options.planes = support::integer("--planes", planes_text, 2, 1000);
    run.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
    std::optional<support::OutputFile> json_file, svg_file, png_file;
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);
    try {
        const Locus locus = equilibria::find_cusp_locus<Chain, Chain::alpha, Chain::omega, Chain::ratio>(
            {0.5, 1.5, 1}, {alpha.low, alpha.high, omega.low, omega.high, ratio.low, ratio.high}, run, options);
        if (svg_file)
            svg_file->write(
                equilibria::gnuplot("svg size 1150,620 font 'Helvetica,14' background 'white'", script(locus)));
        if (png_file)
            png_file->write(
                equilibria::gnuplot("pngcairo size 2300,1240 fontscale 1.8 linewidth 2 pointscale 2", script(locus)));
        if (json_file) json_file->write(json(locus));
        if (!json_file || !json_file->to_stdout()) print(locus);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cusp_locus: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--ratio 0:3
    cusp_locus: --ratio 0:3: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--ratio 3:1
    cusp_locus: --ratio 3:1: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--ratio 1.5
    cusp_locus: --ratio 1.5: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--ratio 1:inf
    cusp_locus: --ratio 1:inf: must be LOW:HIGH, finite, with 0 < LOW < HIGH
--alpha 0:1.5
    cusp_locus: --alpha 0:1.5: must be LOW:HIGH with 0 <= LOW < HIGH <= 1
--alpha nan:1
    cusp_locus: --alpha nan:1: must be LOW:HIGH with 0 <= LOW < HIGH <= 1
--omega -1:5
    cusp_locus: --omega -1:5: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--omega 5:5
    cusp_locus: --omega 5:5: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--planes 1
    cusp_locus: --planes 1: must be an integer from 2 to 1000
--planes 9.5
    cusp_locus: --planes 9.5: must be an integer from 2 to 1000
--seed -1
    cusp_locus: --seed -1: must be an integer from 0 to 18446744073709551615
--json missing/folder.json
    cusp_locus: --json missing/folder.json: cannot be written (No such file or directory); must be a file that can, or -
--json good.json --svg .
    cusp_locus: --svg .: is a folder; must be a file that can be written
--json
    cusp_locus: --json: must be followed by a value
--lines 12
    cusp_locus: --lines: is not an option; --help lists them
*/
