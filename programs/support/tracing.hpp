// The main branch of a problem and all that leave it at its bifurcations, for tables, files and figures.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/io/results/branch_output.hpp>

namespace support {

using equilibria::Json;

/// A critical point as it is written, with the number of its "branch".
struct CriticalRow {
    bool bifurcation;
    Json json;
};
struct BranchRow {
    std::vector<equilibria::BranchSample> points;  // critical points are among them
    std::optional<std::size_t> parent;             // the critical point that it was entered from
    std::string end;
};

/// What is traced, and what was found. P: the problem.
template <class P>
struct Tracing {
    std::string name;
    equilibria::BranchMeasures<P> how;
    std::vector<equilibria::EventFunction<P>> functions{};
    /// Each point of a branch, with its number, and the name of the event function that is 0 there.
    std::function<void(std::size_t, const equilibria::Configuration<P>&, double, const std::string&)> observe{};
    /// Each critical point, with the number of the branch that it is on.
    std::function<void(std::size_t, const equilibria::CriticalPoint<P>&)> observe_critical{};

    std::vector<CriticalRow> critical_points{};
    std::vector<BranchRow> branches{};
    std::vector<std::string> unexplained{};
    std::vector<std::string> not_switched{};  ///< bifurcations from which no other branch was found
    std::vector<std::string> families{};      ///< points from which branches leave in every direction, not followed
};

/// Where tracing begins and how far it goes.
template <class P>
struct TracingStart {
    equilibria::Configuration<P> q;
    equilibria::ContinuationOptions options;
    double amplitude;
    bool up = true;     ///< towards larger parameters
    bool down = false;  ///< towards smaller ones
    bool sides = true;  ///< also branches that leave
};

namespace detail {

template <equilibria::ContinuationProblem P>
class Tracer {
public:
    Tracer(Tracing<P>& out, const P& problem, const TracingStart<P>& start)
        : out_(out), start_(start), stepper_(problem, start.options.stepping()) {}

    void run(int direction) {
        const auto first = stepper_.start(start_.q, 0, direction);
        if (!first) throw std::runtime_error("no equilibrium without load");
        const std::size_t events_before = out_.critical_points.size();
        add(*first, nullptr, std::nullopt);
        const equilibria::Branch<P> main = branches_.back();
        for (std::size_t k = 0; k < main.events.size(); ++k) {
            const auto& [step, point] = main.events[k];
            if (start_.sides && is_bifurcation(point.kind)) leave(point, main.points[step].tangent, events_before + k);
        }
    }

private:
    void add(const equilibria::BranchPoint<P>& from, const equilibria::CriticalPoint<P>* parent,
             std::optional<std::size_t> parent_number) {
        add(equilibria::follow(stepper_, from, start_.options, out_.functions), parent, parent_number);
    }
    void add(equilibria::Branch<P> followed, const equilibria::CriticalPoint<P>* parent,
             std::optional<std::size_t> parent_number) {
        branches_.push_back(std::move(followed));
        const equilibria::Branch<P>& branch = branches_.back();
        const std::size_t number = out_.branches.size();
        if (out_.observe)
            for_each_point(branch, out_.functions, parent,
                           [&](const auto& q, double p, std::optional<bool>, const std::string& at) {
                               out_.observe(number, q, p, at);
                           });
        out_.branches.push_back(
            {samples_of(branch, out_.how, out_.functions, parent), parent_number, to_string(branch.end)});
        for (const auto& found : branch.events) {
            out_.critical_points.push_back({is_bifurcation(found.point.kind), json_of(found.point, out_.how)});
            out_.critical_points.back().json["branch"] = number;
            if (out_.observe_critical) out_.observe_critical(number, found.point);
        }
        for (const auto& step : branch.unexplained)
            out_.unexplained.push_back("branch " + std::to_string(number) + ": " + step.reason);
    }

    /// All branches through a bifurcation that are not known.
    void leave(const equilibria::CriticalPoint<P>& point, const equilibria::Direction& tangent, std::size_t number) {
        const auto starts = switch_branch(stepper_, point, tangent, start_.amplitude);
        if (equilibria::leave_in_every_direction(point.nullity, starts.size())) {
            out_.families.push_back("at " + equilibria::to_text(out_.how.value(point.q, point.p)));
            return;
        }
        if (starts.empty() && point.kind != equilibria::CriticalKind::isola_center)
            out_.not_switched.push_back(std::string(to_string(point.kind)) + " at " +
                                        equilibria::to_text(out_.how.value(point.q, point.p)));
        for (const auto& from : starts) {
            const bool known = std::any_of(branches_.begin(), branches_.end(),
                                           [&](const auto& branch) { return lies_on(stepper_, branch, from); });
            if (known) continue;
            std::optional<equilibria::Branch<P>> image;
            for (std::size_t b = 0; b < branches_.size() && !image; ++b)
                image = known_image(stepper_, branches_[b], from, out_.functions);
            if (image)
                add(std::move(*image), &point, number);
            else
                add(from, &point, number);
        }
    }

