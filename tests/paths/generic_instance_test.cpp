#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/generic_instance.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;

namespace {

void check_roots(const ComplexRoots<>& found, std::uint64_t expected) {
    CHECK(found.paths.accounted_for());
    CHECK(found.paths.failed == 0);
    CHECK(found.paths.crossed == 0);
    std::uint64_t regular = 0;
    for (const auto& root : found.roots) {
        regular += root.status == PathStatus::finite;
        CHECK(root.residual < 1e-9);
    }
    CHECK(regular == expected);
}
bool same(const Root<RuntimeUnknowns>& a, const Root<RuntimeUnknowns>& b) {
    return std::ranges::equal(a.q, b.q) && a.residual == b.residual && a.condition == b.condition;
}

}  // namespace

TEST_CASE("systems of the literature have their roots, whatever the seed: cyclic, katsura, noon, eco") {
    for (const char* name : {"cyclic-5", "katsura-4", "noon-3", "noon-4", "eco-6"}) {
        const auto system = sparse_system(families::by_name(name));
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            INFO(name << ", seed " << seed);
            check_roots(solve_polyhedral(system, {.seed = seed}),
                        static_cast<std::uint64_t>(families::known_roots(name)));
        }
    }
}

TEST_CASE("roots with a coordinate 0 are found: x (x - 1) = 0, x y + y^2 - y = 0") {
    const SparseSystem system(RuntimeSizes(0, 2), {{0, SparseMonomial({2, 0}), 1},
                                                   {0, SparseMonomial({1, 0}), -1},
                                                   {1, SparseMonomial({1, 1}), 1},
                                                   {1, SparseMonomial({0, 2}), 1},
                                                   {1, SparseMonomial({0, 1}), -1}});
    const auto found = solve_polyhedral(system);
    // (0, 0), (0, 1) and, doubly, (1, 0)
    CHECK(found.paths.total == 4);
    CHECK(found.paths.finite == 2);
    CHECK(found.paths.singular == 2);
    CHECK(found.paths.accounted_for());
}

TEST_CASE(
    "coupled angles with loads have C(2n, n) roots, rows 2.73^n or so, and one generic instance serves all "
    "parameters") {
    for (const int n : {3, 4}) {
        const families::LoadedAngles model{n, families::complete(n)};
        const auto system = [&](std::uint64_t seed) {
            return families::system_of(model, families::generic(model.parameters(), seed));
        };
        const GenericInstance instance(system(1));
        const std::uint64_t expected = n == 3 ? 20 : 70;
        CHECK(instance.mixed_volume() == expected);
        CHECK(instance.failed() == 0);
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const auto found = instance.solve(system(seed));
            check_roots(found, expected);
            CHECK(found.paths.total == expected);
            CHECK(found.start == "polyhedral");
        }
    }
    const families::LoadedAngles row{5, families::row(5)};
    check_roots(solve_polyhedral(families::system_of(row, families::generic(row.parameters(), 1))), 120);
}

TEST_CASE(
    "the same seed gives the same roots, bit by bit, with any number of threads, and in double, the same to rounding") {
    const families::LoadedAngles model{5, families::complete(5)};
    const auto system = families::system_of(model, families::generic(model.parameters(), 3));
    const auto serial = solve_polyhedral(system), parallel = solve_polyhedral(system, {.executor = threads(3)});
    REQUIRE(serial.roots.size() == parallel.roots.size());
    for (std::size_t k = 0; k < serial.roots.size(); ++k) CHECK(same(serial.roots[k], parallel.roots[k]));
    TrackerOptions in_double;
    in_double.single_precision = false;
    const auto other = solve_polyhedral(system, {}, in_double);
    REQUIRE(serial.roots.size() == other.roots.size());
    for (const auto& root : serial.roots) {
        double nearest = 1e300;
        for (const auto& candidate : other.roots) {
            double distance = 0;
            for (int u = 0; u < 5; ++u)
                distance = std::max(distance, std::abs(std::exp(std::complex<double>(0, 1) * root.q[u]) /
                                                           std::exp(std::complex<double>(0, 1) * candidate.q[u]) -
                                                       1.0));
            nearest = std::min(nearest, distance);
        }
        CHECK(nearest < 1e-10);
    }
}

TEST_CASE("a target with other unknowns or exponents is refused") {
    const families::LoadedAngles small{3, families::row(3)}, full{3, families::complete(3)};
    const GenericInstance instance(families::system_of(small, families::generic(small.parameters(), 1)));
    CHECK_THROWS_AS(instance.solve(families::system_of(full, families::generic(full.parameters(), 1))),
                    InvalidArgument);
    CHECK_THROWS_AS(instance.solve(sparse_system(families::cyclic(3))), InvalidArgument);
}

TEST_CASE("uniform coupling of all oscillators leaves 2^N - 2 finite roots, and the rest at toric infinity") {
    for (const int oscillators : {4, 5}) {
        const families::Oscillators model{oscillators - 1, families::complete(oscillators)};
        const auto system = families::system_of(model, families::equal_couplings(model, 1));
        const auto found = solve_polyhedral(system);
        const auto expected = (std::uint64_t{1} << oscillators) - 2;
        check_roots(found, expected);
        CHECK(found.paths.at_infinity == found.paths.total - expected);
    }
}

TEST_CASE(
    "the start of the least predicted cost: polyhedral where the mixed volume is small, degrees where it is not") {
    const auto eco = sparse_system(families::eco(8));
    const auto bounds = start_bounds(eco, {}, true);
    CHECK(bounds.total_degree == PathCount{1458, false});
    CHECK(bounds.mixed_volume == 64U);
    const auto choice = choose_start(bounds);
    CHECK(choice.kind == StartKind::polyhedral);
    CHECK_FALSE(choice.why.empty());
    CHECK(choose_start(bounds, StartKind::total_degree).kind == StartKind::total_degree);
    const auto katsura = sparse_system(families::katsura(4));
    const auto counted = start_bounds(katsura);
    CHECK(choose_start(counted).kind == StartKind::total_degree);
    // what cannot pay is not counted to its end
    CHECK_FALSE(counted.mixed_volume.has_value());
    for (const auto kind : {StartKind::total_degree, StartKind::multihomogeneous, StartKind::polyhedral})
        check_roots(solve_from_start(eco, choose_start(bounds, kind)), 64);
}
