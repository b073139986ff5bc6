/// \file
/// All events on a line of the parameter space: the values of one parameter at which the number or the indices of the
/// equilibria change, and the equilibria between them.
///
/// Folds are the solutions of the critical system (critical_system.hpp), all complex ones, real ones kept and refined.
/// Pitchforks of symmetric branches are singular solutions of it; they are roots of one polynomial a branch
/// (symmetric_branches.hpp), which accounts for their paths. Other singular solutions are refined and named. Between
/// each two events the equilibria are enumerated: the tables must differ exactly by what the events say.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line/line_event.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/symmetric_branches.hpp>

namespace equilibria {

/// Parameter values between neighbouring events.
template <Model M>
struct EventGap : Interval {
    double at = 0;  ///< where the equilibria were enumerated
    std::uint64_t count = 0;
    std::vector<std::int64_t> by_index;
    bool clean = false;  ///< nothing speaks against the enumeration (RootSet::clean)
};

template <Model M>
struct LineEvents {
    Interval range;
    std::vector<LineEvent<M>> events;    ///< by value
    std::vector<EventGap<M>> intervals;  ///< one more than there are different values of events

    PathCounts paths;                     ///< of the critical system, in the last attempt
    std::uint64_t attempts = 0;           ///< start systems tried until no path failed
    std::uint64_t complex_solutions = 0;  ///< of the critical system, distinct ones
    std::uint64_t regular_solutions = 0;  ///< of those: folds, real or not, in the segment or not
    std::uint64_t pitchfork_paths = 0;    ///< singular paths that end at pitchforks of symmetric branches
    std::uint64_t other_singular = 0;     ///< singular paths that end elsewhere, on no real event of the segment
    std::uint64_t unexplained = 0;   ///< real singular solutions in the segment that Newton's method did not confirm
    std::uint64_t compared = 0;      ///< values of events at which the tables were compared
    std::uint64_t wrong_tables = 0;  ///< values at which the tables do not differ by what the events say
    std::uint64_t unclean = 0;       ///< intervals whose enumeration is not clean
    double solve_seconds = 0, seconds = 0;

    bool complete() const { return paths.failed == 0 && unexplained == 0 && wrong_tables == 0 && unclean == 0; }
    /// Why nothing is missing, or what speaks against it, in words.
    std::string argument() const {
        std::ostringstream out;
        out << paths.total
            << " paths from a multihomogeneous start reach every isolated complex solution of F = 0, J v = 0: "
            << regular_solutions << " regular, " << paths.singular << " singular (" << pitchfork_paths
            << " at pitchforks of symmetric branches, found there by themselves), " << paths.at_infinity
            << " at infinity, " << paths.failed << " failed; the tables of the " << intervals.size()
            << " intervals, each enumerated, ";
        if (!PotentialModel<M> && !events.empty())
            out << "are not compared with the events, since the model has no potential";
        else if (wrong_tables == 0)
            out << "differ exactly by the events between them";
        else
            out << "DO NOT DIFFER by the events at " << wrong_tables << " values";
        if (unclean > 0) out << "; " << unclean << " ENUMERATIONS ARE NOT CLEAN";
        if (unexplained > 0) out << "; " << unexplained << " SINGULAR SOLUTIONS ARE NOT EXPLAINED";
        if (paths.failed > 0) out << "; NOT COMPLETE: events may be missing";
        return out.str();
    }
};

namespace detail {

template <Model M, int Active>
class LineEventFinder {
public:
    using System = CriticalSystem<M, Active>;
    using Problem = ModelProblem<M, Active>;
    static constexpr int n = n_unknowns<M>;

    LineEventFinder(const Parameters<M>& p, const Interval& range, const RunOptions& run) : p_(p), run_(run) {
        found_.range = range;
    }

    LineEvents<M> run() {
        const detail::Stopwatch begin;
        add_pitchforks();
        // the events' size is that of the segment, or, of a wide one, its root or 1
        const double wide = std::max(std::abs(found_.range.low), std::abs(found_.range.high));
        std::vector<double> scales{wide};
        if (wide > 30) scales = {wide, std::sqrt(wide), 1};
        for (std::size_t k = 0; k < scales.size() && (k == 0 || !found_.complete()); ++k) {
            scale_[0] = scales[k];
            const detail::Stopwatch solving;
            add_solutions(k + 1 < scales.size() ? 2 : 8);
            found_.solve_seconds += solving.seconds();
            std::sort(found_.events.begin(), found_.events.end(),
                      [](const auto& a, const auto& b) { return a.value < b.value; });
            count();
        }
        found_.seconds = begin.seconds();
        return std::move(found_);
    }

private:
    static constexpr double same_value = 1e-9;

