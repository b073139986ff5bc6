// A whole study on one page: a mechanism's equilibria, proved; their stability by energy, Routh, Hurwitz and poles; its
// motion in three formulations; and where motions end. Tables 1 to 5 of Vesovic and
// Radulovic, "Modelling and stability analysis of the nonlinear system" (2022), with their data.
#include <cstdio>
#include <equilibria/dynamics/basins.hpp>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>
#include <iostream>
#include <numbers>
#include <vector>

using namespace equilibria;
using Mechanism = mechanisms::HolonomicMechanism;
using Points = mechanisms::HolonomicMechanismPoints;
using std::numbers::pi;

int main() {
    const auto p = Mechanism::paper_parameters(100);  // F = 100 N
    const auto found = enumerate<Mechanism>(p);
    std::cout << found << '\n' << prove(found).reason << "\n\n";
    for (const auto& e : found.equilibria) {
        const auto motion = linearise<Mechanism>(e.q, p);
        const auto energy = lagrange_dirichlet(motion.stiffness);
        const auto poles = count_poles(motion);
        std::printf("q %9.6f %9.6f  minors %8.3f %9.1f\n", e.q[0], e.q[1], energy.minors[0], energy.minors[1]);
        std::printf("  s^4 %+.5f s^3 %+.5f s^2 %+.5f s %+.5f\n", poles.polynomial[1], poles.polynomial[2],
                    poles.polynomial[3], poles.polynomial[4]);
        const auto routh = poles.routh.first_column().eval();
        std::printf("  Routh %.4f %.4f %.4f %.4f; %d poles on the right: %s\n", routh[1], routh[2], routh[3], routh[4],
                    poles.right_half_plane().value_or(-1), to_string(poles.verdict()));
    }

    const auto falling = Mechanism::paper_parameters(100, 0.7);  // F = 100 exp(-0.7 t) N
    const MotionState<Mechanism> start{{4 * pi / 13, pi / 7}, {0, 0}};
    const auto lagrange = integrate_motion(LagrangeSecondKind<Mechanism>(falling), start, {1, 2, 10});
    const auto hamilton = integrate_motion(HamiltonEquations<Mechanism>(falling), start, {1, 2, 10});
    const auto cartesian =
        integrate_motion(LagrangeFirstKind<Points>(falling), mechanisms::points_of(start, falling), {1, 2, 10});
    std::printf("\n   t   q1, second kind   q1, first kind    q1, Hamilton      slider x3 [m]\n");
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& x = cartesian.points[k];
        std::printf("%4g   %.9f       %.9f       %.9f       %.9f\n", x.time, lagrange.points[k].q[0],
                    mechanisms::angles_of({x.q, x.velocity}).q[0], hamilton.points[k].q[0], x.q[4]);
    }

    std::printf("\n");
    const std::vector<MotionState<Mechanism>> starts{{{0.8, -3}, {0, 0}}, {{-2.4, 1.4}, {0, 0}}, {{0, 0}, {5, -5}}};
    for (const auto& y : find_basins<Mechanism>(p, found.equilibria, starts))
        std::printf("comes to q1 = %.4f; trapped since t = %.2f s\n", found.equilibria[y.equilibrium.value()].q[0],
                    y.trapped_time);
}

// clang-format off
/* Output:
16 paths: 6 finite, 10 at infinity, 0 singular, 0 failed; 6 distinct roots, 4 real: index 0: 1, 1: 2, 2: 1; Morse relations hold
6 roots are proved to be distinct, as many as the Laurent mixed volume 6 allows: by Bernstein's theorem there is no other that is isolated

q  1.465440 -0.256309  minors  576.559  167162.7
  s^4 +6.01551 s^3 +38.30231 s^2 +149.28018 s +305.99180
  Routh 6.0155 13.4864 12.7950 305.9918; 0 poles on the right: stable
q -1.421758 -2.544882  minors -119.042  -53281.4
  s^4 +5.33619 s^3 +2.36749 s^2 +53.05648 s -83.53573
  Routh 5.3362 -7.5753 -5.7880 -83.5357; 1 poles on the right: unstable
q  0.779777 -2.959175  minors  111.015  -77387.7
  s^4 +5.02123 s^3 -31.92514 s^2 -98.39684 s -139.75829
  Routh 5.0212 -12.3290 -155.3163 -139.7583; 1 poles on the right: unstable
q -2.356471  1.386096  minors -529.601  120212.2
  s^4 +1.54640 s^3 -65.79451 s^2 -30.66652 s +325.54318
  Routh 1.5464 -45.9636 -19.7140 325.5432; 2 poles on the right: unstable

   t   q1, second kind   q1, first kind    q1, Hamilton      slider x3 [m]
   1   1.395008075       1.395008075       1.395008075       2.394677130
   2   1.532278874       1.532278874       1.532278874       2.213733436
  10   1.548212363       1.548212363       1.548212363       2.193475069

comes to q1 = 1.4654; trapped since t = 0.00 s
comes to q1 = 1.4654; trapped since t = 1.36 s
comes to q1 = 1.4654; trapped since t = 0.42 s
*/
