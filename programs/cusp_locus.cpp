// The cusps of the rotating chain of two links as curves over alpha, ratio and omega, with what they meet in:
// swallowtails, lips, beak-to-beak, umbilics.
//
//   cusp_locus --ratio 1:3 --alpha 0:1 --omega 0:20 --svg figure.svg --json cusps.json
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <equilibria/core/grid_value.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/io/results/cusp_locus_output.hpp>
#include <equilibria/locus/space/cusp_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plots/cusp_locus.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::CuspLocus<Chain>;
using End = equilibria::CurveEnd;

/// What the command line says.
struct Command {
    support::Range ratio{1, 3}, alpha{0, 1}, omega{0, 20};
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::CuspLocusOptions options;
    std::optional<support::OutputFile> json;
    support::Pictures pictures;
};

Command read(int argc, char** argv) {
    Command c;
    c.options.planes = 9;
    support::CommandLine app{
        "All cusps of the rotating chain of two links, as curves over alpha = m2 / (m1 + m2), ratio = l2 / l1 and "
        "omega, "
        "with their swallowtails, lips, beak-to-beak and umbilics, and what could be missed."};
    app.add_option("--ratio", c.ratio, "the range of l2 / l1 (default 1:3)")
        .transform(
            support::range("must be LOW:HIGH, finite, with 0 < LOW < HIGH", std::numeric_limits<double>::min(), 1e6));
    app.add_option("--alpha", c.alpha, "the range of alpha, within 0:1 (default 0:1)")
        .transform(support::range("must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1));
    app.add_option("--omega", c.omega, "the range of omega (default 0:20)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_option("--planes", c.options.planes,
                   "planes of constant ratio that are solved for all cusps, 2 to 1000 (default 9)")
        .transform(support::integer(2, 1000));
    app.add_seed(c.run.seed, "of the random start systems, an integer (default 1)");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    c.pictures.add_to(app, "the figure");
    app.parse("cusp_locus", argc, argv);
    return c;
}

const char* end_name(End end) { return end == End::border ? "box" : to_string(end); }

void print(const Locus& locus) {
    for (const auto& curve : locus.curves) {
        std::printf("curve of cusps, %zu points\n", curve.points.size());
        const std::pair<const char*, const equilibria::Singularity<Chain>&> ends[] = {
            {end_name(curve.ends[0]), curve.points.front()}, {end_name(curve.ends[1]), curve.points.back()}};
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

/// What `set xtics` takes. Where the axis has too few ticks in the range there are five at equal distances.
std::string ticks(const Axis& axis, double low, double high) {
    std::vector<double> values;
    for (const double tick : axis.ticks)
        if (tick >= low && tick <= high) values.push_back(tick);
    if (values.size() < 3) {
        values.clear();
        for (std::uint64_t k = 0; k < 5; ++k) values.push_back(equilibria::grid_value(low, high, k, 5));
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

/// What the figure shows of the range of the ratio, and which ends of curves there are.
struct Shown {
    double low, high, omega_low;
    bool any, at_window = false, at_degenerate = false, at_other = false;
};
Shown shown(const Locus& locus) {
    const auto& box = locus.box;
    double low = box.z.high, high = box.z.low, slowest = box.y.high;
    Shown y{};
    for (const auto& curve : locus.curves) {
        for (const auto& p : curve.points)
            low = std::min(low, p.z()), high = std::max(high, p.z()), slowest = std::min(slowest, p.y());
        for (const End end : curve.ends) {
            y.at_window = y.at_window || end == End::border;
            y.at_degenerate = y.at_degenerate || end == End::degenerate;
            y.at_other = y.at_other || (end != End::border && end != End::degenerate && end != End::closed);
        }
    }
    // of the range of the ratio the part that the curves take, and a third of that above and below
    y.any = low <= high;
    const double margin = y.any ? (high - low) / 3 : 0;
    y.low = y.any ? std::max(box.z.low, low - margin) : box.z.low;
    y.high = y.any ? std::min(box.z.high, high + margin) : box.z.high;
    // no pendulum leaves the vertical below omega = 1
    y.omega_low = slowest >= 1 && box.y.low < 1 && box.y.high > 1 ? 1 : box.y.low;
    return y;
}

/// Rows: alpha and omega in their scales, the ratio.
void add_blocks(equilibria::GnuplotData& data, const Locus& locus, const Shown& s) {
    std::ostringstream curves, planes, cusps, at_window, degenerate, other_ends, transitions;
    for (auto* out : {&curves, &planes, &cusps, &at_window, &degenerate, &other_ends, &transitions}) out->precision(12);
    const auto add = [](std::ostringstream& out, const auto& at, double ratio) {
        out << alpha_axis.scaled(at.x()) << ' ' << omega_axis.scaled(at.y()) << ' ' << ratio << '\n';
    };
    for (const auto& plane : locus.planes) {
        if (plane.z >= s.low && plane.z <= s.high)
            planes << "-1e3 -1e3 " << plane.z << "\n1e3 1e3 " << plane.z << "\n\n";
        for (const auto& c : plane.cusps) add(cusps, c, plane.z);
    }
    for (const auto& curve : locus.curves) {
        for (const auto& p : curve.points) add(curves, p, p.z());
        curves << "\n\n";
        for (std::size_t k = 0; k < 2; ++k) {
            if (curve.ends[k] == End::closed) continue;
            const auto& p = k == 0 ? curve.points.front() : curve.points.back();
            add(curve.ends[k] == End::border       ? at_window
                : curve.ends[k] == End::degenerate ? degenerate
                                                   : other_ends,
                p, p.z());
        }
        for (const auto& t : curve.transitions) add(transitions, t.at, t.at.z());
    }
    const std::pair<const char*, std::string> blocks[] = {
        {"curves", curves.str()},          {"planes", planes.str()},         {"cusps", cusps.str()},
        {"window", at_window.str()},       {"degenerate", degenerate.str()}, {"other", other_ends.str()},
        {"transitions", transitions.str()}};
    for (const auto& [name, rows] : blocks) data.block(name, rows, 3);
}

/// What is written beside the transitions, in both panels.
void add_labels(equilibria::GnuplotData& data, const Locus& locus) {
    std::vector<std::string> kinds, places;
    std::vector<double> x, y;
    for (const Axis* axis : {&alpha_axis, &omega_axis})
        for (const auto& curve : locus.curves)
            for (const auto& t : curve.transitions) {
                const bool alpha = axis == &alpha_axis;
                std::ostringstream at;
                at.precision(7);
                at << "{/:Italic r} = " << t.at.z() << (alpha ? ", {/:Italic α} = " : ", {/:Italic ω} = ")
                   << (alpha ? t.at.x() : t.at.y());
                kinds.emplace_back(to_string(t.at.kind));
                places.push_back(at.str());
                x.push_back(axis->scaled(alpha ? t.at.x() : t.at.y()));
                y.push_back(t.at.z());
            }
    data.integer("transitions", static_cast<long long>(x.size() / 2)).strings("label_kind", kinds);
    data.strings("label_place", places).values("label_x", x).values("label_y", y);
}

equilibria::GnuplotData plotted(const Locus& locus) {
    const auto& box = locus.box;
    const Shown s = shown(locus);
    std::ostringstream not_shown;
    not_shown.precision(4);
    for (const auto& plane : locus.planes)
        if (plane.z < s.low || plane.z > s.high) not_shown << (not_shown.str().empty() ? "" : ", ") << plane.z;
    equilibria::GnuplotData data;
    data.value("low", s.low).value("high", s.high).string("not_shown", not_shown.str());
    data.values("panel_left", {alpha_axis.scaled(box.x.low), omega_axis.scaled(s.omega_low)});
    data.values("panel_right", {alpha_axis.scaled(box.x.high), omega_axis.scaled(box.y.high)});
    data.strings("ticks", {ticks(alpha_axis, box.x.low, box.x.high), ticks(omega_axis, s.omega_low, box.y.high)});
    data.integer("any", s.any).integer("at_window", s.at_window);
    data.integer("at_degenerate", s.at_degenerate).integer("at_other", s.at_other);
    add_labels(data, locus);
    add_blocks(data, locus, s);
    return data;
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        const Locus locus = equilibria::find_cusp_locus<Chain, Chain::alpha, Chain::omega, Chain::ratio>(
            {0.5, 1.5, 1}, {{c.alpha.low, c.alpha.high}, {c.omega.low, c.omega.high}, {c.ratio.low, c.ratio.high}},
            c.run, c.options, equilibria::more_digits);
        if (c.pictures.asked()) c.pictures.draw({1150, 620}, plotted(locus), plots::cusp_locus);
        if (c.json)
            c.json->write(
                equilibria::json_text(equilibria::json_of(locus, {.x = "alpha", .y = "omega", .z = "ratio"}), 1));
        if (!to_stdout(c.json)) print(locus);
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
