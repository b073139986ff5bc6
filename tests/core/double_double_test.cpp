// Sums of two doubles: relative errors against 60 digits, within the bounds of Joldes, Muller and Popescu (2017).
#include <cmath>
#include <limits>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Exact = Multiprecision<70>;

Exact exact(const DoubleDouble& a) { return Exact(a.high()) + Exact(a.low()); }

/// Relative errors in units of 2^-106.
double error(const DoubleDouble& computed, const Exact& right) {
    return static_cast<double>(ldexp(abs(exact(computed) - right) / abs(right), 106));
}

/// Of any size between 2^-60 and 2^60, with digits down to the last; of both signs.
DoubleDouble draw(Generator& generator) {
    const double high = std::ldexp(uniform(generator, 0.5, 1), static_cast<int>(uniform(generator, -60, 60)));
    const double low = high * 0x1p-54 * uniform(generator, -1, 1);
    return uniform(generator) < 0.5 ? DoubleDouble(high, low) : -DoubleDouble(high, low);
}

}  // namespace

TEST_CASE("sums of two doubles: each operation is within its bound, and normal") {
    Generator generator(1);
    double sum = 0, product = 0, quotient = 0, root = 0;
    bool normal = true;
    for (int k = 0; k < 20000; ++k) {
        const DoubleDouble a = draw(generator);
        // sums that cancel, some of them nearly
        const DoubleDouble b = k % 3 == 0 ? -a * DoubleDouble(1 + std::ldexp(1.0, -k % 50)) : draw(generator);
        const Exact x = exact(a), y = exact(b);
        const DoubleDouble results[] = {a + b, a * b, a / b, sqrt(abs(a))};
        if (!(x + y == Exact(0.0))) sum = std::max(sum, error(results[0], x + y));
        product = std::max(product, error(results[1], x * y));
        quotient = std::max(quotient, error(results[2], x / y));
        root = std::max(root, error(results[3], sqrt(abs(x))));
        for (const auto& r : results) normal = normal && r.high() + r.low() == r.high();
    }
    CHECK(sum <= 3);
    CHECK(product <= 5);
    CHECK(quotient <= 10);
    CHECK(root <= 10);
    CHECK(normal);
}

TEST_CASE("sums of two doubles: what cancels exactly is zero, and what is exact stays so") {
    const DoubleDouble third = DoubleDouble(1) / 3;
    CHECK(third - third == DoubleDouble(0));
    CHECK(third * 3 - 1 <= DoubleDouble(0x1p-104));
    CHECK(sqrt(DoubleDouble(4)) == DoubleDouble(2));
    CHECK(sqrt(DoubleDouble(0)) == DoubleDouble(0));
    CHECK(std::isnan(static_cast<double>(sqrt(DoubleDouble(-1)))));
    CHECK_FALSE(isfinite(DoubleDouble(1) / 0));
}

TEST_CASE("sums of two doubles are ordered by both") {
    const DoubleDouble one(1), more(1, 0x1p-80), less(1, -0x1p-80);
    CHECK(less < one);
    CHECK(one < more);
    CHECK(more > less);
    CHECK(one <= one);
    CHECK_FALSE(one < one);
    const DoubleDouble nan = std::numeric_limits<DoubleDouble>::quiet_NaN();
    CHECK_FALSE(nan < one);
    CHECK_FALSE(one < nan);
    CHECK_FALSE(nan == nan);
    CHECK(abs(-more) == more);
}
