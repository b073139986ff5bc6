/// \file
/// See core/exact_ball.hpp.
#pragma once

#include <cmath>
#include <concepts>

#include <equilibria/core/exact_ball.hpp>
#include <equilibria/core/multiprecision.hpp>

namespace equilibria {

/// f over the ball: its value at the midpoint; `slope` bounds |f'| on the ball.
template <class F>
ExactBall ExactBall::through(F f, double slope) const {
    using Float = Multiprecision<110>;
    constexpr double trust = 1e-100;  // share by which a function or quotient over Float is wrong at the most
    const Float x = mid_.to<Float>(), y = f(x);
    const double off = rounded_up(1.01 * slope * (rad_ + trust * size()) + trust * std::abs(static_cast<double>(y)));
    require(std::isfinite(off), "model", text(), "a function of the parameters is not finite there");
    return {Dyadic(y), off};
}

template <std::same_as<ExactBall> B>
ExactBall sqrt(const B& a) {
    if (a == 0) return 0;
    require(a.low() > 0, "model", a.text(), "the square root needs a positive number");
    return a.through([](const auto& x) { return sqrt(x); }, 0.5 / std::sqrt(a.low()));
}
template <std::same_as<ExactBall> B>
ExactBall exp(const B& a) {
    if (a == 0) return 1;
    return a.through([](const auto& x) { return exp(x); }, 1.01 * std::exp(a.mid_.template to<double>() + a.rad_));
}
template <std::same_as<ExactBall> B>
ExactBall log(const B& a) {
    if (a == 1) return 0;
    require(a.low() > 0, "model", a.text(), "the logarithm needs a positive number");
    return a.through([](const auto& x) { return log(x); }, 1 / a.low());
}
template <std::same_as<ExactBall> B>
ExactBall sin(const B& a) {
    if (a == 0) return 0;
    return a.through([](const auto& x) { return sin(x); }, 1);
}
template <std::same_as<ExactBall> B>
ExactBall cos(const B& a) {
    if (a == 0) return 1;
    return a.through([](const auto& x) { return cos(x); }, 1);
}
template <std::same_as<ExactBall> B>
ExactBall inverse(const B& a) {
    if (a == 1) return 1;
    const double gap = std::abs(a.mid_.template to<double>()) * (1 - 1e-14) - a.rad_;
    require(gap > 0, "model", a.text(), "divides by a number that may be 0 at these parameters");
    return a.through([](const auto& x) { return 1 / x; }, 1.01 / gap / gap);
}

}  // namespace equilibria