    bool in_segment(double value) const { return found_.range.contains(value); }
    Parameters<M> at(double value) const { return with_active<Active>(p_, value); }

    void add_pitchforks() {
        if constexpr (Formulation<M>::reflection_symmetric)
            for (const Unknowns<M>& branch : symmetric_branches<M>()) add_pitchforks(branch);
    }
    void add_pitchforks(const Unknowns<M>& branch)
    requires(n_coordinates<M> == 0)
    {
        const auto values = singular_points_of_branch<M>(branch, p_, Active, System::entry().degree[0],
                                                         found_.range.low, found_.range.high);
        for (std::size_t k = 0; k < values.size(); ++k) {
            LineEvent<M> event;
            event.q = branch;
            event.value = values[k];
            event.v = null_vector<M>(jacobian<M, double>(branch, at(event.value)));
            const double near = 1e-6 * (1 + std::abs(event.value));
            const bool twice = (k > 0 && values[k] - values[k - 1] < near) ||
                               (k + 1 < values.size() && values[k + 1] - values[k] < near);
            event.kind = twice ? CriticalKind::multiple : CriticalKind::pitchfork;
            if (!twice) {
                const auto refined = refine_singularity<M, SingularityKind::pitchfork, Active>(branch, at(event.value));
                if (refined.converged && std::abs(refined.p[Active] - event.value) < 100 * near) {
                    event.value = refined.p[Active];
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
            const auto set =
                solve_multihomogeneous(System::system(System::numbers(p_, scale_, generator)), System::grouping, run);
            found_.paths = set.paths;
            found_.complex_solutions = set.roots.size();
            found_.regular_solutions = found_.pitchfork_paths = found_.other_singular = found_.unexplained = 0;
            for (const auto& root : set.roots) {
                if (root.status == PathStatus::finite) ++found_.regular_solutions;
                take(root);
            }
        }
    }

    void take(const auto& root) {
        Unknowns<M> q;
        double imaginary = 0;
        for (int i = 0; i < n; ++i) {
            q[i] = root.q[i].real();
            imaginary = std::max(imaginary, std::abs(root.q[i].imag()));
        }
        const std::complex<double> x = root.q[System::n_angles + System::first_active];
        const bool singular = root.status == PathStatus::singular;
        const auto paths = static_cast<std::uint64_t>(root.paths);
        const double near = singular ? 1e-3 : 1e-6;
        if (singular && complex_symmetric(root)) {
            found_.pitchfork_paths += paths;
            return;
        }
        const bool real = imaginary < near && std::abs(x.imag()) < near * (1 + std::abs(x)) &&
                          (System::entry().power[0] == 1 || x.real() > -near);
        const double value =
            real ? System::parameter(0, System::entry().power[0] == 1 ? x.real() : std::max(0.0, x.real()), scale_[0])
                 : 0;
        if (!real) {
            if (singular) found_.other_singular += paths;
            return;
        }
        if (System::entry().power[0] == 2 && value > 0 && found_.range.low < 0) take_at(q, -value, singular);
        take_at(q, value, singular);
    }

    /// A real solution next to q and value.
    void take_at(const Unknowns<M>& q, double value, bool singular) {
        const double around = 1e-3 * scale_[0];
        if (value < found_.range.low - around || value > found_.range.high + around) return;
        LineEvent<M> event;
        const auto refined = refine_singularity<M, SingularityKind::fold, Active>(q, at(value));
        // a singular endpoint is exact to 1e-7 and better: what is further off is another point
        const double near = singular ? 1e-6 : 1e-3;
        if (refined.converged && std::abs(refined.p[Active] - value) < around && same_unknowns<M>(refined.q, q, near)) {
            event.value = refined.p[Active];
            event.q = wrapped<M>(refined.q);
            event.v = refined.v;
            event.correction = refined.correction;
            // the fold's system converges at bifurcations too, linearly, and from an endpoint's digits that is enough
            if (singular) event.kind = bifurcation_kind<M, Active>(event, p_);
        } else if (singular && correct_bifurcation(q, value, event)) {
            event.kind = bifurcation_kind<M, Active>(event, p_);
        } else {
            const Problem problem(p_);
            const auto point = CriticalPointSolver<Problem>(problem).solve(Problem::vector(q), value);
            if (!point || std::abs(point->p - value) > around ||
                !same_unknowns<M>(Problem::unknowns(point->q), q, 1e-2)) {
                ++found_.unexplained;
                return;
            }
            event.kind = point->kind;
            event.value = point->p;
            event.q = wrapped<M>(Problem::unknowns(point->q));
            event.v = Problem::unknowns(point->null_vector.normalized());
            event.correction = std::numeric_limits<double>::quiet_NaN();
        }
        add(event);
    }

    /// Newton's method for F = 0, J v = 0, |v| = 1 in (q, v, p), with steps of least length along what these equations
    /// determine: at a bifurcation they are singular, and the direction that they leave open stays as the endpoint has
    /// it. False where that does not converge next to the endpoint.
    bool correct_bifurcation(const Unknowns<M>& q, double value, LineEvent<M>& event) const {
        event.q = wrapped<M>(q);
        event.value = value;
        event.v = null_vector<M>(jacobian<M, double>(event.q, at(value)));
        for (int round = 0; round < 8; ++round) {
            const Parameters<M> p = at(event.value);
            const Eigen::Map<const Eigen::Matrix<double, n, 1>> v(&event.v[0]);
            const Eigen::Matrix<double, n, n> j = jacobian<M, double>(event.q, p);
            const Unknowns<M> f = equations<M, double>(event.q, p);
            const auto by = parameter_derivative<M, double>(event.q, p, Active);
            Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(2 * n + 1, 2 * n + 1);
            Eigen::VectorXd values(2 * n + 1);
            slopes.topLeftCorner(n, n) = j;
            slopes.block(n, 0, n, n) = jacobian_derivative<M, double>(event.q, event.v, p);
            slopes.block(n, n, n, n) = j;
            slopes.block(2 * n, n, 1, n) = v.transpose();
            slopes.block(n, 2 * n, n, 1) = jacobian_parameter_derivative<M, double>(event.q, p, Active) * v;
            for (int i = 0; i < n; ++i) slopes(i, 2 * n) = by[i], values(i) = f[i];
            values.segment(n, n) = j * v;
            values(2 * n) = 0.5 * (v.squaredNorm() - 1);
            const Eigen::VectorXd d = least_squares(slopes, values, 1e-5);
            event.correction = d.template lpNorm<Eigen::Infinity>();
            if (!(event.correction < 1e-5)) return false;
            for (int i = 0; i < n; ++i) event.q[i] -= d(i), event.v[i] -= d(n + i);
            event.value -= d(2 * n);
            if (event.correction < 1e-14) break;
        }
        return event.correction < 1e-12 && same_unknowns<M>(event.q, q, 1e-6);
    }

    static bool complex_symmetric(const auto& root) {
        if (!Formulation<M>::reflection_symmetric) return false;
        for (int i = 0; i < n_angles<M>; ++i)
            if (std::abs(std::sin(root.q[i])) > 1e-2) return false;
        return true;
    }

    /// Unless it is out of the segment or known.
    void add(LineEvent<M> event) {
        if (!in_segment(event.value)) return;
        for (const auto& other : found_.events)
            if (std::abs(other.value - event.value) <= 1e-8 * (1 + std::abs(event.value)) &&
                same_unknowns<M>(other.q, event.q, 1e-5))
                return;
        describe<M>(event, p_, Active);
        found_.events.push_back(event);
    }

    /// Enumerates between the events and compares.
    void count() {
        found_.intervals.clear();
        found_.unclean = found_.compared = found_.wrong_tables = 0;
        const auto add_interval = [&](double low, double high) {
            EventGap<M> interval{{low, high}, 0.5 * (low + high), 0, {}, false};
            const auto set = enumerate<M>(at(interval.at), run_);
            interval.count = set.real();
            interval.by_index = set.by_index();
            interval.clean = set.clean();
            found_.unclean += !interval.clean;
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
    void compare() {
        for (std::size_t k = 1; k < found_.intervals.size(); ++k) {
            std::vector<std::int64_t> expected = found_.intervals[k - 1].by_index;
            bool known = true;
            for (const auto& event : found_.events) {
                if (event.interval != k) continue;
                known = known && !event.change.empty();
                for (std::size_t i = 0; i < event.change.size(); ++i) expected[i] += event.change[i];
            }
            found_.compared += known;
            found_.wrong_tables += known && expected != found_.intervals[k].by_index;
        }
    }

    Parameters<M> p_;
    RunOptions run_;
    Array<double, 1> scale_;
    LineEvents<M> found_;
};

}  // namespace detail

/// All events with the parameter number Active in `range`, the others those of p. The model must be polynomial in
/// that parameter.
///
/// Throws InvalidArgument for an interval that is empty, reversed or not finite, for parameters that are not finite,
/// and for a run with a checkpoint or a cancel: these are of one enumeration, and here are many.
template <Model M, int Active>
LineEvents<M> find_events(const Parameters<M>& p, const Interval& range, const RunOptions& run = {}) {
    require_finite(p, "parameters");
    range.validate("interval");
    run.require_whole("a search for events");
    return detail::LineEventFinder<M, Active>(p, range, run).run();
}

}  // namespace equilibria
