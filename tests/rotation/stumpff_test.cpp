// Stumpff's functions against their series in 50 digits, and the laws that tie them together.
#include <cmath>
#include <numbers>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <equilibria/core/dual.hpp>
#include <equilibria/rotation/stumpff.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

/// sum_j (-x)^j / (2 j + k)!
Wide series(double x, int k) {
    Wide term = 1, sum = 0;
    for (int j = 1; j <= k; ++j) term /= j;
    for (int j = 0; j < 200; ++j) {
        sum += term;
        term *= -Wide(x) / ((2 * j + k + 1) * (2 * j + k + 2));
    }
    return sum;
}

}  // namespace

TEST_CASE("Stumpff's functions are right to a few units in the last place") {
    for (double psi :
         {0.0, 1e-9, 1e-3, 0.5, 1.0, 2.0, 3.1, std::sqrt(10.0), 4.5, 6.0, 2 * std::numbers::pi, 6.7, 12.0}) {
        const double x = psi * psi;
        const auto c = stumpff<6>(x);
        for (int k = 0; k <= 6; ++k) {
            const double exact = static_cast<double>(series(x, k));
            // what a rounding of x changes: x dc_k/dx
            const double change =
                std::abs(static_cast<double>(k * series(x, k + 2) - (k ? series(x, k + 1) : Wide(0)))) * x +
                (k == 0 ? std::abs(std::sin(psi)) * psi : 0);
            CHECK(std::abs(c[k] - exact) < 4e-16 * (std::abs(exact) + change + (psi > 6.3 ? 1 : 0.1)));
        }
    }
}

TEST_CASE("Stumpff's functions obey their recurrence") {
    for (double x : {0.0, 0.3, 5.0, 20.0, 50.0}) {
        const auto c = stumpff<6>(x);
        double factorial = 1;
        for (int k = 0; k <= 4; ++k) {
            if (k > 1) factorial *= k;
            CHECK(c[k] + x * c[k + 2] == Approx(1 / factorial).margin(1e-14));
        }
        CHECK(c[0] * c[0] + x * c[1] * c[1] == Approx(1).margin(1e-14));
    }
}

TEST_CASE("Derivatives of Stumpff's functions are sums of the next two") {
    for (double x : {0.0, 0.4, 3.0, 15.0, 60.0}) {
        const auto c = stumpff<6>(Dual<double, 1>::variable(x, 0));
        for (int k = 1; k <= 4; ++k)
            CHECK(2 * c[k].derivative[0] == Approx(k * c[k + 2].value - c[k + 1].value).margin(1e-13));
    }
}
