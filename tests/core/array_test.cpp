#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>

#include <equilibria/core/array.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("an array is zero until it is filled, and any integer indexes it") {
    Array<double, 4> a;
    for (double x : a) CHECK(x == 0);
    a[0] = 1;
    a[1u] = 2;
    a[std::size_t{2}] = 3;
    a[std::int8_t{3}] = 4;
    const auto& b = a;
    CHECK(b[0L] + b[1LL] + b[2] + b[char{3}] == 10);
    CHECK(std::accumulate(b.begin(), b.end(), 0.0) == 10);
    STATIC_REQUIRE(Array<double, 4>::size() == 4);
}

TEST_CASE("arrays are aggregates that compare, in constant expressions too") {
    constexpr Array<int, 3> a{{1, 2, 3}};
    constexpr auto doubled = [&] {
        auto b = a;
        for (int& x : b) x *= 2;
        return b;
    }();
    STATIC_REQUIRE(doubled == Array<int, 3>{{2, 4, 6}});
    STATIC_REQUIRE(a != doubled);
    STATIC_REQUIRE(std::is_trivially_copyable_v<Array<double, 3>>);
}

TEST_CASE("an array of nothing takes no element and has none") {
    constexpr Array<double, 0> none;
    STATIC_REQUIRE(none.size() == 0);
    STATIC_REQUIRE(std::is_empty_v<Array<double, 0>>);
    STATIC_REQUIRE(none == Array<double, 0>{});
    CHECK(none.begin() == none.end());
    CHECK_THROWS(none[0]);
}
