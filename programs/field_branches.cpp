// Branches of discretised differential equations: Bratu's, Gelfand's, the Swift-Hohenberg equation, Carrier's. Folds
// and bifurcations are located exactly, side branches followed, other solutions found by deflation.
//
//   field_branches --case bratu --dimension 2 --intervals 64
//   field_branches --case swift_hohenberg --png snaking.png
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/io/results/branch_output.hpp>

#include "plots/field_branches.hpp"
#include "support/fields.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using Eigen::VectorXd;
using equilibria::Json;

/// What the command line says.
struct Command {
    std::string name;
    int dimension = 1, degree = 1;
    std::optional<int> intervals, branches, steps;
    std::optional<double> start, length, nu;
    std::optional<support::Range> window;
    std::optional<support::OutputFile> json, csv;
    support::Pictures pictures;
};

Command read(int argc, char** argv) {
    Command c;
    const std::string cases = "must be bratu, gelfand, swift_hohenberg or carrier";
    support::Range window;
    support::CommandLine app{
        "Follows the solutions of a discretised differential equation, locates every fold and bifurcation, and follows "
        "the branches that leave them."};
    const auto only = [&c](std::vector<std::string> names) {
        return support::applies([&c, names = std::move(names)] {
            return std::find(names.begin(), names.end(), c.name) != names.end() ? std::string() : c.name;
        });
    };
    app.add_option("--case", c.name, cases.substr(8))
        .transform(support::one_of({"bratu", "gelfand", "swift_hohenberg", "carrier"}, cases));
    app.add_option("--dimension", c.dimension, "1 to 3, of swift_hohenberg 1 or 2 (default 1)")
        .transform([&c](std::string& text) { return support::integer(1, c.name == "bratu" ? 3 : 2)(text); })
        .transform(only({"bratu", "swift_hohenberg"}));
    app.add_option("--intervals", c.intervals,
                   "of the grid along its first edge, 4 to 100000 (default: the case's own)")
        .transform(support::integer(4, 100000));
    app.add_option("--degree", c.degree, "of Bratu's elements in one dimension, 1 to 4 (default 1: second differences)")
        .transform(support::integer(1, 4))
        .transform(support::applies([&c] {
            return c.name == "bratu" && c.dimension == 1 ? std::string()
                                                         : (c.name == "bratu" ? "more dimensions than 1" : c.name);
        }));
    app.add_option("--length", c.length, "of the first edge (default 60, 16 pi in two dimensions)")
        .transform(support::positive())
        .transform(only({"swift_hohenberg"}));
    app.add_option("--nu", c.nu, "the quadratic coefficient (default 1.8, 1.6 in two dimensions)")
        .transform(support::positive())
        .transform(only({"swift_hohenberg"}));
    app.add_option("--start", c.start, "the parameter of the first solution (default: the case's own)")
        .transform(support::finite());
    app.add_option("--parameter", window, "the range LOW:HIGH of the parameter (default: the case's own)")
        .transform(support::range("must be LOW:HIGH, finite, with LOW < HIGH", -1e12, 1e12));
    app.add_option("--steps", c.steps, "of each branch at most, 1 to 100000 (default 400, of gelfand 80)")
        .transform(support::integer(1, 100000));
    app.add_option("--branches", c.branches,
                   "at most, 1 to 10000 (default 40, of swift_hohenberg 2: those through the start)")
        .transform(support::integer(1, 10000));
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    support::add_output(app, "--csv", c.csv,
                        "write the points of all branches as CSV to this file, or to stdout for -");
    c.pictures.add_to(app, "the branches");
    app.parse("field_branches", argc, argv);

    if (c.name.empty()) support::fail("--case", "", cases);
    if (app.given("--parameter")) c.window = window;
    return c;
}

/// One case.
template <class M>
struct Field {
    M model;
    std::string heading;                ///< of the picture
    std::string parameter;              ///< its name
    std::vector<std::string> measures;  ///< the first one is drawn
    std::function<std::vector<double>(const VectorXd&)> measure;
    std::function<std::vector<std::pair<double, double>>(const VectorXd&)> profile{};  ///< x, u; none: nothing is drawn
    std::vector<VectorXd> guesses;  ///< of the first solution; several: all that deflation finds from them
    double start, low, high, largest_step;
    double parameter_weight = 0;  ///< one for all components where there are several solutions
    int branches = 40, steps = 400;
};

