#include <cmath>
#include <complex>
#include <cstdint>

#include <equilibria/core/random.hpp>
#include <equilibria/core/splitmix.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("draws are the same everywhere") {
    Generator generator;  // the standard fixes its 10000th output: 9981545732273789042
    generator.discard(9999);
    CHECK(uniform(generator) == static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
    Generator first(7), second(7);
    for (int k = 0; k < 10; ++k) CHECK(unit_complex(first) == unit_complex(second));
}

TEST_CASE("splitmix64 gives the numbers that its authors' program gives") {
    std::uint64_t state = 1234567;  // of S. Vigna's splitmix64.c, by this seed
    for (const std::uint64_t number : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                       4593380528125082431u, 16408922859458223821u})
        CHECK(splitmix64(state) == number);
}

TEST_CASE("draws lie where they should, and about evenly") {
    Generator generator(1);
    double sum = 0, squares = 0;
    std::complex<double> centre = 0;
    const int n = 100000;
    for (int k = 0; k < n; ++k) {
        const double u = uniform(generator), v = uniform(generator, -3, 5);
        if (!(u >= 0 && u < 1 && v >= -3 && v < 5)) FAIL("out of range");
        sum += u, squares += u * u;
        const auto z = unit_complex(generator);
        if (!(std::abs(std::abs(z) - 1) < 1e-15)) FAIL("not on the unit circle");
        centre += z;
    }
    CHECK(std::abs(sum / n - 0.5) < 5 * std::sqrt(1.0 / 12 / n));
    CHECK(std::abs(squares / n - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / n));
    CHECK(std::abs(centre) / n < 5 / std::sqrt(n));
}
