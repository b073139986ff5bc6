// Values at equal distances: the ends exactly, decimals where they are decimals, and others to rounding.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/core/grid_value.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("Values at equal distances are the decimals that they should be") {
    CHECK(grid_value(-3, 3, 4, 7) == 1);
    CHECK(grid_value(0.1, 0.7, 2, 7) == 0.3);
    CHECK(grid_value(-0.3, 0.3, 3, 7) == 0);
    CHECK(grid_value(0, 1e9, 1, 11) == 1e8);
    CHECK(grid_value(0, 1e-9, 3, 11) == 3e-10);
    CHECK(grid_value(0, 1e20, 3, 11) == 3e19);
    // multiples of 0.1, 0.05 and 0.002, from literals as people write them: a quotient of integers is rounded once
    int wrong = 0;
    for (const double denominator : {10.0, 20.0, 500.0})
        for (int low = -40; low < 40; low += 7)
            for (std::uint64_t step = 1; step <= 3; ++step)
                for (const std::uint64_t n : {2, 3, 7, 11, 50, 101, 201})
                    for (std::uint64_t k = 0; k < n; ++k) {
                        const double high = low + static_cast<double>(step * (n - 1));
                        const double exact = (low + static_cast<double>(step * k)) / denominator;
                        wrong += grid_value(low / denominator, high / denominator, k, n) != exact;
                    }
    CHECK(wrong == 0);
}

TEST_CASE("Values at equal distances grow from one end to the other, whatever their size") {
    constexpr double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    for (const auto& [low, high] : {std::pair{0.0, 1 / 3.0},
                                    {1 / 7.0, 22 / 7.0},
                                    {1.0, 1 + 1e-12},
                                    {1e-300, 3e-300},
                                    {0.0, 1e300},
                                    {-most / 2, most / 2},
                                    {0.0, 8 * least},
                                    {2.0, -5.0}}) {
        constexpr std::uint64_t n = 9;
        CHECK(grid_value(low, high, 0, n) == low);
        CHECK(grid_value(low, high, n - 1, n) == high);
        for (std::uint64_t k = 0; k < n; ++k) {
            const double value = grid_value(low, high, k, n), part = static_cast<double>(k) / 8;
            CHECK(std::abs(value - ((1 - part) * low + part * high)) <=
                  1e-15 * std::max(std::abs(low), std::abs(high)));
        }
    }
    CHECK(grid_value(2, 3, 0, 1) == 2);
    CHECK_THROWS_AS(grid_value(2, 3, 1, 1), InvalidArgument);
}
