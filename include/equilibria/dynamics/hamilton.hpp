/// \file
/// Hamilton's equations. Source: Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system",
/// Theoretical and Applied Mechanics (2022), section 1.6, with p = dL/dv.
#pragma once

#include <equilibria/core/cholesky.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>

namespace equilibria {

/// The motion of a model without constraints, in q and the momenta p = M v: q' = dH/dp and p' = -dH/dq - dPhi/dv + Q
/// with H = 1/2 p^T M^-1 p + V.
template <DynamicModel M>
class HamiltonEquations : public detail::ModelMotion<M> {
    using Base = detail::ModelMotion<M>;
    using typename Base::Vector;

public:
    using typename Base::State;
    static_assert(n_constraints<M> == 0,
                  "equilibria: Hamilton's equations are for models without constraints; LagrangeFirstKind takes them");

    /// Throws InvalidArgument for a parameter that is not finite.
    explicit HamiltonEquations(const Parameters<M>& p) : Base(p) {}

    /// A function of a formulation, see MotionFormulation; the state is q, then p.
    /// \{
    State start(const MotionState<M>& at) const {
        this->validate(at);
        return Base::joined(at.q, momenta<M>(at.q, at.velocity, this->p_));
    }

    MotionRates<Base::n_states> rates(double t, const State& y) const {
        const auto q = Base::first_half(y);
        const detail::Cholesky<Base::n> mass(mass_matrix<M>(q, this->p_));
        if (!mass.positive()) return {MotionStatus::singular_mass_matrix};
        const Vector v = mass.solve(detail::vector_of<M>(Base::second_half(y)));
        const auto velocity = detail::unknowns_of<M>(v);
        const auto forces = detail::applied_forces<M>(t, q, velocity, this->p_);
        const auto derivatives = mass_matrix_derivatives<M>(q, this->p_);
        Vector rate = forces.total;
        for (int k = 0; k < Base::n; ++k) rate[k] += 0.5 * v.dot(derivatives[k] * v);
        return {MotionStatus::finished, Base::joined(velocity, detail::unknowns_of<M>(rate)), forces.power,
                forces.loss};
    }

    MotionPoint<M> point(double t, const State& y) const {
        const auto q = Base::first_half(y);
        const detail::Cholesky<Base::n> mass(mass_matrix<M>(q, this->p_));
        const Vector v = mass.solve(detail::vector_of<M>(Base::second_half(y)));
        auto point = this->point_at(t, q, detail::unknowns_of<M>(v));
        point.momentum = Base::second_half(y);
        return point;
    }
    MotionStatus project(State&) const { return MotionStatus::finished; }
    /// \}
};

}  // namespace equilibria
