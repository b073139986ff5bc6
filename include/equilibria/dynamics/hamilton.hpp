/// \file
/// Hamilton's equations. Source: Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system",
/// Theoretical and Applied Mechanics (2022), section 1.6, with p = dL/dv.
#pragma once

#include <concepts>
#include <memory>
#include <utility>

#include <equilibria/dynamics/motion_formulation.hpp>

namespace equilibria {

/// The motion of a model without constraints, in q and the momenta p = M v: q' = dH/dp and p' = -dH/dq - dPhi/dv + Q
/// with H = 1/2 p^T M^-1 p + V. HamiltonEquations<RuntimeUnknowns> is that of a model whose sizes are known at run
/// time, by its functions.
template <MotionModel M>
class HamiltonEquations : public detail::ModelMotion<M> {
    using Base = detail::ModelMotion<M>;
    using typename Base::Vector;

public:
    using typename Base::State;
    static_assert(n_constraints<M> == 0,
                  "equilibria: Hamilton's equations are for models without constraints; LagrangeFirstKind takes them");

    /// Throws InvalidArgument for a parameter that is not finite.
    explicit HamiltonEquations(const Parameters<M>& p)
    requires DynamicModel<M>
        : Base(p) {}
    /// Of a model at run time. Throws InvalidArgument for a parameter that is not finite, and where they are not as
    /// many as the model's.
    HamiltonEquations(std::shared_ptr<const KineticFunctions> functions, RuntimeArray<double> p)
    requires std::same_as<M, RuntimeUnknowns>
        : Base(std::move(functions), std::move(p)) {}

    /// A function of a formulation, see MotionFormulation; the state is q, then p.
    /// \{
    State start(const MotionState<M>& at) const {
        this->validate(at);
        return Base::joined(at.q, this->momenta_of(at.q, at.velocity));
    }

    MotionRates<Base::n_states> rates(double t, const State& y) const {
        const auto q = this->first_half(y);
        const auto mass = this->mass(q);
        if (!mass.positive()) return {MotionStatus::singular_mass_matrix};
        const Vector v = mass.solve(detail::vector_of<M>(this->second_half(y)));
        const auto velocity = detail::unknowns_of<M>(v);
        const auto forces = this->forces(t, q, velocity);
        const Vector rate = forces.total + this->kinetic_gradient(q, v);
        return {MotionStatus::finished, Base::joined(velocity, detail::unknowns_of<M>(rate)), forces.power,
                forces.loss};
    }

    MotionPoint<M> point(double t, const State& y) const {
        const auto q = this->first_half(y);
        const Vector v = this->mass(q).solve(detail::vector_of<M>(this->second_half(y)));
        auto point = this->point_at(t, q, detail::unknowns_of<M>(v));
        point.momentum = this->second_half(y);
        return point;
    }
    MotionStatus project(State&) const { return MotionStatus::finished; }
    /// \}
};

}  // namespace equilibria
