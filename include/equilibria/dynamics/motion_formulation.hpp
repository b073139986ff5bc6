/// \file
/// What a formulation of a model's motion is: a system of first order in a state of its own, from which the motion can
/// be read. `MotionStepper` integrates any of them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/cholesky.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/christoffel.hpp>
#include <equilibria/dynamics/motion_point.hpp>
#include <equilibria/dynamics/motion_status.hpp>
#include <equilibria/model/kinetic_functions.hpp>

namespace equilibria {

/// The number of a formulation's states where that is known at run time alone.
inline constexpr std::size_t states_at_run_time = std::dynamic_extent;

/// A formulation's state: N numbers, or a vector of them.
template <std::size_t N>
using FormulationState = std::conditional_t<N == states_at_run_time, std::vector<double>, std::array<double, N>>;

/// How fast a formulation's state changes, and what goes in and out of the energy meanwhile.
template <std::size_t N>
struct MotionRates {
    MotionStatus status = MotionStatus::finished;  ///< anything else: no rates
    FormulationState<N> state{};                   ///< of each number of the state
    double power = 0;                              ///< of the generalised forces
    double loss = 0;                               ///< to damping
};

/// A formulation F of the motion of F::Model in F::n_states numbers, a state being a FormulationState of them:
/// - `start(MotionState)`: the state that belongs to it; throws InvalidArgument where that is no start of a motion;
/// - `rates(t, state)`: MotionRates;
/// - `point(t, state)`: a MotionPoint, but for work, dissipated and balance;
/// - `project(state)`: MotionStatus; puts right what the integration made drift, where there is such a thing.
template <class F>
concept MotionFormulation =
    requires(const F& f, double t, FormulationState<F::n_states>& y, const MotionState<typename F::Model>& start) {
        { f.start(start) } -> std::same_as<FormulationState<F::n_states>>;
        { f.rates(t, y) } -> std::same_as<MotionRates<F::n_states>>;
        { f.point(t, y) } -> std::same_as<MotionPoint<typename F::Model>>;
        { f.project(y) } -> std::same_as<MotionStatus>;
    };

namespace detail {

/// What the formulations of a model's own equations share: a state of two halves, the first of them q; and what the
/// model's functions say, so that the same equations are those of sizes at run time.
template <MotionModel M>
class ModelMotion {
public:
    using Model = M;
    static constexpr std::size_t n_states = 2 * n_unknowns<M>;
    using State = std::array<double, n_states>;

    const Parameters<M>& parameters() const { return p_; }

protected:
    using Vector = UnknownVector<M>;
    using Mass = Cholesky<n_unknowns<M>>;
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

    Mass mass(const Unknowns<M>& q) const { return Mass(mass_matrix<M>(q, p_)); }
    Unknowns<M> momenta_of(const Unknowns<M>& q, const Unknowns<M>& v) const { return momenta<M>(q, v, p_); }
    AppliedForces<M> forces(double t, const Unknowns<M>& q, const Unknowns<M>& v) const {
        return applied_forces<M>(t, q, v, p_);
    }
    /// Gamma_ij,k v_i v_j, and the same with the index raised, by the factor of M.
    Vector convective_forces(const Unknowns<M>& q, const Vector& v) const {
        return contracted<M>(christoffel_first_kind<M>(q, p_), v);
    }
    Vector raised_convective_forces(const Unknowns<M>& q, const Vector& v, const Mass&) const {
        return contracted<M>(christoffel_second_kind<M>(q, p_), v);
    }
    /// dT/dq at constant v.
    Vector kinetic_gradient(const Unknowns<M>& q, const Vector& v) const {
        const auto derivatives = mass_matrix_derivatives<M>(q, p_);
        Vector y;
        for (int k = 0; k < n; ++k) y[k] = 0.5 * v.dot(derivatives[k] * v);
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

/// The same of a model whose sizes are known at run time, by its functions.
template <>
class ModelMotion<RuntimeUnknowns> {
public:
    using Model = RuntimeUnknowns;
    static constexpr std::size_t n_states = states_at_run_time;
    using State = std::vector<double>;
    using Numbers = RuntimeArray<double>;

    const Numbers& parameters() const { return p_; }

protected:
    using Vector = Eigen::VectorXd;
    using Mass = Cholesky<Eigen::Dynamic>;

    ModelMotion(std::shared_ptr<const KineticFunctions> functions, Numbers p);

    void validate(const MotionState<RuntimeUnknowns>& start) const;
    Numbers first_half(const State& y) const { return half(y, 0); }
    Numbers second_half(const State& y) const { return half(y, functions_->unknowns()); }
    static State joined(const Numbers& a, const Numbers& b) {
        State y(a.begin(), a.end());
        y.insert(y.end(), b.begin(), b.end());
        return y;
    }
    MotionPoint<RuntimeUnknowns> point_at(double t, const Numbers& q, const Numbers& v) const;

    Mass mass(const Numbers& q) const { return Mass(functions_->mass_matrix(q, p_)); }
    Numbers momenta_of(const Numbers& q, const Numbers& v) const {
        return unknowns_of<RuntimeUnknowns>(functions_->momenta(q, v, p_));
    }
    AppliedForces<RuntimeUnknowns> forces(double t, const Numbers& q, const Numbers& v) const;
    Vector convective_forces(const Numbers& q, const Vector& v) const {
        return functions_->convective_forces(q, unknowns_of<RuntimeUnknowns>(v), p_);
    }
    Vector raised_convective_forces(const Numbers& q, const Vector& v, const Mass& mass) const {
        return mass.solve(convective_forces(q, v));
    }
    Vector kinetic_gradient(const Numbers& q, const Vector& v) const {
        return functions_->kinetic_gradient(q, unknowns_of<RuntimeUnknowns>(v), p_);
    }

    std::shared_ptr<const KineticFunctions> functions_;
    Numbers p_;

private:
    Numbers half(const State& y, int from) const {
        Numbers a(functions_->unknowns());
        for (int i = 0; i < a.size(); ++i) a[i] = y[static_cast<std::size_t>(from + i)];
        return a;
    }
};

}  // namespace detail

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/dynamics/detail/motion_formulation_definitions.hpp>
#endif
