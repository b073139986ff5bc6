/// \file
/// See continuation/branch.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
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
            if (!(before[f] * values_[f] < 0 || (values_[f] == 0 && before[f] != 0))) continue;
            if (auto zero = zero_between(stepper_, functions_[f], from, next))
                branch.crossings.push_back({step, f, std::move(*zero)});
            else
                branch.unexplained.push_back({step, functions_[f].name + " changes sign, and no zero was found"});
        }
    }
    /// Points have been replaced.
    void forget() { at_.reset(); }

private:
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

}  // namespace detail

template <class Matrix>
Branch<Erased> follow(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& start,
                      const ContinuationOptions& options, const std::vector<EventFunction<Erased>>& functions) {
    Branch<Erased> branch;
    branch.points.push_back(start);
    detail::CrossingFinder<Matrix> crossings(stepper, functions);
    BranchPoint<Erased> before;
    bool gone_back = false;  // by images: at the other end the branch closes
    for (int k = 0; k < options.most_steps; ++k) {
        const BranchPoint<Erased> from = branch.points.back();
        auto next = stepper.advance(from, k > 0 ? &before : nullptr);
        if (!next) {
            branch.end = BranchEnd::stopped;
            return branch;
        }
        const std::size_t step = branch.points.size() - 1;
        auto events = events_between(stepper, options.critical, from, *next);
        for (auto& point : events.points) branch.events.push_back({step, std::move(point)});
        if (!events.explained) branch.unexplained.push_back({step, std::move(events.reason)});
        before = from;
        branch.points.push_back(std::move(*next));
        crossings.add(branch, step);
        const BranchPoint<Erased>& last = branch.points.back();
        if (branch.events.size() >= static_cast<std::size_t>(options.most_critical_points)) {
            branch.end = BranchEnd::critical;
            return branch;
        }
        if (last.p < options.range.low || last.p > options.range.high) {
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
            const Direction back = stepper.difference(last, start.q, start.p);
            const double along = stepper.dot(back, last.tangent);
            if (along <= 0 && -along <= last.step && stepper.length(back) <= 1.1 * last.step &&
                stepper.dot(last.tangent, start.tangent) > 0.5) {
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
    AnyBranchStepper<Matrix> stepper(problem, options.branch);
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
    std::vector<BranchPoint<Erased>> found;
    std::vector<Direction> directions;  // from the critical point to what was found
    const auto cosine = [&](const Direction& a, const Direction& b) {
        return stepper.dot(a, b) / (stepper.length(a) * stepper.length(b));
    };
    // amplitudes in turn until the corrector converges
    const auto attempt = [&](Direction t, double p_curvature, std::initializer_list<double> shares) {
        AnyBranchStepper<Matrix>::scale(t, 1 / stepper.length(t));
        // the plane's normal has no share of the branch that is left: the corrector cannot fall back onto it
        Direction normal = incoming;
        AnyBranchStepper<Matrix>::scale(normal, -stepper.dot(t, incoming) / stepper.dot(incoming, incoming));
        normal.q += t.q;
        normal.p += t.p;
        for (const double sign : {1.0, -1.0})
            for (const double share : shares) {
                const double s = share * amplitude;
                Direction increment = t, along = t;
                AnyBranchStepper<Matrix>::scale(increment, sign * s);
                AnyBranchStepper<Matrix>::scale(along, sign);
                increment.p += p_curvature * s * s / 2;
                auto start = stepper.onto(point.q, point.p, increment, normal, along);
                if (!start) continue;
                BranchPoint<Erased> center;
                center.q = point.q;
                center.p = point.p;
                const Direction to = stepper.difference(center, start->q, start->p);
                if (std::none_of(directions.begin(), directions.end(),
                                 [&](const Direction& other) { return cosine(to, other) > 0.995; })) {
                    directions.push_back(to);
                    found.push_back(std::move(*start));
                }
                break;
            }
    };
    if (point.tangents.size() == 2) {
        // the other one than the branch that is left
        const bool first =
            std::abs(cosine(point.tangents[0], incoming)) < std::abs(cosine(point.tangents[1], incoming));
        const Direction& t = point.tangents[first ? 0 : 1];
        const double phi2 = point.null_vector.dot(stepper.metric().cwiseProduct(point.null_vector));
        attempt(t, point.kind == CriticalKind::pitchfork && t.p == 0 ? point.curvature / phi2 : 0, {1, .5, .25, .125});
    }
    if (point.kind == CriticalKind::multiple && point.null_vectors.cols() == 2)
        for (const double share : {1.0, 2.0, 4.0, 8.0}) {
            // close to the point all directions between branches are nearly equilibria
            for (int k = 0; k < 24; ++k) {
                const double angle = std::numbers::pi * k / 24;
                attempt({std::cos(angle) * point.null_vectors.col(0) + std::sin(angle) * point.null_vectors.col(1), 0},
                        0, {share});
            }
            if (!found.empty()) break;
        }
    return found;
}

}  // namespace equilibria
