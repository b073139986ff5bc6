/// \file
/// The linearised motion about an equilibrium, to be seen beside the true one.
#pragma once

#include <equilibria/core/cholesky.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>
#include <equilibria/stability/linearise.hpp>

namespace equilibria {

/// M x'' + D x' + C x = 0 for the deviation x from an equilibrium, linearised at time t = 0. Starts and points hold q,
/// not the deviation.
template <DynamicModel M>
class LinearMotion : public detail::ModelMotion<M> {
    using Base = detail::ModelMotion<M>;
    using typename Base::Vector;

public:
    using typename Base::State;

    /// Throws InvalidArgument where the mass matrix is not positive definite there.
    LinearMotion(const Parameters<M>& p, const Unknowns<M>& equilibrium)
        : Base(p), equilibrium_(equilibrium), system_(linearise<M>(equilibrium, p)), mass_(system_.mass) {
        system_.validate();
    }
    const SecondOrderSystem<UnknownMatrix<M>>& system() const { return system_; }  ///< M, D and C at the equilibrium

    /// A function of a formulation, see MotionFormulation; the state is q, then v.
    /// \{
    State start(const MotionState<M>& at) const {
        this->validate(at);
        return Base::joined(at.q, at.velocity);
    }
    MotionRates<Base::n_states> rates(double, const State& y) const {
        const auto v = Base::second_half(y);
        const Vector velocity = detail::vector_of<M>(v), damping = system_.damping * velocity;
        const Vector a = mass_.solve(Vector(-damping - system_.stiffness * deviation(y)));
        return {MotionStatus::finished, Base::joined(v, detail::unknowns_of<M>(a)), 0, damping.dot(velocity)};
    }
    MotionPoint<M> point(double t, const State& y) const {
        MotionPoint<M> point;
        const Vector x = deviation(y), v = detail::vector_of<M>(Base::second_half(y)), momentum = system_.mass * v;
        point.time = t;
        point.q = Base::first_half(y);
        point.velocity = Base::second_half(y);
        point.momentum = detail::unknowns_of<M>(momentum);
        point.kinetic = 0.5 * v.dot(momentum);
        point.potential = 0.5 * x.dot(system_.stiffness * x);
        return point;
    }
    MotionStatus project(State&) const { return MotionStatus::finished; }
    /// \}

private:
    Vector deviation(const State& y) const {
        return detail::vector_of<M>(Base::first_half(y)) - detail::vector_of<M>(equilibrium_);
    }

    Unknowns<M> equilibrium_;
    SecondOrderSystem<UnknownMatrix<M>> system_;
    detail::Cholesky<Base::n> mass_;
};

}  // namespace equilibria
