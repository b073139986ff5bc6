// The main branch of a problem and all that leave it at its bifurcations, as rows for tables and figures.
#pragma once

#include <algorithm>
#include <cstdio>
#include <equilibria/continuation/branch.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace support {

using Json = nlohmann::ordered_json;

struct CriticalRow {
    equilibria::CriticalKind kind;
    double parameter;
    std::vector<double> measures;
    int nullity, iterations;
    double residual;
    std::optional<int> before, after;
    std::size_t branch;
};
struct BranchRow {
    struct Point {
        double parameter;
        std::vector<double> measures;
        bool stable;       // of a critical point, by the branch before it
        std::string name;  // of a zero of an event function, else empty
    };
    std::vector<Point> points;          // critical points are among them
    std::optional<std::size_t> parent;  // the critical point that it was entered from
    std::string end;
};

/// What is traced, and what was found. P: the problem.
template <class P>
struct Tracing {
    std::string name, parameter;
    std::vector<std::string> measures;
    std::function<double(const equilibria::Configuration<P>&, double)> value;  ///< the parameter in its unit
    std::function<std::vector<double>(const equilibria::Configuration<P>&)> measure;
    std::vector<equilibria::EventFunction<P>> functions;
    std::function<void(std::size_t, const equilibria::Configuration<P>&, double)> observe;  ///< each point of a branch

    std::vector<CriticalRow> critical_points;
    std::vector<BranchRow> branches;
    std::vector<std::string> unexplained;
    std::vector<std::string> families;  ///< points from which branches leave in all directions: one is followed
};

/// Follows the branch from the equilibrium near `start` without load, towards larger parameters and, if `both_ways`,
/// smaller ones, and all branches that leave it. Throws std::runtime_error where there is no such equilibrium.
template <equilibria::ContinuationProblem P>
void trace(Tracing<P>& out, const P& problem, const equilibria::Configuration<P>& start,
           const equilibria::ContinuationOptions& options, double amplitude, bool both_ways = false) {
    using equilibria::Branch;
    equilibria::PathStepper<P> stepper(problem, options.path);
    std::vector<Branch<P>> branches;
    const auto add = [&](const equilibria::BranchPoint<P>& from, const equilibria::CriticalPoint<P>* parent,
                         std::optional<std::size_t> parent_number) {
        branches.push_back(equilibria::follow(stepper, from, options, out.functions));
        const Branch<P>& branch = branches.back();
        BranchRow row{{}, parent_number, to_string(branch.end)};
        const std::size_t number = out.branches.size();
        const auto push = [&](const equilibria::Configuration<P>& q, double p, bool stable, const std::string& name) {
            row.points.push_back({out.value(q, p), out.measure(q), stable, name});
            if (out.observe) out.observe(number, q, p);
        };
        if (parent) push(parent->q, parent->p, false, "");
        auto event = branch.events.begin();
        for (std::size_t k = 0; k < branch.points.size(); ++k) {
            const auto& point = branch.points[k];
            push(point.q, point.p, point.stable().value_or(false), "");
            for (const auto& crossing : branch.crossings)
                if (crossing.step == k)
                    push(crossing.point.q, crossing.point.p, crossing.point.stable().value_or(false),
                         out.functions[crossing.function].name);
            for (; event != branch.events.end() && event->step == k; ++event)
                push(event->point.q, event->point.p, event->point.negative_before == 0, "");
        }
        out.branches.push_back(std::move(row));
        for (const auto& found : branch.events) {
            const auto& e = found.point;
            out.critical_points.push_back({e.kind, out.value(e.q, e.p), out.measure(e.q), e.nullity, e.iterations(),
                                           e.residual, e.negative_before, e.negative_after, number});
        }
        for (const auto& step : branch.unexplained)
            out.unexplained.push_back("branch " + std::to_string(number) + ": " + step.reason);
    };
    for (const int direction : {1, -1}) {
        if (direction < 0 && !both_ways) break;
        const auto first = stepper.start(start, 0, direction);
        if (!first) throw std::runtime_error("no equilibrium without load");
        const std::size_t events_before = out.critical_points.size();
        add(*first, nullptr, std::nullopt);
        const Branch<P> main = branches.back();
        for (std::size_t k = 0; k < main.events.size(); ++k) {
            const auto& [step, point] = main.events[k];
            if (!is_bifurcation(point.kind)) continue;
            auto starts = switch_branch(stepper, point, main.points[step].tangent, amplitude);
            // more than the branches of any discrete symmetry: turns of one branch, which K is singular along
            if (starts.size() > 12) {
                out.families.push_back("at " + equilibria::to_text(out.value(point.q, point.p)));
                continue;
            }
            for (const auto& from : starts) {
                const bool known = std::any_of(branches.begin(), branches.end(),
                                               [&](const auto& branch) { return lies_on(stepper, branch, from); });
                if (!known) add(from, &point, events_before + k);
            }
        }
    }
}

