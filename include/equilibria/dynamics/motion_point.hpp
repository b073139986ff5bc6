/// \file
/// A place in a motion, and the forces and energies there.
#pragma once

#include <Eigen/Core>

#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/kinetics.hpp>

namespace equilibria {

/// A model in motion at one time. For linearised motion the energies are those of the quadratic forms.
template <MotionModel M>
struct MotionPoint {
    double time = 0;                   ///< in the model's unit
    UnknownArray<M, double> q;         ///< angles in radians, then coordinates
    UnknownArray<M, double> velocity;  ///< their rates
    UnknownArray<M, double> momentum;  ///< dT/dv
    double kinetic = 0;                ///< kinetic energy
    double potential = 0;              ///< potential energy
    double work = 0;                   ///< of the generalised forces since the start
    double dissipated = 0;             ///< lost by damping since the start
    /// kinetic + potential + dissipated - work, less its value at the start: 0 but for the integration's errors.
    double balance = 0;
    ConstraintValues<M> multipliers;            ///< Lagrange's, where there are constraints
    UnknownArray<M, double> constraint_forces;  ///< J^T multipliers: what the constraints exert on each unknown
    double drift = 0;                           ///< the largest |f_i(q)| of the constraints
    double velocity_drift = 0;                  ///< the largest |(J v)_i|
};

namespace detail {

/// Of a size at run time where the model's is one.
template <class M>
using UnknownVector = Eigen::Vector<double, Sizes<M>::extent>;
static_assert(at_run_time == Eigen::Dynamic);

template <class M>
UnknownVector<M> vector_of(const UnknownArray<M, double>& values) {
    return Eigen::Map<const UnknownVector<M>>(values.begin(), values.size());
}
template <class M>
UnknownArray<M, double> unknowns_of(const UnknownVector<M>& values) {
    UnknownArray<M, double> y;
    if constexpr (Sizes<M>::extent == at_run_time) y.resize(static_cast<int>(values.size()));
    for (int i = 0; i < y.size(); ++i) y[i] = values[i];
    return y;
}

/// Forces on the unknowns, and what those that are not the potential's do a unit of time.
template <class M>
struct AppliedForces {
    UnknownVector<M> total;      ///< -dV/dq - dPhi/dv + Q
    double power = 0, loss = 0;  ///< Q v and (dPhi/dv) v
};

template <class M>
AppliedForces<M> applied_forces(double t, const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    const UnknownVector<M> velocity = vector_of<M>(v), other = vector_of<M>(generalised_forces<M>(t, q, v, p)),
                           damping = vector_of<M>(dissipation_gradient<M>(q, v, p));
    return {other - damping - vector_of<M>(equations<M>(q, p)), other.dot(velocity), damping.dot(velocity)};
}

}  // namespace detail

}  // namespace equilibria
