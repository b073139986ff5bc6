#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include <equilibria/locus/regions/regions.hpp>

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
    for (const auto& cell : plane.cells()) area[cell.region] += plane.area(cell);
    return area;
}

/// Whether the segment from a to b comes nearer to a curve than `near`.
bool meets(const std::vector<Curve>& curves, PlanePoint a, PlanePoint b, double near) {
    const auto side = [](PlanePoint o, PlanePoint p, PlanePoint q) {
        return (p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y);
    };
    const auto distance = [](PlanePoint p, PlanePoint from, PlanePoint to) {
        const double dx = to.x - from.x, dy = to.y - from.y, length2 = dx * dx + dy * dy;
        const double t = length2 > 0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / length2, 0.0, 1.0) : 0;
        return std::hypot(p.x - from.x - t * dx, p.y - from.y - t * dy);
    };
    for (const Curve& c : curves)
        for (std::size_t k = 1; k < c.size(); ++k) {
            const PlanePoint p = c[k - 1], q = c[k];
            if (side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0) return true;
            if (std::min({distance(a, p, q), distance(b, p, q), distance(p, a, b), distance(q, a, b)}) < near)
                return true;
        }
    return false;
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

TEST_CASE("Curves that touch each other or the border midway part regions there") {
    const Curve up{{0, 0.9}, {0.5, 0.5}, {1, 0.9}}, down{{0, 0.1}, {0.5, 0.5}, {1, 0.1}};
    const PlaneDecomposition two({{0, 1}, {0, 1}}, {up, down});
    CHECK(two.regions() == 4);
    CHECK(two.region_of(0.1, 0.5) != two.region_of(0.9, 0.5));
    // a wedge on each side of the point in the middle of the upper border
    const Curve w{{0.1, 1}, {0.3, 0.7}, {0.5, 1 - 4e-10}, {0.7, 0.7}, {0.9, 1}};
    const PlaneDecomposition wedges({{0, 1}, {0, 1}}, {w});
    CHECK(wedges.regions() == 3);
    CHECK(wedges.region_of(0.3, 0.9) >= 0);
    CHECK(wedges.region_of(0.3, 0.9) != wedges.region_of(0.7, 0.9));
    double total = 0;
    for (const auto& [region, area] : areas(wedges)) total += area;
    CHECK(total == Approx(1).epsilon(1e-9));
}

TEST_CASE("Every point is in a region, and segments that meet no curve stay in one: curves of few places") {
    // corners on a coarse grid: curves touch, cross in corners, lie over each other and over the border
    std::mt19937 draw(7);
    const auto place = [&](int of) { return static_cast<double>(draw() % static_cast<unsigned>(of + 1)) / of; };
    for (int k = 0; k < 1000; ++k) {
        std::vector<Curve> curves(1 + draw() % 3);
        const int grid = 2 + static_cast<int>(draw() % 7);
        for (Curve& c : curves)
            for (int corners = 2 + static_cast<int>(draw() % 6); corners > 0; --corners)
                c.push_back({place(grid), place(grid)});
        const PlaneDecomposition plane({{0, 1}, {0, 1}}, curves);
        INFO("system " << k);
        double total = 0;
        for (const auto& [region, area] : areas(plane)) total += area;
        CHECK(total == Approx(1).epsilon(1e-6));
        for (int m = 0; m < 100; ++m) {
            const PlanePoint a{place(997), place(991)}, b{place(983), place(977)};
            if (meets(curves, a, a, 1e-5) || std::min({a.x, a.y, 1 - a.x, 1 - a.y}) < 1e-5) continue;
            CHECK(plane.region_of(a.x, a.y) >= 0);
            if (std::min({b.x, b.y, 1 - b.x, 1 - b.y}) < 1e-5 || meets(curves, a, b, 1e-5)) continue;
            CHECK(plane.region_of(a.x, a.y) == plane.region_of(b.x, b.y));
        }
    }
}

TEST_CASE("An empty, reversed or infinite window is refused with its values") {
    CHECK_THROWS_WITH((Window{{1, 0}, {0, 1}}.validate()), Catch::Matchers::Contains("window x = 1:0"));
    CHECK_THROWS_WITH((Window{{0, 1}, {2, 2}}.validate()), Catch::Matchers::Contains("window y = 2:2"));
    CHECK_THROWS_WITH((Window{{0, 1}, {0, INFINITY}}.validate()), Catch::Matchers::Contains("window y = 0:inf"));
}
