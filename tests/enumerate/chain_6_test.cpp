#include "enumerate/chain_laws.hpp"

TEST_CASE("6 links: the benchmark chain, for any number of threads") {
    tests::check_benchmark_chain<6>(250, {1, 2, 3});
}
TEST_CASE("6 links: 4^n distinct roots, for any seed") { tests::check_seeds<6>(2 * tests::thoroughness); }
TEST_CASE("6 links: Theorem 3.1, small omega") { tests::check_small_omega<6>(.1); }

TEST_CASE("6 links: a count confirmed by interval branch and bound") {
    const auto r = equilibria::enumerate<tests::Chain<6>>(
        tests::chain<6>({2.148, .792, .934, 2.105, 1.648, 1.496}, {1.013, 1.403, 1.331, .974, .918, 1.905}, .917));
    tests::check_generic_chain<6>(r);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 14, 37, 53, 38, 11, 1});
}
