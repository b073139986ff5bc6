/// \file
/// Branches: followed from point to point with everything that happens in between, and left at bifurcations.
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/events.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>

namespace equilibria {

/// How far a branch is followed, and how.
struct ContinuationOptions {
    BranchOptions branch{};           ///< steps along the branch
    CriticalPointOptions critical{};  ///< Newton's method at critical points
    /// Window of p, in its own unit: the branch ends on its border. A start outside is led to it, and nothing noted on
    /// the way.
    Interval range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    int most_steps = 1000;  ///< the branch ends after as many
    /// The branch ends with the step on which it has as many.
    int most_critical_points = std::numeric_limits<int>::max();

    /// The steps, of a span of p that is the range's width where that is finite and no span is given.
    BranchOptions stepping() const {
        BranchOptions y = branch;
        const double width = range.high - range.low;
        if (y.parameter_span == 0 && std::isfinite(width)) y.parameter_span = width;
        return y;
    }

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        branch.validate();
        critical.validate();
        require(range.low < range.high, "range.low", range.low, "must be below range.high");
        require(most_steps >= 1, "most_steps", most_steps, "must be at least 1");
        require(most_critical_points >= 1, "most_critical_points", most_critical_points, "must be at least 1");
    }
};

/// Why a branch ends.
enum class BranchEnd {
    steps,     ///< as many as allowed
    window,    ///< p left its range: the last point is on the range's border
    closed,    ///< back at its first point
    stopped,   ///< the smallest step did not converge
    critical,  ///< as many critical points as allowed
    event,     ///< an event function that ends it vanished on its last step
};
/// One word: "steps", "window", "closed", "stopped", "critical" or "event".
constexpr const char* to_string(BranchEnd end) {
    constexpr const char* names[] = {"steps", "window", "closed", "stopped", "critical", "event"};
    return names[static_cast<int>(end)];
}

/// A step whose changes of sign the events do not account for.
struct UnexplainedStep {
    std::size_t step;    ///< between points step and step + 1
    std::string reason;  ///< what is not accounted for, in words
};

/// A branch in one direction: its points in order, and what happens between them.
template <class P>
struct Branch {
    /// A critical point that was met.
    struct Event {
        std::size_t step;        ///< between points step and step + 1
        CriticalPoint<P> point;  ///< where it is exactly
    };
    /// A zero of an event function.
    struct Crossing {
        std::size_t step;      ///< between points step and step + 1
        std::size_t function;  ///< number of the event function
        BranchPoint<P> point;  ///< where it is 0
    };
    using Unexplained = UnexplainedStep;  ///< a step with changes of sign that are left over

    std::vector<BranchPoint<P>> points;    ///< from the start on; empty where there was none
    std::vector<Event> events;             ///< critical points, in the order in which they were met
    std::vector<Crossing> crossings;       ///< zeros of event functions
    std::vector<Unexplained> unexplained;  ///< steps that hide something; none: the branch is complete
    BranchEnd end = BranchEnd::steps;      ///< why there are no more points
};

/// The same branch, its configurations of any type, and back.
/// \{
template <ContinuationProblem P>
Branch<Erased> erased(const Branch<P>& branch) {
    Branch<Erased> y;
    for (const auto& point : branch.points) y.points.push_back(erased(point));
    for (const auto& [step, point] : branch.events) y.events.push_back({step, erased(point)});
    for (const auto& [step, function, point] : branch.crossings) y.crossings.push_back({step, function, erased(point)});
    y.unexplained = branch.unexplained;
    y.end = branch.end;
    return y;
}
template <ContinuationProblem P>
Branch<P> typed(const Branch<Erased>& branch) {
    Branch<P> y;
    for (const auto& point : branch.points) y.points.push_back(typed<P>(point));
    for (const auto& [step, point] : branch.events) y.events.push_back({step, typed<P>(point)});
    for (const auto& [step, function, point] : branch.crossings)
        y.crossings.push_back({step, function, typed<P>(point)});
    y.unexplained = branch.unexplained;
    y.end = branch.end;
    return y;
}
/// \}

/// The points of a branch, one after the other, for a driver of its own:
///
///     BranchStepper stepper(problem, options);
///     for (const auto& point : BranchPoints(stepper, *stepper.start(q, p, 1))) if (enough(point)) break;
template <ContinuationProblem P>
class BranchPoints {
public:
    /// The stepper must outlive it; start: a point of the branch with a tangent that leads onwards.
    BranchPoints(BranchStepper<P>& stepper, BranchPoint<P> start) : stepper_(&stepper), start_(std::move(start)) {}

    /// An input iterator, which makes a step for each increment.
    class Iterator {
    public:
        /// As an iterator of the standard library has it.
        /// \{
        using value_type = BranchPoint<P>;
        using difference_type = std::ptrdiff_t;
        /// \}
        /// At the point `start`.
        Iterator(BranchStepper<P>* stepper, const BranchPoint<P>& start) : stepper_(stepper), point_(start) {}
        /// The point of the branch at which it is.
        const BranchPoint<P>& operator*() const { return *point_; }
        const BranchPoint<P>* operator->() const { return &*point_; }  ///< the same, for its members
        /// A step onwards, which may lead to the end.
        /// \{
        Iterator& operator++() {
            auto next = stepper_->advance(*point_, before_ ? &*before_ : nullptr);
            before_ = std::move(point_);
            point_ = std::move(next);
            return *this;
        }
        void operator++(int) { ++*this; }
        /// \}
        /// Whether the branch has ended.
        friend bool operator==(const Iterator& i, std::default_sentinel_t) { return !i.point_; }

