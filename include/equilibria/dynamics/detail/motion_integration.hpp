/// \file
/// What MotionStepper does whatever the model and its formulation: steps, projection onto the constraints, and the
/// evidence of both. Compiled once.
#pragma once

#include <cstdint>

#include <equilibria/core/compiled.hpp>
#include <equilibria/dynamics/dense_output_integrator.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria::detail {

/// Of a place in a motion, as in MotionPoint.
struct MotionEnergies {
    double kinetic, potential, drift, velocity_drift;
};

/// A formulation of a motion. A state is the formulation's own, then the work of the generalised forces, then what
/// damping has taken.
class MotionEquations {
public:
    using State = DenseOutputIntegrator::State;

    /// Leaves `rate` alone where the status is another one than finished.
    virtual MotionStatus rates(double t, const State& y, State& rate) const = 0;
    /// Leaves y alone where the status is another one than finished.
    virtual MotionStatus project(State& y) const = 0;
    virtual MotionEnergies energies(double t, const State& y) const = 0;

protected:
    MotionEquations() = default;
    MotionEquations(const MotionEquations&) = default;
    MotionEquations& operator=(const MotionEquations&) = default;
    ~MotionEquations() = default;
};

/// One motion. The equations are handed to each call, and must be the same in all.
class MotionIntegration {
public:
    using State = MotionEquations::State;

    /// Throws InvalidArgument where one of them is none.
    MotionIntegration(double start_time, const MotionOptions& options);
    void begin(const MotionEquations& equations, const State& start);

    // see MotionStepper
    double time() const { return integrator_.time(); }
    MotionStatus status() const { return status_; }
    std::uint64_t steps() const { return steps_; }
    std::uint64_t evaluations() const { return evaluations_; }
    double largest_balance() const { return largest_energy_ > 0 ? largest_balance_ / largest_energy_ : 0; }
    double largest_drift() const { return largest_drift_; }
    double largest_velocity_drift() const { return largest_velocity_drift_; }

    bool step(const MotionEquations& equations);
    /// The state at a time between the ends of the last step, with the constraints put right; valid until the next
    /// call.
    const State& at(const MotionEquations& equations, double t);

    static double work(const State& y) { return y[y.size() - 2]; }
    static double dissipated(const State& y) { return y[y.size() - 1]; }
    double balance(double kinetic, double potential, const State& y) const {
        return kinetic + potential + dissipated(y) - work(y) - start_energy_;
    }

private:
    void rates(const MotionEquations& equations, double t, const State& y, State& rate);
    double first_step(const MotionEquations& equations, const State& y);
    void note(const MotionEnergies& at, const State& y);
    bool end(MotionStatus status) {
        status_ = status;
        return false;
    }

    MotionOptions options_;
    DenseOutputIntegrator integrator_;
    State projected_, between_;
    double start_time_;
    bool corrected_ = false;
    MotionStatus status_ = MotionStatus::finished, trouble_ = MotionStatus::finished;
    std::uint64_t steps_ = 0, evaluations_ = 0;
    double start_energy_ = 0, start_potential_ = 0;
    double largest_balance_ = 0, largest_energy_ = 0, largest_drift_ = 0, largest_velocity_drift_ = 0;
};

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/dynamics/detail/motion_integration_definitions.hpp>
#endif
