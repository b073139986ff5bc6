#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/model/angle.hpp>
#include <equilibria/model/model.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

CircleAngle<double> at(double theta) { return {std::cos(theta), std::sin(theta)}; }

/// The angle is expected on the circle.
void check(const CircleAngle<double>& a, double expected) {
    CHECK(cos(a) == Approx(std::cos(expected)).margin(1e-14));
    CHECK(sin(a) == Approx(std::sin(expected)).margin(1e-14));
}

}  // namespace

TEST_CASE("sums, differences, multiples and phases of angles") {
    Generator generator(1);
    for (int trial = 0; trial < 20; ++trial) {
        const double x = uniform(generator, -4, 4), y = uniform(generator, -4, 4), phase = uniform(generator, -4, 4);
        const auto a = at(x), b = at(y);
        check(+a, x);
        check(-a, -x);
        check(a + b, x + y);
        check(a - b, x - y);
        for (int k : {-3, -1, 0, 1, 2, 5}) {
            check(k * a, k * x);
            check(a * k, k * x);
        }
        check(3L * a - 2u * b, 3 * x - 2 * y);
        check(a + phase, x + phase);
        check(phase + a, x + phase);
        check(a - phase, x - phase);
        check(phase - a, phase - x);
        check(a + 1, x + 1);
        auto sum = a;
        sum += b;
        sum -= phase;
        sum -= 2 * a;
        check(sum, y - phase - x);
    }
}

TEST_CASE("corners: 0, a tiny angle, pi") {
    for (double x : {0.0, 1e-8, -1e-8, std::numbers::pi, -std::numbers::pi}) {
        check(at(x) - at(x), 0);
        check(2 * at(x), 2 * x);
        check(at(x) + std::numbers::pi, x + std::numbers::pi);
    }
    CHECK(sin(at(1e-8) - at(1e-9)) == Approx(9e-9).epsilon(1e-7));
}

TEST_CASE("angles over other scalars") {
    SECTION("complex angles: the addition formulas hold off the real circle") {
        using Z = std::complex<double>;
        const Z x(0.4, 1.1), y(-1.3, 0.2);
        const CircleAngle<Z> a(std::cos(x), std::sin(x)), b(std::cos(y), std::sin(y));
        CHECK(std::abs(cos(2 * a - b) - std::cos(2.0 * x - y)) < 1e-13);
        CHECK(std::abs(sin(0.7 - a) - std::sin(0.7 - x)) < 1e-13);
    }
    SECTION("packs of lanes") {
        using R = Lanes<native_lanes>;
        CircleAngle<Complex<R>> a;
        std::complex<double> x[native_lanes];
        for (int k = 0; k < native_lanes; ++k) {
            x[k] = {0.3 * k, 0.1 - 0.2 * k};
            set_lane(a.c, k, std::cos(x[k]));
            set_lane(a.s, k, std::sin(x[k]));
        }
        const auto s = sin(3 * a + 0.5);
        for (int k = 0; k < native_lanes; ++k) CHECK(std::abs(lane(s, k) - std::sin(3.0 * x[k] + 0.5)) < 1e-12);
    }
    SECTION("duals: d/dx sin(3 x + 0.2) = 3 cos(3 x + 0.2)") {
        using D = Dual<double, 1>;
        const double x = 0.8;
        CircleAngle<D> a(D(std::cos(x)), D(std::sin(x)));
        a.c.derivative[0] = -std::sin(x), a.s.derivative[0] = std::cos(x);
        const D s = sin(3 * a + 0.2);
        CHECK(s.value == Approx(std::sin(3 * x + 0.2)));
        CHECK(s.derivative[0] == Approx(3 * std::cos(3 * x + 0.2)));
        // a phase with a derivative
        const D phase = D::variable(0.2, 0);
        CHECK(sin(3 * a + phase).derivative[0] == Approx(4 * std::cos(3 * x + 0.2)));
    }
}

TEST_CASE("symbolic angles follow the same rules") {
    using Angle = SymbolicAngle<2, 0>;
    Angle::Pool pool;
    const Angle a(&pool, 0), b(&pool, 1);
    const auto value = [](const Angle::Scalar& f, double x, double y) {
        double sum = 0;
        const auto polynomial = f.polynomial();
        for (const auto& t : polynomial.terms()) {
            const auto factor = [](int k, double q) { return k >= 0 ? std::cos(k * q) : std::sin(-k * q); };
            sum += t.coefficient * factor(t.monomial.code(0), x) * factor(t.monomial.code(1), y);
        }
        return sum;
    };
    Generator generator(2);
    for (int trial = 0; trial < 10; ++trial) {
        const double x = uniform(generator, -3, 3), y = uniform(generator, -3, 3);
        const auto check = [&](const Angle& angle, double expected) {
            CHECK(value(cos(angle), x, y) == Approx(std::cos(expected)).margin(1e-13));
            CHECK(value(sin(angle), x, y) == Approx(std::sin(expected)).margin(1e-13));
        };
        check(a, x);
        check(-a + b, y - x);
        check(2 * a - 3 * b, 2 * x - 3 * y);
        check(a * 2 + 0.4, 2 * x + 0.4);
        check(2 * (a + 0.4) - b, 2 * x + 0.8 - y);
        check(0.4 - a, 0.4 - x);
        check(0 * a + 0.4, 0.4);
        check(Angle{}, 0);
        check(Angle{} + b, y);
        auto sum = a;
        sum += b;
        sum -= 0.1;
        check(sum, x + y - 0.1);
    }
}

TEST_CASE("what a model's function builds from angles may be kept in arrays, at compile time too") {
    constexpr int terms = [] {
        using Angle = SymbolicAngle<2, 0>;
        Angle::Pool pool;
        const std::array<Angle, 2> theta{Angle(&pool, 0), Angle(&pool, 1)};
        const auto equations = [](const auto& q) {
            std::array<scalar_of<decltype(q)>, 2> f{};
            for (std::size_t i = 0; i < 2; ++i) f[i] = sin(q[i]) + cos(q[1] - q[0]);
            return f;
        };
        const auto f = equations(theta), copy = f;
        return static_cast<int>(copy[0].polynomial().terms().size() + f[1].polynomial().terms().size());
    }();
    STATIC_REQUIRE(terms == 6);
}