    private:
        BranchStepper<P>* stepper_;
        std::optional<BranchPoint<P>> point_, before_;
    };

    /// From the start, to where the stepper gives no point any more.
    /// \{
    Iterator begin() const { return {stepper_, start_}; }
    std::default_sentinel_t end() const { return {}; }
    /// \}

private:
    BranchStepper<P>* stepper_;
    BranchPoint<P> start_;
};

/// Of problems of any type; see below.
/// \{
template <class Matrix>
Branch<Erased> follow(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& start,
                      const ContinuationOptions& options, const std::vector<EventFunction<Erased>>& functions);
template <class Matrix>
Branch<Erased> continue_branch(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p, int direction,
                               const ContinuationOptions& options, const std::vector<EventFunction<Erased>>& functions);
template <class Matrix>
bool lies_on(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch, const BranchPoint<Erased>& point);
template <class Matrix>
Branch<Erased> image_of(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch, std::size_t image,
                        const std::vector<EventFunction<Erased>>& functions);
template <class Matrix>
std::optional<Branch<Erased>> known_image(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch,
                                          const BranchPoint<Erased>& start,
                                          const std::vector<EventFunction<Erased>>& functions);
template <class Matrix>
std::vector<BranchPoint<Erased>> switch_branch(AnyBranchStepper<Matrix>& stepper, const CriticalPoint<Erased>& point,
                                               const Direction& incoming, double amplitude);
/// \}

/// Follows the branch from one of its points, in the direction of its tangent. functions: located where they change
/// sign. Of a problem with `images(q)` a branch that passes a bifurcation along its null vector, and is the image of
/// itself on the other side, is not followed there: its points are the images of those before.
template <ContinuationProblem P>
Branch<P> follow(BranchStepper<P>& stepper, const BranchPoint<P>& start, const ContinuationOptions& options,
                 const std::vector<EventFunction<P>>& functions = {}) {
    return typed<P>(follow(stepper.any(), erased(start), options, erased(functions)));
}

/// Follows the equilibria of a problem from the one near q at the parameter p, towards larger parameters (direction 1)
/// or smaller ones (-1): through folds, with each critical point and each zero of `functions` on the way. Without
/// points where there is no equilibrium near q. Throws InvalidArgument for options out of range and for a problem that
/// fails check_derivatives.
template <ContinuationProblem P>
Branch<P> continue_branch(const P& problem, const Configuration<P>& q, double p, int direction,
                          const ContinuationOptions& options = {},
                          const std::vector<EventFunction<P>>& functions = {}) {
    return typed<P>(
        continue_branch(AnyProblemOf<P>(problem), AnyConfiguration::of(q), p, direction, options, erased(functions)));
}

/// Whether a point lies on a branch, between two of its points.
template <ContinuationProblem P>
bool lies_on(BranchStepper<P>& stepper, const Branch<P>& branch, const BranchPoint<P>& point) {
    return lies_on(stepper.any(), erased(branch), erased(point));
}

/// The image of a branch by one of problem.images(q), from the image of its start on, with the zeros of `functions`.
template <ContinuationProblem P>
Branch<P> image_of(BranchStepper<P>& stepper, const Branch<P>& branch, std::size_t image,
                   const std::vector<EventFunction<P>>& functions = {}) {
    return typed<P>(image_of(stepper.any(), erased(branch), image, erased(functions)));
}

/// The image of a branch which begins next to the start and goes the same way, where an image of the start lies on the
/// branch; nothing otherwise.
template <ContinuationProblem P>
std::optional<Branch<P>> known_image(BranchStepper<P>& stepper, const Branch<P>& branch, const BranchPoint<P>& start,
                                     const std::vector<EventFunction<P>>& functions = {}) {
    const auto found = known_image(stepper.any(), erased(branch), erased(start), erased(functions));
    if (!found) return std::nullopt;
    return typed<P>(*found);
}

/// Points of the other branches through a bifurcation, about `amplitude` away from it, with tangents that lead away:
/// one for each half branch. `incoming`: the tangent of the branch that is left. At a point with two null vectors
/// directions between them are tried all around, and the branches found are those that they lead to. Throws
/// InvalidArgument unless the amplitude is positive and finite.
template <ContinuationProblem P>
std::vector<BranchPoint<P>> switch_branch(BranchStepper<P>& stepper, const CriticalPoint<P>& point,
                                          const Direction& incoming, double amplitude) {
    std::vector<BranchPoint<P>> y;
    for (const auto& start : switch_branch(stepper.any(), erased(point), incoming, amplitude))
        y.push_back(typed<P>(start));
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/branch_definitions.hpp>
#include <equilibria/continuation/detail/branch_images_definitions.hpp>
#endif
