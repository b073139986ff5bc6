/// \file
/// See locus/line/line_events.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/locus/line/coordinate_sizes.hpp>
#include <equilibria/locus/line/detail/describe_event.hpp>
#include <equilibria/locus/line/infinity_search.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/symmetric_branches.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::string EventSearch::argument(std::size_t events) const {
    std::ostringstream out;
    out << paths.total << " paths from a " << start
        << " start reach every isolated complex solution of F = 0, J v = 0: " << regular_solutions << " regular, "
        << paths.singular << " singular (" << pitchfork_paths
        << " at pitchforks of symmetric branches, found there by themselves), " << paths.at_infinity << " at infinity, "
        << paths.failed << " failed; ";
    if (infinity_paths.total > 0)
        out << infinity_paths.total << " paths, " << infinity_paths.failed << " of them failed, find "
            << infinity_values << " complex values at which solutions come from infinity; ";
    out << "the tables of the " << intervals.size() << " intervals, each enumerated at two points, ";
    if (unconfirmed > 0) out << "DIFFER WITHIN " << unconfirmed << " OF THEM, and ";
    if (wrong_tables > 0)
        out << "DO NOT DIFFER by the events at " << wrong_tables << " values";
    else if (has_potential)
        out << "differ exactly by the events between them";
    else
        out << "differ in their numbers exactly by the events between them";
    const std::uint64_t values = intervals.empty() ? 0 : intervals.size() - 1;
    if (events > 0 && compared < values) out << ", which say how at " << compared << " of " << values << " values";
    if (bisected > 0)
        out << "; " << bisected << " events were found by bisection alone, " << unnamed << " of them NOT EXPLAINED";
    if (unclean > 0) out << "; THE ENUMERATIONS OF " << unclean << " INTERVALS ARE NOT CLEAN";
    if (unexplained > 0) out << "; " << unexplained << " SINGULAR SOLUTIONS ARE NOT EXPLAINED";
    if (!complete()) out << "; NOT COMPLETE: events may be missing";
    return out.str();
}

namespace detail {

struct SymmetricProblem : EquilibriumProblem {
    using EquilibriumProblem::EquilibriumProblem;
    static constexpr bool symmetric = true;
};
struct UnsymmetricProblem : EquilibriumProblem {
    using EquilibriumProblem::EquilibriumProblem;
    static constexpr bool symmetric = false;
};

class LineEventFinder {
public:
    LineEventFinder(const SearchedModel& model, const RuntimeArray<double>& p, int active, const Interval& range,
                    const RunOptions& run)
        : model_(model), functions_(*model.functions), n_(model.unknowns()), p_(p), active_(active), run_(run),
          system_(*model.polynomials, {&active, 1}), scale_(1) {
        found_.sizes = model.sizes();
        found_.range = range;
        found_.has_potential = model.has_potential();
    }

    LineEvents<RuntimeUnknowns> run() {
        const detail::Stopwatch begin;
        add_pitchforks();
        add_from_infinity();
        add_continua();
        // the events' size is that of the segment, or, of a wide one, its root or 1
        const double wide = std::max(std::abs(found_.range.low), std::abs(found_.range.high));
        std::vector<double> scales{wide};
        if (wide > 30) scales = {wide, std::sqrt(wide), 1};
        for (std::size_t k = 0; k < scales.size() && (k == 0 || !found_.complete()); ++k) {
            scale_[0] = scales[k];
            const detail::Stopwatch solving;
            add_solutions(k + 1 < scales.size() ? 2 : 8);
            found_.solve_seconds += solving.seconds();
            count();
        }
        name_missed();
        found_.seconds = begin.seconds();
        return std::move(found_);
    }

private:
    static constexpr double same_value = 1e-9;
    /// Points of an interval at which equilibria are enumerated: Gauss's two, off its middle, where special values sit.
    static constexpr double first_part = 0.21132486540518713, second_part = 0.7886751345948129;
    using Unknowns = RuntimeArray<double>;
    using Event = LineEvent<RuntimeUnknowns>;

