#include <complex>
#include <numbers>

#include <equilibria/enumerate/classify.hpp>
#include <equilibria/evaluation/point.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using std::numbers::pi;
using M = models::Pendulum;

namespace {

Root<M> root(std::complex<double> theta, double condition = 1) {
    Root<M> r;
    r.q[0] = theta;
    r.condition = condition;
    return r;
}

bool is_real(const Parameters<M>& p, const Root<M>& root, Unknowns<M>& q) {
    const detail::RealModelEquations<M> equations(p);
    return detail::RootClassifier(equations).is_real(detail::view(root), {q.begin(), q.end()});
}

}  // namespace

TEST_CASE("the angle of a point keeps its digits far up and down the imaginary axis") {
    for (const double re : {-3.1, -1.0, 0.0, 0.5, 3.1})
        for (const double im : {-30.0, -3.0, -1e-9, 0.0, 1e-9, 3.0, 30.0}) {
            const std::complex<double> theta(re, im), c = std::cos(theta), s = std::sin(theta);
            const auto angle = equilibria::angle_of({c.real(), c.imag()}, {s.real(), s.imag()});
            CHECK(std::abs(angle - theta) < 1e-14 * (1 + std::abs(im)));
        }
}

TEST_CASE("a root is real if its imaginary part is rounding, and only then") {
    Unknowns<M> q;
    const Parameters<M> p{0.5};
    const double theta = std::asin(0.5);
    CHECK(is_real(p, root({theta, 0}), q));
    CHECK(q[0] == Approx(theta).margin(1e-15));
    CHECK(is_real(p, root({theta + 1e-13, 1e-13}), q));
    CHECK(q[0] == Approx(theta).margin(1e-15));
    CHECK_FALSE(is_real(p, root({theta, 1e-7}), q));
    CHECK_FALSE(is_real(p, root({theta, 0.5}), q));
    // sin theta = 1 + 1e-12: no real root, but pi/2 + 1.4e-6 i, of condition 1e6
    const Parameters<M> beyond{1 + 1e-12};
    CHECK_FALSE(is_real(beyond, root({pi / 2, std::acosh(1 + 1e-12)}, 1e6), q));
    // sin theta = 1 - 1e-12: two real roots, the imaginary parts being rounding times the condition
    const Parameters<M> below{1 - 1e-12};
    CHECK(is_real(below, root({pi / 2 + std::acos(1 - 1e-12), 1e-11}, 1e6), q));
}

TEST_CASE("real angles are above -pi and at most pi") {
    Unknowns<M> q;
    for (const double start : {pi, -pi, pi + 1e-9, -pi - 1e-9}) {
        CHECK(is_real({0}, root({start, 0}), q));
        CHECK(q[0] > -pi);
        CHECK(q[0] <= pi);
        CHECK(std::abs(q[0]) == Approx(pi));
    }
}
