#include <cstdint>

#include <equilibria/core/lanes.hpp>
#include <equilibria/core/local_array.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("short arrays begin at zero, keep what they hold and are aligned, where they are declared and on the heap") {
    for (int n = 0; n < 40; ++n) {
        LocalArray<double> numbers(n);
        for (const double number : numbers) CHECK(number == 0);
        for (int k = 0; k < n; ++k) numbers[k] = k;
        const LocalArray<double> copy = numbers;
        CHECK(copy.size() == n);
        CHECK(copy.end() - copy.begin() == n);
        for (int k = 0; k < n; ++k) CHECK(copy[k] == k);
        LocalArray<Lanes<native_lanes>> packs(n);
        CHECK(reinterpret_cast<std::uintptr_t>(packs.begin()) % alignof(Lanes<native_lanes>) == 0);
    }
}
