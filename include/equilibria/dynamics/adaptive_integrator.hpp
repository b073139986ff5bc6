/// \file
/// Integrates y' = f(t, y), of as many numbers as are known at run time, by the embedded Runge-Kutta pair of Fehlberg,
/// 7(8), with step control (Boost.Odeint): for motions with unknowns of their own, which are no MotionFormulation.
///
/// Why that pair: at tolerances near rounding it takes the fewest steps of the explicit ones. Steps end at the times
/// that are asked for: there is no dense output of this order (for that, and for projection onto constraints, see
/// MotionStepper in motion.hpp). Where it fails: on stiff equations, whose step is bounded by the fastest decay.
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, sections II.4 and II.5.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria {

/// One solution from time 0, a step at a time.
class AdaptiveIntegrator {
public:
    using State = std::vector<double>;
    /// f: the rates of a state at a time, written to its second argument, which has the state's size.
    using Rates = std::function<void(const State& y, State& rate, double t)>;

    /// first_step: a guess, in units of time. Throws InvalidArgument where an option is none. Of a start whose numbers
    /// are not finite the first step says so.
    AdaptiveIntegrator(Rates rates, State start, double first_step, const MotionOptions& options)
        : rates_(std::move(rates)), options_(options), y_(std::move(start)), step_(first_step) {
        options.validate();
        pair_ = boost::numeric::odeint::make_controlled(options.absolute_tolerance, options.relative_tolerance, Pair());
    }

    /// The end of the last step, and the state there.
    double time() const { return time_; }
    const State& state() const { return y_; }
    MotionStatus status() const { return status_; }
    std::uint64_t steps() const { return steps_; }  ///< that were tried
    std::uint64_t evaluations() const { return evaluations_; }

    /// One step, of the size that the tolerances allow, that ends at `until` or before. False where there is none:
    /// `status` says why. At most most_steps of the options are tried in all.
    bool step(double until) {
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
            const bool done = pair_.try_step(std::cref(counted), y_, t, dt) == boost::numeric::odeint::success;
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

private:
    using Pair = boost::numeric::odeint::runge_kutta_fehlberg78<State>;
    using Controlled = boost::numeric::odeint::result_of::make_controlled<Pair>::type;

    bool end(MotionStatus status) {
        status_ = status;
        return false;
    }

    Rates rates_;
    MotionOptions options_;
    Controlled pair_;
    State y_;
    double time_ = 0, step_;
    MotionStatus status_ = MotionStatus::finished;
    std::uint64_t steps_ = 0, evaluations_ = 0;
};

}  // namespace equilibria