template <class P>
using Graphs = std::vector<equilibria::BranchGraph<P>>;

/// The solutions at the start, and what is joined to them.
template <class P>
Graphs<P> diagrams(const P& problem, const std::vector<VectorXd>& solutions, double start,
                   const equilibria::DiagramOptions& options) {
    Graphs<P> y;
    equilibria::BranchStepper<P> stepper(problem, options.continuation.stepping());
    for (const VectorXd& q : solutions) {
        const auto point = stepper.start(q, start, 1);
        const bool known = point && std::any_of(y.begin(), y.end(), [&](const auto& graph) {
                               return std::any_of(graph.branches.begin(), graph.branches.end(), [&](const auto& edge) {
                                   return lies_on(stepper, edge.branch, *point);
                               });
                           });
        if (!known) y.push_back(equilibria::bifurcation_diagram(problem, q, start, options));
    }
    return y;
}

/// As branches.gp has it, and up to five folds with their profiles.
template <class P, class M>
void draw(const Command& c, const Field<M>& field, const equilibria::BranchMeasures<P>& how, const Graphs<P>& graphs) {
    std::ostringstream stable, unstable, points[2], marks, profiles;
    for (auto* s : {&stable, &unstable, &points[0], &points[1], &marks, &profiles}) s->precision(10);
    std::vector<const equilibria::CriticalPoint<P>*> folds;
    std::size_t bifurcations = 0;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const auto& graph : graphs) {
        for (const auto& edge : graph.branches) {
            const auto samples =
                samples_of(edge.branch, how, {}, edge.parent ? &graph.nodes[*edge.parent].point : nullptr);
            for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
                std::ostringstream& s = samples[k + 1].stable.value_or(false) ? stable : unstable;
                least = std::min(least, samples[k].parameter);
                most = std::max(most, samples[k].parameter);
                for (const std::size_t end : {k, k + 1})
                    s << samples[end].parameter << ' ' << samples[end].measures[0] << '\n';
                s << '\n';
            }
        }
        for (const auto& [point, branches] : graph.nodes) {
            points[is_bifurcation(point.kind) ? 1 : 0] << point.p << ' ' << how.measure(point.q)[0] << '\n';
            if (point.kind == equilibria::CriticalKind::fold) folds.push_back(&point);
            if (is_bifurcation(point.kind)) ++bifurcations;
        }
    }
    std::sort(folds.begin(), folds.end(),
              [&](const auto* a, const auto* b) { return how.measure(a->q)[0] > how.measure(b->q)[0]; });
    const std::size_t shown = field.profile ? std::min<std::size_t>(5, folds.size()) : 0;
    for (std::size_t k = 0; k < shown; ++k) {
        const auto& fold = *folds[shown > 1 ? k * (folds.size() - 1) / (shown - 1) : 0];
        // the letter stands where the branch is not
        const double side = fold.curvature > 0 ? -0.03 : 0.03;
        marks << fold.p + side * (most - least) << ' ' << how.measure(fold.q)[0] << ' ' << static_cast<char>('a' + k)
              << '\n';
        for (const auto& [x, u] : field.profile(fold.q)) profiles << x << ' ' << u << '\n';
        profiles << "\n\n";
    }
    equilibria::GnuplotData data;
    data.string("heading", field.heading).string("parameter", how.parameter).string("measure", how.names[0]);
    data.block("stable", stable.str()).block("unstable", unstable.str());
    data.block("folds", points[0].str()).block("bifurcations", points[1].str());
    data.block("marks", marks.str(), 3).block("profiles", profiles.str());
    data.integer("shown", static_cast<long long>(shown)).integer("bifurcations", static_cast<long long>(bifurcations));
    c.pictures.draw({shown > 0 ? 1000 : 700, 560}, data, plots::field_branches);
}

template <class P>
void print(const Graphs<P>& graphs, const equilibria::BranchMeasures<P>& how, std::size_t solutions, double start) {
    std::printf("%zu solutions at %s = %g\n", solutions, how.parameter.c_str(), start);
    std::printf("kind            %-20s nullity  inertia     %-20s  component\n", how.parameter.c_str(),
                how.names[0].c_str());
    std::size_t branches = 0, unexplained = 0;
    for (std::size_t k = 0; k < graphs.size(); ++k) {
        branches += graphs[k].branches.size();
        for (const auto& edge : graphs[k].branches) {
            unexplained += edge.branch.unexplained.size();
            for (const auto& step : edge.branch.unexplained) std::printf("UNEXPLAINED: %s\n", step.reason.c_str());
        }
        for (const auto& [point, through] : graphs[k].nodes)
            std::printf("%-14s  %-20.12g %4d    %3d to %3d    %-20.10g  %6zu\n", to_string(point.kind), point.p,
                        point.nullity, point.negative_before.value_or(-1), point.negative_after.value_or(-1),
                        how.measure(point.q)[0], k);
    }
    std::printf("%zu components, %zu branches, %zu unexplained steps\n", graphs.size(), branches, unexplained);
}

