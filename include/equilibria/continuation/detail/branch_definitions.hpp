/// \file
/// See continuation/branch.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/detail/branch_changes.hpp>
#include <equilibria/continuation/detail/branch_switch.hpp>
#include <equilibria/continuation/detail/branch_window.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {
template <class Matrix>
std::optional<std::size_t> turns_into_image(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch,
                                            const CriticalPoint<Erased>& point);
template <class Matrix>
class CrossingFinder;
template <class Matrix>
void go_back_by_image(AnyBranchStepper<Matrix>& stepper, CrossingFinder<Matrix>& crossings, Branch<Erased>& branch,
                      std::size_t image);

/// Finds the zeros of functions between the points of a branch, one step after the other.
template <class Matrix>
class CrossingFinder {
public:
    CrossingFinder(AnyBranchStepper<Matrix>& stepper, const std::vector<EventFunction<Erased>>& functions)
        : stepper_(stepper), functions_(functions) {}

    /// Those between points `step` and `step` + 1.
    void add(Branch<Erased>& branch, std::size_t step) {
        const BranchPoint<Erased>&from = branch.points[step], &next = branch.points[step + 1];
        if (at_ != step) values_ = values_at(from);
        at_ = step + 1;
        const std::vector<double> before = std::exchange(values_, values_at(next));
        for (std::size_t f = 0; f < functions_.size(); ++f) {
            if (!changes_sign(before[f], values_[f])) continue;
            if (auto zero = zero_between(stepper_, functions_[f], from, next))
                branch.crossings.push_back({step, f, std::move(*zero)});
            else
                branch.unexplained.push_back({step, functions_[f].name + " changes sign, and no zero was found"});
        }
    }
    /// Whether one of them has a zero between two points, as far as their signs tell.
    bool any_between(const BranchPoint<Erased>& from, const BranchPoint<Erased>& next) const {
        const std::vector<double> before = values_at(from), after = values_at(next);
        for (std::size_t f = 0; f < functions_.size(); ++f)
            if (changes_sign(before[f], after[f])) return true;
        return false;
    }
    /// Points have been replaced.
    void forget() { at_.reset(); }

private:
    static bool changes_sign(double before, double after) { return before * after < 0 || (after == 0 && before != 0); }
    std::vector<double> values_at(const BranchPoint<Erased>& point) const {
        std::vector<double> y;
        for (const auto& function : functions_) y.push_back(function.value(point));
        return y;
    }

    AnyBranchStepper<Matrix>& stepper_;
    const std::vector<EventFunction<Erased>>& functions_;
    std::optional<std::size_t> at_;  ///< the point of values_
    std::vector<double> values_;
};

/// The first point of a branch inside the range of p, and, if it does not come there, why.
struct BranchEntry {
    BranchPoint<Erased> point;
    std::optional<BranchEnd> end;
};
/// `start` itself where it is inside and the branch does not leave at once. steps: those that it took.
template <class Matrix>
BranchEntry into_window(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& start,
                        BranchWindow<Matrix>& window, int most_steps, int& steps) {
    if (window.inside(start.p)) {
        if (window.at_border(start.p, start.tangent.p)) return {start, BranchEnd::window};
        return {start, {}};
    }
    BranchPoint<Erased> from = start;
    std::optional<BranchPoint<Erased>> before;
    for (steps = 1; steps <= most_steps; ++steps) {
        // it leads away from the range
        if ((window.border_before(from.p) > from.p) != (from.tangent.p > 0)) return {start, BranchEnd::window};
        auto next = stepper.advance(from, before ? &*before : nullptr);
        if (!next) return {start, BranchEnd::stopped};
        const double border = window.border_before(from.p);
        if ((next->p < border) != (from.p < border)) {
            auto first = window.on_border(from, *next, border);
            if (!first) return {start, BranchEnd::stopped};
            first->proposed_step = next->proposed_step;
            return {*first, {}};
        }
        before = std::exchange(from, std::move(*next));
    }
    return {start, BranchEnd::steps};
}

}  // namespace detail

