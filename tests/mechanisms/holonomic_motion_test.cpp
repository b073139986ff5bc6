// The motion of section 1 of Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system" (2022),
// in three formulations, the tables of section 2 by three criteria, and where the mechanism's damped motions end.
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <equilibria/dynamics/basins.hpp>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;
using C = mechanisms::HolonomicMechanismPoints;
using std::numbers::pi;

namespace {

/// Section 1: F = 100 exp(-0.7 t), at rest.
const auto moving = M::paper_parameters(100, 0.7);
const MotionState<M> start{{4 * pi / 13, pi / 7}, {}};

/// q(1), q(2), q(10): figures of an integration in extended precision, with the paper's data.
const struct {
    double t, q1, q2;
} expected[] = {{1, 1.395008075400106, 0.066900953194800},
                {2, 1.532278874235488, -0.387246112382632},
                {10, 1.548212362758413, 0.104114829458420}};

/// The tables' rows in the paper's order, with the figures put right that it prints wrongly.
struct Row {
    double q1, q2;
    std::array<double, 4> polynomial;
    int right_half_plane;
    std::array<std::complex<double>, 4> poles;  // by real parts
};
const Row rows[] = {
    {0.779776976161,
     -2.95917510938,
     {5.02122713, -31.9251419, -98.3968375, -139.758291},
     1,
     {{{-7.79296632, 0}, {-1.28231223, -1.31010396}, {-1.28231223, 1.31010396}, {5.33636365, 0}}}},
    {1.46544020854,
     -0.25630918245,
     {6.01550608, 38.3023142, 149.280177, 305.991796},
     0,
     {{{-2.92463634, -1.89756088},
       {-2.92463634, 1.89756088},
       {-.0831167005, -5.01685422},
       {-.0831167005, 5.01685422}}}},
    {-1.42175799139,
     -2.54488196512,
     {5.33619125, 2.36749090, 53.0564806, -83.5357344},
     1,
     {{{-6.52174123, 0}, {-.0357689515, -3.19186326}, {-.0357689515, 3.19186326}, {1.25708788, 0}}}},
    {-2.356470734,
     1.38609618224,
     {1.54639647, -65.7945127, -30.6665210, 325.543179},
     2,
     {{{-8.39706634, 0}, {-2.52218381, 0}, {2.11903126, 0}, {7.25382241, 0}}}},
};

}  // namespace

TEST_CASE("The motion's values to 1e-9 in three formulations, without drift, with its energy balance") {
    std::vector<double> times;
    for (int k = 1; k <= 100; ++k) times.push_back(0.1 * k);
    const auto covariant = integrate_motion(LagrangeSecondKind<M>(moving), start, times);
    const auto contravariant =
        integrate_motion(LagrangeSecondKind<M>(moving, LagrangeForm::contravariant), start, times);
    const auto hamilton = integrate_motion(HamiltonEquations<M>(moving), start, times);
    const auto points = integrate_motion(LagrangeFirstKind<C>(moving), mechanisms::points_of(start, moving), times);
    const auto unstabilised = integrate_motion(LagrangeFirstKind<C>(moving, Stabilisation::none),
                                               mechanisms::points_of(start, moving), times);
    for (const auto* motion : {&covariant, &contravariant, &hamilton}) {
        REQUIRE(motion->status == MotionStatus::finished);
        CHECK(motion->largest_balance < 1e-9);
    }
    for (const auto* motion : {&points, &unstabilised}) {
        REQUIRE(motion->status == MotionStatus::finished);
        CHECK(motion->largest_balance < 1e-9);
        CHECK(motion->largest_drift < 1e-9);
        CHECK(motion->largest_velocity_drift < 1e-9);
    }
    for (const auto& row : expected) {
        const auto k = static_cast<std::size_t>(std::lround(10 * row.t)) - 1;
        const auto first = mechanisms::angles_of({points.points[k].q, points.points[k].velocity});
        for (const auto& q : {covariant.points[k].q, contravariant.points[k].q, hamilton.points[k].q, first.q}) {
            CHECK(std::abs(q[0] - row.q1) < 1e-9);
            CHECK(std::abs(q[1] - row.q2) < 1e-9);
        }
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto &a = covariant.points[k], &b = hamilton.points[k];
        const auto& c = points.points[k];
        const auto same = mechanisms::angles_of({c.q, c.velocity});
        for (int i = 0; i < 2; ++i) {
            CHECK(std::abs(a.q[i] - b.q[i]) < 1e-9);
            CHECK(std::abs(a.velocity[i] - same.velocity[i]) < 1e-8);
            CHECK(std::abs(a.momentum[i] - b.momentum[i]) < 1e-7);
        }
        CHECK(a.dissipated == Approx(c.dissipated).epsilon(1e-8).margin(1e-8));
        // Newton's law for the slider in y: what the guide bears is its weight and the rod's push
        CHECK(c.constraint_forces[5] == Approx(moving[M::mass_3] * moving[M::gravity]).epsilon(1e-9));
    }
}

