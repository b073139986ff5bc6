// Equilibria of the rotating chain of two links against omega, with every bifurcation.
//
//   bifurcation_diagram --ratio 1.5 --alpha .33 --omega 0:4 --svg diagram.svg
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <equilibria/io/results/diagram_output.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <exception>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "plots/bifurcation_diagram.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Diagram = equilibria::BifurcationDiagram<Chain>;
using equilibria::Json;

/// What the command line says.
struct Command {
    double ratio = 1.5, alpha = 0.33;
    support::Range omega{0, 4};
    std::uint64_t seed = 1;
    std::optional<support::OutputFile> json;
    support::Pictures pictures;
};

Command read(int argc, char** argv) {
    Command c;
    support::CommandLine app{
        "Equilibria of the rotating chain of two links against omega, coloured by their index, with all folds and "
        "pitchforks; theta and -theta are both shown."};
    app.add_option("--ratio", c.ratio, "l2 / l1, positive (default 1.5)").transform(support::positive());
    app.add_option("--alpha", c.alpha, "m2 / (m1 + m2), between 0 and 1 (default 0.33)")
        .transform(support::number("must be a number between 0 and 1, both excluded",
                                   [](double a) { return a > 0 && a < 1; }));
    app.add_option("--omega", c.omega, "the range of omega (default 0:4)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_seed(c.seed, "of the random start systems, an integer (default 1)");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    c.pictures.add_to(app, "the diagram");
    app.parse("bifurcation_diagram", argc, argv);
    return c;
}

/// Rows "omega theta_1 theta_2" of the pieces with one index; angles in (-pi, pi].
std::string rows(const Diagram& diagram, int index) {
    std::ostringstream out;
    out.precision(10);
    for (const auto& piece : diagram.pieces) {
        if (piece.index != index) continue;
        // one turn for the whole piece, so that a branch at theta = pi does not flicker between the edges
        double turn[2];
        for (int angle = 0; angle < 2; ++angle) {
            const double middle = piece.points[piece.points.size() / 2].q[angle];
            turn[angle] = middle - std::remainder(middle, 2 * std::numbers::pi);
            if (std::abs(middle - turn[angle] + std::numbers::pi) < 1e-6) turn[angle] -= 2 * std::numbers::pi;
        }
        for (const auto& point : piece.points)
            out << point.parameter << ' ' << point.q[0] - turn[0] << ' ' << point.q[1] - turn[1] << '\n';
        out << "\n\n";
    }
    return out.str();
}

equilibria::GnuplotData plotted(const Diagram& diagram, const Command& c) {
    equilibria::GnuplotData data;
    data.value("ratio", c.ratio).value("alpha", c.alpha).value("low", c.omega.low).value("high", c.omega.high);
    for (int index = 0; index < 3; ++index) data.block("index" + std::to_string(index), rows(diagram, index), 3);
    std::ostringstream folds, pitchforks;
    const auto shown = [](double q) { return q > 3.1415 ? q : std::remainder(q, 2 * std::numbers::pi); };
    for (const auto& e : diagram.events)
        (e.kind == equilibria::CriticalKind::fold ? folds : pitchforks)
            << e.value << ' ' << shown(e.q[0]) << ' ' << shown(e.q[1]) << '\n';
    data.block("folds", folds.str(), 3).block("pitchforks", pitchforks.str(), 3);
    return data;
}

void print(const Diagram& diagram) {
    for (const auto& e : diagram.events)
        std::printf("%-9s  omega %.12f  at %9.6f %9.6f\n",
                    e.kind == equilibria::CriticalKind::fold ? "fold" : "pitchfork", e.value, e.q[0], e.q[1]);
    std::printf("%zu branches between them\n", diagram.pieces.size());
    if (!diagram.complete()) std::printf("NOT COMPLETE: %s.\n", diagram.argument().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        const Diagram diagram = equilibria::trace_diagram<Chain, Chain::omega>(
            {c.alpha, c.ratio, 1}, {c.omega.low, c.omega.high}, {.seed = c.seed});
        if (c.pictures.asked()) c.pictures.draw({1100, 560}, plotted(diagram, c), plots::bifurcation_diagram);
        if (c.json) {
            Json out{{"ratio", c.ratio}, {"alpha", c.alpha}};
            equilibria::add_keys(out, equilibria::json_of(diagram, "omega"));
            c.json->write(equilibria::json_text(out, 1));
        }
        if (!to_stdout(c.json)) print(diagram);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bifurcation_diagram: %s\n", error.what());
        return 1;
    }
}
