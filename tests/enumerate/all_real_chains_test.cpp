// Chains whose 4^n equilibria are all real (docs/all-real-equilibria.md): dominant links, omega above the bound given
// there; 2^n C(n, k) equilibria of index k, each proved.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

struct DominantChain {
    std::vector<double> lengths, hanging;  ///< l_i, and M_i = m_i + .. + m_n
    double kappa(std::size_t i) const {
        double others = 0;
        for (std::size_t j = 0; j < lengths.size(); ++j)
            if (j != i) others += hanging[std::max(i, j)] * lengths[j];
        return 1 - others / (hanging[i] * lengths[i]);
    }
    /// The omega of the theorem, for g = 1.
    double least_speed() const {
        double y = 0;
        for (std::size_t i = 0; i < lengths.size(); ++i)
            y = std::max(y, std::pow(1 + kappa(i), 1.5) / (std::pow(kappa(i), 2.5) * lengths[i]));
        return std::sqrt(y);
    }
    RuntimeArray<double> parameters(double omega) const {
        const int n = static_cast<int>(lengths.size());
        RuntimeArray<double> p(2 * n + 2);
        for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            p[i] = lengths[at];
            p[n + i] = hanging[at] - (i + 1 < n ? hanging[at + 1] : 0);
        }
        p[2 * n] = omega;
        p[2 * n + 1] = 1;
        return p;
    }
};

/// Links that grow by 2.5 to 4 and hang 5 to 20 times less; drawn until all are dominant.
DominantChain dominant(int links, Generator& generator) {
    while (true) {
        DominantChain chain;
        double length = 1, mass = 1;
        bool good = true;
        for (int i = 0; i < links; ++i) {
            chain.lengths.push_back(length *= uniform(generator, 2.5, 4));
            chain.hanging.push_back(mass *= uniform(generator, 0.05, 0.2));
        }
        for (std::size_t i = 0; i < chain.lengths.size(); ++i) good = good && chain.kappa(i) > 0.1;
        if (good) return chain;
    }
}

}  // namespace

TEST_CASE("dominant chains have 4^n real equilibria above the bound of the speed, 2^n C(n, k) of index k, all proved") {
    Generator generator(26);
    for (int n = 1; n <= 5; ++n)
        for (int draw = 0; draw < (n < 4 ? 10 : 3); ++draw) {
            const DominantChain chain = dominant(n, generator);
            const mechanisms::RuntimeRotatingChain model{n};
            const auto found = enumerate(model, chain.parameters(1.001 * chain.least_speed()));
            REQUIRE(found.real() == std::uint64_t{1} << (2 * n));
            std::int64_t count = std::int64_t{1} << n;
            for (int k = 0; k <= n; ++k) {
                CHECK(found.by_index()[static_cast<std::size_t>(k)] == count);
                count = count * (n - k) / (k + 1);
            }
            const auto proof = prove(model, found);
            CHECK(proof.complete);
            CHECK(proof.real == found.real());
            CHECK(proof.index == found.real());
        }
}
