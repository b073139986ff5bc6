// Equilibria of the rotating chain of two links against omega, with every bifurcation.
//
//   bifurcation_diagram --ratio 1.5 --alpha .33 --omega 0:4 --svg diagram.svg
#include <cstdio>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/torus.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <sstream>

#include "instances/locus/chain_events.hpp"
#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"

namespace {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Diagram = equilibria::BifurcationDiagram<Chain>;
using Json = nlohmann::ordered_json;

/// Rows "omega angle" of the pieces with one index; angles in (-pi, pi], a gap where a branch wraps around.
std::string rows(const Diagram& diagram, int index, int angle) {
    std::ostringstream out;
    out.precision(10);
    for (const auto& piece : diagram.pieces) {
        if (piece.index != index) continue;
        // one turn for the whole piece, so that a branch at theta = pi does not flicker between the edges
        const double middle = piece.points[piece.points.size() / 2].q[angle];
        double turn = middle - equilibria::wrap(middle);
        if (std::abs(middle - turn + std::numbers::pi) < 1e-6) turn -= 2 * std::numbers::pi;
        for (const auto& point : piece.points) out << point.parameter << ' ' << point.q[angle] - turn << '\n';
        out << "\n\n";
    }
    return out.str().empty() ? "nan nan\n" : out.str();
}

std::string script(const Diagram& diagram, double ratio, double alpha, double low, double high) {
    std::ostringstream out;
    out.precision(10);
    for (int angle = 0; angle < 2; ++angle) {
        for (int index = 0; index < 3; ++index)
            out << equilibria::gnuplot_block("index" + std::to_string(index) + "angle" + std::to_string(angle),
                                             rows(diagram, index, angle));
        std::ostringstream events[2];
        for (const auto& e : diagram.events)
            events[e.kind == equilibria::CriticalKind::fold ? 0 : 1]
                << e.value << ' ' << equilibria::wrap(e.q[angle]) << '\n';
        for (int kind = 0; kind < 2; ++kind)
            out << equilibria::gnuplot_block((kind == 0 ? "folds" : "pitchforks") + std::to_string(angle),
                                             events[kind].str().empty() ? "nan nan\n" : events[kind].str());
    }
    out << "set multiplot title 'Equilibria of the rotating two-link chain, {/:Italic l}_2 / {/:Italic l}_1 = " << ratio
        << ", {/:Italic α} = " << alpha << "'\n"
        << "set tics out nomirror\nset border 31 lw 0.8\nset xlabel '{/:Italic ω}'\n"
        << "set ytics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)\nset bmargin at screen 0.22\nset tmargin at screen 0.9\n"
        << "set key at screen 0.5,0.02 center bottom horizontal maxrows 1 samplen 2\n";
    for (int angle = 0; angle < 2; ++angle) {
        const auto block = [&](const std::string& name) { return "$" + name + std::to_string(angle); };
        out << "set lmargin at screen " << (angle == 0 ? 0.11 : 0.6) << "\nset rmargin at screen "
            << (angle == 0 ? 0.49 : 0.98) << "\nset ylabel '{/:Italic θ}_" << angle + 1 << "' rotate by 0\n"
            << "plot [" << low << ':' << high << "][-3.4:3.4] " << block("index0angle")
            << " with lines lw 2.4 lc rgb '#009e73' title 'index 0 (stable)', " << block("index1angle")
            << " with lines lw 1.6 lc rgb '#e69f00' title 'index 1', " << block("index2angle")
            << " with lines lw 1.6 lc rgb '#cc3311' title 'index 2', " << block("pitchforks")
            << " with points pt 7 ps 0.7 lc rgb '#0072b2' title 'pitchforks', " << block("folds")
            << " with points pt 5 ps 0.7 lc rgb 'black' title 'folds'\nunset key\n";
    }
    out << "unset multiplot\n";
    return out.str();
}

std::string json(const Diagram& diagram, double ratio, double alpha) {
    Json out{{"ratio", ratio}, {"alpha", alpha}, {"failed_paths", diagram.failed_paths},
             {"events", Json::array()}, {"branches", Json::array()}};
    for (const auto& e : diagram.events)
        out["events"].push_back({{"kind", e.kind == equilibria::CriticalKind::fold ? "fold" : "pitchfork"},
                                 {"omega", e.value},
                                 {"angles", {e.q[0], e.q[1]}}});
    for (const auto& piece : diagram.pieces) {
        Json points = Json::array();
        for (const auto& p : piece.points) points.push_back({p.parameter, p.q[0], p.q[1]});
        out["branches"].push_back({{"index", piece.index}, {"points", std::move(points)}});
    }
    return out.dump(1) + "\n";
}

}  // namespace

int main(int argc, char** argv) {
    std::string ratio_text = "1.5", alpha_text = "0.33", omega_text = "0:4", seed_text = "1";
    std::string json_name, svg_name, png_name;
    CLI::App app{
        "Equilibria of the rotating chain of two links against omega, coloured by their index, with all folds and "
        "pitchforks; theta and -theta are both shown."};
    app.add_option("--ratio", ratio_text, "l2 / l1, positive (default 1.5)");
    app.add_option("--alpha", alpha_text, "m2 / (m1 + m2), between 0 and 1 (default 0.33)");
    app.add_option("--omega", omega_text, "the range of omega (default 0:4)");
    app.add_option("--seed", seed_text, "of the random start systems, an integer (default 1)");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--svg", svg_name, "draw the diagram to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the diagram to this PNG file (needs gnuplot)");
    support::parse(app, "bifurcation_diagram", argc, argv);

    const double ratio = support::number("--ratio", ratio_text, "must be a positive number", [](double r) { return r > 0; });
    const double alpha = support::number("--alpha", alpha_text, "must be a number between 0 and 1, both excluded",
                                         [](double a) { return a > 0 && a < 1; });
    const auto omega = support::range("--omega", omega_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    equilibria::RunOptions options;
    options.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
    std::optional<support::OutputFile> json_file, svg_file, png_file;
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);
    try {
        const Diagram diagram = equilibria::trace_diagram<Chain, Chain::omega>({alpha, ratio, 1}, omega.low,
                                                                                             omega.high, options);
        const auto picture = [&] { return script(diagram, ratio, alpha, omega.low, omega.high); };
        if (svg_file)
            svg_file->write(equilibria::gnuplot("svg size 1100,560 font 'Helvetica,14' background 'white'", picture()));
        if (png_file)
            png_file->write(equilibria::gnuplot("pngcairo size 2200,1120 fontscale 1.8 linewidth 2 pointscale 2", picture()));
        if (json_file) json_file->write(json(diagram, ratio, alpha));
        if (!json_file || !json_file->to_stdout()) {
            for (const auto& e : diagram.events)
                std::printf("%-9s  omega %.12f  at %9.6f %9.6f\n",
                            e.kind == equilibria::CriticalKind::fold ? "fold" : "pitchfork", e.value, e.q[0], e.q[1]);
            std::printf("%zu branches between them\n", diagram.pieces.size());
            if (diagram.failed_paths > 0)
                std::printf("INCOMPLETE: %llu paths failed; events may be missing.\n",
                            static_cast<unsigned long long>(diagram.failed_paths));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bifurcation_diagram: %s\n", error.what());
        return 1;
    }
}
