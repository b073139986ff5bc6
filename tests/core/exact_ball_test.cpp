#include <cstdint>
#include <limits>
#include <vector>

#include <equilibria/core/exact_ball.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Big = Multiprecision<200>;

/// |value - midpoint| <= radius, to the digits of Big.
bool holds(const ExactBall& a, const Big& value) { return abs(value - a.mid().to<Big>()) <= Big(a.rad()); }

}  // namespace

TEST_CASE("integers of 64 bits keep their value, signed or not") {
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    constexpr auto least = std::numeric_limits<std::int64_t>::min();
    CHECK(Dyadic(most) == Dyadic(0x1p64) - Dyadic(1));
    CHECK(Dyadic(least) == Dyadic(-0x1p63));
    CHECK((ExactBall(most) - ExactBall(0x1p64)).mid() == Dyadic(-1));
}

TEST_CASE("sums and products of doubles are exact, and what cancels is 0") {
    Generator generator(1);
    for (int run = 0; run < 100; ++run) {
        const double a = uniform(generator, -1, 1), b = uniform(generator, -1e-9, 1e9), c = uniform(generator, -1, 1);
        const ExactBall x(a), y(b), z(c);
        const ExactBall rest = (x + y) * (x - y) * z - (x * x * z - y * y * z);
        CHECK(rest == 0);
        CHECK((x * y).exact());
        CHECK(holds(x * y + z, Big(a) * Big(b) + Big(c)));
    }
    CHECK(ExactBall(0.1) + ExactBall(0.2) - ExactBall(0.3) != 0);  // the doubles, not the decimals
}

TEST_CASE("quotients and functions hold the value to 100 digits") {
    Generator generator(2);
    for (int run = 0; run < 20; ++run) {
        const double a = uniform(generator, 0.1, 3), b = uniform(generator, -3, 3);
        const ExactBall x(a), y(b);
        const auto check = [](const ExactBall& ball, const Big& value) {
            CHECK(holds(ball, value));
            CHECK(ball.rad() < 1e-97);
        };
        check(x / y, Big(a) / Big(b));
        check(sqrt(x), sqrt(Big(a)));
        check(sin(y), sin(Big(b)));
        check(cos(y), cos(Big(b)));
        check(exp(y), exp(Big(b)));
        check(log(x), log(Big(a)));
    }
    CHECK(sin(ExactBall(0)) == 0);
    CHECK(cos(ExactBall(0)) == 1);
}

TEST_CASE("functions of intervals hold the value at each member") {
    Generator generator(3);
    for (int run = 0; run < 50; ++run) {
        const double low = uniform(generator, 0.2, 2), high = low + uniform(generator, 0, 0.1);
        const ExactBall x = ExactBall::between(low, high);
        for (int k = 0; k <= 8; ++k) {
            const double at = std::min(high, low + k * (high - low) / 8);
            CHECK(holds(x, Big(at)));
            CHECK(holds(x * x - x, Big(at) * Big(at) - Big(at)));
            CHECK(holds(1 / x, 1 / Big(at)));
            CHECK(holds(sqrt(x), sqrt(Big(at))));
            CHECK(holds(sin(x) + log(x), sin(Big(at)) + log(Big(at))));
            CHECK(holds(exp(x), exp(Big(at))));
        }
    }
}

TEST_CASE("enclosures over floating-point types") {
    Generator generator(4);
    for (int run = 0; run < 100; ++run) {
        const double a = uniform(generator, -1, 1), b = uniform(generator, -1, 1);
        const ExactBall product = ExactBall(a) * ExactBall(b) * ExactBall(a);
        const Ball<double> d = product.enclosure<double>();
        CHECK(abs(Big(a) * Big(b) * Big(a) - Big(d.mid.re)) <= Big(d.rad));
        CHECK(d.rad < 1e-15 * std::abs(d.mid.re) + 1e-300);
        CHECK(ExactBall(a).enclosure<double>().rad == 0);
        CHECK(product.enclosure<Multiprecision<68>>().rad == Multiprecision<68>(0));
    }
}

TEST_CASE("what cannot be computed is refused with the number") {
    CHECK_THROWS_WITH(ExactBall(1) / ExactBall(0), "model = 0: divides by a number that may be 0 at these parameters");
    CHECK_THROWS_AS(ExactBall(1) / ExactBall::between(-1, 2), InvalidArgument);
    CHECK_THROWS_AS(sqrt(ExactBall(-1)), InvalidArgument);
    CHECK_THROWS_AS(log(ExactBall(0)), InvalidArgument);
    CHECK_THROWS_AS((ExactBall(1e200) * ExactBall(1e200)).enclosure<double>(), InvalidArgument);
}
