#include "enumerate/chain_laws.hpp"

TEST_CASE("8 links: the benchmark chain, for any number of threads") { tests::check_benchmark_chain<8>(1158, {1, 2}); }

TEST_CASE("8 links: Theorem 3.1, small omega") { tests::check_small_omega<8>(.15); }
