// Equilibrium branches of structures with known critical points: folds and bifurcations located exactly, side branches
// followed.
//
//   branch_tracing --case star_dome --svg dome.svg
#include <cstdio>
#include <equilibria/io/gnuplot.hpp>
#include <optional>
#include <sstream>
#include <type_traits>
#include <vector>

#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/structures.hpp"
#include "support/tracing.hpp"

namespace {

using Eigen::VectorXd;
using support::Json;

template <class P>
std::string json(const support::Tracing<P>& t) {
    Json out{{"case", t.name},
             {"parameter", t.parameter},
             {"measures", t.measures},
             {"critical_points", critical_points_json(t)},
             {"branches", Json::array()},
             {"unexplained_steps", t.unexplained}};
    for (const auto& b : t.branches) {
        Json points = Json::array(), stable = Json::array();
        for (const auto& point : b.points) {
            points.push_back({point.parameter, point.measures[0], point.measures[1]});
            stable.push_back(point.stable);
        }
        out["branches"].push_back({{"points", std::move(points)},
                                   {"stable", std::move(stable)},
                                   {"parent", b.parent ? Json(*b.parent) : Json(nullptr)},
                                   {"end", b.end}});
    }
    return out.dump(1) + "\n";
}

/// The parameter over the first measure; stable parts of branches heavier.
template <class P>
std::string script(const support::Tracing<P>& t) {
    std::ostringstream out;
    out << branch_blocks(t, 0) << "set tics out nomirror\nset border 31 lw 0.8\nset key outside right top samplen 2\n"
        << "set title '" << support::title(t.name) << "'\nset xlabel '" << t.measures[0] << "'\nset ylabel '"
        << t.parameter << "'\n"
        << support::branch_plot();
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    std::string name, rise_text, strain_text = "green", load_text = "ring", links_text = "3", steps_text = "1000",
                                 window_text, json_name, svg_name, png_name;
    CLI::App app{
        "Follows the equilibria of a structure from its unloaded state, locates every fold and bifurcation, and "
        "follows "
        "the branches that leave the first one."};
    app.add_option("--case", name, "von_mises_truss, star_dome, shallow_arch, rigid_link_chain or spring_elastica");
    app.add_option("--rise", rise_text, "of the truss over its half span (default 2), or of the arch (default 2.5)");
    app.add_option("--strain", strain_text, "of the trusses' bars: green or engineering (default green)");
    app.add_option("--load", load_text, "of the dome: ring (1 a node, 0.5 at the apex) or apex (default ring)");
    app.add_option("--links", links_text, "of the chains, 1 to 100000 (default 3)");
    app.add_option("--parameter", window_text, "the range LOW:HIGH of the load (default: the case's own)");
    app.add_option("--steps", steps_text, "of each branch at most, 1 to 100000 (default 1000)");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--svg", svg_name, "draw the branches to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw the branches to this PNG file (needs gnuplot)");
    support::parse(app, "branch_tracing", argc, argv);

    const bool truss = name == "von_mises_truss", dome = name == "star_dome", arch = name == "shallow_arch",
               rigid = name == "rigid_link_chain", elastica = name == "spring_elastica";
    if (!truss && !dome && !arch && !rigid && !elastica)
        support::fail("--case", name,
                      "must be von_mises_truss, star_dome, shallow_arch, rigid_link_chain or spring_elastica");
    if (strain_text != "green" && strain_text != "engineering")
        support::fail("--strain", strain_text, "must be green or engineering");
    if (load_text != "ring" && load_text != "apex") support::fail("--load", load_text, "must be ring or apex");
    const auto applies = [&](const char* option, bool here, const std::string& text) {
        if (app.count(option) > 0 && !here) support::fail(option, text, "does not apply to " + name);
    };
    applies("--rise", truss || arch, rise_text);
    applies("--strain", truss || dome, strain_text);
    applies("--load", dome, load_text);
    applies("--links", rigid || elastica, links_text);
    if (rise_text.empty()) rise_text = arch ? "2.5" : "2";
    const double rise =
        support::number("--rise", rise_text, "must be a positive number", [](double r) { return r > 0; });
    const int links = support::integer<int>("--links", links_text, 1, rigid ? 200 : 100000);
    equilibria::ContinuationOptions options;
    options.most_steps = support::integer<int>("--steps", steps_text, 1, 100000);
    std::optional<support::OutputFile> json_file, svg_file, png_file;
    if (app.count("--json") > 0) json_file.emplace("--json", json_name);
    if (app.count("--svg") > 0) svg_file.emplace("--svg", svg_name);
    if (app.count("--png") > 0) png_file.emplace("--png", png_name);

    const auto strain = strain_text == "green" ? support::Strain::green : support::Strain::engineering;
    const auto window = [&](double low, double high) {
        options.low = low;
        options.high = high;
        if (app.count("--parameter") > 0) {
            const auto given =
                support::range("--parameter", window_text, "must be LOW:HIGH, finite, with LOW < HIGH", -1e12, 1e12);
            options.low = given.low;
            options.high = given.high;
        }
    };
    options.path.largest_step = 0.05;
    try {
        const auto run = [&](const auto& problem, const VectorXd& start, double amplitude, const char* parameter,
                             std::vector<std::string> measures, const auto& measure) {
            support::Tracing<std::remove_cvref_t<decltype(problem)>> t;
            t.name = name;
            t.parameter = parameter;
            t.measures = std::move(measures);
            t.value = [](const VectorXd&, double p) { return p; };
            t.measure = measure;
            trace(t, problem, start, options, amplitude);
            if (svg_file)
                svg_file->write(
                    equilibria::gnuplot("svg size 1000,620 font 'Helvetica,14' background 'white'", script(t)));
            if (png_file)
                png_file->write(
                    equilibria::gnuplot("pngcairo size 2000,1240 fontscale 1.8 linewidth 2 pointscale 2", script(t)));
            if (json_file) json_file->write(json(t));
            if (!json_file || !json_file->to_stdout()) print(t);
        };
        if (truss) {
            const auto problem = support::von_mises_truss(rise, strain);
            window(-1, 1);
            run(problem, problem.unloaded(), 0.02 * rise, "P / EA", {"height of the apex", "sway of the apex"},
                [&](const VectorXd& q) { return std::vector{problem.at(q, 1)(1), problem.at(q, 1)(0)}; });
        } else if (dome) {
            const bool ring = load_text == "ring";
            const auto problem = support::star_dome(ring ? 0.5 : 1, ring ? 1 : 0, strain);
            window(-1e-3, ring ? 2e-3 : 1e-3);
            run(problem, problem.unloaded(), 0.3, "P / EA", {"height of the apex", "sway of the apex"},
                [&](const VectorXd& q) {
                    const Eigen::Vector3d x = problem.at(q, 0);
                    return std::vector{x(2), std::hypot(x(0), x(1))};
                });
        } else if (arch) {
            const support::ShallowArch problem{rise};
            const double fold = rise > 1 ? problem.fold() : rise;
            window(2 * rise - fold - 3, fold + 3);
            run(problem, Eigen::Vector2d(rise, 0), 0.02 * rise, "q", {"A1", "A2"},
                [](const VectorXd& q) { return std::vector{q(0), q(1)}; });
        } else {
            const support::SpringElastica problem{links};
            const double critical = problem.buckling_load();
            window(-critical, rigid ? 4.5 : 1.5 * critical);
            options.path.parameter_weight = 1 / critical;
            const std::vector<std::string> measures{"angle of the last link", "root mean square of the angles"};
            const auto measure = [](const VectorXd& q) {
                return std::vector{q(q.size() - 1), q.norm() / std::sqrt(static_cast<double>(q.size()))};
            };
            if (rigid)
                run(support::DenseSpringElastica{{links}}, VectorXd::Zero(links), 0.05, "P l / c", measures, measure);
            else
                run(problem, VectorXd::Zero(links), 0.05, "P l / c", measures, measure);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "branch_tracing: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--case bridge
    branch_tracing: --case bridge: must be von_mises_truss, star_dome, shallow_arch, rigid_link_chain or spring_elastica
--case star_dome --rise 2
    branch_tracing: --rise 2: does not apply to star_dome
--case von_mises_truss --rise 0
    branch_tracing: --rise 0: must be a positive number
--case star_dome --load sideways
    branch_tracing: --load sideways: must be ring or apex
--case rigid_link_chain --links 201
    branch_tracing: --links 201: must be an integer from 1 to 200
*/
