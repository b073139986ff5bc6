#include <cstdint>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/lanes.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

struct alignas(64) Wide {
    double value;
};

template <class T>
bool aligned(const T* p) {
    return reinterpret_cast<std::uintptr_t>(p) % alignof(T) == 0;
}

}  // namespace

TEST_CASE("vectors of packs begin where their alignment asks for it, and keep what they hold") {
    for (std::size_t n = 1; n < 40; ++n) {
        AlignedVector<Wide> wide(n);
        AlignedVector<Lanes<native_lanes>> packs(n);
        CHECK(aligned(wide.data()));
        CHECK(aligned(packs.data()));
        for (std::size_t k = 0; k < n; ++k) wide[k].value = static_cast<double>(k);
        auto copy = wide;
        copy.resize(3 * n);
        CHECK(aligned(copy.data()));
        double sum = 0;
        for (const Wide& w : copy) sum += w.value;
        CHECK(sum == static_cast<double>(n * (n - 1) / 2));
    }
}
