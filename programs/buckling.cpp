// Critical loads and post-critical paths of structures with large rotations: known cases, or a model of one's own from
// a JSON file.
//
//   buckling --case right_angle_frame --elements 32 --json frame.json --svg frame.svg
//   buckling --model frame.json --vtk shapes/frame
#include <chrono>
#include <cmath>
#include <cstdio>
#include <equilibria/fem/loose_motion.hpp>
#include <equilibria/io/structure/structure_json.hpp>
#include <equilibria/io/structure/structure_output.hpp>
#include <iomanip>

#include "instances/fem/structure_branches.hpp"
#include "support/buckling_cases.hpp"
#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/tracing.hpp"

namespace {

using Eigen::Vector3d;
using equilibria::fem::Model;
using equilibria::fem::StructureState;
using support::Json;

/// A configuration on a branch.
struct Shape {
    std::size_t branch;
    double parameter;
    StructureState state;
};

/// What the run leaves besides the branches.
struct Run {
    int elements = 0, dofs = 0;
    bool in_space = false;  ///< else all moves in the x-y plane
    double seconds = 0;
    std::vector<Shape> shapes;
};

template <class P>
std::string json(const support::Tracing<P>& t, const Run& run) {
    Json out{{"case", t.name},           {"parameter", t.parameter},
             {"elements", run.elements}, {"dofs", run.dofs},
             {"seconds", run.seconds},   {"critical_points", critical_points_json(t)},
             {"branch", Json::array()},  {"branches", Json::array()},
             {"families", t.families},   {"unexplained_steps", t.unexplained}};
    for (std::size_t b = 0; b < t.branches.size(); ++b) {
        for (const auto& point : t.branches[b].points) {
            Json row{{"branch", b}, {"parameter", point.parameter}, {"tip", point.measures}, {"stable", point.stable}};
            if (!point.name.empty()) row["at"] = point.name;
            out["branch"].push_back(std::move(row));
        }
        const auto& parent = t.branches[b].parent;
        out["branches"].push_back({{"parent", parent ? Json(*parent) : Json(nullptr)}, {"end", t.branches[b].end}});
    }
    return out.dump(1) + "\n";
}

template <class P>
std::string csv(const support::Tracing<P>& t) {
    std::ostringstream out;
    out.precision(17);
    out << "branch,parameter,x,y,z,stable,at\n";
    for (std::size_t b = 0; b < t.branches.size(); ++b)
        for (const auto& point : t.branches[b].points)
            out << b << ',' << point.parameter << ',' << point.measures[0] << ',' << point.measures[1] << ','
                << point.measures[2] << ',' << point.stable << ',' << std::quoted(point.name) << '\n';
    return out.str();
}

/// A node of a model in words.
std::string name_of(const equilibria::fem::StructureInput& input, int node) {
    for (const auto& [name, number] : input.nodes)
        if (number == node) return "node " + name;
    return "a node within a beam";
}

/// The elements as rows "x z y": figures in space have the y axis upright.
std::string lines_of(const Model& model, const StructureState& state) {
    std::ostringstream out;
    for (const auto& line : equilibria::fem::element_lines(model)) {
        for (const int node : line) {
            const Vector3d& x = state.frames[static_cast<std::size_t>(node)].x;
            out << x(0) << ' ' << x(2) << ' ' << x(1) << '\n';
        }
        out << "\n\n";
    }
    return out.str();
}

/// Branches at the left, shapes along them at the right.
template <class P>
std::string script(const support::Tracing<P>& t, const P& structure, const Run& run) {
    // the component of the tip that moves most
    std::size_t most = 0;
    double widest = -1;
    for (std::size_t c = 0; c < 3; ++c) {
        double low = 1e300, high = -1e300;
        for (const auto& b : t.branches)
            for (const auto& point : b.points)
                low = std::min(low, point.measures[c]), high = std::max(high, point.measures[c]);
        if (high - low > widest) widest = high - low, most = c;
    }
    std::ostringstream out;
    out << branch_blocks(t, most)
        << equilibria::gnuplot_block("initial", lines_of(structure.model(), structure.initial()));
    // up to six shapes of the main branch and of the first that leaves it, equally spaced
    std::ostringstream plots;
    const char* columns = run.in_space ? "" : " using 1:3";
    for (std::size_t b = 0; b < std::min<std::size_t>(2, t.branches.size()); ++b) {
        std::vector<const Shape*> own;
        for (const Shape& shape : run.shapes)
            if (shape.branch == b) own.push_back(&shape);
        if (own.size() < 2) continue;
        const std::size_t count = std::min<std::size_t>(b == 0 && t.branches.size() > 1 ? 2 : 6, own.size() - 1);
        for (std::size_t k = 1; k <= count; ++k) {
            const std::string name = "shape" + std::to_string(b) + "x" + std::to_string(k);
            out << equilibria::gnuplot_block(name,
                                             lines_of(structure.model(), own[k * (own.size() - 1) / count]->state));
            plots << ", $" << name << columns << " with lines lw 1.6 lc rgb '" << (b == 0 ? "#009e73" : "#e69f00")
                  << "' " << (k == 1 ? (b == 0 ? "title 'main branch'" : "title 'side branch'") : "notitle");
        }
    }
    // about three tics on the longest axis: 1, 2 or 5 times a power of 10
    const double third = structure.length() / 3, power = std::pow(10, std::floor(std::log10(third)));
    const double tic = power * (third < 2 * power ? 1 : third < 5 * power ? 2 : 5);
    out << "set multiplot title '" << support::title(t.name) << "'\nset tics out nomirror\nset border 31 lw 0.8\n"
        << "set bmargin at screen 0.22\nset tmargin at screen 0.9\n"
        << "set lmargin at screen 0.09\nset rmargin at screen 0.47\n"
        << "set key at screen 0.28,0.01 center bottom horizontal maxrows 2 samplen 2\n"
        << "set xlabel '{/:Italic " << t.measures[most] << "} of the watched node'\n"
        << "set ylabel '" << t.parameter << "'\n"
        << support::branch_plot() << "set key at screen 0.77,0.03 center bottom horizontal maxrows 1\n"
        << "set lmargin at screen 0.56\nset rmargin at screen 0.97\nunset ylabel\nunset xlabel\n";
    if (!run.in_space)
        out << "set size ratio -1\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\nplot";
    else
        out << "set view 75,335\nset view equal xyz\nset xyplane relative 0\nset xlabel '{/:Italic x}'\n"
            << "set ylabel '{/:Italic z}'\nset zlabel '{/:Italic y}'\nset xtics " << tic << " offset 0,-0.3\nset ytics "
            << tic << "\nset ztics " << tic << "\nsplot";
    out << " $initial" << columns << " with lines lw 2.4 lc rgb '#888888' title 'without load'" << plots.str()
        << "\nunset multiplot\n";
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    std::string name, model_name, elements_text = "32", order = "cubic", links_text = "3", steps_text, window_text,
                                  json_name, csv_name, vtk_name, svg_name, png_name;
    std::string ei2, ei3, gj, ea, ga, angle, tension, rise, threads_text = "1";
    support::CaseData data;
    CLI::App app{
        "Follows the equilibria of a structure with large rotations from its unloaded state, locates every critical "
        "point, and follows the branches that leave the first one. Cases are named by name or number."};
    app.add_option("--case", name, "a case's name or number; see docs/finite-rotations.md");
    app.add_option("--model", model_name, "a structure from this JSON file instead");
    app.add_option("--elements", elements_text, "of the case's structure, 1 to 100000 (default 32)");
    app.add_option("--order", order, "of the elements: linear, quadratic or cubic (default cubic)");
    app.add_option("--ei2", ei2, "bending stiffness about axis 2, or in the plane");
    app.add_option("--ei3", ei3, "bending stiffness about axis 3");
    app.add_option("--gj", gj, "torsional stiffness");
    app.add_option("--ea", ea, "axial stiffness");
    app.add_option("--ga", ga, "shear stiffness");
    app.add_option("--angle", angle, "opening angle of the arches, degrees");
    app.add_option("--load-direction", data.load_direction, "of the right-angle frame: +x, -x, +y or -y (default +x)");
    app.add_option("--load", data.load, "of the ring: hydrostatic, fixed or central; of the dome: ring or apex");
    app.add_option("--ends", data.ends, "of the column: cantilever, hinged, clamped or clamped-hinged");
    app.add_option("--tension", tension, "of the twisted rod, T L^2 / EI2");
    app.add_option("--rise", rise, "of toggle, truss and shallow arch");
    app.add_option("--links", links_text, "of the chain, 1 to 1000 (default 3)");
    app.add_option("--parameter", window_text, "the range LOW:HIGH of the parameter (default: the case's own)");
    app.add_option("--steps", steps_text, "of each branch at most, 1 to 100000 (default: the case's own)");
    app.add_option("--threads", threads_text,
                   "of assembly, 1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -");
    app.add_option("--csv", csv_name, "write the branches as CSV to this file, or to stdout for -");
    app.add_option("--vtk", vtk_name, "write the deformed shapes to files NAME_branch_number.vtk");
    app.add_option("--svg", svg_name, "draw branches and shapes to this SVG file (needs gnuplot)");
    app.add_option("--png", png_name, "draw them to this PNG file (needs gnuplot)");
    support::parse(app, "buckling", argc, argv);

    const auto given = [&](const char* option) { return app.count(option) > 0; };
    if (given("--case") == given("--model"))
        support::fail("--case", given("--case") ? name : "''", "must be given, or --model, and not both");
    const support::CaseEntry* entry = nullptr;
    if (given("--case")) {
        std::string names;
        for (const auto& c : support::buckling_cases()) {
            if (name == c.name || name == std::to_string(c.number)) entry = &c;
            names += (names.empty() ? "" : ", ") + std::string(c.name);
        }
        if (!entry) support::fail("--case", name, "must be a case: " + names);
    }
    for (const char* option : {"--ei2", "--ei3", "--gj", "--ea", "--ga", "--angle", "--load-direction", "--load",
                               "--ends", "--tension", "--rise", "--links"})
        if (given(option) &&
            (!entry || std::find(entry->options.begin(), entry->options.end(), option) == entry->options.end()))
            support::fail(
                option, app.get_option(option)->as<std::string>(),
                entry ? "does not apply to " + std::string(entry->name) : "does not apply to a model from a file");
    const auto positive = [&](const char* option, const std::string& text, std::optional<double>& to) {
        if (given(option))
            to = support::number(option, text, "must be a positive number", [](double x) { return x > 0; });
    };
    positive("--ei2", ei2, data.ei2);
    positive("--ei3", ei3, data.ei3);
    positive("--gj", gj, data.gj);
    positive("--ea", ea, data.ea);
    positive("--ga", ga, data.ga);
    positive("--rise", rise, data.rise);
    if (given("--angle"))
        data.angle = support::number("--angle", angle, "must be between 0 and 360, both excluded",
                                     [](double x) { return x > 0 && x < 360; });
    if (given("--tension"))
        data.tension = support::number("--tension", tension, "must be a number", [](double) { return true; });
    const auto one_of = [&](const char* option, const std::string& text, std::initializer_list<const char*> words) {
        std::string all;
        for (const char* word : words) all += (all.empty() ? "" : ", ") + std::string(word);
        if (given(option) && std::find(words.begin(), words.end(), text) == words.end())
            support::fail(option, text, "must be one of " + all);
    };
    one_of("--load-direction", data.load_direction, {"+x", "-x", "+y", "-y"});
    one_of("--ends", data.ends, {"cantilever", "hinged", "clamped", "clamped-hinged"});
    one_of("--order", order, {"linear", "quadratic", "cubic"});
    if (entry && entry->number == 13) one_of("--load", data.load, {"ring", "apex"});
    if (entry && entry->number == 14) one_of("--load", data.load, {"hydrostatic", "fixed", "central"});
    data.nodes = order == "linear" ? 2 : order == "quadratic" ? 3 : 4;
    data.elements = support::integer<int>("--elements", elements_text, 1, 100000);
    data.links = support::integer<int>("--links", links_text, 1, 1000);
    data.threads = support::integer<unsigned>("--threads", threads_text, 0, 1024);
    std::optional<support::OutputFile> json_file, csv_file, svg_file, png_file;
    if (given("--json")) json_file.emplace("--json", json_name);
    if (given("--csv")) csv_file.emplace("--csv", csv_name);
    if (given("--svg")) svg_file.emplace("--svg", svg_name);
    if (given("--png")) png_file.emplace("--png", png_name);
    if (given("--vtk")) support::OutputFile("--vtk", vtk_name + "_0_0.vtk");

    const auto change = [&](equilibria::ContinuationOptions& options) {
        if (given("--steps")) options.most_steps = support::integer<int>("--steps", steps_text, 1, 100000);
        if (given("--parameter")) {
            const auto window =
                support::range("--parameter", window_text, "must be LOW:HIGH, finite, with LOW < HIGH", -1e12, 1e12);
            options.low = window.low;
            options.high = window.high;
        }
    };
    const auto follow = [&](const auto& structure, const std::string& title, const std::string& parameter,
                            const auto& value, int tip, const std::vector<support::CasePoint>& points,
                            equilibria::ContinuationOptions options, double amplitude, bool both_ways) {
        using Structure = std::remove_cvref_t<decltype(structure)>;
        change(options);
        support::Tracing<Structure> t;
        t.name = title;
        t.parameter = parameter;
        t.measures = {"x", "y", "z"};
        t.value = value;
        t.measure = [=](const StructureState& q) {
            const Vector3d& x = q.frames[static_cast<std::size_t>(tip)].x;
            return std::vector<double>(x.begin(), x.end());
        };
        for (const auto& point : points)
            t.functions.push_back({point.name, [f = point.value](const equilibria::BranchPoint<Structure>& at) {
                                       return f(at.q, at.p);
                                   }});
        Run run;
        for (int k = 0; k < structure.model().nodes(); ++k)
            run.in_space = run.in_space || structure.unknown(k, equilibria::fem::uz) >= 0;
        run.dofs = structure.size() - structure.multipliers();
        for (const auto& group : structure.model().groups())
            if (group->n_nodes() > 1) run.elements += static_cast<int>(group->size());
        if (given("--vtk") || svg_file || png_file)
            t.observe = [&](std::size_t branch, const StructureState& q, double p) {
                // one branch after the other, 4 million nodes at most
                if (run.shapes.size() * q.frames.size() < 4000000) run.shapes.push_back({branch, value(q, p), q});
            };
        const auto begin = std::chrono::steady_clock::now();
        equilibria::check_derivatives(structure, structure.initial(), 0.0);
        support::trace(t, structure, structure.initial(), options, amplitude, both_ways);
        run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (svg_file)
            svg_file->write(equilibria::gnuplot("svg size 1200,560 font 'Helvetica,14' background 'white'",
                                                script(t, structure, run)));
        if (png_file)
            png_file->write(equilibria::gnuplot("pngcairo size 2400,1120 fontscale 1.8 linewidth 2 pointscale 2",
                                                script(t, structure, run)));
        std::vector<int> number(t.branches.size());
        if (given("--vtk"))
            for (const Shape& shape : run.shapes)
                support::OutputFile("--vtk", vtk_name + "_" + std::to_string(shape.branch) + "_" +
                                                 std::to_string(number[shape.branch]++) + ".vtk")
                    .write(vtk(structure.model(), shape.state, shape.parameter, title));
        if (csv_file) csv_file->write(csv(t));
        if (json_file) json_file->write(json(t, run));
        if ((!json_file || !json_file->to_stdout()) && (!csv_file || !csv_file->to_stdout())) {
            print(t);
            for (const auto& b : t.branches)
                for (const auto& point : b.points)
                    if (!point.name.empty())
                        std::printf("%s: %s %.10g, tip %.9g %.9g %.9g\n", point.name.c_str(), parameter.c_str(),
                                    point.parameter, point.measures[0], point.measures[1], point.measures[2]);
            std::printf("%d elements, %d degrees of freedom, %.2f s\n", run.elements, run.dofs, run.seconds);
        }
    };
    try {
        if (entry) {
            const support::BucklingCase c = entry->make(data);
            follow(c.structure, entry->name, c.parameter, c.value, c.tip, c.points, c.options, c.amplitude,
                   c.both_ways);
        } else {
            auto input = equilibria::fem::read_structure(model_name);
            equilibria::ContinuationOptions options;
            options.low = input.low;
            options.high = input.high;
            options.path.first_step = input.first_step.value_or(0.01);
            options.path.largest_step = input.largest_step.value_or(0.1);
            const auto value = [](const StructureState&, double p) { return p; };
            const auto run = [&](const auto& structure) {
                if (const auto loose = equilibria::fem::loose_motion(structure, structure.initial(), 0))
                    throw std::runtime_error("the structure moves without a force: " + name_of(input, loose->node) +
                                             ", " + to_string(loose->component));
                follow(structure, input.name.empty() ? model_name : input.name, input.parameter, value, input.measured,
                       {}, options, 0.02, false);
            };
            const equilibria::fem::StructureOptions structure_options{.executor = equilibria::threads(data.threads)};
            if (input.conservative)
                run(equilibria::fem::Structure(std::move(input.model), structure_options));
            else
                run(equilibria::fem::NonconservativeStructure(std::move(input.model), structure_options));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "buckling: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--case bridge
    buckling: --case bridge: must be a case: euler_column, roll_up, lateral_cantilever, lateral_strip, right_angle_frame, hinged_frame, deep_arch, hinged_arch, lee_frame, williams_toggle, von_mises_truss, star_dome, ring, twisted_rod, bend, rigid_link_chain, shallow_arch
--case deep_arch --rise 2
    buckling: --rise 2: does not apply to deep_arch
--case deep_arch --angle 400
    buckling: --angle 400: must be between 0 and 360, both excluded
--case right_angle_frame --gj -1
    buckling: --gj -1: must be a positive number
--case ring --load sideways
    buckling: --load sideways: must be one of hydrostatic, fixed, central
--case 5 --elements 0
    buckling: --elements 0: must be an integer from 1 to 100000
*/
