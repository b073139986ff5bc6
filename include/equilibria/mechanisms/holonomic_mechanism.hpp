/// \file
/// A planar mechanism with two degrees of freedom: three rods, a slider, two springs, a damper, gravity and a
/// horizontal force. Source: Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system",
/// Theoretical and Applied Mechanics (2022), no. 1, 29-48, sections 1 and 2 and appendix; its misprints are listed in
/// docs/mechanism.md.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/kinetics.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria::mechanisms {

/// The parameters of the mechanism, for both of its descriptions below.
struct HolonomicMechanismParameters {
    /// Masses in kg, gravity in m/s^2, length in m, stiffnesses c1 and c2 in N/m, damping beta in N s/m, force in N,
    /// decay alpha in 1/s.
    enum Parameter {
        mass_1,
        mass_2,
        mass_3,
        gravity,
        length,
        stiffness_1,
        stiffness_2,
        damping,
        force,
        decay,
        n_parameters
    };
    using Values = Array<double, n_parameters>;  ///< one of each, by `Parameter`

    /// What the paper computed with: g = 9.80665 and c2 = 1100/3 give its printed digits. A force in N (100 in Tables 1
    /// to 5) that stays constant, unless a decay is given (0.7 in section 1).
    static constexpr Values paper_parameters(double force_in_newtons, double decay_rate = 0) {
        return {10, 10, 10, 9.80665, 1.25, 162.5, 1100. / 3, 121, force_in_newtons, decay_rate};
    }
    /// The appendix to the letter: c2 = 366.67, and g = 9.81, which it does not state.
    static constexpr Values appendix_parameters(double force_in_newtons, double decay_rate = 0) {
        Values p = paper_parameters(force_in_newtons, decay_rate);
        p[gravity] = 9.81;
        p[stiffness_2] = 366.67;
        return p;
    }

    /// Throws InvalidArgument unless masses and length are positive, stiffnesses, damping and decay not negative, and
    /// all is finite.
    static void validate(const Values& p) {
        require_finite(p, "parameters");
        require(p[mass_1] > 0, "mass_1", p[mass_1], "must be positive");
        require(p[mass_2] > 0, "mass_2", p[mass_2], "must be positive");
        require(p[mass_3] > 0, "mass_3", p[mass_3], "must be positive");
        require(p[length] > 0, "length", p[length], "must be positive");
        require(p[stiffness_1] >= 0, "stiffness_1", p[stiffness_1], "must be 0 or more");
        require(p[stiffness_2] >= 0, "stiffness_2", p[stiffness_2], "must be 0 or more");
        require(p[damping] >= 0, "damping", p[damping], "must be 0 or more");
        require(p[decay] >= 0, "decay", p[decay], "must be 0 or more");
    }
};

/// Points M1, M2, M3 of masses m_1, m_2, m_3 in a vertical plane, the y axis upwards: M1 on a rod of length l from the
/// origin O, M2 on a rod of length l from M1, and a slider M3 on the x axis, on a rod of length 2 l from M1. With the
/// absolute angles q1, from the x axis to O M1, and q2, from the downward vertical to M1 M2, in radians, equations
/// (1.10) are
///     x1 = l cos q1,   y1 = l sin q1,   x2 = x1 - l sin q2,   y2 = y1 - l cos q2,   x3 = x1 + l sqrt(3 + cos^2 q1), y3
///     = 0.
/// Two springs are stretched by the distances from O to M2 (stiffness c1) and from (0, l) to M1 (c2); a damper of
/// coefficient beta holds the slider. A force F exp(-alpha t) acts on M2 along x. Its share F has the potential -F x2:
/// the whole is V = Pi - F x2, with Pi of equation (1.14),
///     Pi = g (m_1 y1 + m_2 y2 + m_3 y3) + c1/2 (x2^2 + y2^2) + c2/2 (x1^2 + (l - y1)^2).
/// The equilibria under the constant force F are the solutions of (2.3): six, real and complex. The slider enters there
/// by y3 alone; the square root in x3 is in the kinetic energy and in the damping.
///
/// The reflection x -> -x takes (F, q1, q2) to (-F, pi - q1, -q2) and leaves V as it is, but not T: the slider stays on
/// its side.
struct HolonomicMechanism : HolonomicMechanismParameters {
    static constexpr int n_angles = 2;  ///< q1 and q2

    /// V = Pi - F x2, in J.
    constexpr auto potential(const auto& q, const auto& p) const {
        return potential_without_force(q, p) - p[force] * (p[length] * (cos(q[0]) - sin(q[1])));
    }
    /// Pi.
    constexpr auto potential_without_force(const auto& q, const auto& p) const {
        return p[gravity] * p[length] * ((p[mass_1] + p[mass_2]) * sin(q[0]) - p[mass_2] * cos(q[1])) +
               p[length] * p[length] * (p[stiffness_1] * (1 - sin(q[0] + q[1])) + p[stiffness_2] * (1 - sin(q[0])));
    }
    /// (1.12), for masses of their own.
    constexpr auto kinetic_energy(const auto& q, const auto& v, const auto& p) const {
        const auto x3 = slider_velocity(q, v, p);
        return 0.5 * p[length] * p[length] *
                   (p[mass_1] * v[0] * v[0] +
                    p[mass_2] * (v[0] * v[0] + 2 * sin(q[0] + q[1]) * v[0] * v[1] + v[1] * v[1])) +
               0.5 * p[mass_3] * x3 * x3;
    }
    /// Half the damping force times the slider's velocity, in W.
    constexpr auto dissipation(const auto& q, const auto& v, const auto& p) const {
        const auto x3 = slider_velocity(q, v, p);
        return 0.5 * p[damping] * x3 * x3;
    }
    /// What the force F exp(-alpha t) at M2 has beside its constant share F.
    auto generalised_forces(double t, const auto& q, const auto&, const auto& p) const {
        const auto rest = changing_force(t, p) * p[length];
        return std::array{-rest * sin(q[0]), -rest * cos(q[1])};
    }
    /// (1.10): x1, y1, x2, y2, x3, y3 in m.
    constexpr auto points(const auto& q, const auto& p) const {
        using std::sqrt;
        const auto l = p[length];
        const auto x1 = l * cos(q[0]), y1 = l * sin(q[0]);
        return std::array{x1,      y1, x1 - l * sin(q[1]), y1 - l * cos(q[1]), x1 + l * sqrt(3 + cos(q[0]) * cos(q[0])),
                          0.0 * x1};
    }

