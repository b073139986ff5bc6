/// \file
/// Branches: followed from point to point with everything that happens in between, and left at bifurcations.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <vector>

#include <equilibria/continuation/events.hpp>
#include <equilibria/core/window.hpp>

namespace equilibria {

struct ContinuationOptions {
    BranchOptions branch{};
    CriticalPointOptions critical{};
    /// Of p, in its own unit: the branch ends at the first point outside.
    Interval range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    int most_steps = 1000;

    void validate() const {
        branch.validate();
        require(range.low < range.high, "range.low", range.low, "must be below range.high");
        require(most_steps >= 1, "most_steps", most_steps, "must be at least 1");
    }
};

/// Why a branch ends.
enum class BranchEnd {
    steps,    ///< as many as allowed
    window,   ///< p left its range
    closed,   ///< back at its first point
    stopped,  ///< the smallest step did not converge
};
constexpr const char* to_string(BranchEnd end) {
    constexpr const char* names[] = {"steps", "window", "closed", "stopped"};
    return names[static_cast<int>(end)];
}

template <class P>
struct Branch {
    struct Event {
        std::size_t step;  ///< between points step and step + 1
        CriticalPoint<P> point;
    };
    struct Crossing {
        std::size_t step;
        std::size_t function;  ///< number of the event function
        BranchPoint<P> point;  ///< where it is 0
    };
    struct Unexplained {
        std::size_t step;
        std::string reason;
    };

    std::vector<BranchPoint<P>> points;
    std::vector<Event> events;
    std::vector<Crossing> crossings;       ///< zeros of event functions
    std::vector<Unexplained> unexplained;  ///< steps whose changes of sign the events do not account for
    BranchEnd end = BranchEnd::steps;
};

/// The points of a branch, one after the other, for a driver of its own:
///
///     BranchStepper stepper(problem, options);
///     for (const auto& point : BranchPoints(stepper, *stepper.start(q, p, 1))) if (enough(point)) break;
template <ContinuationProblem P>
class BranchPoints {
public:
    BranchPoints(BranchStepper<P>& stepper, BranchPoint<P> start) : stepper_(&stepper), start_(std::move(start)) {}

    class Iterator {
    public:
        using value_type = BranchPoint<P>;
        using difference_type = std::ptrdiff_t;
        Iterator(BranchStepper<P>* stepper, const BranchPoint<P>& start) : stepper_(stepper), point_(start) {}
        const BranchPoint<P>& operator*() const { return *point_; }
        const BranchPoint<P>* operator->() const { return &*point_; }
        Iterator& operator++() {
            auto next = stepper_->advance(*point_, before_ ? &*before_ : nullptr);
            before_ = std::move(point_);
            point_ = std::move(next);
            return *this;
        }
        void operator++(int) { ++*this; }
        friend bool operator==(const Iterator& i, std::default_sentinel_t) { return !i.point_; }

    private:
        BranchStepper<P>* stepper_;
        std::optional<BranchPoint<P>> point_, before_;
    };

