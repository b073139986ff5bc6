// Motions with known answers, in every formulation; orders, energy balances, statuses and refusals.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/dynamics/linear_motion.hpp>
#include <equilibria/dynamics/motion.hpp>

#include "support/catch.hpp"
#include "support/moving_models.hpp"

using namespace equilibria;
using models::DrivenPendulum, models::ElasticPendulumInMotion, models::NotQuadratic, models::PendulumInPlane;
using std::numbers::pi;

namespace {

/// The time that a pendulum from rest at `angle` takes for a quarter of its swing: K(sin(angle / 2)) sqrt(l / g).
double quarter_period(double angle, double length, double gravity) {
    return std::comp_ellint_1(std::sin(angle / 2)) * std::sqrt(length / gravity);
}

std::string message_of(const auto& f) {
    try {
        f();
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "";
}

/// Ends in a place where its mass matrix is 0.
struct VanishingMass {
    static constexpr int n_angles = 0, n_coordinates = 1, n_parameters = 1;
    constexpr auto potential(const auto&, const auto& x, const auto& p) const { return p[0] * x[0]; }
    constexpr auto kinetic_energy(const auto&, const auto& x, const auto& v, const auto&) const {
        return 0.5 * x[0] * v[0] * v[0];
    }
};
/// x'' = x^2 from 1: infinite in a finite time.
struct Explosion {
    static constexpr int n_angles = 0, n_coordinates = 1, n_parameters = 1;
    constexpr auto potential(const auto&, const auto& x, const auto& p) const { return -p[0] * x[0] * x[0] * x[0] / 3; }
    constexpr auto kinetic_energy(const auto&, const auto&, const auto& v, const auto&) const {
        return 0.5 * v[0] * v[0];
    }
};
/// A point on a line given twice.
struct ConstrainedTwice {
    static constexpr int n_angles = 0, n_coordinates = 2, n_parameters = 0, n_constraints = 2;
    constexpr auto potential(const auto&, const auto& x, const auto&) const { return x[1]; }
    constexpr auto kinetic_energy(const auto&, const auto&, const auto& v, const auto&) const {
        return 0.5 * (v[0] * v[0] + v[1] * v[1]);
    }
    constexpr auto constraints(const auto&, const auto& x, const auto&) const { return std::array{x[0], 2 * x[0]}; }
};

}  // namespace

TEST_CASE("A pendulum swings with the period of the elliptic integral, in all formulations") {
    const double length = 1.3, gravity = 9.81;
    const Parameters<DrivenPendulum> p{2, length, gravity, 0, 0, 1};
    for (const double angle : {0.1, 1.0, 2.0, 3.0}) {
        const double quarter = quarter_period(angle, length, gravity);
        const std::vector<double> times{quarter, 2 * quarter, 4 * quarter};
        const MotionState<DrivenPendulum> start{{angle}, {0}};
        const auto check = [&](const auto& motion) {
            REQUIRE(motion.status == MotionStatus::finished);
            REQUIRE(motion.points.size() == 3);
            CHECK(std::abs(motion.points[0].q[0]) < 1e-9);
            CHECK(motion.points[1].q[0] == Approx(-angle).margin(1e-9));
            CHECK(motion.points[2].q[0] == Approx(angle).margin(1e-9));
            CHECK(std::abs(motion.points[2].velocity[0]) < 1e-8);
            CHECK(motion.largest_balance < 1e-10);
            // the energy at the lowest point, and its momentum
            const double energy = 2 * gravity * length * (1 - std::cos(angle));
            CHECK(motion.points[0].kinetic == Approx(energy).epsilon(1e-9));
            CHECK(motion.points[0].momentum[0] == Approx(-2 * length * std::sqrt(energy)).epsilon(1e-9));
        };
        check(integrate_motion(LagrangeSecondKind<DrivenPendulum>(p), start, times));
        check(integrate_motion(LagrangeSecondKind<DrivenPendulum>(p, LagrangeForm::contravariant), start, times));
        check(integrate_motion(HamiltonEquations<DrivenPendulum>(p), start, times));
        // the first kind, with the rod's tension: m (v^2 / l + g cos q) = lambda l in the direction of the joint
        const auto plane = integrate_motion(LagrangeFirstKind<PendulumInPlane>({2, length, gravity}),
                                            {{length * std::sin(angle), length * std::cos(angle)}, {0, 0}}, times);
        REQUIRE(plane.status == MotionStatus::finished);
        CHECK(std::abs(plane.points[0].q[0]) < 1e-9);
        CHECK(plane.points[1].q[0] == Approx(-length * std::sin(angle)).margin(1e-9));
        CHECK(plane.largest_balance < 1e-10);
        for (const auto& point : plane.points) {
            const double speed = std::hypot(point.velocity[0], point.velocity[1]);
            const double tension = 2 * (speed * speed / length + gravity * point.q[1] / length);
            CHECK(-point.multipliers[0] * length == Approx(tension).epsilon(1e-8));
            CHECK(point.constraint_forces[1] == Approx(-tension * point.q[1] / length).epsilon(1e-8).margin(1e-8));
            CHECK(point.drift < 1e-14);
            CHECK(point.velocity_drift < 1e-13);
        }
    }
}

TEST_CASE("Small tolerances cost steps of order five, and the error falls with them") {
    const Parameters<DrivenPendulum> p{1, 1, 1, 0, 0, 1};
    const double quarter = quarter_period(2, 1, 1);
    double error_before = 1;
    std::uint64_t steps_before = 1;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
        const auto motion = integrate_motion(LagrangeSecondKind<DrivenPendulum>(p), {{2}, {0}}, {4 * quarter},
                                             {tolerance, tolerance, 0, 100'000});
        const double error = std::abs(motion.points[0].q[0] - 2) + std::abs(motion.points[0].velocity[0]);
        CAPTURE(tolerance, error, motion.steps);
        CHECK(error < 0.2 * error_before);
        if (steps_before > 10) {
            // a hundredth of the tolerance: 100^(1/5) = 2.5 times the steps
            CHECK(static_cast<double>(motion.steps) < 3.2 * static_cast<double>(steps_before));
            CHECK(static_cast<double>(motion.steps) > 1.6 * static_cast<double>(steps_before));
        }
        error_before = error;
        steps_before = motion.steps;
    }
    CHECK(error_before < 1e-8);
}

TEST_CASE("What damping takes and a driving torque gives adds up") {
    const Parameters<DrivenPendulum> p{1, 1, 9.81, 0.4, 3, 2.5};
    const MotionState<DrivenPendulum> start{{0.2}, {1}};
    std::vector<double> times;
    for (int k = 1; k <= 40; ++k) times.push_back(0.5 * k);
    const auto lagrange = integrate_motion(LagrangeSecondKind<DrivenPendulum>(p), start, times);
    const auto hamilton = integrate_motion(HamiltonEquations<DrivenPendulum>(p), start, times);
    CHECK(lagrange.largest_balance < 1e-10);
    CHECK(hamilton.largest_balance < 1e-10);
    double dissipated = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto &a = lagrange.points[k], &b = hamilton.points[k];
        CHECK(a.q[0] == Approx(b.q[0]).margin(1e-9));
        CHECK(a.work == Approx(b.work).margin(1e-9));
        CHECK(a.dissipated > dissipated);
        CHECK(a.kinetic + a.potential + a.dissipated - a.work - a.balance ==
              Approx(0.5 - 9.81 * std::cos(0.2)).margin(1e-12));
        dissipated = a.dissipated;
    }
    CHECK(dissipated > 1);
}

TEST_CASE("Linearised motion is that of the poles, and small motions follow it") {
    const Parameters<DrivenPendulum> p{1, 1, 4, 0.6, 0, 1};
    const LinearMotion<DrivenPendulum> linear(p, {0});
    const double decay = 0.3, frequency = std::sqrt(4 - decay * decay);
    const std::vector<double> times{0.5, 1, 3, 10};
    const auto motion = integrate_motion(linear, {{1}, {0}}, times);
    CHECK(motion.largest_balance < 1e-10);
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double t = times[k];
        CHECK(motion.points[k].q[0] ==
              Approx(std::exp(-decay * t) * (std::cos(frequency * t) + decay / frequency * std::sin(frequency * t)))
                  .margin(1e-10));
    }
    // the difference to the true motion is of third order in the amplitude
    double before = 0;
    for (const double amplitude : {1e-1, 1e-2}) {
        const auto a = integrate_motion(linear, {{amplitude}, {0}}, {2});
        const auto b = integrate_motion(LagrangeSecondKind<DrivenPendulum>(p), {{amplitude}, {0}}, {2});
        const double difference = std::abs(a.points[0].q[0] - b.points[0].q[0]);
        if (before > 0) CHECK(before / difference == Approx(1000).epsilon(0.05));
        before = difference;
    }
}

