/// \file
/// See dynamics/detail/motion_integration.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/detail/motion_integration.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE MotionIntegration::MotionIntegration(double start_time, const MotionOptions& options)
    : options_(options), integrator_(options), start_time_(start_time) {
    require(std::isfinite(start_time), "start_time", start_time, "must be finite");
}

EQUILIBRIA_INLINE void MotionIntegration::begin(const MotionEquations& equations, const State& start) {
    between_ = start;
    const auto energies = equations.energies(start_time_, start);
    start_energy_ = energies.kinetic + energies.potential;
    start_potential_ = energies.potential;
    integrator_.initialize(start, start_time_, first_step(equations, start));
    note(energies, start);
}

EQUILIBRIA_INLINE bool MotionIntegration::step(const MotionEquations& equations) {
    if (status_ != MotionStatus::finished) return false;
    if (steps_ >= options_.most_steps) return end(MotionStatus::too_many_steps);
    if (corrected_) {
        integrator_.initialize(projected_, time(), integrator_.time_step());
        corrected_ = false;
    }
    trouble_ = MotionStatus::finished;
    const bool done = integrator_.step([&](const State& y, State& rate, double t) { rates(equations, t, y, rate); });
    if (!done) return end(trouble_ != MotionStatus::finished ? trouble_ : MotionStatus::step_too_small);
    ++steps_;
    const State& y = integrator_.state();
    if (!std::all_of(y.begin(), y.end(), [](double x) { return std::isfinite(x); }))
        return end(trouble_ != MotionStatus::finished ? trouble_ : MotionStatus::not_finite);
    note(equations.energies(time(), y), y);
    projected_ = y;
    const auto status = equations.project(projected_);
    corrected_ = projected_ != y;
    return status == MotionStatus::finished || end(status);
}

EQUILIBRIA_INLINE const MotionIntegration::State& MotionIntegration::at(const MotionEquations& equations, double t) {
    if (t != time())
        integrator_.interpolate(t, between_);
    else
        between_ = integrator_.state();
    equations.project(between_);
    return between_;
}

EQUILIBRIA_INLINE void MotionIntegration::rates(const MotionEquations& equations, double t, const State& y,
                                                State& rate) {
    ++evaluations_;
    const auto status = equations.rates(t, y, rate);
    if (status == MotionStatus::finished) return;
    trouble_ = status;
    std::fill(rate.begin(), rate.end(), std::numeric_limits<double>::quiet_NaN());
}

/// A hundredth of the time in which the formulation's state changes by its own size.
EQUILIBRIA_INLINE double MotionIntegration::first_step(const MotionEquations& equations, const State& y) {
    State rate(y.size());
    rates(equations, start_time_, y, rate);
    double size = 0, speed = 0;
    for (std::size_t k = 0; k + 2 < y.size(); ++k)
        size = std::max(size, std::abs(y[k])), speed = std::max(speed, std::abs(rate[k]));
    const double step = size > 0 && speed > 0 && std::isfinite(size / speed) ? 0.01 * size / speed : 1e-6;
    return options_.largest_step > 0 ? std::min(step, options_.largest_step) : step;
}

EQUILIBRIA_INLINE void MotionIntegration::note(const MotionEnergies& at, const State& y) {
    largest_drift_ = std::max(largest_drift_, at.drift);
    largest_velocity_drift_ = std::max(largest_velocity_drift_, at.velocity_drift);
    largest_balance_ = std::max(largest_balance_, std::abs(balance(at.kinetic, at.potential, y)));
    largest_energy_ = std::max(
        {largest_energy_, at.kinetic, std::abs(at.potential - start_potential_), std::abs(work(y)), dissipated(y)});
}

}  // namespace equilibria::detail
