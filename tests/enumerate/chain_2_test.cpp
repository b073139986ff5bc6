#include "enumerate/chain_laws.hpp"
#include "enumerate/instances.hpp"

template TESTS_ENUMERATION_OF(tests::Chain<2>);

TEST_CASE("2 links: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<2>(10, {1, 2, 3}); }
TEST_CASE("2 links: 4^n distinct roots, for any seed") { tests::check_seeds<2>(20); }
TEST_CASE("2 links: Theorem 3.1, small omega") { tests::check_small_omega<2>(.1); }
TEST_CASE("2 links: Theorem 3.2, random parameters") { tests::check_random_parameters<2>(40 * tests::thoroughness); }
TEST_CASE("2 links: at rest") { tests::check_at_rest<2>(); }
