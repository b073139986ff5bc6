// The integrator for unknowns of one's own: closed forms to the tolerance, the order of the pair, ends of steps, and
// what goes wrong as a status.
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <equilibria/dynamics/adaptive_integrator.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using State = AdaptiveIntegrator::State;

namespace {

/// x'' = -x as (x, x'), from (1, 0).
void oscillator(const State& y, State& rate, double) {
    rate[0] = y[1];
    rate[1] = -y[0];
}
AdaptiveIntegrator oscillation(const MotionOptions& options) { return {oscillator, {1, 0}, 0.01, options}; }

}  // namespace

TEST_CASE("An oscillator is integrated to its tolerance, and steps end where they are told") {
    std::uint64_t before = 0;
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
        CAPTURE(tolerance);
        auto y = oscillation({tolerance, tolerance});
        for (const double t : {1.0, 1.0, 7.5, 20.0}) {
            while (y.time() < t && y.step(t)) {
            }
            CHECK(y.status() == MotionStatus::finished);
            CHECK(y.time() == t);
            CHECK(std::abs(y.state()[0] - std::cos(t)) < 100 * tolerance);
            CHECK(std::abs(y.state()[1] + std::sin(t)) < 100 * tolerance);
        }
        // an error of order 8 a step: a thousandth of the tolerance takes 1000^(1/8) = 2.4 times the steps
        if (before > 0) {
            CHECK(y.steps() < 4 * before);
            CHECK(y.steps() > before);
        }
        before = y.steps();
        CHECK(y.evaluations() >= 13 * y.steps());
    }
}

TEST_CASE("The rates may depend on the time, and a largest step is kept") {
    const auto growth = [](const State&, State& rate, double t) { rate[0] = 3 * t * t; };
    AdaptiveIntegrator y(growth, {0}, 0.1, {.largest_step = 0.25});
    while (y.time() < 5) {
        const double before = y.time();
        REQUIRE(y.step(5));
        CHECK(y.time() - before <= 0.25 + 1e-15);
    }
    CHECK(y.state()[0] == Approx(125).epsilon(1e-13));
}

TEST_CASE("What goes wrong in an integration is a status, and wrong options are refused") {
    MotionOptions few;
    few.most_steps = 5;
    auto y = oscillation(few);
    while (y.step(100)) {
    }
    CHECK(y.status() == MotionStatus::too_many_steps);
    CHECK(y.steps() == 5);
    CHECK(y.time() < 100);
    // it stays so
    CHECK(!y.step(100));
    CHECK(y.steps() == 5);

    // x' = x^2 from 1 ends at the time 1
    AdaptiveIntegrator blow([](const State& x, State& rate, double) { rate[0] = x[0] * x[0]; }, {1}, 0.01, {});
    while (blow.step(2)) {
    }
    CHECK((blow.status() == MotionStatus::step_too_small || blow.status() == MotionStatus::not_finite ||
           blow.status() == MotionStatus::too_many_steps));
    CHECK(blow.time() == Approx(1).margin(1e-6));

    AdaptiveIntegrator lost(oscillator, {std::numeric_limits<double>::quiet_NaN(), 0}, 0.01, {});
    CHECK(!lost.step(1));
    CHECK(lost.status() == MotionStatus::not_finite);

    CHECK_THROWS_WITH(oscillation({.most_steps = 0}), Catch::Matchers::Contains("most_steps = 0: must be positive"));
    CHECK_THROWS_AS(oscillation({.relative_tolerance = 0}), InvalidArgument);
}
