#include <cmath>

#include <equilibria/core/exponential.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// The largest relative error over random numbers from low to high.
template <class R>
double largest_error(double low, double high) {
    using Scalar = typename LaneTraits<R>::Scalar;
    Generator generator(1);
    double worst = 0;
    for (int draw = 0; draw < 5000; ++draw) {
        R x;
        for (int k = 0; k < LaneTraits<R>::width; ++k)
            set_lane(x, k, static_cast<Scalar>(uniform(generator, low, high)));
        const R y = exponential(x);
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            const double expected = std::exp(static_cast<double>(lane(x, k)));
            worst = std::max(worst, std::abs(static_cast<double>(lane(y, k)) / expected - 1));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("the exponential in lanes is that of libm, to the rounding of the lanes' numbers") {
    CHECK(largest_error<Lanes<native_lanes>>(-700, 20) < 1e-15);
    CHECK(largest_error<FloatLanes<2 * native_lanes>>(-86, 20) < 4e-7);
    CHECK(exponential(-3.0) == std::exp(-3.0));
}

TEST_CASE("far below, the exponential in lanes is normal and next to nothing, at 0 it is 1") {
    const auto far = exponential(Lanes<native_lanes>{} - 1e5);
    CHECK(lane(far, 0) > 0);
    CHECK(lane(far, 0) < 1e-300);
    const auto single = exponential(FloatLanes<2 * native_lanes>{} - 1e5);
    CHECK(lane(single, 0) > 0);
    CHECK(lane(single, 0) < 1e-37f);
    CHECK(lane(exponential(Lanes<native_lanes>{}), 0) == 1);
}
