// The folds of the rotating chain of two links over alpha, omega and the ratio of its lengths: planes of constant
// ratio side by side, and the surface through them as an interactive page.
//
//   fold_surface --planes 1.1,1.2,1.5,1.7,1.9,2.2 --svg planes.svg --png planes.png
//   fold_surface --ratio 1.2:2.4 --slices 25 --html surface.html --plotly "$(scripts/plotly)"
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/plotly.hpp>
#include <equilibria/io/results/locus_output.hpp>

#include "fold_surface/figure.hpp"
#include "fold_surface/sheets.hpp"
#include "fold_surface/view.hpp"
#include "plots/fold_surface.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using namespace fold_surface;

/// What the command line says.
struct Command {
    support::List ratios{{1.1, 1.2, 1.5, 1.7, 1.9, 2.2}};
    support::Range ratio{1.2, 2.4}, alpha{0, 1}, omega{0, 5};
    int slices = 25, bisections = 4;
    equilibria::RunOptions run{.executor = equilibria::threads(0)};
    equilibria::LocusOptions options;
    std::string library;  ///< the text of Plotly
    std::optional<support::OutputFile> html, json;
    support::Pictures pictures;

    Window window() const { return {{alpha.low, alpha.high}, {omega.low, omega.high}}; }
    bool quiet() const {
        return to_stdout(json) || to_stdout(html) || to_stdout(pictures.svg) || to_stdout(pictures.png);
    }
};

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

void add_options(support::CommandLine& app, Command& c) {
    app.add_option("--planes", c.ratios, "the ratios of the figure's planes (default 1.1,1.2,1.5,1.7,1.9,2.2)")
        .transform(support::list("must be 1 to 12 positive numbers, with commas between", 1, 12,
                                 [](double x) { return x > 0; }));
    app.add_option("--ratio", c.ratio, "the surface's range of l2 / l1; slow below 1.15 (default 1.2:2.4)")
        .transform(
            support::range("must be LOW:HIGH, finite, with 0 < LOW < HIGH", std::numeric_limits<double>::min(), 1e6));
    app.add_option("--slices", c.slices, "planes of constant ratio of the surface, 2 to 1000 (default 25)")
        .transform(support::integer(2, 1000));
    app.add_option("--bisections", c.bisections,
                   "how often the gap between planes whose curves do not match is halved, 0 to 20 (default 4)")
        .transform(support::integer(0, 20));
    app.add_option("--alpha", c.alpha, "the window's range of alpha, within 0:1 (default 0:1)")
        .transform(support::range("must be LOW:HIGH with 0 <= LOW < HIGH <= 1", 0, 1));
    app.add_option("--omega", c.omega, "the window's range of omega (default 0:5)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_option("--lines", c.options.lines,
                   "lines in each direction that are solved for seeds, 2 to 1000 (default 4)")
        .transform(support::integer(2, 1000));
    app.add_seed(c.run.seed, "of the random start systems, an integer (default 1)");
    c.pictures.add_to(app, "the planes");
}

Command read(int argc, char** argv) {
    Command c;
    c.options.checks = 0;
    c.options.lines = 4;
    std::string html_name, plotly_name;
    support::CommandLine app{
        "The surface of folds of the rotating chain of two links over alpha = m2 / (m1 + m2), omega and ratio = "
        "l2 / l1: planes of constant ratio in one figure, and an interactive page."};
    add_options(app, c);
    app.add_option("--html", html_name, "write the surface as a page to this file");
    app.add_option("--plotly", plotly_name, "the library for the page: the file whose path scripts/plotly prints");
    support::add_output(app, "--json", c.json, "write the planes and their cusps to this file, or to stdout for -");
    app.parse("fold_surface", argc, argv);
    const bool page = app.given("--html");
    if (page != (app.given("--plotly")))
        support::fail(page ? "--html" : "--plotly", "", page ? "needs --plotly" : "has no use without --html");
    if (page) {
        c.library = library(plotly_name);
        c.html.emplace("--html", html_name);
    }
    return c;
}

Json document(const Planes& planes, const std::optional<Surface>& surface) {
    const equilibria::AxisNames names{.x = "alpha", .y = "omega"};
    const auto& w = planes.window();
    Json out{{names.x, equilibria::json_range(w.x.low, w.x.high)},
             {names.y, equilibria::json_range(w.y.low, w.y.high)},
             {"planes", Json::array()}};
    for (const auto& [ratio, plane] : planes.all()) {
        Json cusps = Json::array();
        for (const auto& cusp : plane.locus.of(equilibria::SingularityKind::cusp))
            cusps.push_back(equilibria::cusp_json(cusp, names));
        out["planes"].push_back({{"ratio", ratio},
                                 {"cusps", std::move(cusps)},
                                 {"complete", plane.locus.evidence.complete()},
                                 {"argument", plane.locus.argument()},
                                 {"seconds", plane.locus.evidence.seconds}});
    }
    if (surface) {
        out["gaps"] = Json::array();
        for (const auto& gap : surface->gaps) out["gaps"].push_back(equilibria::json_range(gap.low, gap.high));
    }
    return out;
}

void print(const Planes& planes, const std::optional<Surface>& surface) {
    for (const auto& [ratio, plane] : planes.all()) {
        const auto& e = plane.locus.evidence;
        std::printf("ratio %-10.10g  %-8s  %s  %.1f s\n", ratio, cusp_count(plane.locus).c_str(),
                    e.complete() ? "complete" : "NOT COMPLETE", e.seconds);
        for (const auto& c : plane.locus.of(equilibria::SingularityKind::cusp))
            std::printf("  cusp  alpha %.14f  omega %.14f\n", c.x(), c.y());
        if (!e.complete()) std::printf("  %s\n", plane.locus.argument().c_str());
    }
    if (surface)
        for (const auto& gap : surface->gaps)
            std::printf("gap    ratio %.10g to %.10g: curves end there, or join in another way\n", gap.low, gap.high);
}

void draw(Planes& planes, const Command& c) {
    planes.trace(c.ratios.values, "planes");
    if (!c.pictures.asked()) return;
    std::vector<const Plane*> shown;
    for (const double ratio : c.ratios.values) shown.push_back(&planes.at(ratio));
    c.pictures.draw(Layout(shown.size()).size(), plotted(shown), plots::fold_surface);
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        Planes planes(c.window(), c.run, c.options);
        if (c.pictures.asked() || !c.html) draw(planes, c);
        std::optional<Surface> found;
        if (c.html) {
            found = surface(planes, {c.ratio.low, c.ratio.high}, c.slices, c.bisections);
            c.html->write(equilibria::plotly_page(view(planes, *found), c.library));
        }
        if (c.json) c.json->write(equilibria::json_text(document(planes, found), 1));
        if (!c.quiet()) print(planes, found);
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
