#include "enumerate/chain_laws.hpp"
#include "enumerate/instances.hpp"

template TESTS_ENUMERATION_OF(tests::Chain<3>);

TEST_CASE("3 links: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<3>(26, {1, 2, 3}); }
TEST_CASE("3 links: 4^n distinct roots, for any seed") { tests::check_seeds<3>(20); }
TEST_CASE("3 links: Theorem 3.1, small omega") { tests::check_small_omega<3>(.1); }
TEST_CASE("3 links: Theorem 3.2, random parameters") { tests::check_random_parameters<3>(30 * tests::thoroughness); }
TEST_CASE("3 links: at rest") { tests::check_at_rest<3>(); }

TEST_CASE("3 links: counts confirmed by interval branch and bound") {
    const auto few =
        equilibria::enumerate<tests::Chain<3>>(tests::chain<3>({1.387, 1.538, 1.087}, {.505, .364, .302}, .655));
    tests::check_generic_chain<3>(few);
    CHECK(few.by_index() == std::vector<std::int64_t>{2, 4, 3, 1});

    const auto all = equilibria::enumerate<tests::Chain<3>>(tests::chain<3>({1, 2.1, 4.5}, {.75, .225, .025}, 6));
    tests::check_generic_chain<3>(all);
    CHECK(all.by_index() == std::vector<std::int64_t>{8, 24, 24, 8});
}
