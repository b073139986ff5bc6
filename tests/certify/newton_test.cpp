// Newton's method over exact coefficients: the digits of the scalar type, and NaN where there is no step.
#include <cmath>
#include <complex>

#include <equilibria/certify/newton.hpp>
#include <equilibria/core/multiprecision.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::TorquePendulum;  // stiffness sin(theta) = torque

template <class S>
BallSystem<S> pendulum(double torque, double stiffness) {
    return BallSystem<S>(ExactSystem<M>::at(Parameters<M>{{torque, stiffness}}));
}
template <class S>
auto start(const std::complex<double>& angle) {
    return complex_unknowns<S>({&angle, 1});
}

}  // namespace

TEST_CASE("a root has the digits of its scalar type") {
    using S = Multiprecision<68>;
    const auto system = pendulum<S>(1, 2);
    auto q = start<S>(0.5);
    CHECK(newton(system, q, 20) < 4 * rounding_unit<S>);
    CHECK(q[0].re > S(0.5235));  // pi / 6
    CHECK(q[0].re < S(0.5237));
    CHECK(abs(S(sin(q[0].re) - S(0.5))) < 8 * rounding_unit<S>);
    CHECK(abs(q[0].im) < 8 * rounding_unit<S>);
}

TEST_CASE("the convergence is quadratic: each step is of the size of the last one's square") {
    const auto system = pendulum<double>(1, 2);
    double before = 1;
    for (int most = 1; most <= 4; ++most) {
        auto q = start<double>(0.4);
        const double size = newton(system, q, most);
        CHECK(size < 2 * before * before);
        before = size;
    }
}

TEST_CASE("a root that is not real is found beside a real point with an imaginary part") {
    const auto system = pendulum<double>(4, 2);  // sin(theta) = 2: theta = pi/2 +- i arcosh(2)
    auto q = start<double>({1.5, 1});
    CHECK(newton(system, q, 20) < 1e-14);
    CHECK(q[0].re == Approx(std::acos(-1) / 2).epsilon(1e-14));
    CHECK(std::abs(q[0].im) == Approx(std::acosh(2)).epsilon(1e-14));
}

TEST_CASE("where the Jacobian is singular the size of the step is no number") {
    const auto system = pendulum<double>(1, 0);
    auto q = start<double>(0.5);
    CHECK_FALSE(newton(system, q, 5) < 1e3);
}
