// Coupled angles: fewer equilibria than the total degree, so most paths must be seen to go to infinity.
#pragma once

#include <vector>

#include "support/enumeration.hpp"
#include "support/models.hpp"

namespace tests {

/// binomial(2N, N) distinct roots with all-to-all coupling, `neighbours` with nearest neighbours alone; the rest of the
/// 4^N paths goes to infinity. Returns how many enumerations were checked: two a seed.
template <int N>
int check_coupled_angles(std::uint64_t all_to_all, std::uint64_t neighbours, int seeds) {
    using M = models::CoupledAngles<N>;
    Generator generator(50 + static_cast<std::uint64_t>(N));
    int checked = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Parameters<M> p;
        for (double& x : p) x = uniform(generator, 0.3, 1.3);
        const RunOptions options{.seed = static_cast<std::uint64_t>(seed), .executor = threads(2)};
        for (const std::uint64_t expected : {all_to_all, neighbours}) {
            if (expected == neighbours)
                for (int i = 0; i < N; ++i)
                    for (int j = 0; j < N; ++j)
                        if (std::abs(i - j) > 1) p[N * i + j] = 0;
            const auto r = enumerate<M, TotalDegree<M>>(p, options);
            check_accounts(r);
            CHECK(r.paths.total == std::uint64_t{1} << (2 * N));
            CHECK(r.paths.finite == expected);
            CHECK(r.paths.at_infinity == r.paths.total - expected);
            CHECK(r.distinct() == expected);
            CHECK(r.clean());
            CHECK(r.real() % 2 == 0);
            CHECK_FALSE(r.morse_applies());
            CHECK(distance(conjugated(r.roots), r.roots) < 1e-8);
            const auto least = enumerate<M>(p, options);
            CHECK(least.start.name == (N > 3 ? "polyhedral" : "total degree"));
            if (N > 3) CHECK(least.paths.total == expected);
            CHECK(least.paths.failed == 0);
            CHECK(distance(least.roots, r.roots) < 1e-8);
            ++checked;
        }
    }
    return checked;
}

}  // namespace tests
