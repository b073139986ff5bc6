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

/// Curves, cusps, regions with their counts, and insets.
equilibria::GnuplotData plotted(const Locus& locus, double ratio) {
    std::ostringstream heading;
    heading.precision(10);
    heading << "Bifurcation locus of the rotating two-link chain, {/:Italic l}_2 / {/:Italic l}_1 = " << ratio;
    return support::locus_figure(locus,
                                 {.heading = heading.str(),
                                  .x = "{/:Italic α}",
                                  .y = "{/:Italic ω}",
                                  .x_label = "{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)"});
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
