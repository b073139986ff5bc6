// Monodromy: all roots of families whose numbers of roots are known, far below their mixed volumes, from one root.
#include <atomic>
#include <cmath>
#include <complex>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/paths/monodromy.hpp>
#include <equilibria/system/laurent_terms.hpp>
#include <equilibria/system/system_family.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;

namespace {

/// The inverse kinematics of an arm of six joints (Hong, Stahl, Safe starting regions by fixed points and tightening,
/// Computing 53 (1994)), in its angles: 48 solutions for generic constants; total degree 4608, mixed volume 320.
struct SixJoints {
    int angles() const { return 6; }
    int parameters() const { return 6; }
    auto equations(const auto& theta, const auto& p) const {
        using S = std::remove_cvref_t<decltype(sin(theta[0]) * p[0])>;
        std::vector<S> c, s;
        for (int k = 0; k < 6; ++k) c.push_back(cos(theta[k])), s.push_back(sin(theta[k]));
        const S a = c[1] + c[2] + c[3], b = s[1] + s[2] + s[3], d = 3 * s[1] + 2 * s[2] + s[3];
        return std::vector<S>{3 * c[1] + 2 * c[2] + c[3] - p[0],
                              c[0] * d - p[1],
                              s[0] * d - p[2],
                              a * c[4] - p[3],
                              s[0] * b * c[4] + c[0] * s[4] - p[4],
                              b * s[5] - a * s[4] * c[5] - p[5]};
    }
};
const std::vector<double> six_joints{3.9701, 1.7172, 4.0616, 1.9791, 1.9115, 0.4077};

/// A planar platform on three legs of given squared lengths, at 6 places (Hunt, Structural kinematics of
/// in-parallel-actuated robot arms, J. Mech. Transm. Autom. Des. 105 (1983)), all real here.
struct Platform {
    int angles() const { return 1; }
    int coordinates() const { return 2; }
    int parameters() const { return 3; }
    auto equations(const auto& theta, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(sin(theta[0]) * x[0])>;
        constexpr double base[3][2] = {{0, 0}, {15.91, 0}, {0, 10}}, at[3][2] = {{0, 0}, {17.04, 0}, {13.8, 15.29}};
        const S c = cos(theta[0]), s = sin(theta[0]);
        std::vector<S> f;
        for (int k = 0; k < 3; ++k) {
            const S u = x[0] + at[k][0] * c - at[k][1] * s - base[k][0];
            const S v = x[1] + at[k][0] * s + at[k][1] * c - base[k][1];
            f.push_back(u * u + v * v - p[k]);
        }
        return f;
    }
};
const std::vector<double> platform{14.98 * 14.98, 15.38 * 15.38, 144};

int real_roots(const ComplexRoots<>& of) {
    int y = 0;
    for (const auto& root : of.roots) y += is_real(root);
    return y;
}

/// At real parameters every path from the generic roots is accounted for, and ends at a regular root.
ComplexRoots<> check_at(const MonodromyRoots& generic, const SystemFamily& family, const std::vector<double>& p) {
    for (const auto& root : generic.roots) CHECK(root.residual < 1e-9);
    const auto y = solve_from(generic, family, p);
    CHECK(y.paths.accounted_for());
    CHECK(y.paths.total == generic.roots.size());
    CHECK(y.paths.finite == generic.roots.size());
    CHECK(y.roots.size() == generic.roots.size());
    for (const auto& root : y.roots) CHECK(root.residual < 1e-9);
    return y;
}

}  // namespace

TEST_CASE("monodromy finds the 48 solutions of an arm of six joints, 16 of them real, from one") {
    const auto family = system_family(SixJoints());
    CHECK(family.support().size() > 20);
    for (const std::uint64_t seed : {1, 2}) {
        const auto generic = monodromy(family, six_joints, {.seed = seed});
        CHECK(generic.roots.size() == 48);
        CHECK(generic.closed());
        // roots come from infinity with the constants: the sums are not affine, and say nothing
        CHECK(generic.end == MonodromyEnd::quiet_loops);
        CHECK(generic.trace > 1e-3);
        CHECK(generic.quiet_loops == 10);
        CHECK(generic.sentence().find("evidence, no proof") != std::string::npos);
        CHECK(real_roots(check_at(generic, family, six_joints)) == 16);
    }
}

