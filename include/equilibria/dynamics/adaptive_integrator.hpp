/// \file
/// Integrates y' = f(t, y), of as many numbers as are known at run time, by the embedded Runge-Kutta pair of Fehlberg,
/// 7(8), with step control (Boost.Odeint): for motions with unknowns of their own, which are no MotionFormulation.
///
/// Why that pair: at tolerances near rounding it takes the fewest steps of the explicit ones. Steps end at the times
/// that are asked for: there is no dense output of this order (for that, and for projection onto constraints, see
/// MotionStepper in motion.hpp). Where it fails: on stiff equations, whose step is bounded by the fastest decay.
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, sections II.4 and II.5.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria {

/// One solution from time 0, a step at a time. It can be moved and not copied.
class AdaptiveIntegrator {
public:
    using State = std::vector<double>;  ///< as many numbers as the start has
    /// f: the rates of a state at a time, written to its second argument, which has the state's size.
    using Rates = std::function<void(const State& y, State& rate, double t)>;

    /// first_step: a guess, in units of time. Throws InvalidArgument where an option is none. Of a start whose numbers
    /// are not finite the first step says so.
    AdaptiveIntegrator(Rates rates, State start, double first_step, const MotionOptions& options);
    /// Moved with its state.
    /// \{
    AdaptiveIntegrator(AdaptiveIntegrator&&) noexcept;
    AdaptiveIntegrator& operator=(AdaptiveIntegrator&&) noexcept;
    /// \}
    ~AdaptiveIntegrator();

    /// The end of the last step.
    double time() const { return time_; }
    const State& state() const { return y_; }  ///< at the end of the last step
    /// Why there is no further step; `finished` as long as there is one.
    MotionStatus status() const { return status_; }
    std::uint64_t steps() const { return steps_; }              ///< that were tried
    std::uint64_t evaluations() const { return evaluations_; }  ///< of the rates

    /// One step, of the size that the tolerances allow, that ends at `until` or before. False where there is none:
    /// `status` says why. At most most_steps of the options are tried in all.
    bool step(double until);

private:
    struct Pair;  ///< Boost.Odeint's, with its step control

    bool end(MotionStatus status) {
        status_ = status;
        return false;
    }

    Rates rates_;
    MotionOptions options_;
    std::unique_ptr<Pair> pair_;
    State y_;
    double time_ = 0, step_;
    MotionStatus status_ = MotionStatus::finished;
    std::uint64_t steps_ = 0, evaluations_ = 0;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/dynamics/detail/adaptive_integrator_definitions.hpp>
#endif
