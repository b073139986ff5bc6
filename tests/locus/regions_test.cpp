#include <cmath>
#include <equilibria/locus/regions/regions.hpp>
#include <map>
#include <numbers>
#include <vector>

#include "support/catch.hpp"

using namespace equilibria;
using Curve = std::vector<PlanePoint>;

namespace {

Curve circle(double x, double y, double r, int points = 400) {
    Curve c;
    for (int k = 0; k <= points; ++k) {
        const double phi = 2 * std::numbers::pi * k / points;
        c.push_back({x + r * std::cos(phi), y + r * std::sin(phi)});
    }
    return c;
}

std::map<int, double> areas(const PlaneDecomposition& plane) {
    std::map<int, double> area;
    for (const auto& cell : plane.cells()) area[cell.region] += (cell.x.high - cell.x.low) * cell.height;
    return area;
}

}  // namespace

TEST_CASE("No curve leaves one region, the window") {
    const PlaneDecomposition plane({{0, 1}, {0, 5}}, {});
    CHECK(plane.regions() == 1);
    CHECK(plane.region_of(0.5, 2) == 0);
}

TEST_CASE("A circle has an inside and an outside, however small it is") {
    for (const double r : {0.3, 1e-2, 1e-5}) {
        const PlaneDecomposition plane({{0, 1}, {0, 1}}, {circle(0.4, 0.5, r)});
        CHECK(plane.regions() == 2);
        CHECK(plane.region_of(0.4, 0.5) != plane.region_of(0.9, 0.9));
        CHECK(plane.region_of(0.1, 0.5) == plane.region_of(0.9, 0.5));
    }
}

TEST_CASE("Two crossing circles make four regions, two disjoint ones three, an annulus three") {
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {circle(0.4, 0.5, 0.2), circle(0.6, 0.5, 0.2)}).regions() == 4);
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {circle(0.2, 0.5, 0.1), circle(0.7, 0.5, 0.1)}).regions() == 3);
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {circle(0.5, 0.5, 0.1), circle(0.5, 0.5, 0.3)}).regions() == 3);
}

TEST_CASE("A vertical line parts the regions on its two sides, as far as it goes") {
    const Curve line{{0.4, 0}, {0.4, 0.3}, {0.4 + 1e-16, 0.7}, {0.4, 1}}, half{{0.4, 0}, {0.4, 0.5}};
    const PlaneDecomposition whole({{0, 1}, {0, 1}}, {line});
    REQUIRE(whole.regions() == 2);
    const int left = whole.region_of(0.2, 0.5), right = whole.region_of(0.7, 0.5);
    CHECK(left != right);
    REQUIRE(whole.borders().size() == 1);
    CHECK(whole.borders()[0] == RegionBorder{left, right, 0});
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {half}).regions() == 1);
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {line, {{0, 0.5}, {1, 0.5}}}).regions() == 4);
    CHECK(PlaneDecomposition({{0, 1}, {0, 1}}, {line, circle(0.4, 0.5, 0.2)}).regions() == 4);
}

TEST_CASE("The sliver of a cusp is a region, joined to nothing at its tip") {
    Curve cusp;  // y^2 = (x - 0.3)^3, tip at (0.3, 0.5)
    for (int k = -200; k <= 200; ++k) {
        const double s = 0.8 * k / 200;
        cusp.push_back({0.3 + s * s, 0.5 + s * s * s});
    }
    const PlaneDecomposition plane({{0, 0.9}, {0, 1}}, {cusp});
    CHECK(plane.regions() == 2);
    CHECK(plane.region_of(0.301, 0.5) == plane.region_of(0.5, 0.5));
    CHECK(plane.region_of(0.299, 0.5) == plane.region_of(0.5, 0.9));
    CHECK(plane.region_of(0.299, 0.5) == plane.region_of(0.5, 0.1));
    CHECK(plane.region_of(0.301, 0.5) != plane.region_of(0.299, 0.5));
}

TEST_CASE("Cells cover the window: their areas add up to its own") {
    const PlaneDecomposition plane({{0, 1}, {0, 1}}, {circle(0.4, 0.5, 0.2, 20000), {{0, 0.1}, {1, 0.8}}});
    double total = 0;
    for (const auto& [region, area] : areas(plane)) total += area;
    CHECK(total == Approx(1).epsilon(1e-9));
}

TEST_CASE("Polygons of the cells have the cells' areas, and borders name regions and curves") {
    const PlaneDecomposition plane({{0, 1}, {0, 1}}, {circle(0.4, 0.5, 0.2), circle(0.7, 0.5, 0.2)});
    double total = 0;
    for (const auto& cell : plane.cells()) {
        const auto polygon = plane.polygon(cell);
        double twice = 0;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            twice += a.x * b.y - b.x * a.y;
        }
        CHECK(twice > 0);
        total += 0.5 * twice;
    }
    CHECK(total == Approx(1).epsilon(1e-9));
    // outside, the two moons and the lens: each curve parts two pairs of regions
    const int outside = plane.region_of(0.05, 0.05), lens = plane.region_of(0.55, 0.5),
              left = plane.region_of(0.3, 0.5), right = plane.region_of(0.8, 0.5);
    const auto parts = [&](int a, int b, std::size_t curve) {
        for (const auto& border : plane.borders())
            if (border.curve == curve &&
                ((border.below == a && border.above == b) || (border.below == b && border.above == a)))
                return true;
        return false;
    };
    CHECK(parts(outside, left, 0));
    CHECK(parts(outside, right, 1));
    CHECK(parts(right, lens, 0));
    CHECK(parts(left, lens, 1));
    CHECK_FALSE(parts(outside, lens, 0));
    CHECK_FALSE(parts(left, right, 0));
}

TEST_CASE("An empty, reversed or infinite window is refused with its values") {
    CHECK_THROWS_WITH((Window{{1, 0}, {0, 1}}.validate()), Catch::Matchers::Contains("window x = 1:0"));
    CHECK_THROWS_WITH((Window{{0, 1}, {2, 2}}.validate()), Catch::Matchers::Contains("window y = 2:2"));
    CHECK_THROWS_WITH((Window{{0, 1}, {0, INFINITY}}.validate()), Catch::Matchers::Contains("window y = 0:inf"));
}
