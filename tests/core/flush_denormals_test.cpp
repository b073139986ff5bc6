// Denormal numbers are 0 in a scope, and are again what they were behind it, whatever was in force before.
#include <limits>

#include <equilibria/core/flush_denormals.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// The smallest normal number over 4, as computed now.
template <class T>
T denormal() {
    volatile T smallest = std::numeric_limits<T>::min(), quarter = T(0.25);
    return smallest * quarter;
}

}  // namespace

TEST_CASE("Denormal numbers are zeros in a scope alone") {
    CHECK(denormal<float>() > 0);
    CHECK(denormal<double>() > 0);
#ifdef EQUILIBRIA_FLUSHES_DENORMALS
    volatile float before = denormal<float>(), large = 1e30f;
    {
        const FlushDenormals outer;
        CHECK(denormal<float>() == 0);
        CHECK(denormal<double>() == 0);
        CHECK(before * large == 0);
        {
            const FlushDenormals inner;
            CHECK(denormal<float>() == 0);
        }
        CHECK(denormal<float>() == 0);
    }
    CHECK(before * large > 0);
#endif
    CHECK(denormal<float>() > 0);
    CHECK(denormal<double>() > 0);
}
