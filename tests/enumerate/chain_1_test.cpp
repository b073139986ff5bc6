#include "enumerate/chain_laws.hpp"
#include "enumerate/instances.hpp"

template TESTS_ENUMERATION_OF(tests::Chain<1>);

TEST_CASE("1 link: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<1>(4, {1, 2}); }
TEST_CASE("1 link: 4^n distinct roots, for any seed") { tests::check_seeds<1>(20); }
TEST_CASE("1 link: Theorem 3.1, small omega") { tests::check_small_omega<1>(.1); }
TEST_CASE("1 link: Theorem 3.2, random parameters") { tests::check_random_parameters<1>(20 * tests::thoroughness); }
TEST_CASE("1 link: at rest") { tests::check_at_rest<1>(); }
