#include "enumerate/chain_laws.hpp"
#include "enumerate/instances.hpp"

template TESTS_ENUMERATION_OF(tests::Chain<5>);

TEST_CASE("5 links: the benchmark chain, for any number of threads") {
    tests::check_benchmark_chain<5>(116, {1, 2, 3});
}
TEST_CASE("5 links: 4^n distinct roots, for any seed") { tests::check_seeds<5>(2 * tests::thoroughness); }
TEST_CASE("5 links: Theorem 3.1, small omega") { tests::check_small_omega<5>(.1); }
TEST_CASE("5 links: at rest") { tests::check_at_rest<5>(); }
