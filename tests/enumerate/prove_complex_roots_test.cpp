// Systems with known numbers of roots: all are found, each is proved, and none is missing where a bound of Bezout's
// says so.
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;

namespace {

struct Known {
    std::string name;
    std::int64_t total_degree, multihomogeneous;
    std::uint64_t roots;
};

}  // namespace

TEST_CASE("families of systems have their numbers of roots, each of them proved") {
    const std::vector<Known> systems{{"katsura-5", 32, 32, 32}, {"cyclic-5", 120, 120, 70}, {"eco-6", 162, 48, 16},
                                     {"noon-3", 27, 27, 21},    {"reimer-3", 24, 24, 12},   {"chandra-4", 16, 8, 8},
                                     {"row-3", 64, 24, 16},     {"kuramoto-3", 16, 8, 6}};
    for (const auto& known : systems) {
        INFO(known.name);
        if (const auto roots = families::known_roots(known.name); roots > 0)
            CHECK(roots == static_cast<std::int64_t>(known.roots));
        const auto system = sparse_system(families::by_name(known.name));
        CHECK(total_degree_count(system).value == known.total_degree);
        const auto smallest = smallest_multihomogeneous_number(system);
        CHECK(smallest.number.value == known.multihomogeneous);
        CHECK(multihomogeneous_number(system, smallest.grouping) == smallest.number);
        const auto by_degree = solve_total_degree(system, {.seed = 4});
        const auto by_groups = solve_multihomogeneous(system, smallest.grouping, {.seed = 4});
        CHECK(by_degree.paths.total == static_cast<std::uint64_t>(known.total_degree));
        CHECK(by_groups.paths.total == static_cast<std::uint64_t>(known.multihomogeneous));
        for (const auto& found : {by_degree, by_groups}) {
            CHECK(found.paths.accounted_for());
            CHECK(found.paths.failed == 0);
            CHECK(found.paths.finite == known.roots);
            const auto proof = prove(system, found, bezout_bounds(system));
            CHECK(proof.distinct == known.roots);
            CHECK(proof.undecided == 0);
            CHECK(proof.contradictions == 0);
            CHECK(proof.complete == (known.roots == static_cast<std::uint64_t>(known.multihomogeneous)));
            REQUIRE(proof.bound.has_value());
            CHECK(proof.bound->value == static_cast<std::uint64_t>(known.multihomogeneous));
            std::uint64_t real = 0;
            for (const auto& root : found.roots) real += is_real(root);
            CHECK(proof.real == real);
        }
    }
}

TEST_CASE("a system of angles as data: proved complete by its total degree, in angles and in their sines and cosines") {
    // each angle for itself
    const families::LoadedAngles model{3, {}};
    const auto system = families::system_of(model, families::generic(model.parameters(), 3));
    CHECK(total_degree_count(system).value == 8);
    CHECK(multihomogeneous_number(system, std::vector<int>{0, 1, 2}).value == 8);
    CHECK_THROWS_WITH(multihomogeneous_number(system, std::vector<int>{0, 1}),
                      "grouping = 2: must have a group for each unknown");
    const auto found = solve_total_degree(system);
    CHECK(prove(system, found, bezout_bounds(system)).complete);
    const auto plain = sparse_system(polynomial_system(system));
    CHECK(plain.sizes().coordinates == 6);
    const auto same = solve_total_degree(plain);
    CHECK(same.roots.size() == 8);
    CHECK(prove(plain, same, bezout_bounds(plain)).real == prove(system, found, bezout_bounds(system)).real);
}

TEST_CASE("a larger bound than the number of roots does not prove that none is missing, nor does a missing root") {
    const auto system = sparse_system(families::katsura(3));
    auto found = solve_total_degree(system);
    CHECK(prove(system, found, bezout_bounds(system)).complete);
    CHECK_FALSE(prove(system, found, {{9, "a number", "somebody's"}}).complete);
    CHECK_FALSE(prove(system, found, {}).complete);
    found.roots.pop_back();
    const auto proof = prove(system, found, bezout_bounds(system));
    CHECK_FALSE(proof.complete);
    CHECK(proof.reason == "all 7 roots found are proved, but the best bound known, the total degree 8, allows more");
}

TEST_CASE("points that cannot be roots, since a bound is reached without them, take no more digits") {
    const auto system = sparse_system(families::katsura(3));
    auto found = solve_total_degree(system);
    found.roots.push_back(found.roots.front());
    for (auto& z : found.roots.back().q) z += 0.1;
    CHECK(prove(system, found, {{9, "a number", "somebody's"}}).more_digits == 1);
    auto proof = prove(system, found, bezout_bounds(system));
    CHECK(proof.complete);
    CHECK(proof.more_digits == 0);
    CHECK(proof.undecided == 1);
    proof.forget(8);
    CHECK(proof.undecided == 0);
    CHECK(proof.certificates.size() == 8);
    const auto real = proof.real, path = proof.certificates[1].path;
    const bool is_real = proof.certificates[0].reality == Reality::real;
    proof.forget(0);
    CHECK(proof.distinct == 7);
    CHECK(proof.real == real - is_real);
    CHECK(proof.real + proof.non_real == 7);
    CHECK(proof.certificates[0].path == path);
    proof.forget(7);
    CHECK(proof.distinct == 7);
}

TEST_CASE("an equation that is a constant has no total-degree start") {
    const PolynomialSystem<double> system{{"x", "y"}, {{{1, {1, 0}}}, {{1, {0, 0}}}}};
    CHECK_THROWS_WITH(solve_total_degree(sparse_system(system)), "degree of equation 1 = 0: must be at least 1");
}
