/// \file
/// Zeros of scalars along a branch.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>

namespace equilibria {

/// A scalar of the points of a branch whose zeros are located: where a node passes a height, where a reaction vanishes.
template <class P>
struct EventFunction {
    std::string name;                                    ///< what reports call it
    std::function<double(const BranchPoint<P>&)> value;  ///< the scalar at a point; continuous along the branch
    bool ends = false;                                   ///< the branch ends with the step on which it vanishes
};

/// The same function or functions, of points of any type.
/// \{
template <ContinuationProblem P>
EventFunction<Erased> erased(const EventFunction<P>& function) {
    return {function.name, [value = function.value](const BranchPoint<Erased>& at) { return value(typed<P>(at)); },
            function.ends};
}
template <ContinuationProblem P>
std::vector<EventFunction<Erased>> erased(const std::vector<EventFunction<P>>& functions) {
    std::vector<EventFunction<Erased>> y;
    for (const auto& function : functions) y.push_back(erased(function));
    return y;
}
/// \}

/// Of a problem of any type, see below.
template <class Matrix>
std::optional<BranchPoint<Erased>> zero_between(AnyBranchStepper<Matrix>& stepper,
                                                const EventFunction<Erased>& function, const BranchPoint<Erased>& a,
                                                const BranchPoint<Erased>& b);

/// Where the function vanishes between two neighbouring points at which its signs differ; nothing where the branch is
/// lost or the function jumps.
template <ContinuationProblem P>
std::optional<BranchPoint<P>> zero_between(BranchStepper<P>& stepper, const EventFunction<P>& function,
                                           const BranchPoint<P>& a, const BranchPoint<P>& b) {
    return typed<P>(zero_between(stepper.any(), erased(function), erased(a), erased(b)));
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/event_function_definitions.hpp>
#endif
