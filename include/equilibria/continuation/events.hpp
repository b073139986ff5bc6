/// \file
/// What happens in a step of continuation: folds and bifurcations, located exactly, and an account of the eigenvalues
/// that changed sign. A step whose changes are not all explained is reported as such.
///
/// Two signs decide: that of det K (or the number of negative eigenvalues, where it is known) and that of dp/ds.
///     both change                a fold
///     det K alone                a bifurcation, crossed on a branch transversal to it
///     dp/ds alone                a pitchfork passed along its side branch, where an eigenvalue only touches 0
///     two eigenvalues or more    several points close to each other, or one with several null vectors
/// Where the points found do not account for the step it is halved, down to a resolution; so it is where an
/// eigenvalue's slope at one end predicts a zero in the step that is not seen at the other, or where K changes by more
/// than the distances of its eigenvalues from 0: two may change in opposite directions. Where one only touches 0
/// branches touch; where two cross 0 in opposite directions in one point, that is a dead point of a mechanism.
#pragma once

#include <string>
#include <vector>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/event_function.hpp>

namespace equilibria {

/// The critical points between two neighbouring points of a branch, in order.
template <class P>
struct StepEvents {
    std::vector<CriticalPoint<P>> points;  ///< folds and bifurcations, in the order of travel
    bool explained = true;                 ///< they account for every change of sign
    std::string reason;                    ///< what is not accounted for, in words
};

/// The same events, with the configurations of the problem's own type.
template <ContinuationProblem P>
StepEvents<P> typed(const StepEvents<Erased>& events) {
    StepEvents<P> y;
    for (const auto& point : events.points) y.points.push_back(typed<P>(point));
    y.explained = events.explained;
    y.reason = events.reason;
    return y;
}

/// Of a problem of any type, see EventFinder.
template <class Matrix>
StepEvents<Erased> events_between(AnyBranchStepper<Matrix>& stepper, const CriticalPointOptions& options,
                                  const BranchPoint<Erased>& a, const BranchPoint<Erased>& b);

/// Finds what happens between two neighbouring points of a branch.
template <ContinuationProblem P>
class EventFinder {
public:
    using Point = BranchPoint<P>;  ///< of a branch

    /// The stepper must outlive it. Throws InvalidArgument for an option out of range.
    explicit EventFinder(BranchStepper<P>& stepper, const CriticalPointOptions& options = {})
        : stepper_(&stepper), options_(options) {
        options_.validate();
    }

    /// Between the points a and b, next to each other and in the order of travel.
    StepEvents<P> between(const Point& a, const Point& b) {
        return typed<P>(events_between(stepper_->any(), options_, erased(a), erased(b)));
    }

private:
    BranchStepper<P>* stepper_;
    CriticalPointOptions options_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/events_definitions.hpp>
#endif
