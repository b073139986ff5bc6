// Models with coordinates in units of their own, small terms, families: what is proved by default.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

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

/// n angles, each coupled with each: nothing changes when all turn together.
struct Coupled {
    int n;
    int angles() const { return n; }
    int coordinates() const { return 0; }
    int parameters() const { return 0; }
    auto potential(const auto& theta, const auto&, const auto&) const {
        auto v = 0.0 * cos(theta[0]);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < i; ++j) v = v + (1 + 0.3 * i + 0.1 * j) * cos(theta[i] - theta[j]);
        return v;
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

namespace {

/// The quartic as a type; p[0] - p[1] multiplies x^4.
struct QuarticType {
    static constexpr int n_angles = 0, n_coordinates = 1, n_parameters = 2;
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        return x[0] * x[0] * 0.5 - x[0] * x[0] * x[0] * x[0] * (p[0] - p[1]);
    }
};
/// Two pendulums that turn together.
struct PairType {
    static constexpr int n_angles = 2, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return -cos(theta[0]) - cos(theta[1]) - p[0] * cos(theta[0] - theta[1]);
    }
};

/// A potential with a product of two parameters.
struct Product {
    int angles() const { return 0; }
    int coordinates() const { return 1; }
    int parameters() const { return 2; }
    auto potential(const auto&, const auto& x, const auto& p) const {
        return p[0] * p[1] * x[0] * x[0] * x[0] * x[0] - x[0] * x[0];
    }
};

/// Three combinations of three angles, which do not change when the angles turn by t (1, 2, -1).
struct WeightedDifferences {
    int angles() const { return 3; }
    int coordinates() const { return 0; }
    int parameters() const { return 0; }
    auto potential(const auto& t, const auto&, const auto&) const {
        return -0.5 * sin(2 * t[0] - t[1]) - 6.0 * cos(t[0] + t[2]) + 9.0 * cos(t[0] - t[1] - t[2]);
    }
};

}  // namespace

TEST_CASE("a singular point of curves is no root where no root is isolated", "[every_equilibrium]") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        CAPTURE(seed);
        const auto y = every_equilibrium(WeightedDifferences{}, {}, {.seed = seed});
        CHECK(y.proof.complete);
        CHECK(y.set.roots.empty());
        CHECK(y.set.equilibria.empty());
        CHECK(y.proof.certificates.empty());
        CHECK(y.proof.undecided == 0);
        CHECK(y.confirmed.empty());
        CHECK(!y.set.families.empty());
        CHECK(!y.set.alarms.raised());
    }
}

TEST_CASE("circles of equilibria are found, or it is said that they were not looked for", "[every_equilibrium]") {
    // a function on a torus has critical points; those of one that turns with all angles are circles
    const auto searched = every_equilibrium<Polyhedral>(Coupled{3}, {});
    CHECK(searched.set.real() == 0);
    CHECK(!searched.set.families.empty());
    for (const int n : {6, 8}) {
        CAPTURE(n);
        const auto y = every_equilibrium(Coupled{n}, {});
        CHECK(y.set.roots.empty());
        CHECK(!y.proof.complete);
        CHECK(y.set.completeness.completeness == Completeness::open);
        CHECK(y.set.completeness.missing_at_most == 0);
        CHECK(y.set.completeness.sentence.find("curves of equilibria") != std::string::npos);
    }
}

TEST_CASE("models that are types are proved as those at run time are", "[every_equilibrium]") {
    const auto small = every_equilibrium<QuarticType>({{1 + 1e-15, 1.0}});
    CHECK(small.set.completeness.completeness == Completeness::complete);
    REQUIRE(small.set.real() == 3);
    CHECK(small.set.by_index() == std::vector<std::int64_t>{1, 2});
    CHECK(small.proof.index == 3);
    // what cancels exactly is no term: the degree is 1
    const auto none = every_equilibrium<QuarticType>({{0.1 + 0.2, 0.30000000000000004}});
    CHECK(none.set.completeness.completeness == Completeness::complete);
    CHECK(none.set.real() == 1);
    CHECK(none.set.paths.total == 1);

    const auto pair = every_equilibrium<PairType>({{0.7}});
    CHECK(pair.proof.complete);
    CHECK(pair.set.completeness.completeness == Completeness::complete);
    // angles 0 or pi, and opposite ones with cos = -1 / 1.4
    CHECK(pair.set.by_index() == std::vector<std::int64_t>{1, 3, 2});
    CHECK(pair.confirmed.size() == pair.set.roots.size());
    CHECK(pair.proof.index == static_cast<std::uint64_t>(pair.set.real()));
}

TEST_CASE("what a stopped search for equilibria found is proved, and its verdict is open", "[every_equilibrium]") {
    const std::atomic<bool> stopped = true;
    const auto check = [](const auto& y) {
        CHECK(y.set.cancelled());
        CHECK(y.set.paths.accounted_for());
        CHECK(y.set.completeness.completeness == Completeness::open);
        CHECK(y.set.completeness.sentence.find("stopped") != std::string::npos);
    };
    check(every_equilibrium(PendulumOnSlider(), RuntimeArray<double>{1.0}, {.cancel = &stopped}));
    check(every_equilibrium<PairType>({{0.7}}, {.cancel = &stopped}));
    // without an isolated solution there is nothing to be stopped: the mixed volume of the exact terms is 0
    CHECK(every_equilibrium(Difference(), RuntimeArray<double>(0), {.cancel = &stopped}).proof.complete);
}

TEST_CASE("coordinates of 1e100 and of 1e-100 are found, and what no double can hold is refused",
          "[every_equilibrium]") {
    for (const double size : {1e100, 1e-100, 1e150, 1e-150}) {
        INFO("size = " << size);
        // x^2 = size^2
        const auto y = every_equilibrium(Quartic(), RuntimeArray<double>{0, -0.5, 0, 0.25 / size / size});
        CHECK(y.proof.complete);
        REQUIRE(y.set.real() == 3);
        CHECK(y.set.by_index() == std::vector<std::int64_t>{2, 1});
        CHECK(y.proof.index == 3);
        for (int k = 0; k < 2; ++k)
            CHECK(std::abs(std::abs(y.set.equilibria[static_cast<std::size_t>(k)].q[0]) / size - 1) < 1e-14);
        CHECK(y.set.equilibria[2].q[0] == 0);
    }
    // a coefficient of 1e-400, which is no 0
    CHECK_THROWS_WITH(every_equilibrium(Product(), RuntimeArray<double>{1e-200, 1e-200}),
                      Catch::Contains("coefficient of equation 1") && Catch::Contains("choose other units"));
}
