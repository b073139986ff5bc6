// An arc through three points: on a circle, with unit speed, and its clearance as a scan over the directions finds it.
#include <cmath>
#include <numbers>

#include <equilibria/core/random.hpp>
#include <equilibria/fem/arc.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using fem::Arc;

namespace {

Eigen::Vector3d draw(Generator& generator) {
    Eigen::Vector3d v;
    for (double& x : v) x = uniform(generator, -1, 1);
    return v;
}

}  // namespace

TEST_CASE("an arc goes from its first point by way of the second to the third") {
    Generator generator(1);
    for (int round = 0; round < 20; ++round) {
        const Eigen::Vector3d a = draw(generator), m = draw(generator), b = draw(generator);
        const auto arc = Arc::through(a, m, b);
        REQUIRE(arc);
        CHECK((arc->at(0) - a).norm() < 1e-12);
        CHECK((arc->at(1) - b).norm() < 1e-10 * (1 + arc->radius));
        CHECK((arc->direction(0) - arc->tangent).norm() < 1e-15);
        const Eigen::Vector3d center = a + arc->radius * arc->inwards;
        CHECK(std::abs((m - center).norm() - arc->radius) < 1e-10 * arc->radius);
        // m at the angle that its chord from a subtends
        const double t = 2 * std::asin(std::min(1.0, (m - a).norm() / (2 * arc->radius))) / arc->angle;
        const double reflex = (2 * std::numbers::pi / arc->angle) - t;
        const double error =
            std::min((arc->at(t) - m).norm(), reflex <= 1 ? (arc->at(reflex) - m).norm() : arc->radius);
        CHECK(error < 1e-6 * arc->radius);
        const double h = 1e-5;
        for (const double at : {0.2, 0.7}) {
            const Eigen::Vector3d speed = (arc->at(at + h) - arc->at(at - h)) / (2 * h * arc->radius * arc->angle);
            CHECK((speed - arc->direction(at)).norm() < 1e-8);
            CHECK(std::abs(arc->direction(at).norm() - 1) < 1e-14);
        }
    }
}

TEST_CASE("a quarter of a circle has its radius, angle and normal") {
    const double r = std::sqrt(0.5);
    const auto arc = Arc::through({1, 0, 0}, {r, r, 0}, {0, 1, 0});
    REQUIRE(arc);
    CHECK(arc->radius == Approx(1).epsilon(1e-14));
    CHECK(arc->angle == Approx(std::numbers::pi / 2).epsilon(1e-14));
    CHECK((arc->normal - Eigen::Vector3d::UnitZ()).norm() < 1e-14);
}

TEST_CASE("points on a line, or that coincide, have no arc") {
    CHECK_FALSE(Arc::through({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
    CHECK_FALSE(Arc::through({0, 0, 0}, {0, 0, 0}, {2, 2, 2}));
    CHECK_FALSE(Arc::through({0, 0, 0}, {1, 0, 0}, {0, 0, 0}));
    CHECK_FALSE(Arc::through({0, 0, 0}, {1, INFINITY, 0}, {2, 0, 0}));
}

TEST_CASE("the clearance is the least angle to a direction of the arc, or its opposite") {
    Generator generator(2);
    for (int round = 0; round < 20; ++round) {
        const auto arc = Arc::through(draw(generator), draw(generator), draw(generator));
        REQUIRE(arc);
        const Eigen::Vector3d v = draw(generator);
        double least = 4;
        const int steps = 20000;
        for (int k = 0; k <= steps; ++k) {
            const double cosine = std::abs(arc->direction(k / double(steps)).dot(v.normalized()));
            least = std::min(least, std::acos(std::min(1.0, cosine)));
        }
        CHECK(arc->clearance(v) == Approx(least).margin(1e-3));
        CHECK(arc->clearance(v) <= least + 1e-7);
    }
}
