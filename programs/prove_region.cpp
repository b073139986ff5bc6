// The part of the plane in which the number of equilibria of the rotating chain of two links is proved: a
// computer-assisted version of Baillieul's Figure 3.2.
//
//   prove_region --ratio 1.5 --alpha 0:1 --omega 0:3 --min-cell 1e-2 --json cells.json --svg figure.svg
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <equilibria/io/results/locus_proof_output.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_region.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <exception>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "plots/prove_region.hpp"
#include "support/locus_figure.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"
#include "support/progress_bar.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using equilibria::Json;
using equilibria::Window;
using equilibria::ProvedCell;
using equilibria::RegionProof;

/// What the command line says.
struct Command {
    double ratio = 1.5;
    support::Range alpha{0, 1}, omega{0, 3};
    unsigned threads = 1;
    equilibria::RunOptions run;
    equilibria::ProveRegionOptions options{.min_cell = 1e-2};
    std::optional<support::OutputFile> json;
    support::Pictures pictures;

    Window window() const { return {{alpha.low, alpha.high}, {omega.low, omega.high}}; }
};

Command read(int argc, char** argv) {
    Command c;
    support::CommandLine app{
        "Proves the number of equilibria of the rotating chain of two links, by index, for all points of as much as "
        "possible of a window of the plane of alpha = m2 / (m1 + m2) and omega, and paints it over the bifurcation "
        "locus."};
    app.add_option("--ratio", c.ratio, "l2 / l1, positive (default 1.5)").transform(support::positive());
    app.add_option("--alpha", c.alpha, "the window's range of alpha, within 0:1 (default 0:1)")
        .transform(support::range("must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1));
    app.add_option("--omega", c.omega, "the window's range of omega (default 0:3)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_option("--min-cell", c.options.min_cell,
                   "cells with both edges below this are not cut again (default 1e-2)")
        .transform(support::number_from(1e-6, 1e6, "must be a number from 1e-6 to 1e6"));
    app.add_seed(c.run.seed, "of the random start systems, an integer (default 1)");
    app.add_threads(c.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    c.pictures.add_to(app, "the figure");
    app.parse("prove_region", argc, argv);
    return c;
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
        pass([](const ProvedCell& c) { return std::tuple(c.count, c.window.x.low, c.window.x.high, c.window.y.low); },
             [](Window& a, const Window& b) {
                 if (a.x.low != b.x.low || a.x.high != b.x.high || a.y.high != b.y.low) return false;
                 a.y.high = b.y.high;
                 return true;
             });
        pass([](const ProvedCell& c) { return std::tuple(c.count, c.window.y.low, c.window.y.high, c.window.x.low); },
             [](Window& a, const Window& b) {
                 if (a.y.low != b.y.low || a.y.high != b.y.high || a.x.high != b.x.low) return false;
                 a.x.high = b.x.high;
                 return true;
             });
    }
    return cells;
}

/// The proved cells by count, a data set each, and the curves of the locus.
equilibria::GnuplotData plotted(const RegionProof& proof, const equilibria::Locus<Chain>& locus, double ratio) {
    std::map<std::int64_t, std::string> rows;
    for (const auto& cell : joined(proof.cells)) {
        const auto& w = cell.window;
        std::ostringstream row;
        row.precision(10);
        row << 0.5 * (w.x.low + w.x.high) << ' ' << 0.5 * (w.y.low + w.y.high) << ' ' << w.x.low << ' ' << w.x.high
            << ' ' << w.y.low << ' ' << w.y.high << '\n';
        rows[cell.count] += row.str();
    }
    std::string counts, cells;
    for (const auto& [count, block] : rows) {
        counts += (counts.empty() ? "" : " ") + std::to_string(count);
        cells += block + "\n\n";
    }
    equilibria::GnuplotData data;
    data.value("ratio", ratio).value("share", 100 * proof.proved_area_share).string("counts", counts);
    data.block("cells", cells, 6);
    support::add_window(data, proof.window);
    support::add_locus(data, locus);
    return data;
}

}  // namespace

int main(int argc, char** argv) {
    Command c = read(argc, argv);
    support::ProgressBar bar("proving");
    c.run.executor = equilibria::threads(c.threads);
    c.run.progress = [&](std::uint64_t done, std::uint64_t all) { bar.update(done, all); };
    try {
        const equilibria::Parameters<Chain> p{0.5, c.ratio, 1};
        const auto proof = equilibria::prove_region<Chain, Chain::alpha, Chain::omega>(p, c.window(), c.run, c.options);
        if (c.pictures.asked()) {
            const auto locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>(p, c.window());
            c.pictures.draw({1000, 760}, plotted(proof, locus, c.ratio), plots::prove_region);
        }
        if (c.json) {
            Json out{{"ratio", c.ratio}, {"min_cell", c.options.min_cell}};
            equilibria::add_keys(out, equilibria::json_of(proof, {.x = "alpha", .y = "omega"}));
            c.json->write(equilibria::json_text(out, -1));
        }
        if (!to_stdout(c.json)) print(proof);
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
