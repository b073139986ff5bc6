// Mixed areas of lattice polygons.
#include <cstdint>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/polyhedral/mixed_area.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using detail::LatticePoint, detail::mixed_area, detail::twice_hull_area;
using Polygon = std::vector<LatticePoint>;

namespace {

Polygon random_polygon(Generator& generator) {
    Polygon y;
    for (int k = 0; k < 6; ++k)
        y.push_back({static_cast<std::int64_t>(generator() % 9) - 4, static_cast<std::int64_t>(generator() % 9) - 4});
    return y;
}
Polygon sum(const Polygon& a, const Polygon& b) {
    Polygon y;
    for (const auto& p : a)
        for (const auto& q : b) y.push_back({p[0] + q[0], p[1] + q[1]});
    return y;
}

}  // namespace

TEST_CASE("Areas of hulls: a point, a segment, a square with points inside") {
    CHECK(twice_hull_area({{3, 4}}) == 0);
    CHECK(twice_hull_area({{0, 0}, {2, 2}, {1, 1}}) == 0);
    CHECK(twice_hull_area({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}}) == 8);
    CHECK(twice_hull_area({{0, 0}, {3, 0}, {0, 1}}) == 3);
}

TEST_CASE("The mixed area is symmetric, additive, twice the area of a polygon with itself, and blind to translations") {
    Generator generator(1);
    for (int k = 0; k < 200; ++k) {
        const auto p = random_polygon(generator), q = random_polygon(generator), r = random_polygon(generator);
        CHECK(mixed_area(p, q) == mixed_area(q, p));
        CHECK(mixed_area(p, p) == twice_hull_area(p));
        CHECK(mixed_area(p, sum(q, r)) == mixed_area(p, q) + mixed_area(p, r));
        CHECK(mixed_area(p, sum(q, {{5, -2}})) == mixed_area(p, q));
        CHECK(mixed_area(p, q) >= 0);
    }
    // two lines, a line and a conic, two conics (Bezout), and a segment times itself
    const Polygon line{{0, 0}, {1, 0}, {0, 1}}, conic{{0, 0}, {2, 0}, {0, 2}};
    CHECK(mixed_area(line, line) == 1);
    CHECK(mixed_area(line, conic) == 2);
    CHECK(mixed_area(conic, conic) == 4);
    CHECK(mixed_area({{0, 0}, {1, 1}}, {{0, 0}, {2, 2}}) == 0);
}
