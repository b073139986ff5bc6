// The integrator with dense output: closed forms to the tolerance at the ends of steps and between them, the order of
// the pair, beginning again, copies, and where a solution ends.
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <equilibria/dynamics/dense_output_integrator.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using State = DenseOutputIntegrator::State;

/// x'' = -x as (x, x').
void oscillator(const State& y, State& rate, double) {
    rate[0] = y[1];
    rate[1] = -y[0];
}
double error_of(const State& y, double t) { return std::hypot(y[0] - std::cos(t), y[1] + std::sin(t)); }

}  // namespace

TEST_CASE("An oscillator is integrated to its tolerance at the ends of steps and between them") {
    std::size_t before = 0;
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
        CAPTURE(tolerance);
        DenseOutputIntegrator y({tolerance, tolerance});
        y.initialize({1, 0}, 0, 0.01);
        CHECK(y.time() == 0);
        CHECK(y.time_step() == 0.01);
        CHECK(y.state() == State{1, 0});
        std::size_t steps = 0;
        State between(2);
        while (y.time() < 20) {
            const double from = y.time();
            REQUIRE(y.step(oscillator));
            ++steps;
            CHECK(error_of(y.state(), y.time()) < 100 * tolerance);
            for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
                const double t = from + share * (y.time() - from);
                y.interpolate(t, between);
                CHECK(error_of(between, t) < 100 * tolerance);
            }
        }
        // an error of order 5 a step: a thousandth of the tolerance takes 1000^(1/5) = 4 times the steps
        if (before > 0) {
            CHECK(steps < 5 * before);
            CHECK(steps > 3 * before);
        }
        before = steps;
    }
}

TEST_CASE("With dense output too the rates may depend on the time, and a largest step is kept") {
    DenseOutputIntegrator y({.largest_step = 0.25});
    y.initialize({8}, 2, 0.1);
    while (y.time() < 5) {
        const double from = y.time();
        REQUIRE(y.step([](const State&, State& rate, double t) { rate[0] = 3 * t * t; }));
        CHECK(y.time() - from <= 0.25 + 1e-15);
        CHECK(y.state()[0] == Approx(std::pow(y.time(), 3)).epsilon(1e-13));
    }
}

TEST_CASE("A solution can begin again elsewhere, and a copy goes its own way") {
    DenseOutputIntegrator y(MotionOptions{});
    y.initialize({3, 4}, 0, 0.01);
    for (int k = 0; k < 5; ++k) REQUIRE(y.step(oscillator));
    y.initialize({1, 0}, 0, 0.02);
    CHECK(y.time() == 0);
    for (int k = 0; k < 5; ++k) REQUIRE(y.step(oscillator));
    CHECK(error_of(y.state(), y.time()) < 1e-10);

    const double time = y.time();
    const State state = y.state();
    DenseOutputIntegrator copy(y);
    for (int k = 0; k < 5; ++k) REQUIRE(copy.step(oscillator));
    CHECK(y.time() == time);
    CHECK(y.state() == state);
    for (int k = 0; k < 5; ++k) REQUIRE(y.step(oscillator));
    CHECK(y.time() == copy.time());
    CHECK(y.state() == copy.state());
    copy = y;
    CHECK(copy.state() == y.state());
    const DenseOutputIntegrator moved(std::move(copy));
    CHECK(moved.state() == y.state());
}

TEST_CASE("Where a solution ends no step is made, or one to what is no number, and wrong options are refused") {
    // x' = x^2 from 1 ends at the time 1
    DenseOutputIntegrator y(MotionOptions{});
    y.initialize({1}, 0, 0.01);
    const auto square = [](const State& x, State& rate, double) { rate[0] = x[0] * x[0]; };
    int steps = 0;
    while (steps < 100000 && y.step(square) && std::isfinite(y.state()[0])) ++steps;
    CHECK(steps < 100000);
    CHECK(y.time() == Approx(1).margin(1e-6));

    y.initialize({1}, 0, 0.01);
    const auto none = [](const State&, State& rate, double) { rate[0] = std::numeric_limits<double>::quiet_NaN(); };
    CHECK((!y.step(none) || std::isnan(y.state()[0])));
    CHECK_THROWS_AS(DenseOutputIntegrator({.relative_tolerance = 0}), InvalidArgument);
}
