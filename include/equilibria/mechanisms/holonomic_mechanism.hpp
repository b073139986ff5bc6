/// \file
/// A planar mechanism with two degrees of freedom: three rods, a slider, two springs, gravity and a horizontal force.
/// Source: "Modelling and stability analysis of the nonlinear system" (2022), section 1 and appendix.
#pragma once

#include <equilibria/model/model.hpp>

namespace equilibria::mechanisms {

/// Points M1, M2, M3 of equal mass m in a vertical plane, the y axis upwards: M1 on a rod of length l from the origin
/// O, M2 on a rod of length l from M1, and a slider M3 on the x axis, on a rod of length 2 l from M1. With the absolute
/// angles q1, from the x axis to O M1, and q2, from the downward vertical to M1 M2, in radians, equations (1.10) are
///     x1 = l cos q1,   y1 = l sin q1,   x2 = x1 - l sin q2,   y2 = y1 - l cos q2,   y3 = 0.
/// Two springs are stretched by the distances from O to M2 (stiffness c1) and from (0, l) to M1 (c2). A constant force
/// F acts on M2 along x and has the potential -F x2: the whole is V = Pi - F x2, with Pi of equation (1.14),
///     Pi = m g (y1 + y2 + y3) + c1/2 (x2^2 + y2^2) + c2/2 (x1^2 + (l - y1)^2).
/// The equilibria are the solutions of (2.3): six, real and complex. The slider enters by y3 alone; the square root in
/// x3 is in the kinetic energy and in the damping.
///
/// The reflection x -> -x takes (F, q1, q2) to (-F, pi - q1, -q2) and leaves V as it is.
struct HolonomicMechanism {
    static constexpr int n_angles = 2;
    /// m in kg, g in m/s^2, l in m, c1 and c2 in N/m, F in N.
    enum Parameter { mass, gravity, length, stiffness_1, stiffness_2, force, n_parameters };

    /// The appendix's data and a force in N (100 in Tables 1 to 5), with g = 9.80665 and c2 = 1100/3, which give the
    /// printed digits: the appendix does not state g and rounds c2 to 366.67.
    static constexpr Array<double, n_parameters> paper_parameters(double force_in_newtons) {
        return {10, 9.80665, 1.25, 162.5, 1100. / 3, force_in_newtons};
    }

    constexpr auto potential(const auto& q, const auto& p) const {
        const auto weight = p[mass] * p[gravity];
        const auto x2 = p[length] * (cos(q[0]) - sin(q[1]));
        return weight * p[length] * (2 * sin(q[0]) - cos(q[1])) +
               p[length] * p[length] * (p[stiffness_1] * (1 - sin(q[0] + q[1])) + p[stiffness_2] * (1 - sin(q[0]))) -
               p[force] * x2;
    }
};

}  // namespace equilibria::mechanisms
