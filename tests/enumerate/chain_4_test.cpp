#include "enumerate/chain_laws.hpp"
#include "enumerate/instances.hpp"

template TESTS_ENUMERATION_OF(tests::Chain<4>);

TEST_CASE("4 links: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<4>(54, {1, 2, 3}); }
TEST_CASE("4 links: 4^n distinct roots, for any seed") { tests::check_seeds<4>(20); }
TEST_CASE("4 links: Theorem 3.1, small omega") { tests::check_small_omega<4>(.1); }
TEST_CASE("4 links: Theorem 3.2, random parameters") { tests::check_random_parameters<4>(10 * tests::thoroughness); }
TEST_CASE("4 links: at rest") { tests::check_at_rest<4>(); }

TEST_CASE("4 links: a count confirmed by interval branch and bound") {
    const auto r = equilibria::enumerate<tests::Chain<4>>(
        tests::chain<4>({.841, 2.146, .809, 2.078}, {.637, .74, .347, .188}, 1.056));
    tests::check_generic_chain<4>(r);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 10, 18, 14, 4});
}
