/// \file
/// Zeros of scalars along a branch.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <boost/math/tools/toms748_solve.hpp>

#include <equilibria/continuation/branch_stepper.hpp>

namespace equilibria {

/// A scalar of the points of a branch whose zeros are located: where a node passes a height, where a reaction vanishes.
template <class P>
struct EventFunction {
    std::string name;
    std::function<double(const BranchPoint<P>&)> value;
};

/// Where the function vanishes between two neighbouring points at which its signs differ; nothing where the branch is
/// lost or the function jumps.
template <ContinuationProblem P>
std::optional<BranchPoint<P>> zero_between(BranchStepper<P>& stepper, const EventFunction<P>& function,
                                           const BranchPoint<P>& a, const BranchPoint<P>& b) {
    const double at_a = function.value(a), at_b = function.value(b), h = b.arc_length - a.arc_length;
    if (at_b == 0) return b;
    std::optional<BranchPoint<P>> best;
    double least = std::numeric_limits<double>::infinity();
    const auto value = [&](double share) {
        auto point = stepper.step(a, share * h);
        // where the branch is ill determined, as at a double point, the function is nearly linear
        if (!point) return (1 - share) * at_a + share * at_b;
        const double y = function.value(*point);
        if (std::abs(y) < least) least = std::abs(y), best = std::move(point);
        return y;
    };
    std::uintmax_t iterations = 60;
    boost::math::tools::toms748_solve(value, 0.0, 1.0, at_a, at_b, boost::math::tools::eps_tolerance<double>(50),
                                      iterations);
    if (!(least <= 1e-6 * std::max(std::abs(at_a), std::abs(at_b)))) return std::nullopt;
    return best;
}

}  // namespace equilibria
