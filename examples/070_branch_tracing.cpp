// Equilibrium branches of structures with known critical points: folds and bifurcations located exactly, side branches
// followed.
//
//   branch_tracing --case star_dome --svg dome.svg
#include <algorithm>
#include <cstdio>
#include <equilibria/continuation/branch.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/structures.hpp"

namespace {

using Eigen::VectorXd;
using equilibria::CriticalKind;
using Json = nlohmann::ordered_json;

struct CriticalRow {
    CriticalKind kind;
    double parameter;
    std::array<double, 2> measures;
    int nullity, iterations;
    double residual;
    std::optional<int> before, after;
    std::size_t branch;
};
struct BranchRow {
    std::vector<std::array<double, 3>> points;  // the parameter and two measures; critical points are among them
    std::vector<bool> stable;                   // critical points by the branch before them
    std::optional<std::size_t> parent;          // the critical point that it was entered from
    std::string end;
};
struct Tracing {
    std::string name, parameter;
    std::array<std::string, 2> measures;
    std::vector<CriticalRow> critical_points;
    std::vector<BranchRow> branches;
    std::vector<std::string> unexplained;
};

/// The main branch, and all that leave it at bifurcations.
template <equilibria::ContinuationProblem P>
void trace(Tracing& out, const P& problem, const VectorXd& start, const equilibria::ContinuationOptions& options,
           double amplitude, const std::function<std::array<double, 2>(const VectorXd&)>& measure) {
    equilibria::PathStepper<P> stepper(problem, options.path);
    const auto first = stepper.start(start, 0, 1);
    if (!first) throw std::runtime_error("no equilibrium without load");
    std::vector<equilibria::Branch<P>> branches;
    const auto add = [&](const equilibria::BranchPoint<P>& from, std::optional<std::size_t> parent) {
        branches.push_back(equilibria::follow(stepper, from, options));
        const auto& branch = branches.back();
        BranchRow row{{}, {}, parent, to_string(branch.end)};
        const auto push = [&](const VectorXd& q, double p, bool stable) {
            const auto m = measure(q);
            row.points.push_back({p, m[0], m[1]});
            row.stable.push_back(stable);
        };
        if (parent) push(branches[0].events[*parent].point.q, branches[0].events[*parent].point.p, false);
        auto event = branch.events.begin();
        for (std::size_t k = 0; k < branch.points.size(); ++k) {
            const auto& point = branch.points[k];
            push(point.q, point.p, point.stable().value_or(false));
            for (; event != branch.events.end() && event->step == k; ++event)
                push(event->point.q, event->point.p, event->point.negative_before == 0);
        }
        const std::size_t number = out.branches.size();
        out.branches.push_back(std::move(row));
        for (const auto& found : branch.events) {
            const auto& e = found.point;
            out.critical_points.push_back({e.kind, e.p, measure(e.q), e.nullity, e.iterations(), e.residual,
                                           e.negative_before, e.negative_after, number});
        }
        for (const auto& step : branch.unexplained)
            out.unexplained.push_back("branch " + std::to_string(number) + ": " + step.reason);
    };
    add(*first, std::nullopt);
    const auto main = branches[0];
    for (std::size_t k = 0; k < main.events.size(); ++k) {
        const auto& [step, point] = main.events[k];
        if (!is_bifurcation(point.kind)) continue;
        for (const auto& from : switch_branch(stepper, point, main.points[step].tangent, amplitude)) {
            const bool known = std::any_of(branches.begin(), branches.end(),
                                           [&](const auto& branch) { return lies_on(stepper, branch, from); });
            if (!known) add(from, k);
        }
    }
}

std::string json(const Tracing& t) {
    const auto inertia = [](const std::optional<int>& n) { return n ? Json(*n) : Json(nullptr); };
    Json out{{"case", t.name},
             {"parameter", t.parameter},
             {"measures", t.measures},
             {"critical_points", Json::array()},
             {"branches", Json::array()},
             {"unexplained_steps", t.unexplained}};
    for (const auto& c : t.critical_points)
        out["critical_points"].push_back({{"kind", to_string(c.kind)},
                                          {"parameter", c.parameter},
                                          {"measures", c.measures},
                                          {"nullity", c.nullity},
                                          {"iterations", c.iterations},
                                          {"residual", c.residual},
                                          {"inertia_before", inertia(c.before)},
                                          {"inertia_after", inertia(c.after)},
                                          {"branch", c.branch}});
    for (const auto& b : t.branches)
        out["branches"].push_back({{"points", b.points},
                                   {"stable", b.stable},
                                   {"parent", b.parent ? Json(*b.parent) : Json(nullptr)},
                                   {"end", b.end}});
    return out.dump(1) + "\n";
}

std::string title(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// The parameter over the first measure; stable parts of branches heavier.
std::string script(const Tracing& t) {
    std::ostringstream stable, unstable, points[2], out;
    for (auto* s : {&stable, &unstable, &points[0], &points[1]}) s->precision(10);
    for (const auto& b : t.branches) {
        for (std::size_t k = 0; k + 1 < b.points.size(); ++k) {
            // up to a critical point, or from one, at which the stability may change
            std::ostringstream& s = b.stable[k + 1] ? stable : unstable;
            for (const std::size_t end : {k, k + 1}) s << b.points[end][1] << ' ' << b.points[end][0] << '\n';
            s << "\n";
        }
    }
    for (const auto& c : t.critical_points)
        points[is_bifurcation(c.kind) ? 1 : 0] << c.measures[0] << ' ' << c.parameter << '\n';
    const auto block = [&](const char* name, const std::ostringstream& rows) {
        out << equilibria::gnuplot_block(name, rows.str().empty() ? "nan nan\n" : rows.str());
    };
    block("stable", stable);
    block("unstable", unstable);
    block("folds", points[0]);
    block("bifurcations", points[1]);
    out << "set tics out nomirror\nset border 31 lw 0.8\nset key outside right top samplen 2\n"
        << "set title '" << title(t.name) << "'\nset xlabel '" << t.measures[0] << "'\nset ylabel '" << t.parameter
        << "'\n"
        << "plot $unstable with lines lw 1.2 lc rgb '#e69f00' title 'unstable', "
        << "$stable with lines lw 2.4 lc rgb '#009e73' title 'stable', "
        << "$bifurcations with points pt 7 ps 0.8 lc rgb '#0072b2' title 'bifurcations', "
        << "$folds with points pt 5 ps 0.8 lc rgb 'black' title 'folds'\n";
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
    Tracing t;
    t.name = name;
    try {
        if (truss) {
            const auto problem = support::von_mises_truss(rise, strain);
            t.parameter = "P / EA";
            t.measures = {"height of the apex", "sway of the apex"};
            window(-1, 1);
            trace(t, problem, problem.unloaded(), options, 0.02 * rise, [&](const VectorXd& q) {
                return std::array{problem.at(q, 1)(1), problem.at(q, 1)(0)};
            });
        } else if (dome) {
            const bool ring = load_text == "ring";
            const auto problem = support::star_dome(ring ? 0.5 : 1, ring ? 1 : 0, strain);
            t.parameter = "P / EA";
            t.measures = {"height of the apex", "sway of the apex"};
            window(-1e-3, ring ? 2e-3 : 1e-3);
            trace(t, problem, problem.unloaded(), options, 0.3, [&](const VectorXd& q) {
                const Eigen::Vector3d x = problem.at(q, 0);
                return std::array{x(2), std::hypot(x(0), x(1))};
            });
        } else if (arch) {
            const support::ShallowArch problem{rise};
            t.parameter = "q";
            t.measures = {"A1", "A2"};
            const double fold = rise > 1 ? problem.fold() : rise;
            window(2 * rise - fold - 3, fold + 3);
            trace(t, problem, Eigen::Vector2d(rise, 0), options, 0.02 * rise, [](const VectorXd& q) {
                return std::array{q(0), q(1)};
            });
        } else {
            const support::SpringElastica problem{links};
            const double critical = problem.buckling_load();
            t.parameter = "P l / c";
            t.measures = {"angle of the last link", "root mean square of the angles"};
            window(-critical, rigid ? 4.5 : 1.5 * critical);
            options.path.parameter_weight = 1 / critical;
            const auto measure = [](const VectorXd& q) {
                return std::array{q(q.size() - 1), q.norm() / std::sqrt(static_cast<double>(q.size()))};
            };
            if (rigid)
                trace(t, support::DenseSpringElastica{{links}}, VectorXd::Zero(links), options, 0.05, measure);
            else
                trace(t, problem, VectorXd::Zero(links), options, 0.05, measure);
        }
        if (svg_file)
            svg_file->write(equilibria::gnuplot("svg size 1000,620 font 'Helvetica,14' background 'white'", script(t)));
        if (png_file)
            png_file->write(
                equilibria::gnuplot("pngcairo size 2000,1240 fontscale 1.8 linewidth 2 pointscale 2", script(t)));
        if (json_file) json_file->write(json(t));
        if (!json_file || !json_file->to_stdout()) {
            std::printf("kind           %-18s nullity  inertia   iterations  branch\n", t.parameter.c_str());
            for (const auto& c : t.critical_points)
                std::printf("%-13s  %-18.12g %4d    %3d to %3d  %6d    %6zu\n", to_string(c.kind), c.parameter,
                            c.nullity, c.before.value_or(-1), c.after.value_or(-1), c.iterations, c.branch);
            std::printf("%zu branches, %zu unexplained steps\n", t.branches.size(), t.unexplained.size());
            for (const std::string& reason : t.unexplained) std::printf("UNEXPLAINED: %s\n", reason.c_str());
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
