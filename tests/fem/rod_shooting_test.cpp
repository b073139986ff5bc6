#include <cmath>
#include <numbers>
#include <vector>

#include "fem/reference_paths.hpp"
#include "support/catch.hpp"
#include "support/rod_shooting.hpp"

using namespace rods;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double degree = pi / 180;
const Vector3d e1 = Vector3d::UnitX(), e3 = Vector3d::UnitZ();

/// Inextensible and unshearable, EI = 1.
constexpr Section kirchhoff{rigid, rigid, rigid, 1, 1, 1};

/// A column in the plane along x, pressed by p at its end, which, if guided, moves along x alone.
Shooting column(const Section& section, Support first, bool guided) {
    return {3, {Leg{1, section}}, planar_start(first, 0), [=](const State<Number>& end, const Number& p) -> Numbers {
                return {end.n(0) + p, guided ? end.r(1) : end.n(1), end.m(2)};
            }};
}

void check_position(const Shooting& rod, const Point& at, const Vector3d& expected, double tolerance) {
    const Vector3d r = rod.states(at).back().r;
    CAPTURE(r.transpose(), expected.transpose());
    CHECK((r - expected).cwiseAbs().maxCoeff() < tolerance);
}

}  // namespace

TEST_CASE("shooting: Euler columns") {
    const auto critical = [](const Section& section, Support first, bool guided, double most) {
        return column(section, first, guided).first_bifurcation(most, 8).at.p();
    };
    CHECK(critical(kirchhoff, Support::clamped, false, 4) == Approx(pi * pi / 4).epsilon(1e-12));
    CHECK(critical(kirchhoff, Support::hinged, true, 15) == Approx(pi * pi).epsilon(1e-12));
    CHECK(critical(kirchhoff, Support::clamped, true, 30) == Approx(20.190728556).epsilon(1e-10));
    CHECK(critical({1e4, 5e3, 5e3, 1, 1, 1}, Support::clamped, false, 4) == Approx(2.4667925937).epsilon(1e-10));
    CHECK(critical({1e3, 4e2, 4e2, 1, 1, 1}, Support::clamped, false, 4) == Approx(2.45833597661).epsilon(2e-12));
}

TEST_CASE("shooting: a column under its own weight") {
    Leg leg{1, {rigid, rigid, rigid, 1, 1, 2}};
    leg.load = -e1;
    // 9/4 times the square of the first zero of the Bessel function of order -1/3
    CHECK(cantilever({leg}, Vector3d::Zero()).first_bifurcation(12, 6).at.p() ==
          Approx(2.25 * std::pow(1.866350858873895, 2)).epsilon(1e-12));
}

TEST_CASE("shooting: the elastica") {
    const Shooting rod = column(kirchhoff, Support::clamped, false);
    const Measure angle = [](const auto& states, const Number&) {
        const auto& q = states.back().q;
        return 2.0 * atan2(q.z(), q.w());
    };
    const Critical euler = rod.first_bifurcation(4, 8);
    Point at = rod.leave(euler, angle, 20 * degree);
    for (const auto& y : references::elastica) {
        at = rod.follow(at, angle, y[0] * degree, 4).back();
        CHECK(at.p() / euler.at.p() == Approx(y[1]).epsilon(1e-11));
        check_position(rod, at, {y[2], y[3], 0}, 1e-11);
    }
}

TEST_CASE("shooting: lateral buckling of a cantilever, and its post-critical branch") {
    const auto rod = [](double ei3) {
        return cantilever({Leg{1, {rigid, rigid, rigid, 1.343, 1, ei3}}}, -Vector3d::UnitY());
    };
    CHECK(rod(rigid).first_bifurcation(6, 6).at.p() == Approx(4.012599343578901 * std::sqrt(1.343)).epsilon(1e-12));

    const Shooting strip = rod(25);
    const Critical critical = strip.first_bifurcation(6, 6);
    CHECK(critical.at.p() == Approx(references::lateral_critical_load).epsilon(1e-11));
    Point at = strip.leave(critical, position(2, 0), .1);
    for (const auto& y : references::lateral_cantilever) {
        at = strip.solve(at, position(2, 0), y[0]);
        CHECK(at.p() / critical.at.p() == Approx(y[1]).epsilon(1e-9));
        check_position(strip, at, {y[2], y[3], y[0]}, 6e-8);
    }
}