    RuntimeSingularity<> located(SingularityKind kind, const Unknowns& q, double value) const {
        return locate_singularity(functions_, kind, {&active_, 1}, q, at(value));
    }
    /// By the extended systems of continuation; where it converges kind, value, q and v of the event are those found.
    bool correct_by_continuation(const Unknowns& q, double value, Event& event) const {
        return functions_.has_potential() ? correct_as<SymmetricProblem>(q, value, event)
                                          : correct_as<UnsymmetricProblem>(q, value, event);
    }
    template <class Problem>
    bool correct_as(const Unknowns& q, double value, Event& event) const {
        const Problem problem(functions_, p_, active_);
        const auto point = CriticalPointSolver<Problem>(problem).solve(eigen_vector(q), value);
        if (!point) return false;
        event.kind = point->kind;
        event.value = point->p;
        event.q = runtime_array(point->q);
        event.v = runtime_array(point->null_vector.normalized());
        event.correction = std::numeric_limits<double>::quiet_NaN();
        return true;
    }

    bool in_segment(double value) const { return found_.range.contains(value); }
    RuntimeArray<double> at(double value) const {
        RuntimeArray<double> p = p_;
        p[active_] = value;
        return p;
    }

    void add_pitchforks() {
        for (const auto& branch : symmetric_branches(*model_.polynomials)) add_pitchforks(branch);
    }
    void add_pitchforks(const Unknowns& branch) {
        const auto values =
            singular_points_of_branch(functions_, branch, p_, active_, system_.entry().degree[0], found_.range);
        for (std::size_t k = 0; k < values.size(); ++k) {
            Event event;
            event.q = branch;
            event.value = values[k];
            event.v = null_vector(jacobian(functions_, branch, at(event.value)));
            const double near = 1e-6 * (1 + std::abs(event.value));
            const bool twice = (k > 0 && values[k] - values[k - 1] < near) ||
                               (k + 1 < values.size() && values[k + 1] - values[k] < near);
            event.kind = twice ? CriticalKind::multiple : CriticalKind::pitchfork;
            if (!twice) {
                const auto refined = located(SingularityKind::pitchfork, branch, event.value);
                if (refined.converged && std::abs(refined.p[active_] - event.value) < 100 * near) {
                    event.value = refined.p[active_];
                    event.v = refined.v;
                    event.correction = refined.correction;
                }
            }
            add(event);
        }
    }

    void add_solutions(int most_attempts) {
        for (int attempt = 0; attempt < most_attempts && (attempt == 0 || found_.paths.failed > 0); ++attempt) {
            const RunOptions run = run_.with_seed(seed_of_attempt(run_.seed, found_.attempts++));
            Generator generator(run.seed);
            const auto set = solve_equations(system_.equations(system_.numbers(p_, scale_, generator)), system_.sizes(),
                                             system_.grouping(), run);
            found_.paths = set.paths;
            found_.start = set.start;
            found_.complex_solutions = set.roots.size();
            found_.regular_solutions = found_.pitchfork_paths = found_.other_singular = found_.unexplained = 0;
            for (const auto& root : set.roots) {
                if (root.status == PathStatus::finite) ++found_.regular_solutions;
                take(root);
            }
        }
    }

    void take(const auto& root) {
        Unknowns q(n_);
        double imaginary = 0;
        for (int i = 0; i < n_; ++i) {
            q[i] = root.q[i].real();
            imaginary = std::max(imaginary, std::abs(root.q[i].imag()));
        }
        const std::complex<double> x = root.q[system_.sizes().angles + system_.first_active()];
        const bool singular = root.status == PathStatus::singular;
        const auto paths = static_cast<std::uint64_t>(root.paths);
        const double near = singular ? 1e-3 : 1e-6;
        if (singular && complex_symmetric(root)) {
            found_.pitchfork_paths += paths;
            return;
        }
        const bool real = imaginary < near && std::abs(x.imag()) < near * (1 + std::abs(x)) &&
                          (system_.entry().power[0] == 1 || x.real() > -near);
        const double value =
            real ? system_.parameter(0, system_.entry().power[0] == 1 ? x.real() : std::max(0.0, x.real()), scale_[0])
                 : 0;
        if (!real) {
            if (singular) found_.other_singular += paths;
            return;
        }
        if (system_.entry().power[0] == 2 && value > 0 && found_.range.low < 0) take_at(q, -value, singular);
        take_at(q, value, singular);
    }

