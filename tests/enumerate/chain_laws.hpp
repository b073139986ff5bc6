// The laws of the rotating chain (Baillieul, section 3) for N links. Each N has a test file of its own, since each is
// an instantiation of the whole enumeration.
#pragma once

#include <vector>

#include "support/enumeration.hpp"

namespace tests {

/// The benchmark chain: its number of equilibria, the same bits whatever the number of threads.
template <int N>
void check_benchmark_chain(std::uint64_t real, const std::vector<unsigned>& threads) {
    std::vector<RootSet<Chain<N>>> results;
    for (const unsigned k : threads) results.push_back(enumerate<Chain<N>>(benchmark_chain<N>(), {.threads = k}));
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
            const auto r = enumerate<Chain<N>>(p, {.seed = static_cast<std::uint64_t>(seed), .threads = 2});
            check_generic_chain<N>(r);
            if (seed == 1) real = r.real();
            CHECK(r.real() == real);
        }
    }
}

/// Theorem 3.1: at small omega exactly the 2^N points with each angle 0 or pi, the index being the number of angles pi.
template <int N>
void check_small_omega(double omega) {
    const auto r = enumerate<Chain<N>>(benchmark_chain<N>(omega), {.threads = 2});
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

}  // namespace tests
