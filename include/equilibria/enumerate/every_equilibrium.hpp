/// \file
/// Every isolated equilibrium of a model, proved, with a verdict on completeness: what `enumerate`, `prove` and
/// every_root say together.
///
/// A model of angles alone is enumerated and proved as it stands. Where that leaves something open, and where there are
/// coordinates, whose units matter, its equations are solved as a system by every_root; the equilibria are classified
/// in the units of that search. Real, not real, and the index are what is proved, where it is.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

/// Equilibria, their proof, and what explains the paths that lead to none. M: the unknowns.
template <class M>
struct EveryEquilibriumOf {
    RootSet<M> set;                           ///< with its verdict, set.completeness
    ProofOfRoots proof;                       ///< of set.roots
    std::vector<char> confirmed;              ///< of each root that is singular: its multiplicity was confirmed
    std::vector<DivergingPaths> at_infinity;  ///< explained paths, by their direction
};
/// Equilibria of a model at run time.
using EveryEquilibrium = EveryEquilibriumOf<RuntimeUnknowns>;

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
/// The verdict on a cancelled run.
void say_stopped(RootsVerdict& verdict, const PathCounts& paths);
/// The paths of a start that finds curves, up to which it is tracked for their sake.
inline constexpr std::uint64_t most_paths_for_curves = 2048;
/// The verdict on a set whose curves were not looked for, as so many paths would have been needed.
void say_curves_not_searched(RootsVerdict& verdict, ProofOfRoots& proof, const std::optional<ProvedBound>& paths);
/// What is proved replaces what was measured: indices, and that an equilibrium is not degenerate.
template <class M>
void take_proved_indices(RootSet<M>& set, const ProofOfRoots& proof) {
    std::unordered_map<std::uint64_t, const Certificate*> of_path;
    for (const Certificate& c : proof.certificates) of_path.emplace(c.path, &c);
    std::vector<std::array<std::int64_t, 3>> keys;
    for (auto& e : set.equilibria) {
        if (const auto at = of_path.find(e.path); at != of_path.end() && at->second->index_proved)
            e.index = at->second->index, e.nullity = 0;
        keys.push_back({e.index, e.nullity, static_cast<std::int64_t>(e.path)});
    }
    set.equilibria = in_order(sorted_order(keys), std::move(set.equilibria));
}
/// Leaves out the roots that are not proved, where a theorem says that there is no further isolated one.
template <class M>
void leave_out_unproved(EveryEquilibriumOf<M>& y, const RunOptions& run) {
    std::uint64_t paths = 0;
    for (std::size_t k = y.set.roots.size(); k-- > 0;) {
        if (y.proof.certificates[k].exists) continue;
        const auto path = y.set.roots[k].path;
        paths += static_cast<std::uint64_t>(y.set.roots[k].paths);
        y.set.roots.erase(y.set.roots.begin() + static_cast<std::ptrdiff_t>(k));
        std::erase_if(y.set.equilibria, [path](const auto& e) { return e.path == path; });
        y.proof.forget(k);
    }
    if (paths == 0) return;
    y.proof.reason = y.set.completeness.sentence += no_further_roots(paths);
    y.set.alarms = check_alarms(y.set, run.executor, run.ranks);
}
/// What a set and its proof say.
template <class M>
EveryEquilibriumOf<M> with_verdict(RootSet<M> set, ProofOfRoots proof, const RunOptions& run) {
    EveryEquilibriumOf<M> y{std::move(set), std::move(proof), {}, {}};
    y.set.completeness = verdict_of(y.proof);
    if (y.proof.complete) leave_out_unproved(y, run);
    y.confirmed.assign(y.set.roots.size(), 0);
    take_proved_indices(y.set, y.proof);
    if (y.set.cancelled()) say_stopped(y.set.completeness, y.set.paths);
    return y;
}
/// Whether a set is returned as it is. One that is complete by a bound of isolated roots alone may have curves of
/// equilibria beside it: where it has no root at all, and where the Morse relations, which isolated
/// equilibria satisfy, do not hold. They are looked for by another start if that has few paths; else it is said.
template <class M>
bool is_final(EveryEquilibriumOf<M>& y, const ExactTerms& exact) {
    if (!y.proof.complete) return false;
    const auto verdict = y.set.verdict();
    const bool curves_may_exist = !y.proof.bound->counts_curves && y.set.families.empty() &&
                                  (y.proof.bound->value == 0 || (verdict.morse_applies() && !verdict.morse()));
    if (!curves_may_exist) return true;
    const auto paths = total_degree_bound(exact);
    if (paths && paths->value <= most_paths_for_curves) return false;
    say_curves_not_searched(y.set.completeness, y.proof, paths);
    return true;
}
/// Exact equations in double: what is exactly 0 is no term; nothing where an equation vanishes.
std::optional<SparseSystem> system_of_exact(const ExactTerms& exact);
/// The equilibria among the roots of a system, classified in its units.
EveryEquilibrium equilibria_of(const SparseSystem& system, const ModelToSolve& problem, const RunOptions& run,
                               std::optional<StartKind> asked);

}  // namespace detail

