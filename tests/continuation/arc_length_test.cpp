#include <cmath>
#include <equilibria/continuation/arc_length.hpp>
#include <numbers>
#include <vector>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// x^2 / a^2 + y^2 / b^2 = 1.
struct Ellipse {
    static constexpr int unknowns = 2;
    using Vector = Eigen::Matrix<double, 2, 1>;
    double a, b;
    Eigen::Matrix<double, 1, 1> residual(const Vector& y) const {
        return Eigen::Matrix<double, 1, 1>(y(0) * y(0) / (a * a) + y(1) * y(1) / (b * b) - 1);
    }
    Eigen::Matrix<double, 1, 2> jacobian(const Vector& y) const { return {2 * y(0) / (a * a), 2 * y(1) / (b * b)}; }
};

/// The helix (cos s, sin s, s / 4) as the zero set of two equations.
struct Helix {
    static constexpr int unknowns = 3;
    using Vector = Eigen::Matrix<double, 3, 1>;
    Eigen::Matrix<double, 2, 1> residual(const Vector& y) const {
        return {y(0) - std::cos(4 * y(2)), y(1) - std::sin(4 * y(2))};
    }
    Eigen::Matrix<double, 2, 3> jacobian(const Vector& y) const {
        Eigen::Matrix<double, 2, 3> j;
        j << 1, 0, 4 * std::sin(4 * y(2)), 0, 1, -4 * std::cos(4 * y(2));
        return j;
    }
};

/// y^2 = x^3, which has a cusp of its own at 0: no unit tangent.
struct Semicubical {
    static constexpr int unknowns = 2;
    using Vector = Eigen::Matrix<double, 2, 1>;
    Eigen::Matrix<double, 1, 1> residual(const Vector& y) const {
        return Eigen::Matrix<double, 1, 1>(y(1) * y(1) - y(0) * y(0) * y(0));
    }
    Eigen::Matrix<double, 1, 2> jacobian(const Vector& y) const { return {-3 * y(0) * y(0), 2 * y(1)}; }
};

}  // namespace

TEST_CASE("An ellipse is followed around its four folds, and every point lies on it") {
    const Ellipse ellipse{2, 0.5};
    ArcLengthOptions options;
    options.largest_step = 0.05;
    const ArcLengthStepper<Ellipse> stepper(ellipse, {1, 1}, options);
    auto state = stepper.start({1.9, 0.2}, 1);
    REQUIRE(state);
    double length = 0, turned = 0;
    for (int k = 0; k < 100000 && turned < 2 * std::numbers::pi; ++k) {
        const auto next = stepper.advance(*state);
        REQUIRE(next);
        REQUIRE(std::abs(ellipse.residual(next->y)(0)) < 1e-12);
        REQUIRE(std::abs(next->tangent.norm() - 1) < 1e-12);
        REQUIRE(std::abs((ellipse.jacobian(next->y) * next->tangent)(0)) < 1e-10);
        REQUIRE(next->tangent.dot(state->tangent) > std::cos(options.largest_angle) - 1e-12);
        length += (next->y - state->y).norm();
        const auto& a = state->tangent;
        const auto& b = next->tangent;
        turned += std::abs(std::atan2(a(0) * b(1) - a(1) * b(0), a.dot(b)));
        state = next;
    }
    // the perimeter, 4 a E(1 - b^2 / a^2); chords of a step below 0.05 are shorter by less than a percent
    CHECK(length == Approx(8.578421775410756).epsilon(0.01));
}

TEST_CASE("Both directions of a curve run apart, and the predictor has second order") {
    const Helix helix;
    ArcLengthOptions options;
    const ArcLengthStepper<Helix> stepper(helix, {1, 1, 1}, options);
    const auto forward = stepper.start({1, 0, 0}, 1), backward = stepper.start({1, 0, 0}, -1);
    REQUIRE(forward);
    REQUIRE(backward);
    CHECK((forward->tangent + backward->tangent).norm() < 1e-12);
    double before = 0;
    for (const double h : {0.08, 0.04, 0.02, 0.01}) {
        const auto y = stepper.at(*forward, h);
        REQUIRE(y);
        const double error = (*y - (forward->y + h * forward->tangent)).norm();
        if (before > 0) CHECK(before / error == Approx(4).epsilon(0.05));
        before = error;
    }
}

TEST_CASE("A point with a given value of one unknown is found, or said not to be there") {
    const Ellipse ellipse{2, 0.5};
    const ArcLengthStepper<Ellipse> stepper(ellipse, {1, 1}, {});
    const auto y = stepper.where({1.1, 0.4}, 0, 1);
    REQUIRE(y);
    CHECK((*y)(0) == 1);
    CHECK((*y)(1) == Approx(0.5 * std::sqrt(0.75)).epsilon(1e-14));
    CHECK_FALSE(stepper.where({1.9, 0.1}, 0, 2.5));
}

TEST_CASE("A curve that ends in a singular point stops with no state, not with a wrong one") {
    const Semicubical system;
    const ArcLengthStepper<Semicubical> stepper(system, {1, 1}, {});
    auto state = stepper.start({1, 1}, 1);
    REQUIRE(state);
    if (state->tangent(0) > 0) state->tangent = -state->tangent;
    std::size_t points = 0;
    for (auto next = stepper.advance(*state); next && points < 100000; next = stepper.advance(*state), ++points) {
        REQUIRE(std::abs(system.residual(next->y)(0)) < 1e-10);
        state = next;
        if (state->y(0) > 2) break;
    }
    CHECK(points < 100000);
}

TEST_CASE("Options out of range are refused with name, value and range") {
    ArcLengthOptions options;
    options.largest_step = -1;
    CHECK_THROWS_WITH(options.validate(), Catch::Matchers::Contains("largest_step = -1"));
}