/// Follows and writes.
template <class M>
void run(const Command& c, Field<M> field) {
    const auto problem = support::sparse(field.model);
    using P = std::remove_cv_t<decltype(problem)>;
    equilibria::DiagramOptions options;
    options.continuation.range = {c.window ? c.window->low : field.low, c.window ? c.window->high : field.high};
    options.continuation.branch.largest_step = field.largest_step;
    options.continuation.branch.parameter_weight = field.parameter_weight;
    options.continuation.most_steps = c.steps.value_or(field.steps);
    options.most_branches = c.branches.value_or(field.branches);
    const double start =
        c.start.value_or(c.window ? std::clamp(field.start, c.window->low, c.window->high) : field.start);
    std::vector<VectorXd> solutions;
    if (field.guesses.size() > 1) {
        solutions = support::solutions_at(problem, start, field.guesses);
    } else {
        VectorXd q = field.guesses[0];
        if (correct_at(problem, q, start).converged()) solutions.push_back(std::move(q));
    }
    if (solutions.empty()) throw std::runtime_error("Newton's method finds no solution at the start");
    const Graphs<P> graphs = diagrams(problem, solutions, start, options);
    const equilibria::BranchMeasures<P> how{
        .parameter = field.parameter, .names = field.measures, .measure = field.measure};

    if (c.pictures.asked()) draw(c, field, how, graphs);
    if (c.csv) {
        std::vector<std::vector<equilibria::BranchSample>> samples;
        for (const auto& graph : graphs)
            for (const auto& edge : graph.branches)
                samples.push_back(
                    samples_of(edge.branch, how, {}, edge.parent ? &graph.nodes[*edge.parent].point : nullptr));
        c.csv->write(equilibria::branches_csv(samples, field.measures).text());
    }
    if (c.json) {
        Json components = Json::array(), found = Json::array();
        for (const auto& graph : graphs) components.push_back(equilibria::json_of(graph, how));
        for (const VectorXd& q : solutions) found.push_back(equilibria::json_list(field.measure(q)));
        const Json y = {{"case", c.name}, {"unknowns", problem.unknowns()}, {"colours", problem.colours()},
                        {"start", start}, {"solutions", std::move(found)},  {"components", std::move(components)}};
        c.json->write(equilibria::json_text(y, 1));
    }
    if (!to_stdout(c.json) && !to_stdout(c.csv)) print(graphs, how, solutions.size(), start);
}

double root_mean_square(const VectorXd& u) { return u.norm() / std::sqrt(static_cast<double>(u.size())); }

/// M: either of Bratu's models.
template <class M>
void follow_bratu(const Command& c, M model) {
    const Eigen::Index n = model.size();
    // below, the grids of more dimensions are too coarse for the large solution
    const double low = c.dimension == 1 ? 0.2 : 1;
    run<M>(c, {.model = std::move(model),
               .heading = "Bratu's problem",
               .parameter = "lambda",
               .measures = {"maximum of u", "root mean square of u"},
               .measure = [](const VectorXd& u) { return std::vector{u.maxCoeff(), root_mean_square(u)}; },
               .guesses = {VectorXd::Zero(n)},
               .start = low,
               .low = low,
               .high = 20,
               .largest_step = 0.5});
}

void follow_gelfand(const Command& c) {
    const int n = c.intervals.value_or(1000);
    run<support::Gelfand>(c, {.model = support::Gelfand(n),
                              .heading = "Gelfand's problem on the ball",
                              .parameter = "lambda",
                              .measures = {"u at the centre"},
                              .measure = [](const VectorXd& u) { return std::vector{u(0)}; },
                              .guesses = {VectorXd::Zero(n)},
                              .start = 0.1,
                              .low = 0.1,
                              .high = 20,
                              .largest_step = 0.5,
                              .steps = 80});
}

