#include <array>
#include <cmath>

#include <equilibria/core/constant_math.hpp>

#include "support/catch.hpp"

namespace cm = equilibria::constant_math;

namespace {

constexpr std::array arguments{0.01, 0.3, 0.75, 1.0, 1.5, 2.0, 3.14159, 4.7, 9.5};

template <class F>
constexpr auto table(F f) {
    std::array<double, arguments.size()> y{};
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = f(arguments[k]);
    return y;
}

}  // namespace

TEST_CASE("values at compile time are those at run time") {
    constexpr auto root = table([](double x) { return cm::sqrt(x); });
    constexpr auto exponential = table([](double x) { return cm::exp(x); });
    constexpr auto falling = table([](double x) { return cm::exp(-x); });
    constexpr auto logarithm = table([](double x) { return cm::log(x); });
    constexpr auto sine = table([](double x) { return cm::sin(x); });
    constexpr auto cosine = table([](double x) { return cm::cos(-x); });
    constexpr auto power = table([](double x) { return cm::pow(x, 1.7); });
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        const double x = arguments[k];
        CHECK(root[k] == Approx(std::sqrt(x)).epsilon(1e-15));
        CHECK(exponential[k] == Approx(std::exp(x)).epsilon(1e-14));
        CHECK(falling[k] == Approx(std::exp(-x)).epsilon(1e-14));
        CHECK(logarithm[k] == Approx(std::log(x)).epsilon(1e-15).margin(1e-16));
        CHECK(sine[k] == Approx(std::sin(x)).epsilon(1e-15).margin(2e-15));
        CHECK(cosine[k] == Approx(std::cos(x)).epsilon(1e-15).margin(2e-15));
        CHECK(power[k] == Approx(std::pow(x, 1.7)).epsilon(1e-14));
    }
}

TEST_CASE("corners") {
    STATIC_REQUIRE(cm::sqrt(0.0) == 0);
    STATIC_REQUIRE(cm::sqrt(4.0) == 2);
    STATIC_REQUIRE(cm::exp(0.0) == 1);
    STATIC_REQUIRE(cm::log(1.0) == 0);
    STATIC_REQUIRE(cm::sin(0.0) == 0);
    STATIC_REQUIRE(cm::cos(0.0) == 1);
    constexpr double large = cm::sqrt(1e300), tiny = cm::sqrt(1e-300);
    CHECK(large == Approx(1e150).epsilon(1e-15));
    CHECK(tiny == Approx(1e-150).epsilon(1e-15));
}

TEST_CASE("where generic parameters leave the domain, a constant expression goes on with the absolute value") {
    STATIC_REQUIRE(cm::sqrt(-4.0) == 2);
    STATIC_REQUIRE(cm::log(-1.0) == 0);
    const volatile double minus = -4;
    CHECK(std::isnan(cm::sqrt(minus)));
    CHECK(std::isnan(cm::log(minus)));
}

TEST_CASE("wider numbers are not cut down to doubles") {
    const volatile long double x = 2;
    CHECK(cm::sqrt(+x) == std::sqrt(+x));
    CHECK(cm::exp(+x) == std::exp(+x));
    CHECK(cm::sin(+x) == std::sin(+x));
    CHECK(cm::sqrt(+x) != static_cast<long double>(std::sqrt(2.0)));
}