    /// A real solution next to q and value.
    void take_at(const Unknowns& q, double value, bool singular) {
        const double around = 1e-3 * scale_[0];
        if (value < found_.range.low - around || value > found_.range.high + around) return;
        Event event;
        const auto refined = located(SingularityKind::fold, q, value);
        // a singular endpoint is exact to 1e-7 and better: what is further off is another point
        const double near = singular ? 1e-6 : 1e-3;
        if (refined.converged && std::abs(refined.p[active_] - value) < around &&
            same_unknowns(model_.sizes(), refined.q, q, near)) {
            event.value = refined.p[active_];
            event.q = wrapped(model_.sizes(), refined.q);
            event.v = refined.v;
            event.correction = refined.correction;
            // the fold's system converges at bifurcations too, linearly, and from an endpoint's digits that is enough
            if (singular) event.kind = bifurcation_kind(event, functions_, p_, active_);
        } else if (singular && correct_bifurcation(q, value, event)) {
            event.kind = bifurcation_kind(event, functions_, p_, active_);
        } else {
            if (!correct_by_continuation(q, value, event) || std::abs(event.value - value) > around ||
                !same_unknowns(model_.sizes(), event.q, q, 1e-2)) {
                ++found_.unexplained;
                return;
            }
            event.q = wrapped(model_.sizes(), event.q);
        }
        add(event);
    }

    /// Newton's method for F = 0, J v = 0, |v| = 1 in (q, v, p), with steps of least length along what these equations
    /// determine: at a bifurcation they are singular, and the direction that they leave open stays as the endpoint has
    /// it. False where that does not converge next to the endpoint.
    bool correct_bifurcation(const Unknowns& q, double value, Event& event) const {
        event.q = wrapped(model_.sizes(), q);
        event.value = value;
        event.v = null_vector(jacobian(functions_, event.q, at(value)));
        for (int round = 0; round < 8; ++round) {
            const auto p = at(event.value);
            const Eigen::VectorXd v = eigen_vector(event.v);
            const Eigen::MatrixXd j = eigen_matrix(jacobian(functions_, event.q, p));
            const auto f = equations(functions_, event.q, p);
            const auto [by, change] = parameter_derivatives(functions_, event.q, p, active_);
            const int n = n_;
            Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(2 * n + 1, 2 * n + 1);
            Eigen::VectorXd values(2 * n + 1);
            slopes.topLeftCorner(n, n) = j;
            slopes.block(n, 0, n, n) = eigen_matrix(jacobian_derivative(functions_, event.q, event.v, p));
            slopes.block(n, n, n, n) = j;
            slopes.block(2 * n, n, 1, n) = v.transpose();
            slopes.block(n, 2 * n, n, 1) = eigen_matrix(change) * v;
            for (int i = 0; i < n; ++i) slopes(i, 2 * n) = by[i], values(i) = f[i];
            values.segment(n, n) = j * v;
            values(2 * n) = 0.5 * (v.squaredNorm() - 1);
            const Eigen::VectorXd d = least_squares(slopes, values, 1e-5);
            event.correction = d.lpNorm<Eigen::Infinity>();
            if (!(event.correction < 1e-5)) return false;
            for (int i = 0; i < n; ++i) event.q[i] -= d(i), event.v[i] -= d(n + i);
            event.value -= d(2 * n);
            if (event.correction < 1e-14) break;
        }
        return event.correction < 1e-12 && same_unknowns(model_.sizes(), event.q, q, 1e-6);
    }

