#include <array>
#include <complex>

#include <equilibria/core/ball.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Big = Multiprecision<80>;

/// A ball and an exactly known member of it.
struct Member {
    Ball<double> ball;
    Complex<Big> value;
};

Big distance2(const Member& m) {
    const Complex<Big> d = m.value - Complex<Big>(Big(m.ball.mid.re), Big(m.ball.mid.im));
    return norm2(d);
}
bool holds(const Member& m) { return distance2(m) <= Big(m.ball.rad) * Big(m.ball.rad); }

Member draw(Generator& generator, double size, double rad) {
    const double re = uniform(generator, -size, size), im = uniform(generator, -size, size);
    const double r = rad * uniform(generator), phi = uniform(generator, 0, 6.28);
    const Complex<Big> off(Big(r) * Big(std::cos(phi)) * Big(0.999), Big(r) * Big(std::sin(phi)) * Big(0.999));
    return {{Complex<double>(re, im), r}, Complex<Big>(Big(re), Big(im)) + off};
}

Member combined(Generator& generator, const Member& a, const Member& b) {
    switch (generator() % 5) {
        case 0: return {a.ball + b.ball, a.value + b.value};
        case 1: return {a.ball - b.ball, a.value - b.value};
        case 2: return {-a.ball, -a.value};
        case 3: {
            const int k = static_cast<int>(generator() % 7) - 3;
            return {k * a.ball, Big(k) * a.value};
        }
        default: return {a.ball * b.ball, a.value * b.value};
    }
}

}  // namespace

TEST_CASE("random expressions: the exact value is a member of the ball") {
    Generator generator(1);
    for (const double rad : {0.0, 1e-14, 1e-3, 0.5})
        for (const double size : {1e-160, 1e-3, 1.0, 1e4})
            for (int run = 0; run < 200; ++run) {
                std::array<Member, 6> pool;
                for (auto& m : pool) m = draw(generator, size, rad * size);
                for (int step = 0; step < 12; ++step) {
                    const Member made = combined(generator, pool[generator() % 6], pool[generator() % 6]);
                    REQUIRE(holds(made));
                    pool[generator() % 6] = made;
                }
            }
}

TEST_CASE("the radius of a result from exact operands is a few roundings") {
    Generator generator(2);
    for (int run = 0; run < 1000; ++run) {
        const Member a = draw(generator, 1, 0), b = draw(generator, 1, 0);
        const double size = std::sqrt(norm2(a.ball.mid) * norm2(b.ball.mid));
        CHECK((a.ball * b.ball).rad < 5e-16 * 1.3 * size + 1e-300);
        CHECK((a.ball + b.ball).rad < 3e-16 * std::sqrt(norm2((a.ball + b.ball).mid)) + 1e-300);
    }
}

TEST_CASE("the inverse holds the inverse of each member, or all numbers") {
    Generator generator(3);
    int bounded = 0;
    for (int run = 0; run < 4000; ++run) {
        const Member a = draw(generator, 1, 0.5);
        const Ball<double> y = inverse(a.ball);
        if (std::isinf(y.rad)) continue;
        ++bounded;
        REQUIRE(holds({y, inverse(a.value)}));
    }
    CHECK(bounded > 2000);
    CHECK(std::isinf(inverse(Ball<double>(Complex<double>(0, 0))).rad));
    CHECK(std::isinf(inverse(Ball<double>(Complex<double>(0.5, 0), 0.6)).rad));
}

TEST_CASE("a magnitude bound is not below the magnitude, and close to it") {
    Generator generator(4);
    for (int run = 0; run < 1000; ++run) {
        const Complex<double> z(uniform(generator, -1, 1), uniform(generator, -1, 1));
        const double size = std::abs(std::complex<double>(z.re, z.im));
        CHECK(rounded_up(magnitude_bound(z)) >= size);
        CHECK(magnitude_bound(z) <= 1.12 * size);
    }
    const double nan = std::nan("");
    CHECK(std::isnan(magnitude_bound(Complex<double>(nan, 1))));
    CHECK(std::isnan(magnitude_bound(Complex<double>(1, nan))));
    CHECK_FALSE(magnitude_bound(Complex<double>(INFINITY, 1)) < 1e308);
}

TEST_CASE("lanes do what scalars do") {
    using Pack = Lanes<native_lanes>;
    Generator generator(5);
    Ball<Pack> a, b;
    std::array<Ball<double>, native_lanes> x, y;
    for (int k = 0; k < native_lanes; ++k) {
        const auto at = static_cast<std::size_t>(k);
        x[at] = draw(generator, 1, 0.1).ball;
        y[at] = draw(generator, 1, 0.1).ball;
        set_lane(a.mid, k, {x[at].mid.re, x[at].mid.im});
        set_lane(b.mid, k, {y[at].mid.re, y[at].mid.im});
        set_lane(a.rad, k, x[at].rad);
        set_lane(b.rad, k, y[at].rad);
    }
    const Ball<Pack> product = a * b, inverted = inverse(a);
    for (int k = 0; k < native_lanes; ++k) {
        const auto at = static_cast<std::size_t>(k);
        CHECK(lane(product.rad, k) == Approx((x[at] * y[at]).rad).epsilon(1e-12));
        CHECK(lane(inverted.rad, k) == Approx(inverse(x[at]).rad).epsilon(1e-12));
    }
}
