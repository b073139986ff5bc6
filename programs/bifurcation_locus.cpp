// The bifurcation locus of the rotating chain of two links: Baillieul's Figure 3.2 and his tables 3.3.
//
//   bifurcation_locus --ratio 1.5 --alpha 0:1 --omega 0:5 --svg figure.svg --table tables
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/io/results/locus_output.hpp>
#include <equilibria/io/results/locus_proof_output.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "plots/bifurcation_locus.hpp"
#include "support/locus_figure.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;
using Proof = std::optional<equilibria::LocusProof>;
using equilibria::Json;
using equilibria::SingularityKind;

/// What the command line says.
struct Command {
    double ratio = 1.5;
    support::Range alpha{0, 1}, omega{0, 5};
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::LocusOptions options;
    bool prove = false;
    std::optional<support::OutputFile> json, markdown, csv;
    support::Pictures pictures;
};

Command read(int argc, char** argv) {
    Command c;
    std::string table;
    c.options.lines = 12;
    support::CommandLine app{
        "Folds, pitchforks and cusps of the rotating chain of two links in the plane of alpha = m2 / (m1 + m2) and "
        "omega, "
        "and the regions between them with their equilibria by index (Baillieul, Figures 3.2 and 3.3)."};
    app.add_option("--ratio", c.ratio, "l2 / l1, positive (default 1.5)").transform(support::positive());
    app.add_option("--alpha", c.alpha, "the window's range of alpha, within 0:1 (default 0:1)")
        .transform(support::range("must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1));
    app.add_option("--omega", c.omega, "the window's range of omega (default 0:5)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_option("--lines", c.options.lines,
                   "lines in each direction that are solved for seeds, 2 to 1000 (default 12)")
        .transform(support::integer(2, 1000));
    app.add_seed(c.run.seed, "of the random start systems, an integer (default 1)");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    c.pictures.add_to(app, "the figure");
    app.add_flag("--prove", c.prove,
                 "prove the points of curves, the cusps and the regions' equilibria (interval Newton, Krawczyk)");
    app.add_option("--table", table, "write tables 3.3 to NAME.md and NAME.csv");
    app.parse("bifurcation_locus", argc, argv);
    if (app.given("--table")) {
        c.markdown.emplace("--table", table + ".md");
        c.csv.emplace("--table", table + ".csv");
    }
    return c;
}

Json document(const Locus& locus, const Proof& proof, double ratio) {
    Json out{{"ratio", ratio}};
    equilibria::add_keys(out, equilibria::json_of(locus, {.x = "alpha", .y = "omega"}));
    if (proof) out["proof"] = equilibria::json_of(*proof);
    return out;
}

void print(const Locus& locus, const Proof& proof) {
    for (const auto& c : locus.of(SingularityKind::cusp))
        std::printf("cusp       alpha %.14f  omega %.14f  residual %.1e\n", c.x(), c.y(), c.residual);
    for (const auto& p : locus.of(SingularityKind::tricritical_pitchfork))
        std::printf("degenerate pitchfork  alpha %.12f  omega %.12f\n", p.x(), p.y());
    for (const auto& c : locus.curves)
        std::printf("%-9s  %4zu points  (%.6f, %.6f) to (%.6f, %.6f)\n",
                    std::string(equilibria::kind_name(c.kind)).c_str(), c.points.size(), c.points.front().x(),
                    c.points.front().y(), c.points.back().x(), c.points.back().y());
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
equilibria::Window around(const equilibria::Singularity<Chain>& cusp, const Locus& locus) {
    const auto& w = locus.window;
    const equilibria::PlanePoint c{cusp.x(), cusp.y()};
    const double x_reach = std::min({0.011 * w.width(), c.x - w.x.low, w.x.high - c.x});
    const double y_reach = std::min({0.055 * w.height(), c.y - w.y.low, w.y.high - c.y});
    equilibria::Window box{{c.x, c.x}, {c.y, c.y}};
    for (const auto& curve : locus.curves) {
        const auto at = std::find_if(curve.points.begin(), curve.points.end(),
                                     [&](const auto& p) { return p.x() == c.x && p.y() == c.y; });
        if (at == curve.points.end()) continue;
        const auto add = [&](const auto& point) {
            const equilibria::PlanePoint p{point.x(), point.y()};
            const bool near = std::abs(p.x - c.x) <= x_reach && std::abs(p.y - c.y) <= y_reach;
            if (near)
                box = {{std::min(box.x.low, p.x), std::max(box.x.high, p.x)},
                       {std::min(box.y.low, p.y), std::max(box.y.high, p.y)}};
            return !near;
        };
        std::find_if(at, curve.points.end(), add);
        std::find_if(std::make_reverse_iterator(at), curve.points.rend(), add);
    }
    const double dx = 0.15 * box.width() + 1e-9 * w.width(), dy = 0.15 * box.height() + 1e-9 * w.height();
    return {{std::max(w.x.low, box.x.low - dx), std::min(w.x.high, box.x.high + dx)},
            {std::max(w.y.low, box.y.low - dy), std::min(w.y.high, box.y.high + dy)}};
}

/// The tics of an axis from `low` to `high`: two to four round numbers, as powers of ten where they are small.
struct Tics {
    std::string format;
    double step;
    bool bare_zero;  ///< 0 without a power of ten
};
Tics tics(double low, double high) {
    const double least = (high - low) / 3.5, power = std::pow(10, std::floor(std::log10(least)));
    const double step = power * (least <= 2 * power ? 2 : least <= 5 * power ? 5 : 10);
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    if (std::max(std::abs(low), std::abs(high)) < 1e-3) return {"%.0t×10^{%T}", step, true};
    return {"%." + std::to_string(digits) + "f", step, false};
}

/// Where a cusp is, in words.
std::string place(const equilibria::PlanePoint& c) {
    std::ostringstream out;
    out.precision(4);
    out << "{/:Italic α} = ";
    if (c.x > 0 && c.x < 1e-3) {
        const double power = std::floor(std::log10(c.x));
        out << c.x / std::pow(10, power) << "·10^{" << power << '}';
    } else {
        out << c.x;
    }
    out.precision(6);
    out << ", {/:Italic ω} = " << c.y;
    return out.str();
}

/// Windows around cusps as arrays.
void add_windows(equilibria::GnuplotData& data, const std::string& name,
                 const std::vector<equilibria::Window>& windows) {
    const auto add = [&](const std::string& axis, equilibria::Interval equilibria::Window::* member) {
        std::vector<double> low, high;
        for (const auto& w : windows) low.push_back((w.*member).low), high.push_back((w.*member).high);
        data.values(name + axis + "_low", low);
        data.values(name + axis + "_high", high);
    };
    add("_x", &equilibria::Window::x);
    add("_y", &equilibria::Window::y);
}

/// Insets around the first two cusps.
void add_insets(equilibria::GnuplotData& data, const Locus& locus) {
    const auto& w = locus.window;
    std::vector<equilibria::Window> boxes, frames;
    std::vector<std::string> titles, formats[2];
    std::vector<double> steps[2], zeros[2];
    const auto cusps = locus.of(SingularityKind::cusp);
    for (std::size_t k = 0; k < std::min<std::size_t>(2, cusps.size()); ++k) {
        const equilibria::PlanePoint c{cusps[k].x(), cusps[k].y()};
        const auto box = around(cusps[k], locus);
        boxes.push_back(box);
        // large enough to be seen
        frames.push_back({{std::max(w.x.low, std::min(box.x.low, c.x - 0.013 * w.width())),
                           std::min(w.x.high, std::max(box.x.high, c.x + 0.013 * w.width()))},
                          {std::max(w.y.low, std::min(box.y.low, c.y - 0.013 * w.height())),
                           std::min(w.y.high, std::max(box.y.high, c.y + 0.013 * w.height()))}});
        titles.push_back(place(c));
        const Tics axes[] = {tics(box.x.low, box.x.high), tics(box.y.low, box.y.high)};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            formats[axis].push_back(axes[axis].format);
            steps[axis].push_back(axes[axis].step);
            zeros[axis].push_back(axes[axis].bare_zero ? 1 : 0);
        }
    }
    data.integer("insets", static_cast<long long>(boxes.size())).strings("inset_title", titles);
    add_windows(data, "box", boxes);
    add_windows(data, "frame", frames);
    data.strings("x_format", formats[0]).values("x_step", steps[0]).values("x_zero", zeros[0]);
    data.strings("y_format", formats[1]).values("y_step", steps[1]).values("y_zero", zeros[1]);
}

/// Curves, cusps, regions with their counts, and insets.
equilibria::GnuplotData plotted(const Locus& locus, double ratio) {
    equilibria::GnuplotData data;
    data.value("ratio", ratio);
    support::add_window(data, locus.window);
    support::add_locus(data, locus);
    std::vector<std::string> counts;
    std::vector<double> x, y, sizes;
    for (const auto& r : locus.regions)
        if (r.area > 1e-3 * locus.window.width() * locus.window.height()) {
            counts.push_back(std::to_string(r.count));
            x.push_back(r.point.x);
            y.push_back(r.point.y);
            sizes.push_back(support::crowded(r.point, locus, 0.022, 0.02) ? 12 : 17);
        }
    data.integer("labels", static_cast<long long>(counts.size())).strings("label_text", counts);
    data.values("label_x", x).values("label_y", y).values("label_size", sizes);
    add_insets(data, locus);
    return data;
}

/// The numbers of equilibria by index, by how many there are in all.
using Columns = std::map<std::uint64_t, std::vector<std::int64_t>>;

/// Wherever they differ, for alpha ratio > 1 and below.
std::array<Columns, 2> columns(const Locus& locus, double ratio) {
    std::array<Columns, 2> found;
    const auto& w = locus.window;
    for (const auto& r : locus.regions) found[r.point.x * ratio > 1 ? 0 : 1][r.count] = r.by_index;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 60; ++j) {
            const double alpha = w.x.low + w.width() * (i + 0.5) / 12, omega = w.y.low + w.height() * (j + 0.5) / 60;
            const auto set = equilibria::enumerate<Chain>({alpha, ratio, omega});
            if (set.clean()) found[alpha * ratio > 1 ? 0 : 1][set.real()] = set.by_index();
        }
    return found;
}

/// Tables 3.3 in Markdown.
std::string markdown(const std::array<Columns, 2>& found, const equilibria::Window& w, double ratio) {
    std::ostringstream out;
    out << "# The rotating chain of two links, l2/l1 = " << ratio
        << ": equilibria by index\n\nAs in Baillieul's Figure 3.3; each column is a number of equilibria that occurs "
           "in the window alpha "
        << w.x.low << " to " << w.x.high << ", omega " << w.y.low << " to " << w.y.high << ".\n";
    for (std::size_t t = 0; t < 2; ++t) {
        if (found[t].empty()) continue;
        out << "\n## Table 3.3("
            << "ab"[t] << "): alpha r " << (t == 0 ? "> 1" : "< 1") << "\n\n| index |";
        for (std::size_t k = 1; k <= found[t].size(); ++k) out << " C" << k << " |";
        out << "\n|---|";
        for (std::size_t k = 0; k < found[t].size(); ++k) out << "---|";
        for (std::size_t index = 0; index < 3; ++index) {
            out << "\n| " << index << " |";
            for (const auto& [count, by_index] : found[t]) out << ' ' << by_index[index] << " |";
        }
        out << "\n| total |";
        for (const auto& [count, by_index] : found[t]) out << ' ' << count << " |";
        out << '\n';
    }
    return out.str();
}

/// The same as CSV.
std::string csv(const std::array<Columns, 2>& found) {
    std::vector<std::string> header{"table", "count"};
    equilibria::add_index_columns(header, 2);
    equilibria::CsvTable table(header);
    for (std::size_t t = 0; t < 2; ++t)
        for (const auto& [count, by_index] : found[t])
            table.add(equilibria::CsvRow().add(t == 0 ? "3.3(a)" : "3.3(b)").add(count).add_all(by_index));
    return table.text();
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        const Locus locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>(
            {0.5, c.ratio, 1}, {{c.alpha.low, c.alpha.high}, {c.omega.low, c.omega.high}}, c.run, c.options);
        Proof proof;
        if (c.prove) proof = equilibria::prove_locus<Chain, Chain::alpha, Chain::omega>(locus, c.run);
        if (c.pictures.asked()) c.pictures.draw({1000, 760}, plotted(locus, c.ratio), plots::bifurcation_locus);
        if (c.markdown) {
            const auto found = columns(locus, c.ratio);
            c.markdown->write(markdown(found, locus.window, c.ratio));
            c.csv->write(csv(found));
        }
        if (c.json) c.json->write(equilibria::json_text(document(locus, proof, c.ratio), 1));
        if (!to_stdout(c.json)) print(locus, proof);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bifurcation_locus: %s\n", error.what());
        return 1;
    }
}
