/// \file
/// Models that move. Beside its potential (model.hpp) such a model has a kinetic energy, and may have damping, other
/// forces and holonomic constraints. Each is one generic member function, called with the model's angles and
/// coordinates as `potential` is; v holds the velocities of the unknowns in their order, in radians or units of length
/// a unit of time.
///
/// \code
/// struct Pendulum {
///     static constexpr int n_angles = 1;
///     enum Parameter { mass, gravity, friction, n_parameters };  // the length is 1
///     constexpr auto potential(const auto& q, const auto& p) const {
///         return -p[mass] * p[gravity] * cos(q[0]);
///     }
///     constexpr auto kinetic_energy(const auto& q, const auto& v, const auto& p) const {
///         return 0.5 * p[mass] * v[0] * v[0];
///     }
///     constexpr auto dissipation(const auto& q, const auto& v, const auto& p) const {
///         return 0.5 * p[friction] * v[0] * v[0];
///     }
/// };
/// \endcode
///
/// - `kinetic_energy(theta, v, p)`: a quadratic form in v, 1/2 v^T M(q) v.
/// - `dissipation(theta, v, p)` (optional): Rayleigh's function Phi; the damping forces are -dPhi/dv.
/// - `generalised_forces(t, theta, v, p)` (optional): all other forces, one an unknown (a std::array or an Array); t is
///   the time. What they do is work, what the potential's forces do is not.
/// - `n_constraints` and `constraints(theta, p)` (optional): a std::array or an Array that vanishes as long as the
///   unknowns obey the constraints. Equilibria under constraints are not enumerated.
///
/// With n_coordinates > 0 an argument x follows theta in each.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

namespace detail {

/// Whether M has a member of that name, whatever its arguments. A misspelt argument list must not leave out a force in
/// silence.
#define EQUILIBRIA_MEMBER(name)            \
    template <class M>                     \
    constexpr bool has_##name() {          \
        struct Name {                      \
            int name;                      \
        };                                 \
        struct Both : M, Name {};          \
        return !requires { &Both::name; }; \
    }
EQUILIBRIA_MEMBER(kinetic_energy)
EQUILIBRIA_MEMBER(dissipation)
EQUILIBRIA_MEMBER(generalised_forces)
EQUILIBRIA_MEMBER(constraints)
#undef EQUILIBRIA_MEMBER

/// f(theta, ...), or f(theta, x, ...) for models with coordinates, at the unknowns q.
template <class M, class S>
constexpr auto at_unknowns(const Unknowns<M, S>& q, const auto& f) {
    AnglesOf<M, S> theta;
    CoordinatesOf<M, S> x;
    split<M, S>(q, theta, x);
    if constexpr (n_coordinates<M> == 0)
        return f(theta);
    else
        return f(theta, x);
}

template <class M>
constexpr int constraints_of() {
    if constexpr (requires { M::n_constraints; }) return static_cast<int>(M::n_constraints);
    return 0;
}

}  // namespace detail

/// The number of holonomic constraints.
template <class M>
inline constexpr int n_constraints = detail::constraints_of<M>();

/// A model with a potential and a kinetic energy.
template <class M>
concept DynamicModel = PotentialModel<M> && detail::has_kinetic_energy<M>();

/// What a motion is of: a model that is a type, or one whose sizes are known at run time (KineticFunctions).
template <class M>
concept MotionModel = DynamicModel<M> || std::same_as<M, RuntimeUnknowns>;

/// Where a model is and how fast: unknowns in their order, angles in radians, and their rates.
template <MotionModel M>
struct MotionState {
    UnknownArray<M, double> q;         ///< unknowns
    UnknownArray<M, double> velocity;  ///< their rates, radians or units a unit of time
};

/// A number for each constraint.
template <class M, class S = double>
using ConstraintValues = Array<S, n_constraints<M>>;
/// n_constraints x n.
template <class M>
using ConstraintJacobian = Eigen::Matrix<double, n_constraints<M>, n_unknowns<M>>;

