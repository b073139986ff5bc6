/// \file
/// Proofs about a set of roots: that each exists, is distinct from the others, is real or not, and has its index; and,
/// where a proved bound is reached, that none is missing. Nothing of the tracker is believed: roots are candidates.
///
/// Each root is tested in doubles, then, where that is not enough, with 34 and 68 digits. A real candidate is tested
/// around a real point, so that the root is its own conjugate; any other must have an enclosure without real points.
/// Multiple roots cannot be proved this way: they stay undecided, and a set that holds one is never complete. A root
/// that counts as singular for its condition alone is proved with more digits.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/certify/certificate.hpp>
#include <equilibria/certify/exact_system.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// How far proofs go.
struct ProveOptions {
    int most_digits = 68;  ///< the most decimal digits that a proof may take: 15 (doubles), 34 or 68

    /// Throws InvalidArgument unless the digits are among these.
    void validate() const {
        require(most_digits == 15 || most_digits == 34 || most_digits == 68, "most_digits", most_digits,
                "must be 15, 34 or 68");
    }
};

/// A root that took more digits than a double has: where it is, rounded.
struct MovedRoot {
    std::size_t root;                     ///< its number in the set
    std::vector<std::complex<double>> q;  ///< angles in radians, then coordinates
    double radius;                        ///< of its certificate, around q
};

/// What is proved of a set of roots, of whatever model. Every number counts proofs.
struct ProofOfRoots {
    std::vector<Certificate> certificates;  ///< of set.roots, in their order
    std::uint64_t distinct = 0;             ///< roots proved to exist and to differ from each other
    std::uint64_t real = 0;                 ///< among those
    std::uint64_t non_real = 0;             ///< among those
    std::uint64_t undecided = 0;         ///< roots of the set of which neither is proved; real + non_real + undecided
                                         ///< + duplicates is the number of roots in the set
    std::uint64_t duplicates = 0;        ///< proved roots that could not be told from an earlier one
    std::uint64_t index = 0;             ///< real roots with a proved index
    std::uint64_t contradictions = 0;    ///< roots of which something else is proved than the enumeration says
    std::uint64_t more_digits = 0;       ///< roots that doubles were not enough for
    std::vector<std::int64_t> by_index;  ///< real roots by their proved index
    std::optional<ProvedBound> bound;    ///< of the number of isolated complex roots
    std::vector<MovedRoot> moved;        ///< roots that more digits have moved, by their number
    bool complete = false;               ///< no root is missing: `distinct` is the bound
    std::string reason;                  ///< why, or why not, in words
    double seconds = 0;                  ///< of the whole proof

    /// Leaves out the certificate of the root with the number k, which was taken from the set, and what was counted of
    /// it; nothing where it has none.
    void forget(std::size_t k);
};
/// The counts and the reason, in words.
std::ostream& operator<<(std::ostream& out, const ProofOfRoots& p);

/// A proof about a root set of the model M.
template <Model M>
struct Proof : ProofOfRoots {};

namespace detail {

/// A set of roots, whatever the model, with what a proof takes of the model.
struct RootsToProve {
    struct Candidate {
        std::span<const std::complex<double>> q;
        std::uint64_t path;
        bool singular;
    };
    /// What the enumeration says of a real root.
    struct Classified {
        std::uint64_t path;
        int index;
        bool degenerate;
    };
    ExactTerms equations;
    std::vector<Candidate> roots;
    std::vector<Classified> equilibria;
    std::optional<ProvedBound> bound;  ///< by the total degree
    /// The smallest bound known.
    std::function<std::optional<ProvedBound>()> smallest_bound;
};
ProofOfRoots prove_roots(const RootsToProve& set, const RunOptions& run, const ProveOptions& options);

/// Whether nothing is missing, by the best bound known, and why. found: how many roots the set has. best: that bound,
/// asked for where the first one is not reached.
void conclude_proof(ProofOfRoots& proof, std::size_t found, const std::optional<ProvedBound>& bound,
                    const std::function<std::optional<ProvedBound>()>& best);

/// equations: those of the model at the parameters of the set.
template <class M>
[[gnu::cold]] ProofOfRoots prove_set(const RootSet<M>& set, const ExactTerms& equations,
                                     std::function<std::optional<ProvedBound>()> smallest_bound, const RunOptions& run,
                                     const ProveOptions& options) {
    RootsToProve task{.equations = equations,
                      .roots = {},
                      .equilibria = {},
                      .bound = total_degree_bound(equations),
                      .smallest_bound = std::move(smallest_bound)};
    task.roots.reserve(set.roots.size());
    for (const auto& root : set.roots)
        task.roots.push_back({{root.q.begin(), root.q.end()}, root.path, !may_be_regular(root)});
    for (const auto& e : set.equilibria) task.equilibria.push_back({e.path, e.index, e.degenerate()});
    return prove_roots(task, run, options);
}

}  // namespace detail

/// Proves what can be proved of the roots of an enumeration. Throws InvalidArgument for options out of range, and for a
/// run with a checkpoint or a cancel.
template <Model M>
Proof<M> prove(const RootSet<M>& set, const RunOptions& run = {}, const ProveOptions& options = {}) {
    options.validate();
    run.require_whole("a proof");
    const auto exact = ExactSystem<M>::at(set.parameters);
    return {detail::prove_set(set, exact, [&] { return smallest_proved_bound<M>(exact); }, run, options)};
}

/// The same of the roots of a model at run time; bounds are the total degree and the mixed volume.
template <RuntimeModel T>
ProofOfRoots prove(const T& model, const RootSet<RuntimeUnknowns>& set, const RunOptions& run = {},
                   const ProveOptions& options = {}) {
    options.validate();
    run.require_whole("a proof");
    const ExactTerms exact = exact_terms(model, set.parameters);
    return detail::prove_set(
        set, exact,
        [&] {
            const auto volume = mixed_volume_bound(exact), degree = total_degree_bound(exact);
            return volume && degree && volume->value < degree->value ? volume : degree;
        },
        run, options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/proof_of_roots_definitions.hpp>
#include <equilibria/enumerate/detail/prove_definitions.hpp>
#endif
