// A pack of lanes does in each lane what a scalar does.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include <equilibria/core/lanes.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

template <int W>
void check_against_scalars() {
    using R = Lanes<W>;
    static_assert(LaneTraits<R>::width == W && is_pack<R> && !is_pack<double>);
    static_assert(std::is_same_v<typename LaneTraits<R>::Scalar, double>);
    R a = broadcast<R>(0.0), b = broadcast<R>(2.0);
    for (int k = 0; k < W; ++k) set_lane(a, k, k + 0.5);
    const auto less = a < b;
    const R chosen = select(less, a, b), larger = lane_max(a, b), smaller = lane_min(a, b), root = square_root(a);
    for (int k = 0; k < W; ++k) {
        const double x = lane(a, k), y = lane(b, k);
        CHECK(x == k + 0.5);
        CHECK(y == 2);
        CHECK(mask_lane(less, k) == (x < y));
        CHECK(mask_lane(mask_not(less), k) == !(x < y));
        CHECK(mask_lane(mask_and(less, a > broadcast<R>(1.0)), k) == (x < y && x > 1));
        CHECK(lane(chosen, k) == select(x < y, x, y));
        CHECK(lane(larger, k) == std::max(x, y));
        CHECK(lane(smaller, k) == std::min(x, y));
        CHECK(lane(root, k) == std::sqrt(x));
    }
    CHECK(all_lanes(a < broadcast<R>(W + 1.0)));
    CHECK_FALSE(all_lanes(a < broadcast<R>(W - 1.0)));  // the last lane is not
}

}  // namespace

TEST_CASE("Lanes do what scalars do") {
    check_against_scalars<2>();
    if constexpr (native_lanes > 2) check_against_scalars<native_lanes>();
}

TEST_CASE("A scalar is a pack of one lane") {
    double a = 3;
    set_lane(a, 0, 4);
    CHECK(lane(a, 0) == 4);
    CHECK(broadcast<double>(2.5) == 2.5);
    CHECK(all_lanes(true));
    CHECK_FALSE(mask_lane(mask_and(true, mask_not(true)), 0));
    CHECK(square_root(9.0) == 3);
}