TEST_CASE("the trace test ends a search where the sums over all roots are affine") {
    const auto family = system_family(Platform());
    const auto generic = monodromy(family, platform);
    CHECK(generic.roots.size() == 6);
    CHECK(generic.end == MonodromyEnd::trace_test);
    CHECK(generic.trace < 1e-12);
    CHECK(real_roots(check_at(generic, family, platform)) == 6);

    for (const int n : {3, 4}) {
        const families::LoadedAngles model{n, families::row(n)};
        const auto p = families::generic(model.parameters(), 3);
        const std::vector<double> given(p.begin(), p.end());
        const auto angles = system_family(model);
        const auto row = monodromy(angles, given, {.seed = 5});
        CHECK(row.roots.size() == (n == 3 ? 16 : 44));
        CHECK(row.end == MonodromyEnd::trace_test);
        CHECK(row.loops < 40);
        check_at(row, angles, given);
    }
}

TEST_CASE("a system of numbers is a member of the family of its constants") {
    // Noonburg's network: 3^n - 2 n roots for generic constants too
    const auto noon = sparse_system(families::noon(3));
    const auto family = constants_family(noon);
    const auto constants = constants_of(noon);
    CHECK(constants == std::vector{1.0, 1.0, 1.0});
    CHECK(family.system(constants).terms().size() == noon.terms().size());
    const auto generic = monodromy(family, constants);
    CHECK(generic.roots.size() == 21);
    CHECK(generic.closed());
    check_at(generic, family, constants);
}

TEST_CASE("a search is the same for any number of threads, and may be cancelled") {
    const auto family = system_family(Platform());
    const auto one = monodromy(family, platform, {.seed = 9});
    const auto four = monodromy(family, platform, {.seed = 9, .executor = threads(4)});
    CHECK(one.parameters == four.parameters);
    CHECK(one.paths == four.paths);
    REQUIRE(one.roots.size() == four.roots.size());
    for (std::size_t k = 0; k < one.roots.size(); ++k)
        for (int u = 0; u < 3; ++u) CHECK(one.roots[k].q[u] == four.roots[k].q[u]);

    const std::atomic<bool> cancel = true;
    const auto cancelled = monodromy(family, platform, {.cancel = &cancel});
    CHECK(cancelled.end == MonodromyEnd::cancelled);
    CHECK(!cancelled.closed());
    CHECK(cancelled.roots.empty());
}

TEST_CASE("a search says what it was refused for, and what it did not find") {
    using Catch::Matchers::Contains;
    const auto family = system_family(Platform());
    CHECK_THROWS_WITH(monodromy(family, std::vector{1.0}), Contains("typical = 1: must have as many parameters"));
    CHECK_THROWS_WITH(monodromy(family, platform, {}, {.fixed = {3}}), Contains("fixed = 3: must be the number"));
    CHECK_THROWS_WITH(monodromy(family, platform, {}, {.fixed = {0, 1, 2}}), Contains("must leave a parameter free"));
    CHECK_THROWS_WITH(monodromy(family, platform, {}, {.quiet_loops = 0}), Contains("quiet_loops = 0"));
    CHECK_THROWS_WITH(monodromy(family, platform, {.checkpoint = "x"}), Contains("checkpoint = x"));

    // p (x^2 - 1) = 0 and p (x^2 - 2) = 0
    const SystemFamily none(RuntimeSizes(0, 2),
                            {{0, SparseMonomial({0, 0}), 0},
                             {0, SparseMonomial({2, 0}), 0},
                             {1, SparseMonomial({0, 0}), 0},
                             {1, SparseMonomial({2, 0}), 0}},
                            1, [](SystemFamily::Parameters p) {
                                return std::vector<std::complex<double>>{-p[0], p[0], -2.0 * p[0], p[0]};
                            });
    const auto nothing = monodromy(none, std::vector{1.0}, {}, {.newton_starts = 5});
    CHECK(nothing.end == MonodromyEnd::no_root);
    CHECK(nothing.newton_starts == 5);
    CHECK(nothing.sentence() == "no first root was found from 5 random points");
}
