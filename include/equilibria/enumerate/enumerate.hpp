/// \file
/// The front door: every equilibrium of a model, by homotopy continuation, with every path accounted for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/enumerate/start_report.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/paths/solve_along.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/moving.hpp>
#include <equilibria/start/total_degree.hpp>
#include <equilibria/system/model_system.hpp>
#include <equilibria/system/sparse_system.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

namespace detail {

/// The way from tracked paths to a root set: their account, roots, families, equilibria, alarms.
RootSet<RuntimeUnknowns> root_set_of(PathSet paths, const RuntimeArray<double>& p,
                                     const ModelProperties<RuntimeUnknowns>& model, const PolynomialHomotopy& homotopy,
                                     const RealEquations& equations, const RunOptions& run);

/// The terms that are not 0; nothing where an equation has none.
std::optional<SparseSystem> system_of_terms(const RuntimeSizes& sizes, const std::vector<SparseTerm>& terms);
/// Whether a polyhedral start is predicted to cost less than so many paths from a total degree, reflected or not.
bool polyhedral_pays(const std::optional<SparseSystem>& system, const PathCount& tracked, bool reflected,
                     StartReport& report, const RunOptions& run);
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
    if (run.is_told_apart()) fields = model_fields<M>(p);
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
        const detail::Stopwatch begin;
        using Natural = NaturalStart<M>;
        constexpr bool reflected = std::is_same_v<Natural, Reflected<M>>;
        PathCount tracked = total_degree_count<M>();
        if (reflected) tracked.value /= 2;
        const auto system = system_of(target);
        StartReport report;
        if (polyhedral_pays(system, tracked, reflected, report, run)) {
            auto set = enumerate_polyhedral(target, *system, run, options, resort);
            if (set.paths.singular == 0 && set.families.empty()) {
                set.start.why = report.why;
                set.seconds = begin.seconds();
                return set;
            }
            report.why = "the roots are not all regular, and its paths lead to curves of solutions";
        }
        auto set = enumerate_from<M>(target, Natural(target, generator), run, options, resort);
        set.start.why = report.why;
        set.start.mixed_volume = report.mixed_volume;
        set.seconds = begin.seconds();
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

/// Throws InvalidArgument where a root set has singular or failed paths, or is not finished: others are not followed
/// from it.
void require_start_instance(const PathCounts& solved);
/// The ways from a solved instance that stay in the family where the line in the space of coefficients does not: paths
/// along an arc of the parameters; where some fail, along others, up to three.
PathSet track_along_arc(const SystemFamily& family, const KnownRoots::Points& points, const RuntimeArray<double>& from,
                        const RuntimeArray<double>& to, std::shared_ptr<const OwnEquations> own,
                        const CheckpointFields& model, const RunOptions& run, const TrackerOptions& options,
                        MoreDigits<ArcHomotopy> resort);
/// Whether the line in the space of coefficients leads from a solved instance to all roots: it has all that there may
/// be, or the line is in the family.
bool line_serves(std::uint64_t roots, std::span<const int> degrees, const SystemFamily& family,
                 const RuntimeArray<double>& from, const RuntimeArray<double>& to);

template <Model M>
[[gnu::cold]] RootSet<M> enumerate_by_parameters(const RootSet<M>& solved, const Parameters<M>& p,
                                                 const RunOptions& run, const TrackerOptions& options,
                                                 MoreDigits<> resort = nullptr,
                                                 MoreDigits<ArcHomotopy> arc_resort = nullptr) {
    const detail::Stopwatch begin;
    require_finite(p, "parameters");
    options.validate();
    require_start_instance(solved.paths);
    typename Moving<M>::Points points;
    points.reserve(solved.roots.size());
    for (const auto& root : solved.roots) points.push_back(root.q);
    Generator generator(run.seed);
    const ModelSystem<M> target(p);
    const auto gamma = unit_complex(generator);
    const SystemFamily family = system_family<M>();
    const auto from = runtime_array(solved.parameters), to = runtime_array(p);
    const auto& degrees = Formulation<M>::degrees;
    if (line_serves(points.size(), {degrees.begin(), degrees.end()}, family, from, to)) {
        const Moving<M> start(coefficients<M, double>(solved.parameters), gamma, std::move(points));
        return enumerate_from<M>(target, start, run, options, resort);
    }
    KnownRoots::Points known;
    for (const auto& q : points) known.emplace_back(n_unknowns<M>), std::copy(q.begin(), q.end(), known.back().begin());
    auto paths =
        track_along_arc(family, known, from, to, std::make_shared<OwnEquationsOf<ModelValues<M>>>(ModelValues<M>{p}),
                        run.is_told_apart() ? model_fields<M>(p) : CheckpointFields(), run, options, arc_resort);
    // what families of roots are looked for on: the system that all ways end at
    const PolynomialHomotopy homotopy = model_homotopy(target, Moving<M>(target.coefficients, gamma, {}));
    auto set = typed<M>(root_set_of(std::move(paths), to,
                                    {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric}, homotopy,
                                    RealModelEquations<M>(p), run));
    set.seconds = begin.seconds();
    return set;
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
/// The homotopy is a line in the space of coefficients where that stays in the model, the parameters that change
/// entering the coefficients linearly, or where `solved` has as many roots as its total degree allows, as the chain
/// has. Elsewhere it follows the parameters themselves, along an arc through complex ones (start/coefficient_path.hpp),
/// and all systems on the way are members of the model. Complete if `solved` has as many regular roots as a generic
/// member on the complex line through both. Paths that fail on an arc are tracked along other arcs; `options` and a
/// checkpoint are as of the other. Throws InvalidArgument where `solved` has failed or singular paths, and where no arc
/// is found that avoids the poles of the coefficients.
template <Model M>
[[gnu::cold]] RootSet<M> enumerate(const RootSet<M>& solved, const Parameters<M>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}) {
    return detail::enumerate_by_parameters<M>(solved, p, run, options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/enumerate_definitions.hpp>
#endif