    Iterator begin() const { return {stepper_, start_}; }
    std::default_sentinel_t end() const { return {}; }

private:
    BranchStepper<P>* stepper_;
    BranchPoint<P> start_;
};

/// Follows the branch from one of its points, in the direction of its tangent. functions: located where they change
/// sign.
template <ContinuationProblem P>
Branch<P> follow(BranchStepper<P>& stepper, const BranchPoint<P>& start, const ContinuationOptions& options,
                 const std::vector<EventFunction<P>>& functions = {}) {
    Branch<P> branch;
    branch.points.push_back(start);
    EventFinder<P> finder(stepper, options.critical);
    BranchPoint<P> before;
    for (int k = 0; k < options.most_steps; ++k) {
        const BranchPoint<P> from = branch.points.back();
        auto next = stepper.advance(from, k > 0 ? &before : nullptr);
        if (!next) {
            branch.end = BranchEnd::stopped;
            return branch;
        }
        const std::size_t step = branch.points.size() - 1;
        auto events = finder.between(from, *next);
        for (auto& point : events.points) branch.events.push_back({step, std::move(point)});
        if (!events.explained) branch.unexplained.push_back({step, std::move(events.reason)});
        for (std::size_t f = 0; f < functions.size(); ++f) {
            const double at_from = functions[f].value(from), at_next = functions[f].value(*next);
            if (!(at_from * at_next < 0 || (at_next == 0 && at_from != 0))) continue;
            if (auto zero = zero_between(stepper, functions[f], from, *next))
                branch.crossings.push_back({step, f, std::move(*zero)});
            else
                branch.unexplained.push_back({step, functions[f].name + " changes sign, and no zero was found"});
        }
        before = from;
        branch.points.push_back(std::move(*next));
        const BranchPoint<P>& last = branch.points.back();
        if (last.p < options.range.low || last.p > options.range.high) {
            branch.end = BranchEnd::window;
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
    }
    return branch;
}

/// Follows the equilibria of a problem from the one near q at the parameter p, towards larger parameters (direction 1)
/// or smaller ones (-1): through folds, with each critical point and each zero of `functions` on the way. Without
/// points where there is no equilibrium near q. Throws InvalidArgument for options out of range and for a problem that
/// fails check_derivatives.
template <ContinuationProblem P>
Branch<P> continue_branch(const P& problem, const Configuration<P>& q, double p, int direction,
                          const ContinuationOptions& options = {},
                          const std::vector<EventFunction<P>>& functions = {}) {
    options.validate();
    require(direction == 1 || direction == -1, "direction", direction, "must be 1 or -1");
    check_derivatives(problem, q, p);
    BranchStepper<P> stepper(problem, options.branch);
    const auto start = stepper.start(q, p, direction);
    if (!start) {
        Branch<P> none;
        none.end = BranchEnd::stopped;
        return none;
    }
    return follow(stepper, *start, options, functions);
}

/// Whether a point lies on a branch, between two of its points.
template <ContinuationProblem P>
bool lies_on(BranchStepper<P>& stepper, const Branch<P>& branch, const BranchPoint<P>& point) {
    for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
        const BranchPoint<P>& from = branch.points[k];
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

/// Points of the other branches through a bifurcation, about `amplitude` away from it, with tangents that lead away:
/// one for each half branch. `incoming`: the tangent of the branch that is left. At a point with two null vectors
/// directions between them are tried all around, and the branches found are those that they lead to. Throws
/// InvalidArgument unless the amplitude is positive and finite.
template <ContinuationProblem P>
std::vector<BranchPoint<P>> switch_branch(BranchStepper<P>& stepper, const CriticalPoint<P>& point,
                                          const Direction& incoming, double amplitude) {
    require(amplitude > 0 && std::isfinite(amplitude), "amplitude", amplitude, "must be positive and finite");
    std::vector<BranchPoint<P>> found;
    std::vector<Direction> directions;  // from the critical point to what was found
    const auto cosine = [&](const Direction& a, const Direction& b) {
        return stepper.dot(a, b) / (stepper.length(a) * stepper.length(b));
    };
    // amplitudes in turn until the corrector converges
    const auto attempt = [&](Direction t, double p_curvature, std::initializer_list<double> shares) {
        BranchStepper<P>::scale(t, 1 / stepper.length(t));
        // the plane's normal has no share of the branch that is left: the corrector cannot fall back onto it
        Direction normal = incoming;
        BranchStepper<P>::scale(normal, -stepper.dot(t, incoming) / stepper.dot(incoming, incoming));
        normal.q += t.q;
        normal.p += t.p;
        for (const double sign : {1.0, -1.0})
            for (const double share : shares) {
                const double s = share * amplitude;
                Direction increment = t, along = t;
                BranchStepper<P>::scale(increment, sign * s);
                BranchStepper<P>::scale(along, sign);
                increment.p += p_curvature * s * s / 2;
                auto start = stepper.onto(point.q, point.p, increment, normal, along);
                if (!start) continue;
                BranchPoint<P> center;
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
