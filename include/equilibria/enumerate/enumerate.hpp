/// \file
/// The front door: every equilibrium of a model, by homotopy continuation, with every path accounted for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/enumerate/start_report.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/moving.hpp>
#include <equilibria/start/total_degree.hpp>
#include <equilibria/system/model_system.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {

/// The way from tracked paths to a root set: their account, roots, families, equilibria, alarms.
RootSet<RuntimeUnknowns> root_set_of(PathSet paths, const RuntimeArray<double>& p,
                                     const ModelProperties<RuntimeUnknowns>& model, const PolynomialHomotopy& homotopy,
                                     const RealEquations& equations, const RunOptions& run);

/// The terms that are not 0; nothing where an equation has none.
std::optional<SparseSystem> system_of_terms(const RuntimeSizes& sizes, const std::vector<SparseTerm>& terms);
/// Whether a polyhedral start is predicted to cost less than so many paths from a total degree.
bool polyhedral_pays(const std::optional<SparseSystem>& system, const PathCount& tracked, StartReport& report,
                     const RunOptions& run);
RootSet<RuntimeUnknowns> enumerate_polyhedral(const SparseSystem& system, const RuntimeArray<double>& p,
                                              const ModelProperties<RuntimeUnknowns>& model,
                                              std::shared_ptr<const OwnEquations> own, const RealEquations& equations,
                                              CheckpointFields fields, const RunOptions& run,
                                              const TrackerOptions& options, MoreDigits<> resort);

template <Model M, class StartSystem>
[[gnu::cold]] RootSet<M> enumerate_from(const ModelSystem<M>& target, const StartSystem& start, const RunOptions& run,
                                        const TrackerOptions& options, MoreDigits<> resort = nullptr) {
    const detail::Stopwatch begin;
    const PolynomialHomotopy homotopy = model_homotopy(target, start);
    const Parameters<M>& p = target.parameters;
    auto paths = track_paths(homotopy, model_problem<M>(start, p, run), run, options, resort);
    auto set = typed<M>(root_set_of(std::move(paths), runtime_array(p),
                                    {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric}, homotopy,
                                    RealModelEquations<M>(p), run));
    set.start = {std::string(start.name()), "asked for", {}};
    set.seconds = begin.seconds();
    return set;
}

/// The model's equations at p as data; nothing where one vanishes there.
template <Model M>
[[gnu::cold]] std::optional<SparseSystem> system_of(const ModelSystem<M>& target) {
    std::vector<SparseTerm> terms;
    for (int k = 0; k < Formulation<M>::terms; ++k)
        terms.push_back({Formulation<M>::support[k].equation, sparse_monomial(Formulation<M>::support[k].monomial),
                         target.coefficients[k]});
    return system_of_terms(Sizes<M>(), terms);
}

template <Model M>
[[gnu::cold]] RootSet<M> enumerate_polyhedral(const ModelSystem<M>& target, const SparseSystem& system,
                                              const RunOptions& run, const TrackerOptions& options,
                                              MoreDigits<> resort) {
    const detail::Stopwatch begin;
    const Parameters<M>& p = target.parameters;
    CheckpointFields fields;
    if (!run.checkpoint.empty()) fields = model_fields<M>(p);
    auto set = typed<M>(enumerate_polyhedral(system, runtime_array(p),
                                             {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric},
                                             std::make_shared<OwnEquationsOf<ModelValues<M>>>(ModelValues<M>{p}),
                                             RealModelEquations<M>(p), std::move(fields), run, options, resort));
    set.seconds = begin.seconds();
    return set;
}

template <Model M, class StartSystem>
[[gnu::cold]] RootSet<M> enumerate_all(const Parameters<M>& p, const RunOptions& run, const TrackerOptions& options,
                                       MoreDigits<> resort = nullptr) {
    require_finite(p, "parameters");
    options.validate();
    Generator generator(run.seed);
    const ModelSystem<M> target(p);
    if constexpr (std::is_same_v<StartSystem, LeastCost>) {
        using Natural = NaturalStart<M>;
        constexpr bool reflected = std::is_same_v<Natural, Reflected<M>>;
        PathCount tracked = total_degree_count<M>();
        if (reflected) tracked.value /= 2;
        const auto system = system_of(target);
        StartReport report;
        if (polyhedral_pays(system, tracked, report, run)) {
            auto set = enumerate_polyhedral(target, *system, run, options, resort);
            if (set.paths.singular == 0 && set.families.empty()) {
                set.start.why = report.why;
                return set;
            }
            report.why = "the roots are not all regular, and its paths meet every curve of solutions";
        }
        auto set = enumerate_from<M>(target, Natural(target, generator), run, options, resort);
        set.start.why = report.why;
        set.start.mixed_volume = report.mixed_volume;
        return set;
    } else if constexpr (std::is_same_v<StartSystem, Polyhedral>) {
        const auto system = system_of(target);
        require(system.has_value(), "parameters", "an equation that vanishes",
                "must leave each equation a term for a polyhedral start");
        return enumerate_polyhedral(target, *system, run, options, resort);
    } else {
        return enumerate_from<M>(target, StartSystem(target, generator), run, options, resort);
    }
}

template <Model M>
[[gnu::cold]] RootSet<M> enumerate_by_parameters(const RootSet<M>& solved, const Parameters<M>& p,
                                                 const RunOptions& run, const TrackerOptions& options,
                                                 MoreDigits<> resort = nullptr) {
    require_finite(p, "parameters");
    options.validate();
    require(solved.paths.failed == 0 && solved.paths.singular == 0, "solved.paths",
            std::to_string(solved.paths.failed) + " failed, " + std::to_string(solved.paths.singular) + " singular",
            "a start instance must have regular roots only");
    typename Moving<M>::Points points;
    points.reserve(solved.roots.size());
    for (const auto& root : solved.roots) points.push_back(root.q);
    Generator generator(run.seed);
    const Moving<M> start(coefficients<M, double>(solved.parameters), unit_complex(generator), std::move(points));
    return enumerate_from<M>(ModelSystem<M>(p), start, run, options, resort);
}

}  // namespace detail

/// Every isolated equilibrium of the model at the parameters p.
///
/// Reaches every isolated solution of the polynomial system with probability one over the seed; paths at infinity,
/// singular and failed ones are counted, not hidden. StartSystem: TotalDegree<M>, Reflected<M> or Polyhedral, if not
/// the one of the least predicted cost; the set says which it was, and why. Throws InvalidArgument for parameters that
/// are not finite and for options out of range, CheckpointError for a checkpoint that cannot be used.
template <Model M, class StartSystem = LeastCost>
[[gnu::cold]] RootSet<M> enumerate(const Parameters<M>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}) {
    return detail::enumerate_all<M, StartSystem>(p, run, options);
}

/// The equilibria at p, from those of a solved instance: as many paths as `solved` has roots, not the whole bound.
///
/// The homotopy is a line in the space of coefficients. Complete if `solved` has as many regular roots as a generic
/// system on that line: certainly where it reaches the bound, as the chain does. A line between models whose parameters
/// enter the coefficients nonlinearly leaves the model, and systems on it may have more roots. Throws InvalidArgument
/// where `solved` has failed or singular paths.
template <Model M>
[[gnu::cold]] RootSet<M> enumerate(const RootSet<M>& solved, const Parameters<M>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}) {
    return detail::enumerate_by_parameters<M>(solved, p, run, options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/enumerate_definitions.hpp>
#endif