    bool complex_symmetric(const auto& root) const {
        if (!model_.reflection_symmetric()) return false;
        for (int i = 0; i < model_.sizes().angles; ++i)
            if (std::abs(std::sin(root.q[i])) > 1e-2) return false;
        return true;
    }

    /// What comes from infinity, and goes there.
    void add_from_infinity() {
        if (model_.sizes().coordinates == 0) return;
        const auto inside = [&](double part) { return at(found_.range.low + part * found_.range.width()); };
        const auto sizes = coordinate_sizes(model_, std::array{inside(first_part), inside(second_part)}, run_);
        const auto search = search_infinity(model_, p_, active_, found_.range, sizes, run_);
        found_.infinity_paths = search.paths;
        found_.infinity_values = search.solutions;
        for (const auto& from : search.events) {
            Event event = bare_event(CriticalKind::from_infinity, from.value);
            event.correction = from.error;
            event.change = from.change;
            event.at_infinity = from.equilibria;
            if (from.decided)
                event.change_in_number =
                    static_cast<std::int64_t>(from.equilibria[1]) - static_cast<std::int64_t>(from.equilibria[0]);
            found_.events.push_back(event);
        }
    }
    /// Where an equation vanishes identically, within the segment.
    void add_continua() {
        bool vanishes = false;
        for (const auto& content : system_.entry().content) vanishes = vanishes || content[0] > 0;
        if (vanishes && found_.range.low < 0 && found_.range.high > 0)
            found_.events.push_back(bare_event(CriticalKind::continuum, 0));
    }
    /// An event without an equilibrium.
    Event bare_event(CriticalKind kind, double value) const {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        Event event;
        event.kind = kind;
        event.value = value;
        event.q = event.v = Unknowns(n_);
        for (int i = 0; i < n_; ++i) event.q[i] = event.v[i] = none;
        event.residual = event.correction = event.slope = event.reduced.third = event.reduced.fourth = none;
        return event;
    }

    /// Unless it is out of the segment or known.
    void add(Event event) {
        if (!in_segment(event.value)) return;
        for (const auto& other : found_.events)
            if (other.has_equilibrium() && std::abs(other.value - event.value) <= 1e-8 * (1 + std::abs(event.value)) &&
                same_unknowns(model_.sizes(), other.q, event.q, 1e-5))
                return;
        describe(event, functions_, p_, active_);
        found_.events.push_back(event);
    }

