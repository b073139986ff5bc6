#include <cmath>
#include <complex>
#include <type_traits>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;
using Pack = Lanes<native_lanes>;

namespace {

template <class R>
double tolerance() {
    return std::is_same_v<R, long double> ? 1e-17 : 1e-14;
}

/// Some numbers, another one in each lane.
template <class R>
Complex<R> draw(Generator& generator) {
    Complex<R> z;
    for (int k = 0; k < LaneTraits<R>::width; ++k)
        set_lane(z, k, Z(uniform(generator, -2, 2), uniform(generator, -2, 2)));
    return z;
}

/// The largest absolute value of a lane.
template <class R>
double size(const Complex<R>& z) {
    double largest = 0;
    for (int k = 0; k < LaneTraits<R>::width; ++k) largest = std::max(largest, std::abs(lane(z, k)));
    return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("complex numbers are a field", "", double, long double, Pack) {
    using R = TestType;
    Generator generator(1);
    for (int trial = 0; trial < 20; ++trial) {
        const auto a = draw<R>(generator), b = draw<R>(generator), c = draw<R>(generator);
        CHECK(size(a + b - b - a) < tolerance<R>());
        CHECK(size(a * b - b * a) == 0);
        CHECK(size((a * b) * c - a * (b * c)) < 10 * tolerance<R>());
        CHECK(size(a * (b + c) - (a * b + a * c)) < 10 * tolerance<R>());
        CHECK(size((a / b) * b - a) < 10 * tolerance<R>());
        CHECK(size(inverse(a) * a - 1.0) < 10 * tolerance<R>());
        CHECK(size(conj(a * b) - conj(a) * conj(b)) == 0);
        CHECK(size(a * conj(a) - Complex<R>(norm2(a), broadcast<R>(0.0))) < tolerance<R>());
        CHECK(size(-a + a) == 0);
        auto d = a;
        d += b, d -= c, d *= b;
        CHECK(size(d - (a + b - c) * b) == 0);
    }
}

TEMPLATE_TEST_CASE("each lane is std::complex", "", double, Pack) {
    using R = TestType;
    Generator generator(2);
    for (int trial = 0; trial < 20; ++trial) {
        const auto a = draw<R>(generator), b = draw<R>(generator);
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            const Z x = lane(a, k), y = lane(b, k);
            CHECK(std::abs(lane(a * b, k) - x * y) < 1e-14);
            CHECK(std::abs(lane(a / b, k) - x / y) < 1e-13 * std::abs(x / y));
            CHECK(std::abs(lane(2.0 * a + 1.0, k) - (2.0 * x + 1.0)) < 1e-14);
            CHECK(std::abs(lane(1.0 - a * 0.5, k) - (1.0 - 0.5 * x)) < 1e-14);
            CHECK(std::abs(lane(a - 3.0, k) - (x - 3.0)) < 1e-14);
            CHECK(std::abs(lane(a / 4.0, k) - x / 4.0) < 1e-14);
            CHECK(std::abs(lane(1.0 / a, k) - 1.0 / x) < 1e-13 / std::abs(x));
            // whole numbers, as a model's function has them
            CHECK(std::abs(lane(2 * a - 1, k) - (2.0 * x - 1.0)) < 1e-14);
            CHECK(std::abs(lane(1 + a, k) - (1.0 + x)) < 1e-14);
            CHECK(lane(Complex<R>(2.5), k) == Z(2.5));
        }
    }
}

TEST_CASE("lanes are set, read and chosen one by one") {
    auto a = broadcast_complex<Pack>({1, -1});
    const auto b = broadcast_complex<Pack>({3, 4});
    set_lane(a, native_lanes - 1, {5, 6});
    CHECK(lane(a, native_lanes - 1) == Z(5, 6));
    CHECK(lane(a, 0) == Z(1, -1));
    const auto larger = select(norm2(a) < norm2(b), b, a);
    for (int k = 0; k < native_lanes; ++k) CHECK(lane(larger, k) == (k == native_lanes - 1 ? Z(5, 6) : Z(3, 4)));
    CHECK(lane(select(true, Complex<double>(1, 2), Complex<double>(3, 4)), 0) == Z(1, 2));

    Pack x = broadcast<Pack>(2.0);
    set_lane(x, 1, -7.0);
    CHECK(lane(lane_max(x, broadcast<Pack>(0.0)), 1) == 0);
    CHECK(lane(lane_min(x, broadcast<Pack>(0.0)), 1) == -7);
    CHECK(lane_max(1.0, 2.0) == 2.0);
    STATIC_REQUIRE(LaneTraits<Pack>::width == native_lanes);
    STATIC_REQUIRE(LaneTraits<double>::width == 1);
    STATIC_REQUIRE(is_pack<Pack>);
    STATIC_REQUIRE_FALSE(is_pack<long double>);
}

TEST_CASE("a number divided by zero is not a finite one: acceptance tests refuse it") {
    const auto a = inverse(Complex<double>(0, 0));
    CHECK_FALSE(norm2(a) < 1e300);
}

TEST_CASE("the square root is the one with a real part that is not negative, in every lane") {
    Generator generator(5);
    for (int k = 0; k < 1000; ++k) {
        const Complex<double> z(uniform(generator, -2, 2), uniform(generator, -2, 2)), root = sqrt(z);
        const std::complex<double> expected = std::sqrt(std::complex<double>(z.re, z.im));
        CHECK(std::abs(root.re - expected.real()) < 1e-15);
        CHECK(std::abs(root.im - expected.imag()) < 1e-15);
    }
    CHECK(sqrt(Complex<double>(0.0)).re == 0);
    CHECK(sqrt(Complex<double>(-4.0)).im == 2);
    Complex<Pack> z;
    for (int k = 0; k < native_lanes; ++k) set_lane(z, k, {k - 0.5, 1.0 - k});
    const Complex<Pack> root = sqrt(z);
    for (int k = 0; k < native_lanes; ++k) CHECK(std::abs(lane(root, k) - std::sqrt(lane(z, k))) < 1e-15);
}
