/// \file
/// What a proof says in the end, and of a set from which roots were taken. See enumerate/prove.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include <equilibria/enumerate/prove.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::ostream& operator<<(std::ostream& out, const ProofOfRoots& p) {
    return out << p.distinct << " distinct roots proved, " << p.real << " real, " << p.non_real << " non-real, "
               << p.undecided << " undecided, " << p.index << " with their index; "
               << (p.complete ? "complete: " : "not proved complete: ") << p.reason;
}

EQUILIBRIA_INLINE void ProofOfRoots::forget(std::size_t k) {
    if (k >= certificates.size()) return;
    const Certificate& c = certificates[k];
    if (!c.exists) {
        --undecided;
    } else if (!c.distinct) {
        --duplicates;
    } else {
        --distinct;
        --(c.reality == Reality::real ? real : c.reality == Reality::non_real ? non_real : undecided);
        index -= c.index_proved;
        if (c.index_proved) --by_index[static_cast<std::size_t>(c.index)];
    }
    certificates.erase(certificates.begin() + static_cast<std::ptrdiff_t>(k));
    std::erase_if(moved, [k](const MovedRoot& root) { return root.root == k; });
    for (MovedRoot& root : moved) root.root -= root.root > k;
}

namespace detail {

EQUILIBRIA_INLINE void conclude_proof(ProofOfRoots& proof, std::size_t found, const std::optional<ProvedBound>& bound,
                                      const std::function<std::optional<ProvedBound>()>& best) {
    const auto count = [](std::uint64_t k) { return std::to_string(k); };
    proof.bound = bound;
    if (!proof.bound) {
        proof.reason = "an equation vanishes at these parameters, or the bound is too large to count";
        return;
    }
    if (proof.distinct < proof.bound->value) proof.bound = best();
    const std::string name = "the " + proof.bound->name + " " + count(proof.bound->value);
    proof.complete = proof.distinct == proof.bound->value;
    if (proof.complete)
        proof.reason = count(proof.distinct) + " roots are proved to be distinct, as many as " + name +
                       " allows: " + proof.bound->no_other();
    else if (proof.distinct == found)
        proof.reason = "all " + count(proof.distinct) + " roots found are proved, but the best bound known, " + name +
                       ", allows more";
    else
        proof.reason = count(proof.distinct) + " of " + count(found) + " roots are proved to be distinct, and " + name +
                       " allows more";
}

}  // namespace detail

}  // namespace equilibria
