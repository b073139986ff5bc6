/// \file
/// The Morse relations of a function with nondegenerate critical points on the n-torus, whose Betti numbers are the
/// binomials: a law that the list of all equilibria of angles-only models must obey.
#pragma once

#include <cstdint>
#include <vector>

namespace equilibria {

/// Which of the relations hold for the numbers N_k of critical points of index k = 0 .. n on the n-torus.
struct MorseRelations {
    bool euler = false;   ///< sum (-1)^k N_k = 0 (Poincare-Hopf; for n >= 1)
    bool weak = false;    ///< N_k >= binomial(n, k)
    bool strong = false;  ///< N_k - N_{k-1} + ... >= binomial(n, k) - binomial(n, k-1) + ... for each k
    constexpr bool all() const { return euler && weak && strong; }  ///< every relation holds
};

/// by_index: N_0 .. N_n.
inline MorseRelations morse_relations(const std::vector<std::int64_t>& by_index) {
    MorseRelations y{true, true, true};
    const auto n = static_cast<std::int64_t>(by_index.size()) - 1;
    std::int64_t binomial = 1, alternating = 0, betti = 0;
    for (std::int64_t k = 0; k <= n; ++k) {
        const std::int64_t count = by_index[static_cast<std::size_t>(k)];
        alternating = count - alternating;
        betti = binomial - betti;
        y.weak = y.weak && count >= binomial;
        y.strong = y.strong && alternating >= betti;
        binomial = binomial * (n - k) / (k + 1);
    }
    y.euler = alternating == 0;
    return y;
}

}  // namespace equilibria
