// A pack of lanes does in each lane what a scalar does.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>

#include <equilibria/core/lanes.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

template <class R, class Scalar>
void check_against_scalars() {
    constexpr int W = LaneTraits<R>::width;
    static_assert(is_pack<R> && !is_pack<Scalar> && is_single<R> == std::is_same_v<Scalar, float>);
    static_assert(std::is_same_v<typename LaneTraits<R>::Scalar, Scalar>);
    R a = broadcast<R>(0.0), b = broadcast<R>(2.0);
    for (int k = 0; k < W; ++k) set_lane(a, k, static_cast<Scalar>(k) + Scalar(0.5));
    const auto less = a < b;
    const R chosen = select(less, a, b), larger = lane_max(a, b), smaller = lane_min(a, b), root = square_root(a);
    for (int k = 0; k < W; ++k) {
        const Scalar x = lane(a, k), y = lane(b, k);
        CHECK(x == static_cast<Scalar>(k) + Scalar(0.5));
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
    check_against_scalars<Lanes<2>, double>();
    if constexpr (native_lanes > 2) check_against_scalars<Lanes<native_lanes>, double>();
    check_against_scalars<FloatLanes<4>, float>();
    check_against_scalars<FloatLanes<2 * native_lanes>, float>();
}

TEST_CASE("Lanes of floats take numbers of doubles, rounded") {
    using R = FloatLanes<4>;
    static_assert(LaneTraits<R>::width == 4);
    R a{};
    for (int k = 0; k < 4; ++k) set_lane(a, k, static_cast<float>(k + 1) / 7);
    const R results[] = {a + 0.1, 0.1 + a, a - 0.1, 0.1 - a, 0.1 * a, a * 0.1, 0.1 / a, -a, a / broadcast<R>(0.1)};
    for (int k = 0; k < 4; ++k) {
        const float x = lane(a, k), y = 0.1f;
        const float expected[] = {x + y, x + y, x - y, y - x, x * y, x * y, y / x, -x, x / y};
        for (std::size_t m = 0; m < std::size(expected); ++m) CHECK(lane(results[m], k) == expected[m]);
    }
    CHECK(std::signbit(lane(broadcast<R>(-0.0), 0)));
    CHECK(std::signbit(lane(broadcast<Lanes<2>>(-0.0), 1)));
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
