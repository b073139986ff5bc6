// Critical loads and post-critical paths of structures with large rotations: known cases, or a model of one's own from
// a JSON file.
//
//   buckling --case right_angle_frame --elements 32 --json frame.json --svg frame.svg
//   buckling --case right_angle_frame --first --elements 8
//   buckling --model frame.json --vtk shapes/frame
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/fem/loaded_state.hpp>
#include <equilibria/fem/loose_motion.hpp>
#include <equilibria/io/structure/structure_output.hpp>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "buckling/model.hpp"
#include "buckling/states.hpp"
#include "plots/buckling.hpp"
#include "support/buckling_cases.hpp"
#include "support/factors.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"
#include "support/tracing.hpp"

namespace {

using Eigen::Vector3d;
using equilibria::fem::Model;
using equilibria::fem::StructureState;
using support::Json;

/// What the command line says.
struct Command {
    const support::CaseEntry* entry = nullptr;  ///< or a model
    std::string model, order = "cubic", vtk;
    support::CaseData data;
    std::optional<int> steps;
    std::optional<double> at;
    bool first = false, verify = false;
    std::optional<support::Range> window;
    std::optional<support::OutputFile> json, csv, states;
    support::Pictures pictures;

    bool quiet() const { return to_stdout(json) || to_stdout(csv) || to_stdout(states); }
};

const support::CaseEntry* entry_of(const std::string& name) {
    for (const auto& c : support::buckling_cases())
        if (name == c.name || name == std::to_string(c.number)) return &c;
    return nullptr;
}

/// A case by name or number.
support::Rule a_case() {
    std::string names;
    for (const auto& c : support::buckling_cases()) names += (names.empty() ? "" : ", ") + std::string(c.name);
    return [names](std::string& text) {
        return support::verdict(entry_of(text) != nullptr, text, "must be a case: " + names);
    };
}

/// One of some words, which may depend on the case.
support::Rule one_of(std::function<std::vector<std::string>()> words) {
    return [words = std::move(words)](std::string& text) {
        std::string all;
        for (const std::string& word : words()) all += (all.empty() ? "" : ", ") + word;
        return support::one_of(words(), "must be one of " + all)(text);
    };
}

/// The data of a case, each refused where the case has no such thing.
void add_case_data(support::CommandLine& app, Command& c) {
    const auto only = [&c](support::Option option) {
        const std::string name = option.name();
        option.transform(support::applies([&c, name]() -> std::string {
            if (!c.entry) return c.model.empty() ? "" : "a model from a file";
            const auto& own = c.entry->options;
            return std::find(own.begin(), own.end(), name) == own.end() ? c.entry->name : "";
        }));
    };
    const auto positive = [&](const char* name, std::optional<double>& value, const char* text) {
        only(app.add_option(name, value, text).transform(support::positive()));
    };
    positive("--ei2", c.data.ei2, "bending stiffness about axis 2, or in the plane");
    positive("--ei3", c.data.ei3, "bending stiffness about axis 3");
    positive("--gj", c.data.gj, "torsional stiffness");
    positive("--ea", c.data.ea, "axial stiffness");
    positive("--ga", c.data.ga, "shear stiffness");
    only(app.add_option("--angle", c.data.angle, "opening angle of the arches, degrees")
             .transform(support::number("must be between 0 and 360, both excluded",
                                        [](double x) { return x > 0 && x < 360; })));
    only(app.add_option("--load-direction", c.data.load_direction,
                        "of the right-angle frame: +x, -x, +y or -y (default +x)")
             .transform(one_of([] { return std::vector<std::string>{"+x", "-x", "+y", "-y"}; })));
    only(app.add_option("--load", c.data.load, "of the ring: hydrostatic, fixed or central; of the dome: ring or apex")
             .transform(one_of([&c] {
                 return c.entry && c.entry->number == 13 ? std::vector<std::string>{"ring", "apex"}
                                                         : std::vector<std::string>{"hydrostatic", "fixed", "central"};
             })));
    only(app.add_option("--ends", c.data.ends, "of the column: cantilever, hinged, clamped or clamped-hinged")
             .transform(
                 one_of([] { return std::vector<std::string>{"cantilever", "hinged", "clamped", "clamped-hinged"}; })));
    only(app.add_option("--tension", c.data.tension, "of the twisted rod, T L^2 / EI2")
             .transform(support::finite("must be a number")));
    positive("--rise", c.data.rise, "of toggle, truss and shallow arch");
    only(app.add_option("--links", c.data.links, "of the chain, 1 to 1000 (default 3)")
             .transform(support::integer(1, 1000)));
}

Command read(int argc, char** argv) {
    Command c;
    support::Range window;
    support::CommandLine app{
        "Follows the equilibria of a structure with large rotations from its unloaded state, locates every critical "
        "point, and follows the branches that leave the first one. Cases are named by name or number."};
    app.add_option_function(
           "--case", [&c](const std::string& text) { c.entry = entry_of(text); },
           "a case's name or number; see docs/finite-rotations.md")
        .transform(a_case());
    app.add_option("--model", c.model, "a structure from this JSON file instead");
    app.add_option("--elements", c.data.elements, "of the case's structure, 1 to 100000 (default 32)")
        .transform(support::integer(1, 100000));
    app.add_option("--order", c.order, "of the elements: linear, quadratic or cubic (default cubic)")
        .transform(one_of([] { return std::vector<std::string>{"linear", "quadratic", "cubic"}; }));
    add_case_data(app, c);
    app.add_option("--parameter", window, "the range LOW:HIGH of the parameter (default: the case's own)")
        .transform(support::range("must be LOW:HIGH, finite, with LOW < HIGH", -1e12, 1e12));
    app.add_option("--steps", c.steps, "of each branch at most, 1 to 100000 (default: the case's own)")
        .transform(support::integer(1, 100000));
    app.add_option("--at", c.at, "also the place where the parameter has this value, instead of the case's own places")
        .transform(support::finite("must be a number"));
    app.add_flag("--first", c.first,
                 "end at the first critical point (of each direction, where a case goes both ways), and follow nothing "
                 "that leaves it");
    app.add_flag("--verify", c.verify,
                 "afterwards count the eigenvalues at 5 random points of each branch of the diagram, one by one, and "
                 "look for further branches by deflation at 3 values of the parameter");
    app.add_threads(c.data.threads,
                    "of assembly, 1 to 1024, 0 for one each core (default 1); does not change the result");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    support::add_output(app, "--csv", c.csv, "write the branches as CSV to this file, or to stdout for -");
    support::add_output(app, "--states", c.states,
                        "write displacements, reactions and section forces of a model at its critical points, at --at "
                        "and at the ends of branches, as CSV, to this file, or to stdout for -");
    app.add_option("--vtk", c.vtk, "write the deformed shapes to files NAME_branch_number.vtk");
    support::add_output(app, "--svg", c.pictures.svg, "draw branches and shapes to this SVG file (needs gnuplot)");
    support::add_output(app, "--png", c.pictures.png, "draw them to this PNG file (needs gnuplot)");
    app.parse("buckling", argc, argv);

    if ((app.given("--case")) == (app.given("--model")))
        support::fail("--case", app.given("--case") ? c.entry->name : "''", "must be given, or --model, and not both");
    c.data.nodes = c.order == "linear" ? 2 : c.order == "quadratic" ? 3 : 4;
    if (app.given("--parameter")) c.window = window;
    if (!c.vtk.empty()) support::OutputFile("--vtk", c.vtk + "_0_0.vtk");
    if (c.states && c.entry) support::fail("--states", "a case", "is for --model: cases have no names for their nodes");
    return c;
}

/// A configuration on a branch.
struct Shape {
    std::size_t branch;
    double parameter;  ///< in its unit
    double p;
    StructureState state;
};

/// What the run leaves besides the branches.
struct Run {
    int elements = 0, dofs = 0;
    bool in_space = false;  ///< else all moves in the x-y plane
    double seconds = 0;
    std::vector<Shape> shapes{};
    Json first_stage = nullptr;  ///< how constant loads came, if there are any
    std::vector<std::string> notes{};
    std::vector<Json> states{};                                     ///< of a model
    std::optional<equilibria::DiagramVerification> verification{};  ///< where it was asked for
};

template <class P>
Json document(const support::Tracing<P>& t, const Run& run) {
    Json out = json_of(t);
    out["elements"] = run.elements;
    out["dofs"] = run.dofs;
    out["seconds"] = run.seconds;
    out["first_stage"] = run.first_stage;
    out["notes"] = run.notes;
    if (!run.states.empty()) out["states"] = run.states;
    out["verification"] = run.verification ? json_of(*run.verification) : Json(nullptr);
    // all branches' points in one list
    out["branch"] = Json::array();
    for (std::size_t b = 0; b < t.branches.size(); ++b)
        for (const auto& point : t.branches[b].points) {
            Json row{{"branch", b},
                     {"parameter", point.parameter},
                     {"tip", point.measures},
                     {"stable", equilibria::json_or_null(point.stable)}};
            if (!point.at.empty()) row["at"] = point.at;
            out["branch"].push_back(std::move(row));
        }
    return out;
}

template <class P>
std::string csv(const support::Tracing<P>& t) {
    std::vector<std::vector<equilibria::BranchSample>> branches;
    for (const auto& b : t.branches) branches.push_back(b.points);
    return equilibria::branches_csv(branches, t.how.names).text();
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

/// The component of the watched node that moves most.
template <class P>
std::size_t widest(const support::Tracing<P>& t) {
    std::size_t most = 0;
    double width = -1;
    for (std::size_t c = 0; c < 3; ++c) {
        double low = 1e300, high = -1e300;
        for (const auto& b : t.branches)
            for (const auto& point : b.points)
                low = std::min(low, point.measures[c]), high = std::max(high, point.measures[c]);
        if (high - low > width) width = high - low, most = c;
    }
    return most;
}

/// Up to six shapes of the main branch and of the first that leaves it, equally spaced; how many of one.
long long add_shapes(equilibria::GnuplotData& data, const Model& model, const Run& run, std::size_t b, bool many) {
    std::vector<const Shape*> own;
    for (const Shape& shape : run.shapes)
        if (shape.branch == b) own.push_back(&shape);
    if (own.size() < 2) return 0;
    const std::size_t count = std::min<std::size_t>(b == 0 && many ? 2 : 6, own.size() - 1);
    for (std::size_t k = 1; k <= count; ++k)
        data.block("shape" + std::to_string(b) + "x" + std::to_string(k),
                   lines_of(model, own[k * (own.size() - 1) / count]->state), 3);
    return static_cast<long long>(count);
}

/// Branches, and shapes along them.
template <class P>
equilibria::GnuplotData plotted(const support::Tracing<P>& t, const P& structure, const Run& run) {
    equilibria::GnuplotData data;
    const std::size_t most = widest(t);
    add_branches(data, t, most);
    data.string("component", t.how.names[most]).integer("in_space", run.in_space);
    // about three tics on the longest axis: 1, 2 or 5 times a power of 10
    const double third = structure.length() / 3, power = std::pow(10, std::floor(std::log10(third)));
    data.value("tic", power * (third < 2 * power ? 1 : third < 5 * power ? 2 : 5));
    data.block("initial", lines_of(structure.model(), structure.initial()), 3);
    const bool many = t.branches.size() > 1;
    const long long main = t.branches.empty() ? 0 : add_shapes(data, structure.model(), run, 0, many),
                    side = many ? add_shapes(data, structure.model(), run, 1, many) : 0;
    data.integer("main_shapes", main).integer("side_shapes", side);
    return data;
}

/// What is followed, beside the structure itself.
struct Setup {
    std::string title, parameter;
    std::function<double(const StructureState&, double)> value;
    int tip;
    std::vector<support::CasePoint> points;
    equilibria::ContinuationOptions options;
    double amplitude;
    bool up, down;         ///< where the parameter goes from 0
    StructureState start;  ///< at 0
    Json first_stage = nullptr;
    std::vector<std::string> notes{};
    const equilibria::fem::StructureInput* input = nullptr;  ///< of a model
};

template <class S>
support::Tracing<S> tracing_of(const Setup& setup) {
    support::Tracing<S> t{.name = setup.title,
                          .how = {.parameter = setup.parameter,
                                  .names = {"x", "y", "z"},
                                  .measure =
                                      [tip = setup.tip](const StructureState& q) {
                                          const Vector3d& x = q.frames[static_cast<std::size_t>(tip)].x;
                                          return std::vector<double>(x.begin(), x.end());
                                      },
                                  .value = setup.value}};
    for (const auto& point : setup.points)
        t.functions.push_back(
            {point.name, [f = point.value](const equilibria::BranchPoint<S>& at) { return f(at.q, at.p); }});
    return t;
}

template <class S>
Run run_of(const S& structure) {
    Run run;
    for (int k = 0; k < structure.model().nodes(); ++k)
        run.in_space = run.in_space || structure.unknown(k, equilibria::fem::uz) >= 0;
    run.dofs = structure.size() - structure.multipliers();
    for (const auto& group : structure.model().groups())
        if (group->n_nodes() > 1) run.elements += static_cast<int>(group->size());
    return run;
}

template <class S>
void write_shapes(const std::string& name, const S& structure, const Run& run, const std::string& title) {
    std::vector<int> number;
    for (const Shape& shape : run.shapes) {
        number.resize(std::max(number.size(), shape.branch + 1));
        support::OutputFile(
            "--vtk", name + "_" + std::to_string(shape.branch) + "_" + std::to_string(number[shape.branch]++) + ".vtk")
            .write(vtk(structure, shape.state, shape.p, shape.parameter, title));
    }
}

template <class S>
void print(const support::Tracing<S>& t, const Run& run) {
    support::print(t);
    for (const auto& b : t.branches)
        for (const auto& point : b.points)
            if (!point.at.empty())
                std::printf("%s: %s %.10g, tip %.9g %.9g %.9g\n", point.at.c_str(), t.how.parameter.c_str(),
                            point.parameter, point.measures[0], point.measures[1], point.measures[2]);
    if (run.verification) {
        for (const std::string& mismatch : run.verification->mismatches)
            std::printf("MISMATCH: %s\n", mismatch.c_str());
        std::printf("%s\n", run.verification->summary().c_str());
    }
    std::printf("%d elements, %d degrees of freedom, %.2f s\n", run.elements, run.dofs, run.seconds);
}

/// Traces and writes.
template <class S>
void follow(const Command& c, const S& structure, Setup setup) {
    if (c.steps) setup.options.most_steps = *c.steps;
    if (c.at)
        setup.points = {
            {"at " + equilibria::to_text(*c.at),
             [value = setup.value, at = *c.at](const StructureState& q, double p) { return value(q, p) - at; }}};
    if (c.first) setup.options.most_critical_points = 1;
    // to be drawn, a branch needs more points than to be followed
    if (c.pictures.asked())
        setup.options.branch.largest_step =
            std::max(setup.options.branch.first_step, 0.3 * setup.options.branch.largest_step);
    if (c.window) {
        setup.options.range = {c.window->low, c.window->high};
        setup.up = c.window->high > 0;
        setup.down = c.window->low < 0;
    }
    auto t = tracing_of<S>(setup);
    Run run = run_of(structure);
    run.first_stage = setup.first_stage;
    run.notes = setup.notes;
    if (!c.vtk.empty() || c.pictures.asked())
        t.observe = [&](std::size_t branch, const StructureState& q, double p, const std::string&) {
            // one branch after the other, 4 million nodes at most
            if (run.shapes.size() * q.frames.size() < 4000000) run.shapes.push_back({branch, setup.value(q, p), p, q});
        };
    std::optional<StateRows<S>> rows;
    if (setup.input && (c.json || c.states)) rows.emplace(structure, *setup.input).watch(t);
    const auto begin = std::chrono::steady_clock::now();
    equilibria::check_derivatives(structure, structure.initial(), 0.0);
    trace(t, structure, {setup.start, setup.options, setup.amplitude, setup.up, setup.down, !c.first});
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    if (rows) run.states = rows->take();
    if (c.verify)
        run.verification = equilibria::bifurcation_diagram(
                               structure, setup.start, 0.0,
                               {.continuation = setup.options, .amplitude = setup.amplitude, .slices = 3, .checks = 5})
                               .verification;
    if (c.states) c.states->write(equilibria::fem::structure_results_csv(run.states).text());
    if (c.pictures.asked()) c.pictures.draw({1200, 560}, plotted(t, structure, run), plots::buckling);
    if (!c.vtk.empty()) write_shapes(c.vtk, structure, run, setup.title);
    if (c.csv) c.csv->write(csv(t));
    if (c.json) c.json->write(equilibria::json_text(document(t, run), 1));
    if (!c.quiet()) print(t, run);
}

void follow_case(const Command& c) {
    const support::BucklingCase s = c.entry->make(c.data);
    follow(c, s.structure,
           {c.entry->name,
            s.parameter,
            s.value,
            s.tip,
            s.points,
            s.options,
            s.amplitude,
            true,
            s.both_ways,
            s.structure.initial(),
            nullptr,
            {}});
}

void follow_model(const Command& c) {
    auto input = read_model(c.model);
    Setup setup{.title = input.name.empty() ? c.model : input.name,
                .parameter = input.parameter,
                .value = [](const StructureState&, double p) { return p; },
                .tip = input.measured,
                .points = {},
                .options = continuation_options(input),
                .amplitude = 0.02,
                .up = input.up,
                .down = input.down,
                .start = {},
                .first_stage = nullptr,
                .notes = {},
                .input = nullptr};
    const auto run = [&](const auto& structure) {
        const auto loaded = loaded_state(structure, setup.options);
        if (!loaded.reached()) throw std::runtime_error("p cannot begin: " + loaded.summary());
        if (!c.quiet()) {
            for (const std::string& note : input.notes) std::printf("Note: %s.\n", note.c_str());
            if (structure.model().has_constant_loads())
                std::printf("First stage, constant loads from 0 to 1: %s.\n",
                            loaded.summary().empty() ? "no critical point" : loaded.summary().c_str());
        }
        setup.start = loaded.state;
        setup.notes = input.notes;
        setup.input = &input;
        if (structure.model().has_constant_loads()) {
            Json passed = Json::array();
            for (const auto& [kind, at] : loaded.passed) passed.push_back({{"kind", to_string(kind)}, {"share", at}});
            setup.first_stage = {
                {"share", loaded.share}, {"critical_points", passed}, {"unexplained_steps", loaded.unexplained}};
        }
        if (const auto loose = equilibria::fem::loose_motion(structure, loaded.state, 0))
            throw std::runtime_error("the structure moves without a force: " + name_of(input, loose->node) + ", " +
                                     to_string(loose->component));
        follow(c, structure, setup);
    };
    equilibria::fem::StructureOptions options{.executor = equilibria::threads(c.data.threads),
                                              .symmetric_images = true};
    if (input.conservative) {
        const equilibria::fem::Structure structure(std::move(input.model), options);
        options.factors = support::factors_for(structure);
        if (!options.factors) return run(structure);
        if (!c.quiet()) std::puts("Tangents are factored by MUMPS.");
        run(equilibria::fem::Structure(structure.model(), options));
    } else {
        run(equilibria::fem::NonconservativeStructure(std::move(input.model), options));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        if (c.entry)
            follow_case(c);
        else
            follow_model(c);
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
--case 5 --at nowhere
    buckling: --at nowhere: must be a number
--case 5 --elements 0
    buckling: --elements 0: must be an integer from 1 to 100000
*/
