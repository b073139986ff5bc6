#include <cmath>

#include <equilibria/core/dual.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using D = Dual<double, 2>;
using Wide = Dual<long double, 1>;

}  // namespace

TEST_CASE("the rules of differentiation") {
    Generator generator(1);
    for (int trial = 0; trial < 20; ++trial) {
        const double a = uniform(generator, 0.2, 2), b = uniform(generator, 0.2, 2);
        const D x = D::variable(a, 0), y = D::variable(b, 1);
        const auto check = [](const D& f, double value, double by_x, double by_y) {
            CHECK(f.value == Approx(value));
            CHECK(f.derivative[0] == Approx(by_x).margin(1e-14));
            CHECK(f.derivative[1] == Approx(by_y).margin(1e-14));
        };
        check(x + y, a + b, 1, 1);
        check(x - 2 * y, a - 2 * b, 1, -2);
        check(-x, -a, -1, 0);
        check(x * y, a * b, b, a);
        check(x / y, a / b, 1 / b, -a / (b * b));
        check(1 / x, 1 / a, -1 / (a * a), 0);
        check(x / 4, a / 4, 0.25, 0);
        check(sin(x * y), std::sin(a * b), b * std::cos(a * b), a * std::cos(a * b));
        check(cos(x + y), std::cos(a + b), -std::sin(a + b), -std::sin(a + b));
        check(exp(2 * x), std::exp(2 * a), 2 * std::exp(2 * a), 0);
        check(log(x * x), std::log(a * a), 2 / a, 0);
        check(sqrt(y), std::sqrt(b), 0, 0.5 / std::sqrt(b));
        check(atan2(x, y), std::atan2(a, b), b / (a * a + b * b), -a / (a * a + b * b));
        check(pow(x, 3), a * a * a, 3 * a * a, 0);
        check(pow(x, 0), 1, 0, 0);
        check(pow(x, -2), 1 / (a * a), -2 / (a * a * a), 0);
        check(pow(y, 2u), b * b, 0, 2 * b);
        check(pow(x, 0.5), std::sqrt(a), 0.5 / std::sqrt(a), 0);  // and not pow(x, 0)
        check(pow(x, 1.5), std::pow(a, 1.5), 1.5 * std::sqrt(a), 0);
        D z = x;
        z += y, z *= x, z -= 3, z /= y;
        check(z, ((a + b) * a - 3) / b, (2 * a + b) / b, a / b - ((a + b) * a - 3) / (b * b));
    }
}

TEST_CASE("nested duals give second derivatives") {
    using D1 = Dual<double, 1>;
    using D2 = Dual<D1, 1>;
    const double a = 0.7;
    D2 x(D1::variable(a, 0));
    x.derivative[0] = D1(1.0);
    const D2 f = sin(x) * exp(2 * x) / (1 + x * x) + 0.5;
    const auto plain = [](double t) { return std::sin(t) * std::exp(2 * t) / (1 + t * t) + 0.5; };
    const double h = 1e-4;
    CHECK(f.value.value == Approx(plain(a)));
    CHECK(f.derivative[0].value == Approx(f.value.derivative[0]).epsilon(1e-15));
    CHECK(f.derivative[0].derivative[0] ==
          Approx((plain(a + h) - 2 * plain(a) + plain(a - h)) / (h * h)).epsilon(1e-6));
}

TEST_CASE("numbers enter long doubles with all their digits") {
    const long double third = 1 / 3.0L;
    const Wide x = Wide::variable(1.0L, 0);
    for (const Wide& f : {third * x, x * third, x / 3.0L, x - 1 + third}) CHECK(std::abs(f.value - third) < 1e-19L);
    CHECK(std::abs((third * x).derivative[0] - third) == 0);
    CHECK(std::abs(pow(x + 1, third).value - std::cbrt(2.0L)) < 1e-18L);
    using Nested = Dual<Wide, 1>;
    CHECK(Nested(third).value.value == third);
}

TEST_CASE("duals in constant expressions") {
    constexpr D f = [] {
        const D x = D::variable(3.0, 0), y = D::variable(2.0, 1);
        return (x * x - y) / y + pow(y, 3);
    }();
    STATIC_REQUIRE(f.value == 11.5);
    STATIC_REQUIRE(f.derivative[0] == 3);
    STATIC_REQUIRE(f.derivative[1] == -9.0 / 4 + 12);
}

TEST_CASE("a quotient by a plain number has all the digits of the scalar") {
    using S = Multiprecision<40>;
    const Dual<S, 1> x = Dual<S, 1>::variable(S(1.0), 0), third = x / 3;
    CHECK(abs(3 * third.value - 1) < S(1e-38));
    CHECK(abs(3 * third.derivative[0] - 1) < S(1e-38));
}
