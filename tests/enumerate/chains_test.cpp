// The laws of the rotating chain (Baillieul, section 3) for 1 to 8 links.
#include <vector>

#include "support/enumeration.hpp"

using namespace tests;

namespace {

/// The benchmark chain: its number of equilibria, the same bits whatever the number of threads.
template <int N>
void check_benchmark_chain(std::uint64_t real, const std::vector<unsigned>& counts) {
    std::vector<RootSet<Chain<N>>> results;
    for (const unsigned k : counts)
        results.push_back(enumerate<Chain<N>>(benchmark_chain<N>(), {.executor = threads(k)}));
    check_generic_chain<N>(results[0]);
    CHECK(results[0].real() == real);
    for (const auto& r : results) CHECK(identical(r, results[0]));
}

/// 4^N finite and distinct ones whatever the seed, of the benchmark chain and of a random one.
template <int N>
void check_seeds(int seeds) {
    Generator generator(static_cast<std::uint64_t>(N));
    for (const auto& p : {benchmark_chain<N>(), random_chain<N>(generator)}) {
        std::uint64_t real = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto r = enumerate<Chain<N>>(p, {.seed = static_cast<std::uint64_t>(seed), .executor = threads(2)});
            check_generic_chain<N>(r);
            if (seed == 1) real = r.real();
            CHECK(r.real() == real);
        }
    }
}

/// Theorem 3.1: at small omega exactly the 2^N points with each angle 0 or pi, the index being the number of angles pi.
template <int N>
void check_small_omega(double omega) {
    const auto r = enumerate<Chain<N>>(benchmark_chain<N>(omega), {.executor = threads(2)});
    check_generic_chain<N>(r);
    REQUIRE(r.real() == std::uint64_t{1} << N);
    std::int64_t binomial = 1;
    for (int k = 0; k <= N; ++k) {
        CHECK(r.by_index()[static_cast<std::size_t>(k)] == binomial);
        binomial = binomial * (N - k) / (k + 1);
    }
    for (const auto& e : r.equilibria) {
        int inverted = 0;
        for (const double angle : e.q) inverted += std::abs(angle) > 1;
        CHECK(e.index == inverted);
    }
}

/// Theorem 3.2: never fewer than 2^N, never more than 4^N real ones (check_generic_chain counts), at random parameters.
template <int N>
void check_random_parameters(int cases) {
    Generator generator(100 + static_cast<std::uint64_t>(N));
    for (int k = 0; k < cases; ++k)
        check_generic_chain<N>(
            enumerate<Chain<N>>(random_chain<N>(generator), {.seed = static_cast<std::uint64_t>(k)}));
}

/// Where nothing turns, every angle is 0 or pi; the other 4^N - 2^N paths go to infinity.
template <int N>
void check_at_rest() {
    const auto r = enumerate<Chain<N>>(benchmark_chain<N>(0.0));
    check_accounts(r);
    CHECK(r.paths.finite == std::uint64_t{1} << N);
    CHECK(r.paths.at_infinity == r.paths.total - r.paths.finite);
    CHECK(r.real() == std::uint64_t{1} << N);
    CHECK(r.morse());
}

}  // namespace

TEST_CASE("1 link: the benchmark chain, for any number of threads") { check_benchmark_chain<1>(4, {1, 2}); }
TEST_CASE("1 link: 4^n distinct roots, for any seed") { check_seeds<1>(20); }
TEST_CASE("1 link: Theorem 3.1, small omega") { check_small_omega<1>(.1); }
TEST_CASE("1 link: Theorem 3.2, random parameters") { check_random_parameters<1>(20 * thoroughness); }
TEST_CASE("1 link: at rest") { check_at_rest<1>(); }

