#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/angles.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Pack = Lanes<native_lanes>;
constexpr double unit = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("the angle of a point keeps its digits far up and down the imaginary axis") {
    for (const double re : {-3.1, -1.0, 0.0, 0.5, 3.1})
        for (const double im : {-30.0, -3.0, -1e-9, 0.0, 1e-9, 3.0, 30.0}) {
            const std::complex<double> theta(re, im), c = std::cos(theta), s = std::sin(theta);
            const auto angle = angle_of(Complex<double>(c.real(), c.imag()), Complex<double>(s.real(), s.imag()));
            CHECK(std::abs(std::complex<double>(angle.re, angle.im) - theta) < 1e-14 * (1 + std::abs(im)));
        }
}

TEST_CASE("angles and logarithms in lanes are those of libm to three units in the last place") {
    Generator generator(3);
    double angle_error = 0, log_error = 0;
    bool within = true;
    for (int draw = 0; draw < 20000; ++draw) {
        Pack x, y;
        const double small = draw % 3 == 0 ? std::pow(10.0, -uniform(generator, 0, 15)) : 1;
        for (int k = 0; k < native_lanes; ++k) {
            set_lane(x, k, uniform(generator, -2, 2));
            set_lane(y, k, uniform(generator, -2, 2) * small);
        }
        const Pack angle = detail::angle_of_vector(x, y), logarithm = detail::logarithm(Pack(x * x + y * y));
        for (int k = 0; k < native_lanes; ++k) {
            const double a = lane(x, k), b = lane(y, k), expected = std::atan2(b, a), log = std::log(a * a + b * b);
            angle_error = std::max(angle_error, std::abs(lane(angle, k) - expected) / std::abs(expected));
            log_error = std::max(log_error, std::abs(lane(logarithm, k) - log) / std::max(1.0, std::abs(log)));
            within = within && std::abs(lane(angle, k)) <= std::numbers::pi;
        }
    }
    CHECK(angle_error < 3 * unit);
    CHECK(log_error < 3 * unit);
    CHECK(within);
}

TEST_CASE("angles on the axes") {
    const auto at = [](double x, double y) { return detail::angle_of_vector(x, y); };
    CHECK(at(1, 0) == 0);
    CHECK(at(-1, 0) == std::numbers::pi);
    CHECK(at(0, 1) == std::numbers::pi / 2);
    CHECK(at(0, -1) == -std::numbers::pi / 2);
    CHECK(at(1, 1) == std::numbers::pi / 4);
    CHECK(at(1e-300, 1e-310) == Approx(1e-10));
    CHECK(detail::logarithm(1.0) == 0);
    CHECK(detail::logarithm(std::numeric_limits<double>::max()) ==
          Approx(std::log(std::numeric_limits<double>::max())));
}