template <class P>
Json critical_points_json(const Tracing<P>& t) {
    const auto inertia = [](const std::optional<int>& n) { return n ? Json(*n) : Json(nullptr); };
    Json out = Json::array();
    for (const auto& c : t.critical_points)
        out.push_back({{"kind", to_string(c.kind)},
                       {"parameter", c.parameter},
                       {"measures", c.measures},
                       {"nullity", c.nullity},
                       {"iterations", c.iterations},
                       {"residual", c.residual},
                       {"inertia_before", inertia(c.before)},
                       {"inertia_after", inertia(c.after)},
                       {"branch", c.branch}});
    return out;
}

/// Blocks of the branches, the parameter over measure x, as $stable, $unstable, $folds, $bifurcations of gnuplot.
template <class P>
std::string branch_blocks(const Tracing<P>& t, std::size_t x) {
    std::ostringstream stable, unstable, points[2], out;
    for (auto* s : {&stable, &unstable, &points[0], &points[1]}) s->precision(10);
    for (const auto& b : t.branches)
        for (std::size_t k = 0; k + 1 < b.points.size(); ++k) {
            // up to a critical point, or from one, at which the stability may change
            std::ostringstream& s = b.points[k + 1].stable ? stable : unstable;
            for (const std::size_t end : {k, k + 1})
                s << b.points[end].measures[x] << ' ' << b.points[end].parameter << '\n';
            s << "\n";
        }
    for (const auto& c : t.critical_points)
        points[is_bifurcation(c.kind) ? 1 : 0] << c.measures[x] << ' ' << c.parameter << '\n';
    const auto block = [&](const char* name, const std::ostringstream& rows) {
        out << equilibria::gnuplot_block(name, rows.str().empty() ? "nan nan\n" : rows.str());
    };
    block("stable", stable);
    block("unstable", unstable);
    block("folds", points[0]);
    block("bifurcations", points[1]);
    return out.str();
}

/// The plot of branch_blocks.
inline const char* branch_plot() {
    return "plot $unstable with lines lw 1.2 lc rgb '#e69f00' title 'unstable', "
           "$stable with lines lw 2.4 lc rgb '#009e73' title 'stable', "
           "$bifurcations with points pt 7 ps 0.8 lc rgb '#0072b2' title 'bifurcations', "
           "$folds with points pt 5 ps 0.8 lc rgb 'black' title 'folds'\n";
}

template <class P>
void print(const Tracing<P>& t) {
    std::printf("kind           %-18s nullity  inertia   iterations  branch\n", t.parameter.c_str());
    for (const auto& c : t.critical_points)
        std::printf("%-13s  %-18.12g %4d    %3d to %3d  %6d    %6zu\n", to_string(c.kind), c.parameter, c.nullity,
                    c.before.value_or(-1), c.after.value_or(-1), c.iterations, c.branch);
    std::printf("%zu branches, %zu unexplained steps\n", t.branches.size(), t.unexplained.size());
    for (const std::string& reason : t.unexplained) std::printf("UNEXPLAINED: %s\n", reason.c_str());
    for (const std::string& family : t.families)
        std::printf("Branches leave in every direction %s, turns of one: not followed.\n", family.c_str());
}

/// A case's name as a title.
inline std::string title(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

}  // namespace support
