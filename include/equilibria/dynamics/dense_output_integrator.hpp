/// \file
/// Integrates y' = f(t, y), of as many numbers as are known at run time, by the embedded Runge-Kutta pair of Dormand
/// and Prince, 5(4), with step control and dense output (Boost.Odeint): a step at a time, and the solution anywhere
/// between its ends.
///
/// Why that pair: its last evaluation is the next step's first one, and its dense output of order 4 takes none of its
/// own. Where it fails: on stiff equations, whose step is bounded by the fastest decay. At tolerances near rounding
/// AdaptiveIntegrator takes fewer steps. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I,
/// sections II.4 to II.6.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/dynamics/motion_options.hpp>

namespace equilibria {

/// One solution, from where it was last told to begin. The rates are handed to each step, so that copies share nothing.
class DenseOutputIntegrator {
public:
    using State = std::vector<double>;  ///< as many numbers as the start has
    /// f: the rates of a state at a time, written to its second argument, which has the state's size.
    using Rates = std::function<void(const State& y, State& rate, double t)>;

    /// Throws InvalidArgument where an option is none. How many steps there are is the caller's to count.
    explicit DenseOutputIntegrator(const MotionOptions& options);
    /// Copied or moved with its state.
    /// \{
    DenseOutputIntegrator(const DenseOutputIntegrator&);
    DenseOutputIntegrator(DenseOutputIntegrator&&) noexcept;
    DenseOutputIntegrator& operator=(const DenseOutputIntegrator&);
    DenseOutputIntegrator& operator=(DenseOutputIntegrator&&) noexcept;
    /// \}
    ~DenseOutputIntegrator();

    /// From y at the time t, the first step being tried with `step`, in units of time. All states that follow must have
    /// the size of the first.
    void initialize(const State& y, double t, double step);

    /// One step, of the size that the tolerances allow. False where none is small enough: the solution stays where it
    /// was. A state that is not finite may end a step.
    bool step(const Rates& rates);

    /// The end of the last step.
    double time() const;
    const State& state() const;  ///< at the end of the last step
    double time_step() const;    ///< the step to be tried next

    /// Writes the state at a time between the ends of the last step to y, which has its size.
    void interpolate(double t, State& y) const;

private:
    struct Pair;  ///< Boost.Odeint's, with its step control

    std::unique_ptr<Pair> pair_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/dynamics/detail/dense_output_integrator_definitions.hpp>
#endif