    /// Whether two enumerations have the same table, or, without a potential, the same number.
    bool same_table(const EquilibriaCount& a, const EquilibriaCount& b) const {
        return a.real == b.real && (!functions_.has_potential() || a.by_index == b.by_index);
    }
    /// Enumerates between the events, at two points, and compares.
    void count() {
        std::sort(found_.events.begin(), found_.events.end(),
                  [](const auto& a, const auto& b) { return a.value < b.value; });
        found_.intervals.clear();
        found_.unclean = found_.compared = found_.wrong_tables = found_.unconfirmed = 0;
        const auto add_interval = [&](double low, double high) {
            EventGap interval{{low, high}, 0, 0, 0, {}, false, false};
            interval.at = low + first_part * (high - low);
            interval.also_at = low + second_part * (high - low);
            const auto found = model_.count(at(interval.at), run_), again = model_.count(at(interval.also_at), run_);
            interval.count = found.real;
            interval.by_index = found.by_index;
            interval.clean = found.clean && again.clean;
            interval.confirmed = same_table(found, again);
            found_.unclean += !interval.clean;
            found_.unconfirmed += !interval.confirmed;
            found_.intervals.push_back(std::move(interval));
        };
        double from = found_.range.low;
        for (std::size_t first = 0; first < found_.events.size();) {
            const double value = found_.events[first].value;
            std::size_t last = first;
            while (last < found_.events.size() &&
                   found_.events[last].value - value <= same_value * (1 + std::abs(value)))
                ++last;
            // nor has one at its begin anything below it
            if (first > 0 || value - from > same_value * (1 + std::abs(value))) add_interval(from, value);
            from = found_.events[last - 1].value;
            for (std::size_t k = first; k < last; ++k) found_.events[k].interval = found_.intervals.size();
            first = last;
        }
        // an event at the end of the segment has nothing above it
        if (found_.range.high - from > same_value * (1 + std::abs(found_.range.high)) || found_.intervals.empty())
            add_interval(from, found_.range.high);
        compare();
    }
    /// Where two tables of an interval differ an event was missed: between them, by bisection.
    void name_missed() {
        for (int round = 0; round < 4 && found_.unconfirmed > 0; ++round) {
            const std::size_t known = found_.events.size();
            for (const EventGap& interval : std::vector<EventGap>(found_.intervals))
                if (!interval.confirmed && interval.clean) name_missed(interval);
            if (found_.events.size() == known) break;
            found_.bisected += found_.events.size() - known;
            count();
        }
        for (const Event& event : found_.events) found_.unnamed += event.kind == CriticalKind::unexplained;
    }
    void name_missed(const EventGap& interval) {
        double low = interval.at, high = interval.also_at;
        const double smallest = 1e-11 * std::max({std::abs(low), std::abs(high), 1e-3 * found_.range.width()});
        auto below = model_.count(at(low), run_), above = model_.count(at(high), run_);
        for (int k = 0; k < 60 && high - low > smallest; ++k) {
            const double middle = low + 0.4713 * (high - low);
            auto there = model_.count(at(middle), run_);
            const bool left = same_table(there, below);
            (left ? low : high) = middle;
            (left ? below : above) = std::move(there);
        }
        const double value = 0.5 * (low + high), near = 1e-6 * interval.width();
        const std::size_t known = found_.events.size();
        for (const auto* side : {&below, &above})
            for (const auto& q : side->at) {
                const auto refined = located(SingularityKind::fold, q, value);
                if (!refined.converged || !(std::abs(refined.p[active_] - value) < near)) continue;
                Event event;
                event.value = refined.p[active_];
                event.q = wrapped(model_.sizes(), refined.q);
                event.v = refined.v;
                event.correction = refined.correction;
                event.kind = bifurcation_kind(event, functions_, p_, active_);
                add(event);
            }
        if (found_.events.size() == known)
            found_.events.push_back(bare_event(CriticalKind::unexplained, std::abs(value) < smallest ? 0 : value));
    }
    void compare() {
        for (std::size_t k = 1; k < found_.intervals.size(); ++k) {
            const bool tables = functions_.has_potential();
            std::vector<std::int64_t> expected = found_.intervals[k - 1].by_index;
            auto number = static_cast<std::int64_t>(found_.intervals[k - 1].count);
            bool known = true;
            for (const auto& event : found_.events) {
                if (event.interval != k) continue;
                known = known && (tables ? !event.change.empty() : event.change_in_number.has_value());
                number += event.change_in_number.value_or(0);
                for (std::size_t i = 0; i < event.change.size(); ++i) expected[i] += event.change[i];
            }
            found_.compared += known;
            found_.wrong_tables += known && (tables ? expected != found_.intervals[k].by_index
                                                    : number != static_cast<std::int64_t>(found_.intervals[k].count));
        }
    }

    const SearchedModel& model_;
    const ModelFunctions<>& functions_;
    int n_;  ///< unknowns
    RuntimeArray<double> p_;
    int active_;
    RunOptions run_;
    CriticalSystem system_;
    std::vector<double> scale_;
    LineEvents<RuntimeUnknowns> found_;
};

}  // namespace detail

EQUILIBRIA_INLINE LineEvents<RuntimeUnknowns> find_events(const SearchedModel& model, const RuntimeArray<double>& p,
                                                          int active, const Interval& range, const RunOptions& run) {
    require_finite(p, "parameters");
    range.validate("interval");
    run.require_alone("a search for events");
    return detail::LineEventFinder(model, p, active, range, run).run();
}

}  // namespace equilibria
