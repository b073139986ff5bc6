/// \file
/// See dynamics/motion_formulation.hpp: what is asked of a model's functions at run time.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <equilibria/core/compiled.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE ModelMotion<RuntimeUnknowns>::ModelMotion(std::shared_ptr<const KineticFunctions> functions,
                                                            Numbers p)
    : functions_(std::move(functions)), p_(std::move(p)) {
    require(p_.size() == functions_->parameters(), "p", p_.size(),
            "must be as many as the model's parameters: " + std::to_string(functions_->parameters()));
    require_finite(p_, "p");
}

EQUILIBRIA_INLINE void ModelMotion<RuntimeUnknowns>::validate(const MotionState<RuntimeUnknowns>& start) const {
    const std::string one_each = "must be one for each unknown: " + std::to_string(functions_->unknowns());
    require(start.q.size() == functions_->unknowns(), "number of entries of start.q", start.q.size(), one_each);
    require(start.velocity.size() == functions_->unknowns(), "number of entries of start.velocity",
            start.velocity.size(), one_each);
    require_finite(start.q, "start.q");
    require_finite(start.velocity, "start.velocity");
    Numbers v(functions_->unknowns());
    for (int i = 0; i < v.size(); ++i) v[i] = 0.25 + 1.0 / (3 + i);
    const Vector u = vector_of<RuntimeUnknowns>(v);
    require_equal_form(functions_->kinetic_energy(start.q, v, p_),
                       0.5 * u.dot(functions_->mass_matrix(start.q, p_) * u));
}

EQUILIBRIA_INLINE MotionPoint<RuntimeUnknowns> ModelMotion<RuntimeUnknowns>::point_at(double t, const Numbers& q,
                                                                                      const Numbers& v) const {
    MotionPoint<RuntimeUnknowns> y;
    y.time = t;
    y.q = q;
    y.velocity = v;
    y.momentum = momenta_of(q, v);
    y.kinetic = functions_->kinetic_energy(q, v, p_);
    y.potential = functions_->potential(q, p_);
    return y;
}

EQUILIBRIA_INLINE AppliedForces<RuntimeUnknowns> ModelMotion<RuntimeUnknowns>::forces(double t, const Numbers& q,
                                                                                      const Numbers& v) const {
    const Vector velocity = vector_of<RuntimeUnknowns>(v), other = functions_->generalised_forces(t, q, v, p_),
                 damping = functions_->dissipation_gradient(q, v, p_);
    return {other - damping - functions_->gradient(q, p_), other.dot(velocity), damping.dot(velocity)};
}

}  // namespace equilibria::detail
