// The part of the plane in which the number of equilibria of the rotating chain of two links is proved: a
// computer-assisted version of Baillieul's Figure 3.2.
//
//   prove_region --ratio 1.5 --alpha 0:1 --omega 0:3 --min-cell 1e-2 --json cells.json --svg figure.svg
#include <algorithm>
#include <cstdio>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_region.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <tuple>

#include "instances/locus/two_link_locus.hpp"
#include "instances/locus/two_link_proofs.hpp"
#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using equilibria::PlaneWindow;
using equilibria::ProvedCell;
using equilibria::RegionProof;
using Json = nlohmann::ordered_json;

std::string json(const RegionProof& proof, double ratio, double min_cell) {
    Json out{{"ratio", ratio},
             {"alpha", {proof.window.x_low, proof.window.x_high}},
             {"omega", {proof.window.y_low, proof.window.y_high}},
             {"min_cell", min_cell},
             {"proved_area_share", proof.proved_area_share},
             {"undecided", proof.undecided.size()},
             {"tested", proof.tested},
             {"enumerations", proof.enumerations},
             {"seconds", proof.seconds},
             {"cells", Json::array()}};
    for (const auto& cell : proof.cells)
        out["cells"].push_back({{"alpha", {cell.window.x_low, cell.window.x_high}},
                                {"omega", {cell.window.y_low, cell.window.y_high}},
                                {"count", cell.count},
                                {"by_index", cell.by_index},
                                {"argument", equilibria::to_string(cell.argument)}});
    return out.dump() + "\n";
}

void print(const RegionProof& proof) {
    std::map<std::pair<std::int64_t, std::vector<std::int64_t>>, std::pair<std::size_t, double>> tables;
    for (const auto& cell : proof.cells) {
        auto& [cells, area] = tables[{cell.count, cell.by_index}];
        ++cells;
        area += cell.window.width() * cell.window.height();
    }
    std::printf("equilibria  by index      cells      area\n");
    for (const auto& [key, value] : tables) {
        std::string by_index;
        for (const auto k : key.second) by_index += ' ' + std::to_string(k);
        std::printf("%10lld %-12s %8zu  %8.5f\n", static_cast<long long>(key.first), by_index.c_str(), value.first,
                    value.second);
    }
    std::printf("proved: %.3f %% of the area in %zu cells; undecided: %zu cells; %.1f s\n",
                100 * proof.proved_area_share, proof.cells.size(), proof.undecided.size(), proof.seconds);
}