/// Every isolated equilibrium of a model at run time at the parameters p. StartSystem: as of enumerate_from. Throws as
/// enumerate_from, and where the run names a checkpoint. What a cancelled run found is proved; its verdict is open.
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
    const auto system = detail::system_of_exact(problem.exact);
    if (sizes.coordinates == 0 || !system || asked) {
        auto set = enumerate_from<StartSystem>(model, p, run);
        auto proof = prove(model, set, whole);
        y = detail::with_verdict(std::move(set), std::move(proof), whole);
        if (detail::is_final(y, problem.exact) || !system || y.set.cancelled()) {
            y.set.seconds = clock.seconds();
            return y;
        }
    }
    const detail::RealRuntimeEquations<T> equations(model, p);
    detail::ModelToSolve whole_problem = problem;
    whole_problem.model = {sizes, RuntimePotentialModel<T>, formulation.reflection_symmetric()};
    whole_problem.equations = &equations;
    constexpr auto kind = std::is_same_v<StartSystem, Polyhedral> ? std::optional(StartKind::polyhedral) : std::nullopt;
    auto found = detail::equilibria_of(*system, whole_problem, run, kind);
    found.set.seconds = clock.seconds();
    return found;
}

/// Every isolated equilibrium of a model that is a type, at the parameters p. StartSystem: as of `enumerate`. Throws as
/// that, and where the run names a checkpoint. What a cancelled run found is proved; its verdict is open.
template <Model M, class StartSystem = LeastCost>
[[gnu::cold]] EveryEquilibriumOf<M> every_equilibrium(const Parameters<M>& p, const RunOptions& run = {}) {
    const detail::Stopwatch clock;
    run.require_no_checkpoint();
    RunOptions whole = run;
    whole.cancel = nullptr;
    constexpr bool asked = !std::is_same_v<StartSystem, LeastCost>;
    const ExactTerms exact = ExactSystem<M>::at(p);
    const auto system = detail::system_of_exact(exact);
    EveryEquilibriumOf<M> y;
    if (n_coordinates<M> == 0 || !system || asked) {
        auto set = enumerate<M, StartSystem>(p, run);
        auto proof = prove(set, whole);
        y = detail::with_verdict(std::move(set), std::move(proof), whole);
        if (detail::is_final(y, exact) || !system || y.set.cancelled()) {
            y.set.seconds = clock.seconds();
            return y;
        }
    }
    const detail::RealModelEquations<M> equations(p);
    constexpr auto kind = std::is_same_v<StartSystem, Polyhedral> ? std::optional(StartKind::polyhedral) : std::nullopt;
    auto found = detail::equilibria_of(
        *system,
        {runtime_array(p), {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric}, exact, &equations},
        run, kind);
    found.set.seconds = clock.seconds();
    return {typed<M>(std::move(found.set)), std::move(found.proof), std::move(found.confirmed),
            std::move(found.at_infinity)};
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/every_equilibrium_definitions.hpp>
#endif
