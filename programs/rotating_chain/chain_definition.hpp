// The definition of what chain.hpp declares, instantiated by units that compile side by side.
#pragma once

#include "rotating_chain/chain.hpp"

#include <equilibria/certify/refine_root.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "instances/enumerate/chain_enumerations.hpp"
#include "instances/enumerate/chain_proofs.hpp"

template <int Links>
ChainResult enumerate_chain(const Chain& chain, const Options& options) {
    using Model = equilibria::mechanisms::RotatingChain<Links>;
    equilibria::Parameters<Model> p;
    for (int k = 0; k < Links; ++k) {
        p[Model::length + k] = chain.lengths[static_cast<std::size_t>(k)];
        p[Model::mass + k] = chain.masses[static_cast<std::size_t>(k)];
    }
    p[Model::omega] = chain.omega;
    p[Model::gravity] = chain.gravity;
    const auto found = equilibria::enumerate<Model>(
        p, {.seed = options.seed,
            .executor = equilibria::threads(options.threads),
            .progress = options.progress,
            .checkpoint = options.checkpoint,
            .cancel = options.cancel});

    ChainResult result{.paths = found.paths,
                       .distinct = found.distinct(),
                       .degenerate = found.degenerate(),
                       .clean = found.clean(),
                       .morse_applies = found.morse_applies(),
                       .morse = found.morse(),
                       .by_index = found.by_index(),
                       .tracking_seconds = found.tracking_seconds,
                       .seconds = found.seconds,
                       .equilibria = {},
                       .failures = {},
                       .multiplicities = {},
                       .winding_numbers = {},
                       .families = {},
                       .alarms = found.alarms.sentences(),
                       .proof = {}};
    for (const auto& e : found.equilibria) {
        result.equilibria.push_back({{e.q.begin(), e.q.end()}, e.index, e.nullity, e.multiplicity, e.energy, e.residual,
                                     e.condition, e.margin, {}, {}});
        for (double& angle : result.equilibria.back().angles) angle += 0.0;  // -0 becomes 0
    }
    for (const auto& root : found.roots) {
        result.multiplicities.push_back(root.paths);
        result.winding_numbers.push_back(root.winding_number);
    }
    for (const auto& family : found.families)
        result.families.push_back(std::string(family.real() ? "a real " : "a ") +
                                  equilibria::family_kind(family.dimension) + " of solutions (" +
                                  std::to_string(family.paths()) + " paths)");
    if (options.prove) {
        const auto proof = equilibria::prove(found, {.executor = equilibria::threads(options.threads)});
        result.proof = {proof.distinct, proof.real,  proof.non_real,       proof.undecided,
                        proof.duplicates, proof.index, proof.contradictions, proof.more_digits,
                        proof.bound ? proof.bound->value : 0, proof.complete, proof.reason, proof.seconds};
        std::size_t k = 0;
        for (const auto& e : found.equilibria) {
            const auto at = std::lower_bound(proof.certificates.begin(), proof.certificates.end(), e.path,
                                             [](const auto& c, std::uint64_t path) { return c.path < path; });
            result.equilibria[k++].certificate = *at;
        }
    }
    if (options.digits > 0) {
        std::size_t k = 0;
        for (const auto& e : found.equilibria) {
            equilibria::Array<std::complex<double>, Links> q;
            for (int i = 0; i < Links; ++i) q[i] = e.q[i];
            const auto refined = equilibria::refine<Model>(q, p, options.digits);
            result.equilibria[k++].digits = {{refined.real.begin(), refined.real.end()}, refined.proved, refined.error};
        }
    }
    for (const auto& f : found.failures) result.failures.push_back({f.path, std::string(to_string(f.reason))});
    return result;
}
