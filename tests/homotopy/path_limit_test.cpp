// Limits of paths of which the limit is known: regular and multiple roots, a coordinate that vanishes, directions at
// infinity.
#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/homotopy/local_multiplicity.hpp>
#include <equilibria/homotopy/path_limit.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Number = std::complex<double>;
const RuntimeSizes one(0, 1);

/// A polynomial in one coordinate; from[k] and to[k] belong to x^k.
std::vector<LaurentColumn> polynomial(const std::vector<Number>& from, const std::vector<Number>& to) {
    std::vector<LaurentColumn> y;
    for (std::size_t k = 0; k < from.size(); ++k) y.push_back({0, {static_cast<int>(k)}, from[k], to[k]});
    return y;
}

}  // namespace

TEST_CASE("a path to a regular root is finite, to all digits", "[path_limit]") {
    // x^2 - (3 + 2 i) goes to x^2 - 2
    const auto columns = polynomial({Number(-3, -2), 0, 1}, {-2, 0, 1});
    for (const int digits : {31, 64}) {
        const auto y = follow_to_limit(one, columns, {std::sqrt(Number(3, 2))}, 1, digits);
        REQUIRE(y.kind == LimitKind::finite);
        CHECK(std::abs(y.z[0] - std::sqrt(2.0)) < 1e-15);
        CHECK(y.residual < 1e-28);
    }
}

TEST_CASE("roots 1e-10 apart are two limits, and a double root is one of multiplicity 2", "[path_limit]") {
    const Number start(0.3, 1.1);
    const auto begins = [&] {
        // x^2 - 2 x + 1 - start
        return std::vector<Number>{1.0 + std::sqrt(start), 1.0 - std::sqrt(start)};
    }();
    const auto near = polynomial({1.0 - start, -2, 1}, {1 - 1e-15, -2, 1});
    const double apart = std::sqrt(1 - (1 - 1e-15));
    for (std::size_t k = 0; k < 2; ++k) {
        const auto y = follow_to_limit(one, near, {begins[k]}, 1, 64);
        REQUIRE(y.kind == LimitKind::finite);
        CHECK(std::abs(std::abs(y.z[0] - 1.0) / apart - 1) < 1e-6);
    }
    const auto twice = polynomial({1.0 - start, -2, 1}, {1, -2, 1});
    std::vector<PathLimit> limits;
    for (const Number& x : begins) limits.push_back(follow_to_limit(one, twice, {x}, 1, 64));
    for (const auto& y : limits) {
        REQUIRE(y.kind == LimitKind::singular);
        REQUIRE(!y.points.empty());
        CHECK(std::abs(y.z[0] - 1.0) < 1e-12);
    }
    const auto local = local_multiplicity(one, twice, {&limits[0], &limits[1]}, 0, 2);
    CHECK(local.multiplicity == 2);
    CHECK(local.largest_dropped < 1e-27);
    CHECK(local.smallest_kept > 0.1);
    // of the near roots, whose mean is taken, the value betrays that they are two
    std::vector<PathLimit> false_ones = limits;
    CHECK(local_multiplicity(one, near, {&false_ones[0], &false_ones[1]}, 0, 2).largest_dropped > 1e-17);
    CHECK(local.confirmed);
}

TEST_CASE("two roots nearer than 1e-18 are no double root, though no value there is above 1e-26", "[path_limit]") {
    // (x - 3)^2 (x + 3) x^2 - 2.25e-20 (x - 3), its coefficients rounded
    const auto columns = polynomial(std::vector<Number>(6, 1.0), {6.75e-20, -2.25e-20, 27, -9, -3, 1});
    PathLimit limit;
    limit.kind = LimitKind::singular;
    limit.z = {3.0};
    limit.points = {{1e-44, {{std::vector<double>{3, 2.25e-20 / 108}, {0.0}}}}};
    auto y = local_multiplicity(one, columns, {&limit, &limit}, 0, 2);
    CHECK(y.multiplicity == 2);
    CHECK(y.largest_dropped < 1e-26);
    CHECK_FALSE(y.confirmed);
    // without the small terms it is one, and the mean of points that are 1e-15 off is moved there
    const auto twice = polynomial(std::vector<Number>(6, 1.0), {0, 0, 27, -9, -3, 1});
    limit.points[0].z[0][0] = {3, 1e-28};
    y = local_multiplicity(one, twice, {&limit, &limit}, 0, 2);
    CHECK(y.multiplicity == 2);
    CHECK(y.confirmed);
}

TEST_CASE("a path whose leading coefficient vanishes goes to infinity, in its direction", "[path_limit]") {
    // (1 - t) x^3 + x - 1: two paths leave as (1 - t)^(-1/2)
    const auto columns = polynomial({-1, 1, 0, 1}, {-1, 1, 0, 0});
    int away = 0, finite = 0;
    // roots of x^3 + x - 1
    for (const Number& x : {Number(0.6823278038280193, 0), Number(-0.3411639019140097, 1.161541399997252),
                            Number(-0.3411639019140097, -1.161541399997252)}) {
        const auto y = follow_to_limit(one, columns, {x}, 1, 31);
        if (y.kind == LimitKind::at_infinity) {
            ++away;
            CHECK(y.direction[0] == Approx(0.5).margin(1e-12));
            CHECK(y.residual < 1e-24);
            CHECK(direction_in_words(y.direction) == "(1)/2");
        } else {
            REQUIRE(y.kind == LimitKind::finite);
            ++finite;
            CHECK(std::abs(y.z[0] - 1.0) < 1e-15);
        }
    }
    CHECK(away == 2);
    CHECK(finite == 1);
}

TEST_CASE("a root a million out is finite, not at infinity", "[path_limit]") {
    // 1e-6 x - 1
    const auto columns = polynomial({Number(-0.3, 0.8), 1}, {-1, 1e-6});
    const auto y = follow_to_limit(one, columns, {Number(0.3, -0.8)}, 1, 31);
    REQUIRE(y.kind == LimitKind::finite);
    CHECK(std::abs(y.z[0] / 1e6 - 1.0) < 1e-14);
}

TEST_CASE("a coordinate that tends to 0 is 0 in the limit", "[path_limit]") {
    // x^2 + (1 - t) c: singular at 0
    const auto columns = polynomial({Number(0.4, 0.9), 0, 1}, {0, 0, 1});
    const auto y = follow_to_limit(one, columns, {std::sqrt(-Number(0.4, 0.9))}, 1, 64);
    REQUIRE(y.kind == LimitKind::singular);
    CHECK(y.z[0] == 0.0);
}
