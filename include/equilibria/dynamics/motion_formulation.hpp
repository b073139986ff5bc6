/// \file
/// What a formulation of a model's motion is: a system of first order in a state of its own, from which the motion can
/// be read. `MotionStepper` integrates any of them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/motion_point.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria {

/// How fast a formulation's state changes, and what goes in and out of the energy meanwhile.
template <std::size_t N>
struct MotionRates {
    MotionStatus status = MotionStatus::finished;  ///< anything else: no rates
    std::array<double, N> state{};                 ///< of each number of the state
    double power = 0;                              ///< of the generalised forces
    double loss = 0;                               ///< to damping
};

/// A formulation F of the motion of F::Model in F::n_states numbers:
/// - `start(MotionState)`: the state that belongs to it; throws InvalidArgument where that is no start of a motion;
/// - `rates(t, state)`: MotionRates;
/// - `point(t, state)`: a MotionPoint, but for work, dissipated and balance;
/// - `project(state)`: MotionStatus; puts right what the integration made drift, where there is such a thing.
template <class F>
concept MotionFormulation =
    requires(const F& f, double t, std::array<double, F::n_states>& y, const MotionState<typename F::Model>& start) {
        { f.start(start) } -> std::same_as<std::array<double, F::n_states>>;
        { f.rates(t, y) } -> std::same_as<MotionRates<F::n_states>>;
        { f.point(t, y) } -> std::same_as<MotionPoint<typename F::Model>>;
        { f.project(y) } -> std::same_as<MotionStatus>;
    };

namespace detail {

/// What the formulations of a model's own equations share: a state of two halves, the first of them q.
template <DynamicModel M>
class ModelMotion {
public:
    using Model = M;
    static constexpr std::size_t n_states = 2 * n_unknowns<M>;
    using State = std::array<double, n_states>;

    const Parameters<M>& parameters() const { return p_; }

protected:
    using Vector = UnknownVector<M>;
    static constexpr int n = n_unknowns<M>;

    explicit ModelMotion(const Parameters<M>& p) : p_(p) { require_finite(p, "p"); }

    void validate(const MotionState<M>& start) const {
        require_finite(start.q, "start.q");
        require_finite(start.velocity, "start.velocity");
        require_quadratic_kinetic_energy<M>(start.q, p_);
    }

    static Unknowns<M> first_half(const State& y) { return half(y, 0); }
    static Unknowns<M> second_half(const State& y) { return half(y, n); }
    static State joined(const Unknowns<M>& a, const Unknowns<M>& b) {
        State y;
        for (int i = 0; i < n; ++i) y[static_cast<std::size_t>(i)] = a[i], y[static_cast<std::size_t>(n + i)] = b[i];
        return y;
    }
    MotionPoint<M> point_at(double t, const Unknowns<M>& q, const Unknowns<M>& v) const {
        MotionPoint<M> y;
        y.time = t;
        y.q = q;
        y.velocity = v;
        y.momentum = momenta<M>(q, v, p_);
        y.kinetic = kinetic_energy<M>(q, v, p_);
        y.potential = potential<M>(q, p_);
        return y;
    }

    Parameters<M> p_;

private:
    static Unknowns<M> half(const State& y, int from) {
        Unknowns<M> a;
        for (int i = 0; i < n; ++i) a[i] = y[static_cast<std::size_t>(from + i)];
        return a;
    }
};

}  // namespace detail

}  // namespace equilibria