/// Fewer, larger rectangles for the picture: cells of one count that share an edge are joined.
std::vector<ProvedCell> joined(std::vector<ProvedCell> cells) {
    const auto pass = [&](auto key, auto touch) {
        std::sort(cells.begin(), cells.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
        std::vector<ProvedCell> y;
        for (const auto& cell : cells)
            if (y.empty() || y.back().count != cell.count || !touch(y.back().window, cell.window)) y.push_back(cell);
        cells = std::move(y);
    };
    for (int round = 0; round < 3; ++round) {
        pass([](const ProvedCell& c) { return std::tuple(c.count, c.window.x_low, c.window.x_high, c.window.y_low); },
             [](PlaneWindow& a, const PlaneWindow& b) {
                 if (a.x_low != b.x_low || a.x_high != b.x_high || a.y_high != b.y_low) return false;
                 a.y_high = b.y_high;
                 return true;
             });
        pass([](const ProvedCell& c) { return std::tuple(c.count, c.window.y_low, c.window.y_high, c.window.x_low); },
             [](PlaneWindow& a, const PlaneWindow& b) {
                 if (a.y_low != b.y_low || a.y_high != b.y_high || a.x_high != b.x_low) return false;
                 a.x_high = b.x_high;
                 return true;
             });
    }
    return cells;
}

/// The proved cells by count, under the curves of the locus.
std::string script(const RegionProof& proof, const equilibria::Locus<Chain>& locus, double ratio) {
    std::map<std::int64_t, std::string> rows;
    for (const auto& cell : joined(proof.cells)) {
        const auto& w = cell.window;
        std::ostringstream row;
        row.precision(10);
        row << 0.5 * (w.x_low + w.x_high) << ' ' << 0.5 * (w.y_low + w.y_high) << ' ' << w.x_low << ' ' << w.x_high
            << ' ' << w.y_low << ' ' << w.y_high << '\n';
        rows[cell.count] += row.str();
    }
    std::ostringstream out, folds, pitchforks;
    out.precision(10);
    for (auto* s : {&folds, &pitchforks}) s->precision(10);
    for (const auto& curve : locus.curves) {
        auto& points = curve.kind == equilibria::SingularityKind::fold ? folds : pitchforks;
        for (const auto& p : curve.points) points << p.x() << ' ' << p.y() << '\n';
        points << "\n\n";
    }
    for (const auto& [count, block] : rows) out << equilibria::gnuplot_block("c" + std::to_string(count), block);
    out << equilibria::gnuplot_block("folds", folds.str().empty() ? "nan nan\n" : folds.str())
        << equilibria::gnuplot_block("pitchforks", pitchforks.str().empty() ? "nan nan\n" : pitchforks.str());
    const char* colours[] = {"#dbe9f6", "#cdebd5", "#fdf2c0", "#fbdcc0", "#e6d7ee", "#f6cfd8", "#d9d9d9", "#bfe3e0"};
    const auto& w = proof.window;
    out << "set title sprintf('Equilibria proved: %.2f %% of the window, {/:Italic l}_2 / {/:Italic l}_1 = " << ratio
        << "', " << 100 * proof.proved_area_share << ")\nset tics out nomirror\nset border 31 lw 0.8\n"
        << "set key outside right top title 'equilibria' samplen 2\n"
        << "set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)'\n"
        << "set ylabel '{/:Italic ω}' rotate by 0\n"
        << "plot [" << w.x_low << ':' << w.x_high << "][" << w.y_low << ':' << w.y_high << "] ";
    std::size_t colour = 0;
    for (const auto& [count, block] : rows)
        out << "$c" << count << " with boxxyerror fillstyle solid 1 noborder lc rgb '"
            << colours[colour++ % std::size(colours)] << "' title '" << count << "', ";
    out << "$pitchforks with lines lw 1.4 lc rgb '#0072b2' title 'pitchforks', "
        << "$folds with lines lw 1.6 lc rgb '#d55e00' title 'folds'\n";
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    std::string ratio_text = "1.5", alpha_text = "0:1", omega_text = "0:3", cell_text = "1e-2", seed_text = "1",
                threads_text = "1", json_name, svg_name, png_name;
    CLI::App app{
        "Proves the number of equilibria of the rotating chain of two links, by index, for all points of as much as "
        "possible of a window of the plane of alpha = m2 / (m1 + m2) and omega, and paints it over the bifurcation "
        "locus."};
    app.add_option("--ratio", ratio_text, "l2 / l1, positive (default 1.5)");
    app.add_option("--alpha", alpha_text, "the window's range of alpha, within 0:1 (default 0:1)");
    app.add_option("--omega", omega_text, "the window's range of omega (default 0:3)");
    app.add_option("--min-cell", cell_text, "cells with both edges below this are not cut again (default 1e-2)");
    app.add_option("--seed", seed_text, "of the random start systems, an integer (default 1)");
    app.add_option("--threads", threads_text, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--svg", svg_name, "draw the figure to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the figure to this PNG file (needs gnuplot)");
    support::parse(app, "prove_region", argc, argv);

    const double ratio =
        support::number("--ratio", ratio_text, "must be a positive number", [](double r) { return r > 0; });
    const auto alpha = support::range("--alpha", alpha_text, "must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1);
    const auto omega = support::range("--omega", omega_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    support::ProgressBar bar("proving");
    equilibria::RunOptions run;
    equilibria::ProveRegionOptions options;
    options.min_cell = support::number("--min-cell", cell_text, "must be a number from 1e-6 to 1e6",
                                       [](double c) { return c >= 1e-6 && c <= 1e6; });
    run.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
    run.executor = equilibria::threads(support::integer<unsigned>("--threads", threads_text, 0, 1024));
    options.progress = [&](double share) { bar.update(static_cast<std::uint64_t>(1e6 * share), 1000000); };
    std::optional<support::OutputFile> json_file, svg_file, png_file;
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);
    try {
        const PlaneWindow window{alpha.low, alpha.high, omega.low, omega.high};
        const equilibria::Parameters<Chain> p{0.5, ratio, 1};
        const auto proof = equilibria::prove_region<Chain, Chain::alpha, Chain::omega>(p, window, run, options);
        if (svg_file || png_file) {
            const auto locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>(p, window);
            const std::string text = script(proof, locus, ratio);
            if (svg_file)
                svg_file->write(equilibria::gnuplot("svg size 1000,760 font 'Helvetica,14' background 'white'", text));
            if (png_file)
                png_file->write(
                    equilibria::gnuplot("pngcairo size 2000,1520 fontscale 1.8 linewidth 2 pointscale 2", text));
        }
        if (json_file) json_file->write(json(proof, ratio, options.min_cell));
        if (!json_file || !json_file->to_stdout()) print(proof);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "prove_region: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--ratio 0
    prove_region: --ratio 0: must be a positive number
--alpha 0.5:0.2
    prove_region: --alpha 0.5:0.2: must be LOW:HIGH with 0 <= LOW < HIGH <= 1
--alpha 0:2
    prove_region: --alpha 0:2: must be LOW:HIGH with 0 <= LOW < HIGH <= 1
--omega 3
    prove_region: --omega 3: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--min-cell 0
    prove_region: --min-cell 0: must be a number from 1e-6 to 1e6
--min-cell nan
    prove_region: --min-cell nan: must be a number from 1e-6 to 1e6
--svg missing/figure.svg
    prove_region: --svg missing/figure.svg: cannot be written (No such file or directory); must be a file that can, or -
*/