void follow_swift_hohenberg(const Command& c) {
    const bool line = c.dimension == 1;
    const double length = c.length.value_or(line ? 60 : 16 * std::numbers::pi),
                 width = 2 * std::numbers::pi / std::sqrt(3.0);
    const int n = c.intervals.value_or(line ? 240 : 64);
    // hexagons: a wave along the strip, and two at 60 degrees to it, of which the strip holds half a period
    const int across = std::max(5, static_cast<int>(std::lround(width * n / length)));
    support::SwiftHohenberg model = line ? support::SwiftHohenberg({length}, {n}, c.nu.value_or(1.8))
                                         : support::SwiftHohenberg({length, width}, {n, across}, c.nu.value_or(1.6));
    VectorXd guess(model.size());
    for (Eigen::Index i = 0; i < guess.size(); ++i) {
        const double x = model.coordinate(i, 0);
        const double y = line ? 0 : model.coordinate(i, 1);
        guess(i) =
            line ? 1.4 * std::cos(x) / std::cosh(x / 8)
                 : 0.6 * (std::cos(x) + 2 * std::cos(x / 2) * std::cos(std::sqrt(3.0) / 2 * y)) / std::cosh(x / 8);
    }
    Field<support::SwiftHohenberg> field{
        .model = std::move(model),
        .heading = "Swift-Hohenberg equation",
        .parameter = "r",
        .measures = {"root mean square of u", "maximum of u"},
        .measure = [](const VectorXd& u) { return std::vector{root_mean_square(u), u.maxCoeff()}; },
        .guesses = {std::move(guess)},
        .start = -0.3,
        .low = -1,
        .high = -0.02,
        .largest_step = line ? 0.05 : 0.1,
        .branches = 2};
    if (line)
        field.profile = [model = field.model](const VectorXd& u) {
            std::vector<std::pair<double, double>> y;
            for (Eigen::Index i = u.size() - 1; i >= 0; --i) y.emplace_back(-model.coordinate(i, 0), u(i));
            for (Eigen::Index i = 0; i < u.size(); ++i) y.emplace_back(model.coordinate(i, 0), u(i));
            return y;
        };
    run<support::SwiftHohenberg>(c, std::move(field));
}

void follow_carrier(const Command& c) {
    const support::Carrier model(c.intervals.value_or(400));
    const double start = 0.2;
    run<support::Carrier>(c, {.model = model,
                              .heading = "Carrier's problem",
                              .parameter = "epsilon",
                              .measures = {"slope at x = -1", "u at x = 0"},
                              .measure =
                                  [n = model.intervals](const VectorXd& u) {
                                      // of third order, from three points
                                      return std::vector{(3 * u(0) - 1.5 * u(1) + u(2) / 3) * n / 2, u(u.size() / 2)};
                                  },
                              .profile =
                                  [model](const VectorXd& u) {
                                      std::vector<std::pair<double, double>> y{{-1, 0}};
                                      for (Eigen::Index i = 0; i < u.size(); ++i)
                                          y.emplace_back(model.coordinate(i), u(i));
                                      y.emplace_back(1, 0);
                                      return y;
                                  },
                              .guesses = model.guesses(c.start.value_or(start), 6),
                              .start = start,
                              .low = 0.19,
                              .high = 1,
                              .largest_step = 0.1,
                              .parameter_weight = 2});
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        if (c.name == "bratu" && c.degree > 1) {
            follow_bratu(c, support::BratuElements(c.intervals.value_or(10), c.degree));
        } else if (c.name == "bratu") {
            const int own[] = {1000, 32, 10};
            follow_bratu(c, support::Bratu(c.dimension, c.intervals.value_or(own[c.dimension - 1])));
        }
        if (c.name == "gelfand") follow_gelfand(c);
        if (c.name == "swift_hohenberg") follow_swift_hohenberg(c);
        if (c.name == "carrier") follow_carrier(c);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "field_branches: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--case heat
    field_branches: --case heat: must be bratu, gelfand, swift_hohenberg or carrier
--case gelfand --dimension 2
    field_branches: --dimension 2: does not apply to gelfand
--case swift_hohenberg --dimension 3
    field_branches: --dimension 3: must be an integer from 1 to 2
--case bratu --dimension 2 --degree 4
    field_branches: --degree 4: does not apply to more dimensions than 1
--case carrier --nu 2
    field_branches: --nu 2: does not apply to carrier
--case bratu --intervals 3
    field_branches: --intervals 3: must be an integer from 4 to 100000
*/