TEST_CASE("shooting: right-angle frame, and its post-critical branch") {
    const Shooting rod = cantilever(right_angle_frame(), e1);
    const Critical critical = rod.first_bifurcation(1.2, 6);
    CHECK(critical.at.p() == Approx(references::right_angle_critical_load).epsilon(1e-10));
    Point at = rod.leave(critical, position(2, 1), 10);
    for (const auto& y : references::right_angle_frame) {
        at = rod.follow(at, position(2, 1), y[0], 2).back();
        CHECK(at.p() == Approx(y[1]).epsilon(1e-9));
    }
    const Shooting coarse = cantilever(right_angle_frame(16), e1);
    CHECK(coarse.first_bifurcation(1.2, 6).at.p() == Approx(critical.at.p()).epsilon(1e-11));
}

TEST_CASE("shooting: hinged right-angle frame under end moments") {
    const auto rod = [](double sign) {
        return Shooting(
            6, right_angle_frame(),
            [=](const Numbers& u, const Number& p) {
                State<Number> y;
                y.q = rotation<Number>(e3, pi / 4 + u[3]);
                y.n << u[0], u[1], u[2];
                y.m << u[4], u[5], sign * p;
                return y;
            },
            [=](const State<Number>& end, const Number& p) -> Numbers {
                return {end.r(1), end.r(2), end.n(0), end.q.x(), end.q.y(), end.m(2) - sign * p};
            });
    };
    CHECK(rod(-1).first_bifurcation(640, 32).at.p() == Approx(622.22166).epsilon(1e-8));
    const Shooting forwards = rod(1);
    const auto crossings = forwards.crossings(forwards.follow(forwards.unloaded(), load(), 640, 64));
    REQUIRE(crossings.size() == 2);
    CHECK(forwards.bifurcation(crossings[0]).at.p() == Approx(622.22186).epsilon(1e-8));
    CHECK(forwards.bifurcation(crossings[1]).at.p() == Approx(631.56664).epsilon(1e-8));
}

TEST_CASE("shooting: folds of a deep arch") {
    const auto fold = [](double ea) {
        const Shooting rod = arch({ea, ea, ea, 1, 1, 1e6}, 100, 215 * degree, Support::clamped, Support::hinged);
        const auto crossings = rod.crossings(rod.follow(rod.unloaded(), position(1, 0), 14, 30));
        REQUIRE(crossings.size() == 1);
        return rod.fold(crossings[0]).at.p();
    };
    CHECK(fold(rigid) == Approx(897.308997).epsilon(2e-9));
    CHECK(fold(1e8) == Approx(897.289134).epsilon(1e-9));
}

TEST_CASE("shooting: sway and fold of a half-circle on hinges") {
    const Shooting rod = arch(kirchhoff, 1, pi, Support::hinged, Support::hinged);
    const auto crossings = rod.crossings(rod.follow(rod.unloaded(), position(1, 0), .24, 20));
    REQUIRE(crossings.size() == 2);
    const Critical sway = rod.bifurcation(crossings[0]);
    CHECK(sway.at.p() == Approx(5.86053763).epsilon(1e-9));
    CHECK(std::abs(sway.unfolding) < 1e-11);
    CHECK(rod.fold(crossings[1]).at.p() == Approx(10.15034386).epsilon(1e-9));
}

TEST_CASE("shooting: a clamped rod buckles under torsion") {
    // half of it, symmetric under a half turn about y through its middle; the ends turn by -p/2 and p/2
    const double gj = 0.7;
    const Shooting rod(
        6, {Leg{.5, {rigid, rigid, rigid, gj, 1, 1}}},
        [](const Numbers& u, const Number& p) {
            return State<Number>{{}, rotation<Number>(e1, -0.5 * p), {u[0], u[1], u[2]}, {u[3], u[4], u[5]}};
        },
        [](const State<Number>& middle, const Number&) -> Numbers {
            return {middle.r(2), middle.q.x(), middle.q.z(), middle.n(0), middle.n(1), middle.m(1)};
        });
    CHECK(gj * rod.first_bifurcation(14, 7).at.p() == Approx(8.986818916).epsilon(1e-10));
}

TEST_CASE("shooting: 45-degree bend") {
    const double e = 1e7;
    const Leg leg{100 * pi / 4, {e, e / 2, e / 2, e / 12, e / 12, e / 12}, {0, 0, .01}};
    const Shooting rod = cantilever({leg}, e3);
    Point at = rod.unloaded();
    for (const auto& y : references::bend) {
        at = rod.follow(at, load(), y[0], 3).back();
        check_position(rod, at, {y[1], y[2], y[3]}, 6e-9);
    }
}
