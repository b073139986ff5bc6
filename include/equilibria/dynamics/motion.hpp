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
#include <cstddef>
#include <cstdint>
#include <vector>

#include <equilibria/dynamics/detail/motion_integration.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/dynamics/motion_point.hpp>
#include <equilibria/dynamics/motion_status.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

namespace detail {

/// A formulation as the integration sees it, behind virtual calls.
template <MotionFormulation F>
class FormulationEquations final : public MotionEquations {
public:
    explicit FormulationEquations(const F& formulation) : formulation_(formulation) {}

    State start(const MotionState<typename F::Model>& at) const {
        const auto own = formulation_.start(at);
        State y(own.begin(), own.end());
        y.resize(y.size() + 2);
        return y;
    }
    MotionStatus rates(double t, const State& y, State& rate) const override {
        const auto found = formulation_.rates(t, own(y));
        if (found.status != MotionStatus::finished) return found.status;
        write(found.state, rate);
        rate[rate.size() - 2] = found.power;
        rate[rate.size() - 1] = found.loss;
        return found.status;
    }
    MotionStatus project(State& y) const override {
        auto state = own(y);
        const auto status = formulation_.project(state);
        if (status == MotionStatus::finished) write(state, y);
        return status;
    }
    MotionEnergies energies(double t, const State& y) const override {
        const auto point = formulation_.point(t, own(y));
        return {point.kinetic, point.potential, point.drift, point.velocity_drift};
    }
    MotionPoint<typename F::Model> point(double t, const State& y) const { return formulation_.point(t, own(y)); }

private:
    using Own = FormulationState<F::n_states>;

    static Own own(const State& y) {
        if constexpr (F::n_states == states_at_run_time) {
            return Own(y.begin(), y.end() - 2);
        } else {
            Own state;
            std::copy_n(y.begin(), F::n_states, state.begin());
            return state;
        }
    }
    static void write(const Own& state, State& y) { std::copy(state.begin(), state.end(), y.begin()); }

    F formulation_;
};

}  // namespace detail

/// One motion, a step at a time. Between the ends of the last step it is known everywhere.
template <MotionFormulation F>
class MotionStepper {
public:
    using Model = typename F::Model;  ///< that is in motion

    /// Throws InvalidArgument where the start or an option is none.
    MotionStepper(const F& formulation, const MotionState<Model>& start, double start_time = 0,
                  const MotionOptions& options = {})
        : equations_(formulation), integration_(start_time, options) {
        integration_.begin(equations_, equations_.start(start));
    }

    /// The end of the last step.
    double time() const { return integration_.time(); }
    /// Why there is no further step; `finished` as long as there is one.
    MotionStatus status() const { return integration_.status(); }
    std::uint64_t steps() const { return integration_.steps(); }              ///< that were tried
    std::uint64_t evaluations() const { return integration_.evaluations(); }  ///< of the rates
    /// The largest |balance| at the ends of the steps, over the largest of the energies that it is made of.
    double largest_balance() const { return integration_.largest_balance(); }
    /// The constraints' largest errors at the ends of the steps, before they were put right.
    double largest_drift() const { return integration_.largest_drift(); }
    /// Of the constraints' derivative, likewise.
    double largest_velocity_drift() const { return integration_.largest_velocity_drift(); }

    /// One step of the size that the tolerances allow. False where there is none: `status` says why.
    bool step() { return integration_.step(equations_); }

    /// The motion at a time between the ends of the last step, with the constraints put right.
    MotionPoint<Model> at(double t) {
        const auto& y = integration_.at(equations_, t);
        auto point = equations_.point(t, y);
        point.work = integration_.work(y);
        point.dissipated = integration_.dissipated(y);
        point.balance = integration_.balance(point.kinetic, point.potential, y);
        return point;
    }

private:
    detail::FormulationEquations<F> equations_;
    detail::MotionIntegration integration_;
};

/// A motion at given times, with its evidence.
template <MotionModel M>
struct Motion {
    MotionStatus status = MotionStatus::finished;  ///< why it ended
    double time = 0;                               ///< how far it came
    std::vector<MotionPoint<M>> points;            ///< at the given times, as far as it came
    std::uint64_t steps = 0;                       ///< that were tried
    std::uint64_t evaluations = 0;                 ///< of the rates
    double largest_balance = 0;                    ///< see MotionStepper
    double largest_drift = 0;                      ///< see MotionStepper
    double largest_velocity_drift = 0;             ///< see MotionStepper
};

/// The motion from `start` at start_time, at `times`: none below start_time, none below the one before it. Throws
/// InvalidArgument where these, the start or an option are none; all else that may happen is a status. run: progress,
/// in points of all, and cancel.
template <MotionFormulation F>
Motion<typename F::Model> integrate_motion(const F& formulation, const MotionState<typename F::Model>& start,
                                           const std::vector<double>& times, const MotionOptions& options = {},
                                           double start_time = 0, const RunOptions& run = {}) {
    detail::require_rising_times(times, start_time);
    MotionStepper<F> stepper(formulation, start, start_time, options);
    Motion<typename F::Model> y;
    for (const double t : times) {
        while (stepper.time() < t && !run.cancelled() && stepper.step()) {
        }
        if (stepper.time() < t || stepper.status() != MotionStatus::finished) break;
        y.points.push_back(stepper.at(t));
        if (run.progress) run.progress(y.points.size(), times.size());
    }
    y.status = stepper.status();
    if (y.status == MotionStatus::finished && y.points.size() < times.size()) y.status = MotionStatus::cancelled;
    y.time = stepper.time();
    y.steps = stepper.steps();
    y.evaluations = stepper.evaluations();
    y.largest_balance = stepper.largest_balance();
    y.largest_drift = stepper.largest_drift();
    y.largest_velocity_drift = stepper.largest_velocity_drift();
    return y;
}

}  // namespace equilibria
