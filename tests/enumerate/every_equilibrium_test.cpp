// Models with coordinates in units of their own, small terms, families: what is proved by default.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <equilibria/enumerate/every_equilibrium.hpp>
#include <equilibria/model/runtime_model.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// A potential of one coordinate, c2 x^2 + c3 x^3 + c4 x^4 + c1 x.
struct Quartic {
    int angles() const { return 0; }
    int coordinates() const { return 1; }
    int parameters() const { return 4; }
    auto potential(const auto&, const auto& x, const auto& p) const {
        return p[0] * x[0] + p[1] * x[0] * x[0] + p[2] * x[0] * x[0] * x[0] + p[3] * x[0] * x[0] * x[0] * x[0];
    }
};
/// An angle and a coordinate in units of 1 / k.
struct PendulumOnSlider {
    int angles() const { return 1; }
    int coordinates() const { return 1; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto& x, const auto& p) const {
        const auto y = p[0] * x[0];
        return 0.5 * y * y - y * cos(theta[0]) + 2.0 * sin(theta[0]);
    }
};
/// Two angles of which the difference alone counts.
struct Difference {
    int angles() const { return 2; }
    int coordinates() const { return 0; }
    int parameters() const { return 0; }
    auto potential(const auto& theta, const auto&, const auto&) const {
        return 4.0 * cos(theta[0] - theta[1]) + 9.0 * sin(theta[0] - theta[1]) - cos(2 * theta[0] - 2 * theta[1]);
    }
};

}  // namespace

TEST_CASE("equilibria a million out, and those of a small term, are found and proved", "[every_equilibrium]") {
    const auto far = every_equilibrium(Quartic(), RuntimeArray<double>{-1e12, 0, 1.0 / 3, 0});
    REQUIRE(far.set.real() == 2);
    CHECK(far.proof.complete);
    for (const auto& e : far.set.equilibria) {
        CHECK(std::abs(std::abs(e.q[0]) / 1e6 - 1) < 1e-12);
        CHECK(e.index == (e.q[0] > 0 ? 0 : 1));
    }
    const auto small = every_equilibrium(Quartic(), RuntimeArray<double>{0, 0.5, 0, -1e-15});
    REQUIRE(small.set.real() == 3);
    CHECK(small.proof.complete);
    CHECK(small.set.by_index() == std::vector<std::int64_t>{1, 2});
    CHECK(small.set.completeness.missing_at_most == 0);
}

TEST_CASE("the index does not depend on the unknowns' units", "[every_equilibrium]") {
    for (const double k : {1e-9, 1e-4, 1.0, 1e4, 1e9}) {
        INFO("k = " << k);
        const auto y = every_equilibrium(PendulumOnSlider(), RuntimeArray<double>{k});
        CHECK(y.proof.complete);
        CHECK(y.proof.index == 2);
        REQUIRE(y.set.real() == 2);
        CHECK(y.set.by_index() == std::vector<std::int64_t>{1, 1, 0});
        CHECK(y.set.degenerate() == 0);
        for (const auto& e : y.set.equilibria) CHECK(e.margin > 0.1);
    }
}

TEST_CASE("a model whose equilibria are curves has none that is isolated, by Bernstein's theorem",
          "[every_equilibrium]") {
    const auto y = every_equilibrium(Difference(), RuntimeArray<double>(0));
    CHECK(y.set.roots.empty());
    CHECK(y.proof.complete);
    std::size_t real = 0;
    for (const auto& family : y.set.families) real += family.real();
    CHECK(real == 2);
}
