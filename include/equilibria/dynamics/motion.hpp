/// \file
/// Integrates the motion of a model in any formulation, by the embedded Runge-Kutta pair of Dormand and Prince with
/// dense output (Boost.Odeint), with its energy balance.
///
/// \code
/// const auto motion = integrate_motion(LagrangeSecondKind<Pendulum>(p), {{0.5}, {0}}, {1, 2, 10});
/// motion.points.back().q[0];
/// \endcode
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/dynamics/motion_point.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria {

/// One motion, a step at a time. Between the ends of the last step it is known everywhere.
template <MotionFormulation F>
class MotionStepper {
public:
    using Model = typename F::Model;

    /// Throws InvalidArgument where the start or an option is none.
    MotionStepper(const F& formulation, const MotionState<Model>& start, double start_time = 0,
                  const MotionOptions& options = {})
        : formulation_(formulation), options_(options) {
        options.validate();
        require(std::isfinite(start_time), "start_time", start_time, "must be finite");
        const auto state = formulation_.start(start);
        State y{};
        std::copy(state.begin(), state.end(), y.begin());
        const auto point = formulation_.point(start_time, state);
        start_energy_ = point.kinetic + point.potential;
        start_potential_ = point.potential;
        stepper_ = boost::numeric::odeint::make_dense_output(options.absolute_tolerance, options.relative_tolerance,
                                                             options.largest_step, Pair());
        stepper_.initialize(y, start_time, first_step(y, start_time));
        note(point_at(start_time, y));
    }

    /// The end of the last step.
    double time() const { return stepper_.current_time(); }
    MotionStatus status() const { return status_; }
    std::uint64_t steps() const { return steps_; }
    std::uint64_t evaluations() const { return evaluations_; }
    /// The largest |balance| at the ends of the steps, over the largest of the energies that it is made of.
    double largest_balance() const { return largest_energy_ > 0 ? largest_balance_ / largest_energy_ : 0; }
    /// The constraints' largest errors at the ends of the steps, before they were put right.
    double largest_drift() const { return largest_drift_; }
    double largest_velocity_drift() const { return largest_velocity_drift_; }

    /// One step of the size that the tolerances allow. False where there is none: `status` says why.
    bool step() {
        if (status_ != MotionStatus::finished) return false;
        if (steps_ >= options_.most_steps) return end(MotionStatus::too_many_steps);
        if (corrected_) {
            stepper_.initialize(projected_, time(), stepper_.current_time_step());
            corrected_ = false;
        }
        trouble_ = MotionStatus::finished;
        try {
            stepper_.do_step([this](const State& y, State& rate, double t) { rates(y, rate, t); });
        } catch (const boost::numeric::odeint::odeint_error&) {
            return end(trouble_ != MotionStatus::finished ? trouble_ : MotionStatus::step_too_small);
        }
        ++steps_;
        const State& y = stepper_.current_state();
        if (!std::all_of(y.begin(), y.end(), [](double x) { return std::isfinite(x); }))
            return end(trouble_ != MotionStatus::finished ? trouble_ : MotionStatus::not_finite);
        note(point_at(time(), y));
        projected_ = y;
        const auto status = project(projected_);
        corrected_ = projected_ != y;
        return status == MotionStatus::finished || end(status);
    }

    /// The motion at a time between the ends of the last step, with the constraints put right.
    MotionPoint<Model> at(double t) {
        State y = stepper_.current_state();
        if (t != time()) stepper_.calc_state(t, y);
        project(y);
        return point_at(t, y);
    }

private:
    // the formulation's state, then the work of the generalised forces, then what damping has taken
    static constexpr std::size_t n = F::n_states;
    using State = std::array<double, n + 2>;
    using Pair = boost::numeric::odeint::runge_kutta_dopri5<State>;
    using Stepper = typename boost::numeric::odeint::result_of::make_dense_output<Pair>::type;

    static std::array<double, n> formulation_state(const State& y) {
        std::array<double, n> state;
        std::copy_n(y.begin(), n, state.begin());
        return state;
    }

    void rates(const State& y, State& rate, double t) {
        ++evaluations_;
        const auto found = formulation_.rates(t, formulation_state(y));
        if (found.status != MotionStatus::finished) {
            trouble_ = found.status;
            rate.fill(std::numeric_limits<double>::quiet_NaN());
            return;
        }
        std::copy(found.state.begin(), found.state.end(), rate.begin());
        rate[n] = found.power;
        rate[n + 1] = found.loss;
    }

    /// A hundredth of the time in which the state changes by its own size.
    double first_step(const State& y, double t) {
        State rate;
        rates(y, rate, t);
        double size = 0, speed = 0;
        for (std::size_t k = 0; k < n; ++k)
            size = std::max(size, std::abs(y[k])), speed = std::max(speed, std::abs(rate[k]));
        const double step = size > 0 && speed > 0 && std::isfinite(size / speed) ? 0.01 * size / speed : 1e-6;
        return options_.largest_step > 0 ? std::min(step, options_.largest_step) : step;
    }

    MotionStatus project(State& y) const {
        auto state = formulation_state(y);
        const auto status = formulation_.project(state);
        if (status == MotionStatus::finished) std::copy(state.begin(), state.end(), y.begin());
        return status;
    }

    MotionPoint<Model> point_at(double t, const State& y) const {
        auto point = formulation_.point(t, formulation_state(y));
        point.work = y[n];
        point.dissipated = y[n + 1];
        point.balance = point.kinetic + point.potential + point.dissipated - point.work - start_energy_;
        return point;
    }

    void note(const MotionPoint<Model>& point) {
        largest_drift_ = std::max(largest_drift_, point.drift);
        largest_velocity_drift_ = std::max(largest_velocity_drift_, point.velocity_drift);
        largest_balance_ = std::max(largest_balance_, std::abs(point.balance));
        largest_energy_ = std::max({largest_energy_, point.kinetic, std::abs(point.potential - start_potential_),
                                    std::abs(point.work), point.dissipated});
    }

    bool end(MotionStatus status) {
        status_ = status;
        return false;
    }

    F formulation_;
    MotionOptions options_;
    Stepper stepper_;
    State projected_{};
    bool corrected_ = false;
    MotionStatus status_ = MotionStatus::finished, trouble_ = MotionStatus::finished;
    std::uint64_t steps_ = 0, evaluations_ = 0;
    double start_energy_ = 0, start_potential_ = 0;
    double largest_balance_ = 0, largest_energy_ = 0, largest_drift_ = 0, largest_velocity_drift_ = 0;
};

/// A motion at given times, with its evidence.
template <DynamicModel M>
struct Motion {
    MotionStatus status = MotionStatus::finished;
    double time = 0;                     ///< how far it came
    std::vector<MotionPoint<M>> points;  ///< at the given times, as far as it came
    std::uint64_t steps = 0, evaluations = 0;
    double largest_balance = 0;  ///< see MotionStepper
    double largest_drift = 0, largest_velocity_drift = 0;
};

/// The motion from `start` at start_time, at `times`: none below start_time, none below the one before it. Throws
/// InvalidArgument where these, the start or an option are none; all else that may happen is a status.
template <MotionFormulation F>
Motion<typename F::Model> integrate_motion(const F& formulation, const MotionState<typename F::Model>& start,
                                           const std::vector<double>& times, const MotionOptions& options = {},
                                           double start_time = 0) {
    detail::require_rising_times(times, start_time);
    MotionStepper<F> stepper(formulation, start, start_time, options);
    Motion<typename F::Model> y;
    for (const double t : times) {
        while (stepper.time() < t && stepper.step()) {
        }
        if (stepper.time() < t || stepper.status() != MotionStatus::finished) break;
        y.points.push_back(stepper.at(t));
    }
    y.status = stepper.status();
    y.time = stepper.time();
    y.steps = stepper.steps();
    y.evaluations = stepper.evaluations();
    y.largest_balance = stepper.largest_balance();
    y.largest_drift = stepper.largest_drift();
    y.largest_velocity_drift = stepper.largest_velocity_drift();
    return y;
}

}  // namespace equilibria
