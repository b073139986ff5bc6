// Equilibrium branches of structures with known critical points: folds and bifurcations located exactly, side branches
// followed.
//
//   branch_tracing --case star_dome --svg dome.svg
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plots/branches.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"
#include "support/structures.hpp"
#include "support/tracing.hpp"

namespace {

using Eigen::VectorXd;

/// What the command line says.
struct Command {
    std::string name, strain = "green", load = "ring";
    std::optional<double> rise;
    int links = 3;
    std::optional<support::Range> window;
    equilibria::ContinuationOptions options;
    std::optional<support::OutputFile> json;
    support::Pictures pictures;

    support::Strain strain_measure() const {
        return strain == "green" ? support::Strain::green : support::Strain::engineering;
    }
    /// The options with a case's own range of the parameter, unless one is given.
    equilibria::ContinuationOptions within(double low, double high) const {
        auto y = options;
        y.range.low = window ? window->low : low;
        y.range.high = window ? window->high : high;
        return y;
    }
};

Command read(int argc, char** argv) {
    Command c;
    const std::string cases = "must be von_mises_truss, star_dome, shallow_arch, rigid_link_chain or spring_elastica";
    support::Range window;
    support::CommandLine app{
        "Follows the equilibria of a structure from its unloaded state, locates every fold and bifurcation, and "
        "follows "
        "the branches that leave the first one."};
    const auto only = [&c](std::vector<std::string> names) {
        return support::applies([&c, names = std::move(names)] {
            for (const std::string& name : names)
                if (c.name == name) return std::string();
            return c.name;
        });
    };
    app.add_option("--case", c.name, cases.substr(8))
        .transform(support::one_of(
            {"von_mises_truss", "star_dome", "shallow_arch", "rigid_link_chain", "spring_elastica"}, cases));
    app.add_option("--rise", c.rise, "of the truss over its half span (default 2), or of the arch (default 2.5)")
        .transform(support::positive())
        .transform(only({"von_mises_truss", "shallow_arch"}));
    app.add_option("--strain", c.strain, "of the trusses' bars: green or engineering (default green)")
        .transform(support::one_of({"green", "engineering"}, "must be green or engineering"))
        .transform(only({"von_mises_truss", "star_dome"}));
    app.add_option("--load", c.load, "of the dome: ring (1 a node, 0.5 at the apex) or apex (default ring)")
        .transform(support::one_of({"ring", "apex"}, "must be ring or apex"))
        .transform(only({"star_dome"}));
    app.add_option("--links", c.links, "of the chains, 1 to 100000 (default 3)")
        .transform(
            [&c](std::string& text) { return support::integer(1, c.name == "rigid_link_chain" ? 200 : 100000)(text); })
        .transform(only({"rigid_link_chain", "spring_elastica"}));
    app.add_option("--parameter", window, "the range LOW:HIGH of the load (default: the case's own)")
        .transform(support::range("must be LOW:HIGH, finite, with LOW < HIGH", -1e12, 1e12));
    app.add_option("--steps", c.options.most_steps, "of each branch at most, 1 to 100000 (default 1000)")
        .transform(support::integer(1, 100000));
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -");
    c.pictures.add_to(app, "the branches");
    app.parse("branch_tracing", argc, argv);

    if (c.name.empty()) support::fail("--case", "", cases);
    if (app.given("--parameter")) c.window = window;
    c.options.branch.largest_step = 0.05;
    return c;
}

/// Traces and writes; `how`: what is read off a configuration.
template <class P>
void run(const Command& c, const P& problem, equilibria::BranchMeasures<P> how, support::TracingStart<P> start) {
    support::Tracing<P> t{.name = c.name, .how = std::move(how)};
    trace(t, problem, start);
    if (c.pictures.asked()) {
        equilibria::GnuplotData data;
        add_branches(data, t, 0);
        data.string("measure", t.how.names[0]);
        c.pictures.draw({1000, 620}, data, plots::branches);
    }
    if (c.json) c.json->write(equilibria::json_text(json_of(t), 1));
    if (!to_stdout(c.json)) print(t);
}

void trace_truss(const Command& c) {
    const double rise = c.rise.value_or(2);
    const auto problem = support::von_mises_truss(rise, c.strain_measure());
    run<support::Truss>(
        c, problem,
        {.parameter = "P / EA",
         .names = {"height of the apex", "sway of the apex"},
         .measure = [&](const VectorXd& q) { return std::vector{problem.at(q, 1)(1), problem.at(q, 1)(0)}; }},
        {problem.unloaded(), c.within(-1, 1), 0.02 * rise});
}

void trace_dome(const Command& c) {
    const bool ring = c.load == "ring";
    const auto problem = support::star_dome(ring ? 0.5 : 1, ring ? 1 : 0, c.strain_measure());
    run<support::Truss>(c, problem,
                        {.parameter = "P / EA",
                         .names = {"height of the apex", "sway of the apex"},
                         .measure =
                             [&](const VectorXd& q) {
                                 const Eigen::Vector3d x = problem.at(q, 0);
                                 return std::vector{x(2), std::hypot(x(0), x(1))};
                             }},
                        {problem.unloaded(), c.within(-1e-3, ring ? 2e-3 : 1e-3), 0.3});
}

void trace_arch(const Command& c) {
    const double rise = c.rise.value_or(2.5);
    const support::ShallowArch problem{rise};
    const double fold = rise > 1 ? problem.fold() : rise;
    run<support::ShallowArch>(
        c, problem,
        {.parameter = "q", .names = {"A1", "A2"}, .measure = [](const VectorXd& q) { return std::vector{q(0), q(1)}; }},
        {Eigen::Vector2d(rise, 0), c.within(2 * rise - fold - 3, fold + 3), 0.02 * rise});
}

/// P: the chain with a sparse or a dense tangent.
template <class P>
void trace_chain(const Command& c, const P& problem, double high) {
    const double critical = problem.buckling_load();
    auto options = c.within(-critical, high);
    options.branch.parameter_weight = 1 / critical;
    run<P>(c, problem,
           {.parameter = "P l / c",
            .names = {"angle of the last link", "root mean square of the angles"},
            .measure =
                [](const VectorXd& q) {
                    return std::vector{q(q.size() - 1), q.norm() / std::sqrt(static_cast<double>(q.size()))};
                }},
           {VectorXd::Zero(c.links), options, 0.05});
}

}  // namespace

int main(int argc, char** argv) {
    const Command c = read(argc, argv);
    try {
        if (c.name == "von_mises_truss") trace_truss(c);
        if (c.name == "star_dome") trace_dome(c);
        if (c.name == "shallow_arch") trace_arch(c);
        if (c.name == "rigid_link_chain") trace_chain(c, support::DenseSpringElastica{{c.links}}, 4.5);
        if (c.name == "spring_elastica") {
            const support::SpringElastica chain{c.links};
            trace_chain(c, chain, 1.5 * chain.buckling_load());
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
