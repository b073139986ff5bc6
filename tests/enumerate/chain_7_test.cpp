#include "enumerate/chain_laws.hpp"

TEST_CASE("7 links: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<7>(548, {1, 2}); }

TEST_CASE("7 links: Theorem 3.1, small omega") { tests::check_small_omega<7>(.15); }
