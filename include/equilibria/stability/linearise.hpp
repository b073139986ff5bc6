/// \file
/// The linearised motion of a model about an equilibrium.
#pragma once

#include <string>

#include <Eigen/Core>

#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/kinetic_functions.hpp>
#include <equilibria/model/kinetics.hpp>
#include <equilibria/stability/second_order_system.hpp>

namespace equilibria {

/// M(q), D = d^2 Phi / dv^2 - dQ/dv and C = d^2 V / dq^2 - dQ/dq at rest in q, Q being the generalised forces at time
/// t. q must be an equilibrium: otherwise the equations of motion have a constant term that this leaves out. Exact
/// derivatives. The model must be free of constraints.
template <DynamicModel M>
SecondOrderSystem<UnknownMatrix<M>> linearise(const Unknowns<M>& q, const Parameters<M>& p, double t = 0) {
    static_assert(n_constraints<M> == 0, "equilibria: linearise needs a model without constraints");
    constexpr int n = n_unknowns<M>;
    using D = Dual<double, n>;
    require_finite(q, "q");
    require_finite(p, "p");
    const Unknowns<M> rest;
    const auto at = detail::variables<M, double>(q), moving = detail::variables<M, double>(rest);
    const auto fixed = detail::constants<M, double, n>(q), still = detail::constants<M, double, n>(rest);
    const auto lifted = detail::lifted<M, double, n>(p);
    const auto by_velocity = generalised_forces<M, D>(t, fixed, moving, lifted);
    const auto by_place = generalised_forces<M, D>(t, at, still, lifted);
    const auto damping = dissipation_gradient<M, D>(fixed, moving, lifted);
    SecondOrderSystem<UnknownMatrix<M>> y{mass_matrix<M>(q, p), {}, jacobian<M>(q, p)};
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            y.damping(i, k) = damping[i].derivative[k] - by_velocity[i].derivative[k];
            y.stiffness(i, k) -= by_place[i].derivative[k];
        }
    return y;
}

/// The same of a model whose sizes are known at run time, by its functions. Throws InvalidArgument where q or p has not
/// as many entries as the model, or one that is not finite.
inline SecondOrderSystem<Eigen::MatrixXd> linearise(const KineticFunctions& functions, const RuntimeArray<double>& q,
                                                    const RuntimeArray<double>& p, double t = 0) {
    require(q.size() == functions.unknowns(), "number of entries of q", q.size(),
            "must be one for each unknown: " + std::to_string(functions.unknowns()));
    require(p.size() == functions.parameters(), "number of entries of p", p.size(),
            "must be one for each parameter: " + std::to_string(functions.parameters()));
    require_finite(q, "q");
    require_finite(p, "p");
    SecondOrderSystem<Eigen::MatrixXd> y{functions.mass_matrix(q, p), {}, functions.hessian(q, p)};
    Eigen::MatrixXd slope;
    functions.linearize_forces(t, q, p, y.damping, slope);
    y.stiffness -= slope;
    return y;
}

}  // namespace equilibria
