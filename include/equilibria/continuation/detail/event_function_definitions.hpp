/// \file
/// See continuation/event_function.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

#include <equilibria/continuation/event_function.hpp>

namespace equilibria {

template <class Matrix>
std::optional<BranchPoint<Erased>> zero_between(AnyBranchStepper<Matrix>& stepper,
                                                const EventFunction<Erased>& function, const BranchPoint<Erased>& a,
                                                const BranchPoint<Erased>& b) {
    const double at_a = function.value(a), at_b = function.value(b), h = b.arc_length - a.arc_length;
    if (at_b == 0) return b;
    // the parabola from a through b: b is where a step of -h would have begun
    const bool parabola = stepper.options().predictor == Predictor::quadratic;
    BranchPoint<Erased> from = a;
    if (parabola) from.step = -h;
    std::optional<BranchPoint<Erased>> best;
    double least = std::numeric_limits<double>::infinity();
    const auto value = [&](double share) {
        auto point = stepper.step(from, share * h, parabola ? &b : nullptr);
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