TEST_CASE("Tables 1 to 5 at 100 N: polynomials, poles and the number of them on the right by three criteria") {
    const auto p = M::paper_parameters(100);
    for (const auto& row : rows) {
        CAPTURE(row.q1);
        const auto system = linearise<M>({row.q1, row.q2}, p);
        const auto y = count_poles(system);
        for (int k = 0; k < 4; ++k) {
            CHECK(y.polynomial[k + 1] == Approx(row.polynomial[static_cast<std::size_t>(k)]).epsilon(1e-8));
            const auto pole = row.poles[static_cast<std::size_t>(k)];
            CHECK(y.poles[k].real() == Approx(pole.real()).epsilon(1e-8));
            CHECK(y.poles[k].imag() == Approx(pole.imag()).epsilon(1e-8));
        }
        CHECK(y.right_half_plane() == row.right_half_plane);
        CHECK_FALSE(y.marginal());
        CHECK(y.routh.special.empty());
        // Table 2, and Kelvin, Tait and Chetaev: damping reaches all motions, so the index is that number
        const auto energy = lagrange_dirichlet(system.stiffness);
        CHECK(energy.agree());
        CHECK(energy.inertia.negative == row.right_half_plane);
        CHECK((energy.verdict() == PotentialVerdict::stable) ==
              (y.verdict() == StabilityVerdict::asymptotically_stable));
        // the minors of Hurwitz's matrix and the first column of Routh's table say the same
        CHECK(y.hurwitz.minors[1] / y.hurwitz.minors[0] == Approx(y.routh.first_column()[2]));
    }
}

TEST_CASE("The appendix's data have equilibria of the same kinds near by") {
    const auto r = enumerate<M>(M::appendix_parameters(100));
    REQUIRE(r.real() == 4);
    CHECK(r.by_index() == std::vector<std::int64_t>{1, 2, 1});
    for (const auto& e : r.equilibria) {
        double nearest = 1;
        for (const auto& row : rows) nearest = std::min(nearest, std::hypot(e.q[0] - row.q1, e.q[1] - row.q2));
        CHECK(nearest < 2e-3);
        CHECK(nearest > 1e-6);
        CHECK(count_poles(linearise<M>(e.q, r.parameters)).right_half_plane() == e.index);
    }
}

TEST_CASE("Damped motions from anywhere come to the one stable equilibrium, or to one of two") {
    Generator generator(1);
    std::vector<MotionState<M>> starts;
    for (int k = 0; k < 12; ++k)
        starts.push_back({{uniform(generator, -pi, pi), uniform(generator, -pi, pi)},
                          {uniform(generator, -3, 3), uniform(generator, -3, 3)}});
    const auto check = [&](const Parameters<M>& p, std::size_t wells) {
        const auto r = enumerate<M>(p);
        REQUIRE(r.clean());
        CHECK(r.by_index()[0] == static_cast<std::int64_t>(wells));
        std::vector<int> reached(r.equilibria.size());
        for (const auto& y : find_basins<M>(p, r.equilibria, starts)) {
            REQUIRE(y.equilibrium);
            const auto& e = r.equilibria[*y.equilibrium];
            CHECK(e.stable());
            CHECK(y.energy_rise < 1e-7);
            CHECK(y.trapped_time <= y.time);
            CHECK(distance<M>(y.last.q, e.q) < 0.01);
            ++reached[*y.equilibrium];
        }
        return reached;
    };
    CHECK(check(M::paper_parameters(100), 1)[0] == 12);
    auto p = M::paper_parameters(0);
    p[M::stiffness_2] = 50;
    const auto reached = check(p, 2);
    CHECK(reached[0] + reached[1] == 12);
}
