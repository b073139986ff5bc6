/// \file
/// What one start of every_root found, and its proof. See enumerate/every_root.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/enumerate/every_root_options.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria::detail {

/// What one start found, in scaled units.
struct RootAttempt {
    StartChoice start;
    ComplexRoots<> found;
    std::vector<char> confirmed;
    ProofOfRoots proof;
    std::vector<Family<RuntimeUnknowns>> families;
    std::vector<DivergingPaths> at_infinity;
    std::uint64_t unexplained = 0;  ///< paths
    std::uint64_t hidden = 0;       ///< of those, paths to multiple roots at infinity: other starts have them, too
    std::string left;               ///< what they are, in words
    double tracking_seconds = 0;

    /// Takes the root with the number k out of the set, and out of its proof.
    void leave_out(std::size_t k) {
        const auto at = static_cast<std::ptrdiff_t>(k);
        found.roots.erase(found.roots.begin() + at);
        confirmed.erase(confirmed.begin() + at);
        proof.forget(k);
    }
    /// Proved regular roots, and confirmed multiple ones by their multiplicities.
    std::uint64_t counted() const {
        std::uint64_t y = proof.distinct;
        for (std::size_t k = 0; k < found.roots.size(); ++k)
            if (confirmed[k]) y += static_cast<std::uint64_t>(found.roots[k].paths);
        return y;
    }
};

/// A proof of the roots, which are moved to where it finds them.
inline ProofOfRoots prove_and_refine(const SparseSystem& system, ComplexRoots<>& found,
                                     const std::vector<ProvedBound>& bounds, const RunOptions& run) {
    auto proof = prove(system, found, bounds, {.executor = run.executor, .ranks = run.ranks});
    for (const MovedRoot& refined : proof.moved) {
        auto& root = found.roots[refined.root];
        std::copy(refined.q.begin(), refined.q.end(), root.q.begin());
        proof.certificates[refined.root].radius = refined.radius;
    }
    return proof;
}

}  // namespace equilibria::detail