    /// F exp(-alpha t) - F in N.
    static auto changing_force(double t, const auto& p) {
        using std::exp;
        return p[force] * (exp(-t * p[decay]) - 1);
    }

private:
    constexpr auto slider_velocity(const auto& q, const auto& v, const auto& p) const {
        using std::sqrt;
        return -p[length] * sin(q[0]) * (1 + cos(q[0]) / sqrt(3 + cos(q[0]) * cos(q[0]))) * v[0];
    }
};

/// The same mechanism in the six coordinates x1, y1, x2, y2, x3, y3 of its points, in m, with the constraints (1.2) to
/// (1.5): three rods and the guide of the slider. For Lagrange's equations of the first kind, (1.8).
struct HolonomicMechanismPoints : HolonomicMechanismParameters {
    static constexpr int n_angles = 0;       ///< points instead of angles
    static constexpr int n_coordinates = 6;  ///< x1, y1, x2, y2, x3, y3
    static constexpr int n_constraints = 4;  ///< three rods and the guide

    /// As of HolonomicMechanism, in the coordinates of the points.
    /// \{
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        return p[gravity] * (p[mass_1] * x[1] + p[mass_2] * x[3] + p[mass_3] * x[5]) +
               0.5 * p[stiffness_1] * (x[2] * x[2] + x[3] * x[3]) +
               0.5 * p[stiffness_2] * (x[0] * x[0] + (p[length] - x[1]) * (p[length] - x[1])) - p[force] * x[2];
    }
    constexpr auto kinetic_energy(const auto&, const auto&, const auto& v, const auto& p) const {
        return 0.5 * (p[mass_1] * (v[0] * v[0] + v[1] * v[1]) + p[mass_2] * (v[2] * v[2] + v[3] * v[3]) +
                      p[mass_3] * (v[4] * v[4] + v[5] * v[5]));
    }
    constexpr auto dissipation(const auto&, const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[damping] * v[4] * v[4];
    }
    auto generalised_forces(double t, const auto&, const auto& x, const auto&, const auto& p) const {
        const auto none = 0.0 * x[0];
        return std::array{none, none, none + HolonomicMechanism::changing_force(t, p), none, none, none};
    }
    /// \}
    /// Squares of the rods' lengths less what they should be, and y3: 0 in every motion.
    constexpr auto constraints(const auto&, const auto& x, const auto& p) const {
        const auto squared = [](const auto& a, const auto& b) { return a * a + b * b; };
        const auto rod = p[length] * p[length];
        return std::array{squared(x[0], x[1]) - rod, squared(x[2] - x[0], x[3] - x[1]) - rod,
                          squared(x[4] - x[0], x[5] - x[1]) - 4 * rod, x[5]};
    }
};

/// The state of the points that belongs to the angles and their rates.
inline MotionState<HolonomicMechanismPoints> points_of(const MotionState<HolonomicMechanism>& state,
                                                       const HolonomicMechanismParameters::Values& p) {
    using D = Dual<double, 1>;
    Unknowns<HolonomicMechanism, D> q;
    for (int i = 0; i < q.size(); ++i) q[i] = state.q[i], q[i].derivative[0] = state.velocity[i];
    Array<CircleAngle<D>, 2> theta;
    for (int i = 0; i < q.size(); ++i) theta[i] = {cos(q[i]), sin(q[i])};
    const auto x = HolonomicMechanism{}.points(theta, p);
    MotionState<HolonomicMechanismPoints> y;
    for (int i = 0; i < y.q.size(); ++i) {
        y.q[i] = x[static_cast<std::size_t>(i)].value;
        y.velocity[i] = x[static_cast<std::size_t>(i)].derivative[0];
    }
    return y;
}

/// The angles, in (-pi, pi], and their rates that belong to the points.
inline MotionState<HolonomicMechanism> angles_of(const MotionState<HolonomicMechanismPoints>& state) {
    using D = Dual<double, 1>;
    Unknowns<HolonomicMechanismPoints, D> x;
    for (int i = 0; i < x.size(); ++i) x[i] = state.q[i], x[i].derivative[0] = state.velocity[i];
    const D q[] = {atan2(x[1], x[0]), atan2(x[0] - x[2], x[1] - x[3])};
    return {{q[0].value, q[1].value}, {q[0].derivative[0], q[1].derivative[0]}};
}

}  // namespace equilibria::mechanisms
