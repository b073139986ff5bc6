/// \file
/// Lagrange's equations of the second kind, in covariant or contravariant form. Source: Vesovic and
/// Radulovic, "Modelling and stability analysis of the nonlinear system", Theoretical and Applied Mechanics (2022),
/// section 1.5.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <utility>

#include <equilibria/dynamics/motion_formulation.hpp>

namespace equilibria {

/// How the equations are written; the motion is the same.
enum class LagrangeForm {
    covariant,      ///< M_kj a_j + Gamma_ij,k v_i v_j = Q_k, solved for a
    contravariant,  ///< a_k + Gamma^k_ij v_i v_j = Q^k, with the forces' indices raised
};

/// The motion of a model without constraints, in q and v. LagrangeSecondKind<RuntimeUnknowns> is that of a model whose
/// sizes are known at run time, by its functions.
template <MotionModel M>
class LagrangeSecondKind : public detail::ModelMotion<M> {
    using Base = detail::ModelMotion<M>;
    using typename Base::Vector;

public:
    using typename Base::State;
    static_assert(
        n_constraints<M> == 0,
        "equilibria: Lagrange's equations of the second kind are for models without constraints; those of the "
        "first kind, LagrangeFirstKind, take them");

    /// Throws InvalidArgument for a parameter that is not finite.
    explicit LagrangeSecondKind(const Parameters<M>& p, LagrangeForm form = LagrangeForm::covariant)
    requires DynamicModel<M>
        : Base(p), form_(form) {}
    /// Of a model at run time. Throws InvalidArgument for a parameter that is not finite, and where they are not as
    /// many as the model's.
    LagrangeSecondKind(std::shared_ptr<const KineticFunctions> functions, RuntimeArray<double> p,
                       LagrangeForm form = LagrangeForm::covariant)
    requires std::same_as<M, RuntimeUnknowns>
        : Base(std::move(functions), std::move(p)), form_(form) {}

    /// A function of a formulation, see MotionFormulation; the state is q, then v.
    /// \{
    State start(const MotionState<M>& at) const {
        this->validate(at);
        return Base::joined(at.q, at.velocity);
    }

    MotionRates<Base::n_states> rates(double t, const State& y) const {
        const auto q = this->first_half(y), v = this->second_half(y);
        const auto forces = this->forces(t, q, v);
        const auto a = acceleration(q, detail::vector_of<M>(v), forces.total);
        if (!a) return {MotionStatus::singular_mass_matrix};
        return {MotionStatus::finished, Base::joined(v, detail::unknowns_of<M>(*a)), forces.power, forces.loss};
    }

    MotionPoint<M> point(double t, const State& y) const {
        return this->point_at(t, this->first_half(y), this->second_half(y));
    }
    MotionStatus project(State&) const { return MotionStatus::finished; }
    /// \}

private:
    std::optional<Vector> acceleration(const UnknownArray<M, double>& q, const Vector& v, const Vector& force) const {
        const auto mass = this->mass(q);
        if (!mass.positive()) return {};
        if (form_ == LagrangeForm::contravariant) return mass.solve(force) - this->raised_convective_forces(q, v, mass);
        return mass.solve(Vector(force - this->convective_forces(q, v)));
    }

    LagrangeForm form_;
};

}  // namespace equilibria