    Tracing<P>& out_;
    const TracingStart<P>& start_;
    equilibria::BranchStepper<P> stepper_;
    std::vector<equilibria::Branch<P>> branches_;
};

}  // namespace detail

/// Follows the branch from the equilibrium near the start without load, towards larger parameters if `up`, towards
/// smaller ones if `down`, and, if `sides`, all branches that leave it. Throws std::runtime_error where there is no
/// such equilibrium.
template <equilibria::ContinuationProblem P>
void trace(Tracing<P>& out, const P& problem, const TracingStart<P>& start) {
    detail::Tracer<P> tracer(out, problem, start);
    if (start.up) tracer.run(1);
    if (start.down) tracer.run(-1);
}

/// "parameter", "measures", "critical_points", "branches" (points, stable, parent: a critical point or null, end),
/// "not_switched" (bifurcations from which no other branch was found), "families", "unexplained_steps".
template <class P>
Json json_of(const Tracing<P>& t) {
    Json points = Json::array(), branches = Json::array();
    for (const auto& c : t.critical_points) points.push_back(c.json);
    for (const auto& b : t.branches) {
        branches.push_back(equilibria::json_of(b.points));
        branches.back()["parent"] = equilibria::json_or_null(b.parent);
        branches.back()["end"] = b.end;
    }
    return {{"case", t.name},
            {"parameter", t.how.parameter},
            {"measures", t.how.names},
            {"critical_points", std::move(points)},
            {"branches", std::move(branches)},
            {"not_switched", t.not_switched},
            {"families", t.families},
            {"unexplained_steps", t.unexplained}};
}

/// A case's name as a title.
inline std::string title(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// The parameter over measure x as $stable, $unstable, $folds, $bifurcations, with `heading` and `parameter`.
template <class P>
void add_branches(equilibria::GnuplotData& data, const Tracing<P>& t, std::size_t x) {
    std::ostringstream stable, unstable, points[2];
    for (auto* s : {&stable, &unstable, &points[0], &points[1]}) s->precision(10);
    for (const auto& b : t.branches)
        for (std::size_t k = 0; k + 1 < b.points.size(); ++k) {
            // up to a critical point, or from one, at which the stability may change
            std::ostringstream& s = b.points[k + 1].stable.value_or(false) ? stable : unstable;
            for (const std::size_t end : {k, k + 1})
                s << b.points[end].measures[x] << ' ' << b.points[end].parameter << '\n';
            s << "\n";
        }
    for (const auto& c : t.critical_points)
        points[c.bifurcation ? 1 : 0] << c.json["measures"][x].template get<double>() << ' '
                                      << c.json["parameter"].template get<double>() << '\n';
    data.string("heading", title(t.name)).string("parameter", t.how.parameter);
    data.block("stable", stable.str()).block("unstable", unstable.str());
    data.block("folds", points[0].str()).block("bifurcations", points[1].str());
}

template <class P>
void print(const Tracing<P>& t) {
    std::printf("kind           %-18s nullity  inertia   iterations  branch\n", t.how.parameter.c_str());
    const auto inertia = [](const Json& n) { return n.is_null() ? -1 : n.get<int>(); };
    for (const auto& [bifurcation, c] : t.critical_points)
        std::printf("%-13s  %-18.12g %4d    %3d to %3d  %6d    %6zu\n", c["kind"].template get<std::string>().c_str(),
                    c["parameter"].template get<double>(), c["nullity"].template get<int>(),
                    inertia(c["inertia_before"]), inertia(c["inertia_after"]), c["iterations"].template get<int>(),
                    c["branch"].template get<std::size_t>());
    std::printf("%zu branches, %zu unexplained steps", t.branches.size(), t.unexplained.size());
    if (t.not_switched.empty())
        std::puts("");
    else
        std::printf(", %zu bifurcations not left\n", t.not_switched.size());
    for (const std::string& point : t.not_switched) std::printf("NOT LEFT: %s\n", point.c_str());
    for (const std::string& reason : t.unexplained) std::printf("UNEXPLAINED: %s\n", reason.c_str());
    for (const std::string& family : t.families)
        std::printf("Branches leave in every direction %s, turns of one: not followed.\n", family.c_str());
}

}  // namespace support