TEST_CASE("2 links: the benchmark chain, for any number of threads") { check_benchmark_chain<2>(10, {1, 2, 3}); }
TEST_CASE("2 links: 4^n distinct roots, for any seed") { check_seeds<2>(20); }
TEST_CASE("2 links: Theorem 3.1, small omega") { check_small_omega<2>(.1); }
TEST_CASE("2 links: Theorem 3.2, random parameters") { check_random_parameters<2>(40 * thoroughness); }
TEST_CASE("2 links: at rest") { check_at_rest<2>(); }

TEST_CASE("3 links: the benchmark chain, for any number of threads") { check_benchmark_chain<3>(26, {1, 2, 3}); }
TEST_CASE("3 links: 4^n distinct roots, for any seed") { check_seeds<3>(20); }
TEST_CASE("3 links: Theorem 3.1, small omega") { check_small_omega<3>(.1); }
TEST_CASE("3 links: Theorem 3.2, random parameters") { check_random_parameters<3>(30 * thoroughness); }
TEST_CASE("3 links: at rest") { check_at_rest<3>(); }

TEST_CASE("3 links: counts confirmed by interval branch and bound") {
    const auto few = enumerate<Chain<3>>(chain<3>({1.387, 1.538, 1.087}, {.505, .364, .302}, .655));
    check_generic_chain<3>(few);
    CHECK(few.by_index() == std::vector<std::int64_t>{2, 4, 3, 1});

    const auto all = enumerate<Chain<3>>(chain<3>({1, 2.1, 4.5}, {.75, .225, .025}, 6));
    check_generic_chain<3>(all);
    CHECK(all.by_index() == std::vector<std::int64_t>{8, 24, 24, 8});
}

TEST_CASE("4 links: the benchmark chain, for any number of threads") { check_benchmark_chain<4>(54, {1, 2, 3}); }
TEST_CASE("4 links: 4^n distinct roots, for any seed") { check_seeds<4>(20); }
TEST_CASE("4 links: Theorem 3.1, small omega") { check_small_omega<4>(.1); }
TEST_CASE("4 links: Theorem 3.2, random parameters") { check_random_parameters<4>(10 * thoroughness); }
TEST_CASE("4 links: at rest") { check_at_rest<4>(); }

TEST_CASE("4 links: a count confirmed by interval branch and bound") {
    const auto r = enumerate<Chain<4>>(chain<4>({.841, 2.146, .809, 2.078}, {.637, .74, .347, .188}, 1.056));
    check_generic_chain<4>(r);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 10, 18, 14, 4});
}

TEST_CASE("5 links: the benchmark chain, for any number of threads") { check_benchmark_chain<5>(116, {1, 2, 3}); }
TEST_CASE("5 links: 4^n distinct roots, for any seed") { check_seeds<5>(2 * thoroughness); }
TEST_CASE("5 links: Theorem 3.1, small omega") { check_small_omega<5>(.1); }
TEST_CASE("5 links: at rest") { check_at_rest<5>(); }

TEST_CASE("6 links: the benchmark chain, for any number of threads") { check_benchmark_chain<6>(250, {1, 2, 3}); }
TEST_CASE("6 links: 4^n distinct roots, for any seed") { check_seeds<6>(2 * thoroughness); }
TEST_CASE("6 links: Theorem 3.1, small omega") { check_small_omega<6>(.1); }

TEST_CASE("6 links: a count confirmed by interval branch and bound") {
    const auto r = enumerate<Chain<6>>(
        chain<6>({2.148, .792, .934, 2.105, 1.648, 1.496}, {1.013, 1.403, 1.331, .974, .918, 1.905}, .917));
    check_generic_chain<6>(r);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 14, 37, 53, 38, 11, 1});
}

TEST_CASE("7 links: the benchmark chain, for any number of threads") { check_benchmark_chain<7>(548, {1, 2}); }

TEST_CASE("7 links: Theorem 3.1, small omega") { check_small_omega<7>(.15); }

TEST_CASE("8 links: the benchmark chain, for any number of threads") { check_benchmark_chain<8>(1158, {1, 2}); }

TEST_CASE("8 links: Theorem 3.1, small omega") { check_small_omega<8>(.15); }