/// T(q, v), in the model's unit of energy.
template <DynamicModel M, class S = double>
S kinetic_energy(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    return detail::at_unknowns<M, S>(q, [&](const auto&... at) {
        static_assert(
            requires { M{}.kinetic_energy(at..., v, p); },
            "equilibria: kinetic_energy must be callable as kinetic_energy(theta, v, p), with the coordinates "
            "x after theta where there are any");
        return S(M{}.kinetic_energy(at..., v, p));
    });
}

/// Phi(q, v): Rayleigh's dissipation function, 0 of models without one. Half the power lost where it is quadratic in v.
template <DynamicModel M, class S = double>
S dissipation(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    if constexpr (detail::has_dissipation<M>())
        return detail::at_unknowns<M, S>(q, [&](const auto&... at) {
            static_assert(
                requires { M{}.dissipation(at..., v, p); },
                "equilibria: dissipation must be callable as dissipation(theta, v, p), with the coordinates x "
                "after theta where there are any");
            return S(M{}.dissipation(at..., v, p));
        });
    else
        return S(0.0);
}

/// The forces that neither the potential nor Rayleigh's function gives, one an unknown; 0 of models without any.
template <DynamicModel M, class S = double>
Unknowns<M, S> generalised_forces(double t, const Unknowns<M, S>& q, const Unknowns<M, S>& v,
                                  const Parameters<M, S>& p) {
    Unknowns<M, S> forces;
    if constexpr (detail::has_generalised_forces<M>()) {
        const auto values = detail::at_unknowns<M, S>(q, [&](const auto&... at) {
            static_assert(
                requires { M{}.generalised_forces(t, at..., v, p); },
                "equilibria: generalised_forces must be callable as generalised_forces(t, theta, v, p), with "
                "the coordinates x after theta where there are any");
            return M{}.generalised_forces(t, at..., v, p);
        });
        static_assert(detail::entries_of<std::remove_cvref_t<decltype(values)>>() == n_unknowns<M>,
                      "equilibria: generalised_forces must return a std::array with one entry for each unknown");
        for (int i = 0; i < forces.size(); ++i) forces[i] = S(values[static_cast<std::size_t>(i)]);
    }
    return forces;
}

/// The constraints' values f(q), 0 where they hold.
template <DynamicModel M, class S = double>
ConstraintValues<M, S> constraints(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    ConstraintValues<M, S> y;
    if constexpr (n_constraints<M> != 0) {
        const auto values = detail::at_unknowns<M, S>(q, [&](const auto&... at) {
            static_assert(
                requires { M{}.constraints(at..., p); },
                "equilibria: constraints must be callable as constraints(theta, p), with the coordinates x "
                "after theta where there are any");
            return M{}.constraints(at..., p);
        });
        static_assert(detail::entries_of<std::remove_cvref_t<decltype(values)>>() == n_constraints<M>,
                      "equilibria: constraints must return a std::array with n_constraints entries");
        for (int i = 0; i < y.size(); ++i) y[i] = S(values[static_cast<std::size_t>(i)]);
    } else {
        static_assert(!detail::has_constraints<M>(), "equilibria: a model with constraints needs n_constraints");
    }
    return y;
}

/// The momenta dT/dv.
template <DynamicModel M, class S = double>
Unknowns<M, S> momenta(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    constexpr int n = n_unknowns<M>;
    return kinetic_energy<M, Dual<S, n>>(detail::constants<M, S, n>(q), detail::variables<M, S>(v),
                                         detail::lifted<M, S, n>(p))
        .derivative;
}