template <class Matrix>
Branch<Erased> follow(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& start,
                      const ContinuationOptions& options, const std::vector<EventFunction<Erased>>& functions) {
    Branch<Erased> branch;
    detail::BranchWindow<Matrix> window(stepper, options.range);
    int steps = 0;
    const auto first = detail::into_window(stepper, start, window, options.most_steps, steps);
    branch.points.push_back(first.point);
    if (first.end) {
        branch.end = *first.end;
        return branch;
    }
    detail::CrossingFinder<Matrix> crossings(stepper, functions);
    BranchPoint<Erased> before;
    int shorter = 0;  // steps before `troubled_to` that were made shorter since they were not explained
    double troubled_to = 0;
    bool gone_back = false;  // by images: at the other end the branch closes
    for (int k = 0; k + steps < options.most_steps; ++k) {
        const BranchPoint<Erased> from = branch.points.back();
        auto next = stepper.advance(from, k > 0 ? &before : nullptr);
        if (!next) {
            branch.end = BranchEnd::stopped;
            return branch;
        }
        const std::size_t step = branch.points.size() - 1;
        auto [left, border, events] = window.between(from, *next, options.critical);
        // It may have come to another branch near by, where an eigenvalue changes without a fold, or p turns without
        // one; or its end may be the very point that is ill determined. Not often in one place, which may be one that
        // no step explains.
        const double h = next->arc_length - from.arc_length;
        if (from.arc_length >= troubled_to) shorter = 0;
        const int changed = detail::changes(from, *next);
        const bool jumped = changed < 2 && (changed == 1) != detail::folds(from, *next);
        const bool again = !events.explained && shorter < 6 && !crossings.any_between(from, *next);
        if (!events.explained) troubled_to = std::max(troubled_to, next->arc_length);
        bool shortened = false;
        for (int attempt = 1; again && !shortened && attempt <= (jumped ? 5 : 2); ++attempt) {
            const double share = jumped ? std::ldexp(1.0, -2 * attempt) : attempt == 1 ? 0.83 : 1.19;
            auto less = stepper.step(from, share * h, k > 0 ? &before : nullptr);
            if (!less) continue;
            auto exit = window.between(from, *less, options.critical);
            if (!exit.events.explained) continue;
            less->proposed_step = less->step;
            next = std::move(less);
            left = exit.left, border = std::move(exit.last), events = std::move(exit.events);
            shortened = true;
        }
        shorter += shortened;
        for (auto& point : events.points) branch.events.push_back({step, std::move(point)});
        if (!events.explained) branch.unexplained.push_back({step, std::move(events.reason)});
        if (left && !border) {
            branch.end = BranchEnd::window;
            return branch;
        }
        if (left) next = std::move(border);
        before = from;
        branch.points.push_back(std::move(*next));
        crossings.add(branch, step);
        const BranchPoint<Erased>& last = branch.points.back();
        if (branch.events.size() >= static_cast<std::size_t>(options.most_critical_points)) {
            branch.end = BranchEnd::critical;
            return branch;
        }
        if (left) {
            branch.end = BranchEnd::window;
            return branch;
        }
        if (std::any_of(branch.crossings.begin(), branch.crossings.end(), [&](const auto& crossing) {
                return crossing.step == step && functions[crossing.function].ends;
            })) {
            branch.end = BranchEnd::event;
            return branch;
        }
        if (k > 2) {
            // the start lies within the last step, and the branch goes through it in the same direction
            const Direction back = stepper.difference(last, first.point.q, first.point.p);
            const double along = stepper.dot(back, last.tangent);
            if (along <= 0 && -along <= last.step && stepper.length(back) <= 1.1 * last.step &&
                stepper.dot(last.tangent, first.point.tangent) > 0.5) {
                branch.end = BranchEnd::closed;
                return branch;
            }
        }
        // one event in this step, from which the branch goes back as an image of itself
        const std::size_t events_here = static_cast<std::size_t>(
            std::count_if(branch.events.begin(), branch.events.end(), [&](const auto& e) { return e.step == step; }));
        if (events_here == 1 && !gone_back)
            if (const auto image = detail::turns_into_image(stepper, branch, branch.events.back().point)) {
                detail::go_back_by_image(stepper, crossings, branch, *image);
                before = branch.points[branch.points.size() - 2];
                k += static_cast<int>(step);
                gone_back = true;
            }
    }
    return branch;
}

template <class Matrix>
Branch<Erased> continue_branch(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p, int direction,
                               const ContinuationOptions& options,
                               const std::vector<EventFunction<Erased>>& functions) {
    options.validate();
    require(direction == 1 || direction == -1, "direction", direction, "must be 1 or -1");
    check_derivatives(problem, q, p, 1e-4);
    AnyBranchStepper<Matrix> stepper(problem, options.stepping());
    const auto start = stepper.start(q, p, direction);
    if (!start) {
        Branch<Erased> none;
        none.end = BranchEnd::stopped;
        return none;
    }
    return follow(stepper, *start, options, functions);
}

template <class Matrix>
bool lies_on(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch, const BranchPoint<Erased>& point) {
    for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
        const BranchPoint<Erased>& from = branch.points[k];
        const Direction chord = stepper.difference(from, branch.points[k + 1].q, branch.points[k + 1].p);
        const Direction to = stepper.difference(from, point.q, point.p);
        const double length = stepper.length(chord), share = stepper.dot(chord, to) / (length * length);
        if (!(share > -0.1 && share < 1.1 && stepper.length(to) < 1.2 * length)) continue;
        // on the branch itself, as far along the tangent as the point
        const auto at = stepper.step(from, stepper.dot(from.tangent, to));
        if (at && stepper.length(stepper.difference(*at, point.q, point.p)) < 1e-6 * (1 + length)) return true;
    }
    return false;
}

template <class Matrix>
std::vector<BranchPoint<Erased>> switch_branch(AnyBranchStepper<Matrix>& stepper, const CriticalPoint<Erased>& point,
                                               const Direction& incoming, double amplitude) {
    require(amplitude > 0 && std::isfinite(amplitude), "amplitude", amplitude, "must be positive and finite");
    return detail::BranchSwitch<Matrix>(stepper, point, incoming, amplitude).run();
}

}  // namespace equilibria
