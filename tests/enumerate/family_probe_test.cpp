// The local dimension of solution sets that are known, multiple and crossing ones among them.
#include <functional>
#include <vector>

#include <equilibria/enumerate/detail/family_probe.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using detail::FamilyProbe;

namespace {

using Complex = std::complex<double>;
using Vector = FamilyProbe::Vector;

/// F and its Jacobian by complex divided differences of second order: smooth systems of order-one terms.
FamilyProbe probe(int n, std::function<Vector(const Vector&)> function) {
    return FamilyProbe(n, [n, function](const Vector& q, Vector& f, Vector& j) {
        f = function(q);
        j.assign(static_cast<std::size_t>(n * n), 0.0);
        for (std::size_t c = 0; c < q.size(); ++c) {
            Vector plus = q, minus = q;
            plus[c] += 1e-5, minus[c] -= 1e-5;
            const Vector a = function(plus), b = function(minus);
            for (std::size_t r = 0; r < q.size(); ++r) j[c * q.size() + r] = (a[r] - b[r]) / 2e-5;
        }
    });
}

}  // namespace

TEST_CASE("an isolated root of any multiplicity up to seven is isolated") {
    for (const int order : {1, 2, 3, 4, 5, 6, 7}) {
        CAPTURE(order);
        const auto f = probe(2, [order](const Vector& q) {
            return Vector{std::pow(q[0], order) + q[1] * q[1], q[1] - q[0] * q[0] * q[0] * q[0]};
        });
        const auto found = f.at({0, 0});
        CHECK(found.dimension == 0);
        CHECK(found.nullity == (order > 1));
    }
    // an umbilic: two quadratic terms
    const auto umbilic = probe(2, [](const Vector& q) { return Vector{q[0] * q[0] - q[1] * q[1], q[0] * q[1]}; });
    CHECK(umbilic.at({0, 0}).dimension == 0);
    CHECK(umbilic.at({0, 0}).nullity == 2);
    // and not quite at the root, as the endpoint of a path is
    CHECK(umbilic.at({1e-6, Complex(0, 1e-6)}).dimension == 0);
}

TEST_CASE("curves and surfaces have their dimension") {
    const auto circle = probe(2, [](const Vector& q) {
        const auto f = q[0] * q[0] + q[1] * q[1] - 1.0;
        return Vector{q[0] * f, q[1] * f};
    });
    const auto on_circle = circle.at({0.6, 0.8});
    CHECK(on_circle.dimension == 1);
    REQUIRE(on_circle.tangent.size() == 1);
    CHECK(std::abs(0.6 * on_circle.tangent[0][0] + 0.8 * on_circle.tangent[0][1]) < 1e-9);
    CHECK(circle.at({0.6, 0.8}, true).dimension == 1);
    CHECK(circle.at({0, 0}).dimension == 0);
    const auto sphere = probe(3, [](const Vector& q) {
        const auto f = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1.0;
        return Vector{q[0] * f, q[1] * f, q[2] * f};
    });
    const auto on_sphere = sphere.at({0.36, 0.48, 0.8});
    CHECK(on_sphere.dimension == 2);
    CHECK(on_sphere.residual < 1e-12);
    CHECK(on_sphere.distance > 0.01);
}

TEST_CASE("families that are singular themselves") {
    // two lines that cross: the null space has two dimensions, the family one
    const auto cross = probe(2, [](const Vector& q) { return Vector{q[0] * q[1], 2.0 * q[0] * q[1]}; });
    CHECK(cross.at({0, 0}).nullity == 2);
    CHECK(cross.at({0, 0}).dimension == 1);
    CHECK(cross.at({0.5, 0}).dimension == 1);
    // a double line: the null space is the plane everywhere
    const auto twice = probe(2, [](const Vector& q) { return Vector{q[0] * q[0], 2.0 * q[0] * q[0]}; });
    CHECK(twice.at({0, 0.3}).nullity == 2);
    CHECK(twice.at({0, 0.3}).dimension == 1);
}

TEST_CASE("complex lines through a real point are no real family") {
    // x^2 + y^2 = 0: the lines y = +-i x, which have the origin alone for a real point
    const auto lines = probe(2, [](const Vector& q) {
        const auto f = q[0] * q[0] + q[1] * q[1];
        return Vector{f, 3.0 * f};
    });
    CHECK(lines.at({0, 0}).dimension == 1);
    CHECK(lines.at({0, 0}, true).dimension == 0);
}

TEST_CASE("a double point near a surface is none of its points") {
    // y z - 0.02 = 0 is a surface; x^2 = y = z = 0 a double point, 0.2 from it
    const auto beside = probe(3, [](const Vector& q) {
        const auto f = q[1] * q[2] - 0.02;
        return Vector{q[0] * q[0] * f, q[1] * f, q[2] * f};
    });
    auto found = beside.at({0, 0, 0});
    CHECK(found.dimension == 0);
    CHECK(!beside.lies_on({0, 0, 0}, 2, found));
    CHECK(found.dimension == 0);
}

TEST_CASE("a double point very near a plane is none of its points") {
    for (const double apart : {1e-2, 3e-3, 1e-3, 3e-4}) {
        INFO(apart);
        const auto beside = probe(3, [apart](const Vector& q) {
            const auto f = q[2] - apart;
            return Vector{q[0] * q[0] * f, q[1] * f, q[2] * f};
        });
        auto found = beside.at({0, 0, 0});
        CHECK(found.dimension == 0);
        CHECK(!beside.lies_on({0, 0, 0}, 2, found));
        CHECK(beside.at({0.1, 0.2, apart}).dimension == 2);
    }
}

TEST_CASE("a point that is known to few digits lies on its multiple surface") {
    const auto threefold = probe(3, [](const Vector& q) {
        const auto f = (q[2] - 0.5) * (q[2] - 0.5) * (q[2] - 0.5);
        return Vector{q[0] * f, (q[1] - 2.0) * f, f * (q[0] + q[1] + 3.0)};
    });
    CHECK(threefold.at({0.7, 0.2, 0.5 + 3e-5}).dimension == 2);
}

TEST_CASE("a point of a surface where all equations are singular lies on it") {
    // y = 0; next to x^2 = 2 z^2 on it the terms cancel
    const auto embedded = probe(3, [](const Vector& q) {
        return Vector{-4.0 * q[0] * q[1] * q[1], 4.0 * q[1] * (2.0 * q[2] * q[2] - q[0] * q[0]),
                      8.0 * q[1] * q[1] * q[2]};
    });
    const Vector at{-1, 1e-16, -std::sqrt(0.5)};
    FamilyProbe::Finding found;
    REQUIRE(embedded.lies_on(at, 2, found));
    CHECK(found.dimension == 2);
    CHECK(found.rank_drops);
    CHECK(std::abs(found.neighbour[1]) < 1e-6);
    // x = z = 0 is a line that meets the surface at the origin alone
    found = {};
    CHECK(!embedded.lies_on({0, 0.5, 0}, 2, found));
    CHECK(embedded.lies_on({0, 0.5, 0}, 1, found));
}