/// M(q) = d^2 T / dv^2, n x n. Its column k is the momenta at v = e_k.
template <DynamicModel M, class S = double>
UnknownMatrix<M, S> mass_matrix(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    UnknownMatrix<M, S> y;
    for (int k = 0; k < n_unknowns<M>; ++k) {
        Unknowns<M, S> e;
        e[k] = S(1.0);
        const auto column = momenta<M, S>(q, e, p);
        for (int i = 0; i < column.size(); ++i) y(i, k) = column[i];
    }
    return y;
}

/// dM/dq_k for k = 0 .. n-1, each n x n, exact to rounding.
template <DynamicModel M>
Array<UnknownMatrix<M>, n_unknowns<M>> mass_matrix_derivatives(const Unknowns<M>& q, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    const UnknownMatrix<M, Dual<double, n>> mass =
        mass_matrix<M, Dual<double, n>>(detail::variables<M, double>(q), detail::lifted<M, double, n>(p));
    Array<UnknownMatrix<M>, n> y;
    for (int k = 0; k < n; ++k) y[k] = mass.unaryExpr([k](const Dual<double, n>& d) { return d.derivative[k]; });
    return y;
}

/// dPhi/dv: the damping forces with the other sign, one an unknown.
template <DynamicModel M, class S = double>
Unknowns<M, S> dissipation_gradient(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    constexpr int n = n_unknowns<M>;
    if constexpr (detail::has_dissipation<M>())
        return dissipation<M, Dual<S, n>>(detail::constants<M, S, n>(q), detail::variables<M, S>(v),
                                          detail::lifted<M, S, n>(p))
            .derivative;
    else
        return {};
}

/// df/dq of the constraints, n_constraints x n.
template <DynamicModel M>
ConstraintJacobian<M> constraint_jacobian(const Unknowns<M>& q, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    const auto f = constraints<M, Dual<double, n>>(detail::variables<M, double>(q), detail::lifted<M, double, n>(p));
    ConstraintJacobian<M> y;
    for (int i = 0; i < f.size(); ++i)
        for (int k = 0; k < n; ++k) y(i, k) = f[i].derivative[k];
    return y;
}

/// v^T (d^2 f_i / dq^2) v for each constraint: its second derivative in time at constant velocity.
template <DynamicModel M>
ConstraintValues<M> constraint_curvature(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    using D = Dual<Dual<double, 1>, 1>;
    Unknowns<M, D> y;
    for (int i = 0; i < q.size(); ++i) {
        y[i].value = Dual<double, 1>(q[i]);
        y[i].value.derivative[0] = v[i];
        y[i].derivative[0] = Dual<double, 1>(v[i]);
    }
    Parameters<M, D> lifted;
    for (int k = 0; k < p.size(); ++k) lifted[k] = D(p[k]);
    const auto f = constraints<M, D>(y, lifted);
    ConstraintValues<M> second;
    for (int i = 0; i < second.size(); ++i) second[i] = f[i].derivative[0].derivative[0];
    return second;
}

namespace detail {

/// Throws InvalidArgument unless the kinetic energy is that of the form, at one velocity.
inline void require_equal_form(double energy, double form) {
    if (!std::isfinite(energy)) return;  // a singular configuration: the motion's status says so
    require(std::abs(energy - form) <= 1e-9 * (std::abs(energy) + std::abs(form)), "kinetic_energy", energy,
            "must be a quadratic form in the velocities, here " + to_text(form));
}

}  // namespace detail

/// Throws InvalidArgument unless T is a quadratic form in the velocities, as far as one random velocity tells.
template <DynamicModel M>
void require_quadratic_kinetic_energy(const Unknowns<M>& q, const Parameters<M>& p) {
    Unknowns<M> v;
    for (int i = 0; i < v.size(); ++i) v[i] = 0.25 + 1.0 / (3 + i);
    const Eigen::Map<const Eigen::Vector<double, n_unknowns<M>>> u(v.begin());
    detail::require_equal_form(kinetic_energy<M>(q, v, p), 0.5 * u.dot(mass_matrix<M>(q, p) * u));
}

}  // namespace equilibria
