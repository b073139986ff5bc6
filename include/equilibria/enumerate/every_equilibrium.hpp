/// \file
/// Every isolated equilibrium of a model, proved, with a verdict on completeness: what `enumerate`, `prove` and
/// every_root say together.
///
/// A model of angles alone is enumerated and proved as it is. Where that leaves something open, and where there are
/// coordinates, whose units matter, its equations are solved as a system by every_root; the equilibria are classified
/// in the units of that search. Real, not real, and the index are what is proved, where it is.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

/// Equilibria, their proof, and what explains the paths that lead to none.
struct EveryEquilibrium {
    RootSet<RuntimeUnknowns> set;             ///< with its verdict, set.completeness
    ProofOfRoots proof;                       ///< of set.roots
    std::vector<char> confirmed;              ///< of each root that is singular: its multiplicity was confirmed
    std::vector<DivergingPaths> at_infinity;  ///< explained paths, by their direction
};

namespace detail {

/// What every_equilibrium needs of a model, its numbers of unknowns known at run time.
struct ModelToSolve {
    RuntimeArray<double> p;
    ModelProperties<RuntimeUnknowns> model;
    ExactTerms exact;
    const RealEquations* equations;
};

/// The verdict that a proof alone gives.
RootsVerdict verdict_of(const ProofOfRoots& proof);
/// What is proved replaces what was measured: indices, and that an equilibrium is not degenerate.
void take_proved_indices(RootSet<RuntimeUnknowns>& set, const ProofOfRoots& proof);
/// The equilibria among the roots of a system, classified in its units.
EveryEquilibrium equilibria_of(const SparseSystem& system, const ModelToSolve& problem, const RunOptions& run,
                               std::optional<StartKind> asked);

}  // namespace detail

/// Every isolated equilibrium of a model at run time at the parameters p. StartSystem: as of enumerate_from. Throws as
/// enumerate_from, and where the run names a checkpoint.
template <class StartSystem = LeastCost, RuntimeModel T>
EveryEquilibrium every_equilibrium(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {}) {
    const detail::Stopwatch clock;
    EveryEquilibrium y;
    RunOptions whole = run;
    whole.cancel = nullptr;
    const RuntimeSizes sizes = sizes_of(model);
    constexpr bool asked = !std::is_same_v<StartSystem, LeastCost>;
    const detail::ModelToSolve problem{p, {}, exact_terms(model, p), nullptr};
    const RuntimeFormulation formulation(model);
    const auto system = detail::system_of_terms(sizes, RuntimeModelSystem(formulation, model, p).terms);
    if (sizes.coordinates == 0 || !system || asked) {
        y.set = enumerate_from<StartSystem>(model, p, run);
        if (y.set.cancelled()) return y;
        y.proof = prove(model, y.set, whole);
        y.confirmed.assign(y.set.roots.size(), 0);
        y.set.completeness = detail::verdict_of(y.proof);
        detail::take_proved_indices(y.set, y.proof);
        if (y.proof.complete || !system) {
            y.set.seconds = clock.seconds();
            return y;
        }
    }
    const detail::RealRuntimeEquations<T> equations(model, p);
    detail::ModelToSolve whole_problem = problem;
    whole_problem.model = {sizes, RuntimePotentialModel<T>, formulation.reflection_symmetric()};
    whole_problem.equations = &equations;
    constexpr auto kind = std::is_same_v<StartSystem, Polyhedral> ? std::optional(StartKind::polyhedral) : std::nullopt;
    auto found = detail::equilibria_of(*system, whole_problem, whole, kind);
    found.set.seconds = clock.seconds();
    return found;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/every_equilibrium_definitions.hpp>
#endif
