/// \file
/// See dynamics/adaptive_integrator.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <equilibria/dynamics/adaptive_integrator.hpp>

namespace equilibria {

struct AdaptiveIntegrator::Pair {
    using Fehlberg = boost::numeric::odeint::runge_kutta_fehlberg78<State>;

    explicit Pair(const MotionOptions& options)
        : control(boost::numeric::odeint::make_controlled(options.absolute_tolerance, options.relative_tolerance,
                                                          Fehlberg())) {}
    boost::numeric::odeint::result_of::make_controlled<Fehlberg>::type control;
};

EQUILIBRIA_INLINE AdaptiveIntegrator::AdaptiveIntegrator(AdaptiveIntegrator&&) noexcept = default;
EQUILIBRIA_INLINE AdaptiveIntegrator& AdaptiveIntegrator::operator=(AdaptiveIntegrator&&) noexcept = default;
EQUILIBRIA_INLINE AdaptiveIntegrator::~AdaptiveIntegrator() = default;

EQUILIBRIA_INLINE AdaptiveIntegrator::AdaptiveIntegrator(Rates rates, State start, double first_step,
                                                         const MotionOptions& options)
    : rates_(std::move(rates)), options_(options), y_(std::move(start)), step_(first_step) {
    options.validate();
    pair_ = std::make_unique<Pair>(options);
}

EQUILIBRIA_INLINE bool AdaptiveIntegrator::step(double until) {
    if (status_ != MotionStatus::finished) return false;
    const Rates counted = [this](const State& y, State& rate, double t) {
        ++evaluations_;
        rates_(y, rate, t);
    };
    for (;;) {
        if (steps_ >= options_.most_steps) return end(MotionStatus::too_many_steps);
        ++steps_;
        if (options_.largest_step > 0) step_ = std::min(step_, options_.largest_step);
        const bool last = time_ + step_ >= until;
        double dt = last ? until - time_ : step_, t = time_;
        const bool done = pair_->control.try_step(std::cref(counted), y_, t, dt) == boost::numeric::odeint::success;
        if (!std::all_of(y_.begin(), y_.end(), [](double x) { return std::isfinite(x); }))
            return end(MotionStatus::not_finite);
        if (done) {
            time_ = last ? until : t;
            step_ = last ? std::max(step_, dt) : dt;
            return true;
        }
        step_ = dt;
        if (!(dt > 1e-14 * std::max(1.0, time_))) return end(MotionStatus::step_too_small);
    }
}

}  // namespace equilibria
