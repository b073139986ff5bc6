/// \file
/// The front door: every equilibrium of a model, by homotopy continuation, with every path accounted for.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/moving.hpp>
#include <equilibria/start/total_degree.hpp>
#include <equilibria/system/model_system.hpp>

namespace equilibria {

namespace detail {

/// The way from tracked paths to a root set: their account, roots, families, equilibria, alarms.
RootSet<RuntimeUnknowns> root_set_of(PathSet paths, const RuntimeArray<double>& p,
                                     const ModelProperties<RuntimeUnknowns>& model, const PolynomialHomotopy& homotopy,
                                     const RealEquations& equations, const RunOptions& run);

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
    return enumerate_from<M>(target, StartSystem(target, generator), run, options, resort);
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

/// Every isolated equilibrium of the model at the parameters p, from a total-degree start.
///
/// Reaches every isolated solution of the polynomial system with probability one over the seed; paths at infinity,
/// singular and failed ones are counted, not hidden. StartSystem: TotalDegree<M> or Reflected<M>, if not the natural
/// one. Throws InvalidArgument for parameters that are not finite and for options out of range, CheckpointError for a
/// checkpoint that cannot be used.
template <Model M, class StartSystem = NaturalStart<M>>
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