TEST_CASE("Angles and coordinates move together: an elastic pendulum keeps its energy") {
    const Parameters<ElasticPendulumInMotion> p{1, 40, 9.81};
    const MotionState<ElasticPendulumInMotion> start{{1, 1.2}, {0.5, -1}};
    const auto a = integrate_motion(LagrangeSecondKind<ElasticPendulumInMotion>(p), start, {1, 5});
    const auto b = integrate_motion(HamiltonEquations<ElasticPendulumInMotion>(p), start, {1, 5});
    CHECK(a.largest_balance < 1e-10);
    CHECK(b.largest_balance < 1e-10);
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 2; ++i) CHECK(a.points[k].q[i] == Approx(b.points[k].q[i]).margin(1e-8));
}

TEST_CASE("Without stabilisation the constraints drift, with it they do not") {
    const Parameters<PendulumInPlane> p{1, 1, 1};
    const MotionState<PendulumInPlane> start{{std::sin(2.0), std::cos(2.0)}, {0, 0}};
    const MotionOptions rough{1e-5, 1e-5, 0, 100'000};
    const auto free = integrate_motion(LagrangeFirstKind<PendulumInPlane>(p, Stabilisation::none), start, {100}, rough);
    const auto held = integrate_motion(LagrangeFirstKind<PendulumInPlane>(p), start, {100}, rough);
    CHECK(free.points[0].drift > 1e-5);
    CHECK(free.largest_drift >= free.points[0].drift);
    CHECK(held.points[0].drift < 1e-14);
    CHECK(held.points[0].velocity_drift < 1e-14);
    CHECK(held.largest_drift < 1e-4);  // of one step, before it is put right
    CHECK(held.largest_drift > 0);
}

TEST_CASE("What stops a motion is a status, and what was reached is kept") {
    const auto mass = integrate_motion(LagrangeSecondKind<VanishingMass>({1.0}), {{1}, {-1}}, {0.1, 100});
    CHECK(mass.status != MotionStatus::finished);
    CHECK(mass.points.size() == 1);
    CHECK(mass.time >= 0.1);
    CHECK(mass.time < 100);
    const auto none = integrate_motion(LagrangeSecondKind<VanishingMass>({1.0}), {{0}, {0}}, {1});
    CHECK(none.status == MotionStatus::singular_mass_matrix);
    CHECK(none.points.empty());
    const auto explosion = integrate_motion(LagrangeSecondKind<Explosion>({1.0}), {{1}, {1}}, {1, 100});
    CHECK((explosion.status == MotionStatus::step_too_small || explosion.status == MotionStatus::not_finite ||
           explosion.status == MotionStatus::too_many_steps));
    CHECK(explosion.points.size() == 1);
    const auto few = integrate_motion(LagrangeSecondKind<DrivenPendulum>({1, 1, 1, 0, 0, 1}), {{1}, {0}}, {1000},
                                      {1e-9, 1e-9, 0, 10});
    CHECK(few.status == MotionStatus::too_many_steps);
    CHECK(few.steps == 10);
    CHECK(few.points.empty());
    for (const auto status :
         {MotionStatus::finished, MotionStatus::singular_mass_matrix, MotionStatus::singular_constraints,
          MotionStatus::not_finite, MotionStatus::step_too_small, MotionStatus::too_many_steps})
        CHECK(std::string(to_string(status)).size() > 3);
}

TEST_CASE("The largest step is kept") {
    const auto motion = integrate_motion(LagrangeSecondKind<DrivenPendulum>({1, 1, 1, 0, 0, 1}), {{1}, {0}}, {1},
                                         {1e-3, 1e-3, 0.01, 1000});
    CHECK(motion.steps >= 100);
    CHECK(motion.steps < 120);
}

TEST_CASE("Starts, times and options that are none are refused in a line") {
    const LagrangeSecondKind<DrivenPendulum> pendulum({1, 1, 1, 0, 0, 1});
    const auto refused = [&](const std::vector<double>& times, const MotionOptions& options) {
        return message_of([&] { integrate_motion(pendulum, {{1}, {0}}, times, options); });
    };
    CHECK(refused({1, 0.5}, {}) == "times[1] = 0.5: must be finite, 1 or more");
    CHECK(refused({-1}, {}) == "times[0] = -1: must be finite, 0 or more");
    CHECK(refused({1}, {0, 1, 0, 1}) == "relative_tolerance = 0: must be from 1e-15 to 1");
    CHECK(refused({1}, {1e-3, 0, 0, 1}) == "absolute_tolerance = 0: must be positive");
    CHECK(refused({1}, {1e-3, 1, -1, 1}) == "largest_step = -1: must be 0 or more");
    CHECK(refused({1}, {1e-3, 1, 0, 0}) == "most_steps = 0: must be positive");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(message_of([&] { integrate_motion(pendulum, {{nan}, {0}}, {1}); }) == "start.q[0] = nan: must be finite");
    CHECK(message_of([&] { integrate_motion(pendulum, {{0}, {nan}}, {1}); }) ==
          "start.velocity[0] = nan: must be finite");
    CHECK(message_of([&] { LagrangeSecondKind<DrivenPendulum>({1, nan, 1, 0, 0, 1}); }) ==
          "p[1] = nan: must be finite");
    CHECK(message_of([&] {
              integrate_motion(LagrangeSecondKind<NotQuadratic>({1.0}), {{1}, {0}}, {1});
          }).starts_with("kinetic_energy = "));
    const LagrangeFirstKind<PendulumInPlane> plane({1, 1, 1});
    CHECK(message_of([&] { integrate_motion(plane, {{0, 1.1}, {0, 0}}, {1}); }).starts_with("start.q = 0.105"));
    CHECK(message_of([&] { integrate_motion(plane, {{0, 1}, {0, 1}}, {1}); }) ==
          "start.velocity = 1: must obey the constraints' derivative; this is by how much it fails");
    CHECK(message_of([&] {
              integrate_motion(LagrangeFirstKind<ConstrainedTwice>({}), {{0, 1}, {0, 0}}, {1});
          }).find("must be near a place where the constraints hold and are independent") != std::string::npos);
}
