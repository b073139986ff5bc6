/// \file
/// Enumerations that do not fit into memory: roots are handed to a function instead of kept, and the checkpoint is
/// where the endpoints wait until all paths are done. Only then is it known which paths had run into another one's
/// endpoint.
///
/// What stays in memory: 24 bytes a tracked path while coincident endpoints are looked for (a key, a size, a number),
/// up to RunOptions::key_memory, beyond which they are sorted in files of as many bytes; a bit a path for the merging;
/// 17 bytes a block; and the endpoints that were tracked again.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/run/elapsed.hpp>

namespace equilibria {

/// What is known of an enumeration whose roots were handed on: RootSet without the roots. M: the model, or
/// RuntimeUnknowns.
template <class M>
struct StreamedRoots {
    ParameterArray<M, double> parameters;  ///< at which the roots were sought
    std::uint64_t seed = 0;                ///< of the start's random numbers
    PathCounts paths;                      ///< how all paths ended
    std::vector<FailedPath<M>> failures;   ///< paths that were not finished, and why
    std::uint64_t distinct = 0;            ///< complex and real roots
    std::uint64_t real = 0;                ///< equilibria
    std::uint64_t degenerate = 0;          ///< of them with a singular Hessian
    std::vector<std::int64_t> by_index;    ///< nondegenerate equilibria of each index 0 .. n
    double largest_real_imaginary = 0;     ///< as of RootSet
    double smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();  ///< as of RootSet
    /// Poincare-Hopf's alone; the others look at all roots at once, which are not kept.
    Alarms alarms;
    double tracking_seconds = 0;                       ///< for the paths alone
    double seconds = 0;                                ///< for everything
    [[no_unique_address]] ModelProperties<M> model{};  ///< sizes and symmetries

    /// What is to be said of the count of equilibria.
    CountVerdict verdict() const {
        return {&paths, &alarms, distinct, degenerate, by_index, model.sizes.coordinates == 0 && model.has_potential};
    }
    bool cancelled() const { return verdict().cancelled(); }          ///< as of RootSet
    bool morse_applies() const { return verdict().morse_applies(); }  ///< as of RootSet
    bool morse() const { return verdict().morse(); }                  ///< as of RootSet
    /// As RootSet::clean.
    bool clean() const { return verdict().clean(); }
};

/// What takes streamed roots: the equilibrium is nullptr where the root is not real.
template <class T, class M>
concept RootTaker = std::invocable<T&, const Root<M>&, const Equilibrium<M>*>;

namespace detail {
using RuntimeRootTaker = std::function<void(const Root<RuntimeUnknowns>&, const Equilibrium<RuntimeUnknowns>*)>;

/// As root_set_of, with the roots handed on.
StreamedRoots<RuntimeUnknowns> stream_roots(PathSet paths, const RuntimeArray<double>& p,
                                            const ModelProperties<RuntimeUnknowns>& model,
                                            const RealEquations& equations, const RunOptions& run,
                                            const RuntimeRootTaker& take);
}  // namespace detail

/// `enumerate`, with the roots handed to take(root, equilibrium) one after the other. A mirror image comes after its
/// original, otherwise they come by path number; roots that are their own mirror images are last. Sorted by path they
/// are those of `enumerate`, bit by bit.
///
/// Of several ranks rank 0 alone hands roots on, and gets the result; the others help with the paths, and get an empty
/// one.
///
/// run.checkpoint must name a file, of about 32 n + 40 bytes a tracked path for n angles. Of a cancelled run no root is
/// handed on. Throws InvalidArgument as `enumerate` does, and what `take` throws.
template <Model M, class StartSystem = NaturalStart<M>, RootTaker<M> Take>
StreamedRoots<M> enumerate(const Parameters<M>& p, const RunOptions& run, Take&& take,
                           const TrackerOptions& options = {}) {
    require_finite(p, "parameters");
    options.validate();
    require(!run.checkpoint.empty(), "checkpoint", "''", "must name a file: roots that are streamed wait there");
    const detail::Stopwatch begin;
    Generator generator(run.seed);
    const ModelSystem<M> target(p);
    const StartSystem start(target, generator);
    auto paths = detail::track_paths(model_homotopy(target, start), detail::model_problem<M>(start, p, run, true), run,
                                     options, nullptr);
    if (!run.ranks.first()) {
        StreamedRoots<M> elsewhere;
        elsewhere.parameters = p;
        elsewhere.seed = run.seed;
        return elsewhere;
    }
    auto set = detail::stream_roots(std::move(paths), runtime_array(p),
                                    {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric},
                                    detail::RealModelEquations<M>(p), run,
                                    [&](const Root<RuntimeUnknowns>& root, const Equilibrium<RuntimeUnknowns>* e) {
                                        const auto equilibrium = e ? typed<M>(*e) : Equilibrium<M>{};
                                        take(typed<M>(root), e ? &equilibrium : nullptr);
                                    });
    StreamedRoots<M> y;
    y.parameters = p;
    y.seed = set.seed;
    y.paths = set.paths;
    y.failures = typed<M>(std::move(set.failures));
    y.distinct = set.distinct;
    y.real = set.real;
    y.degenerate = set.degenerate;
    y.by_index = std::move(set.by_index);
    y.largest_real_imaginary = set.largest_real_imaginary;
    y.smallest_nonreal_imaginary = set.smallest_nonreal_imaginary;
    y.alarms = std::move(set.alarms);
    y.tracking_seconds = set.tracking_seconds;
    y.seconds = begin.seconds();
    return y;
}

/// The same of a model at run time, from its total degree.
template <RuntimeModel T, RootTaker<RuntimeUnknowns> Take>
StreamedRoots<RuntimeUnknowns> enumerate(const T& model, const RuntimeArray<double>& p, const RunOptions& run,
                                         Take&& take, const TrackerOptions& options = {}) {
    options.validate();
    require(!run.checkpoint.empty(), "checkpoint", "''", "must name a file: roots that are streamed wait there");
    const detail::Stopwatch begin;
    const detail::RuntimeProblem<T> problem(model, p, run);
    const TotalDegreeStart start = problem.total_degree_start();
    auto paths = detail::track_paths(model_homotopy(model, problem.target, start),
                                     {.start = StartPoints(start), .model = problem.fields, .streamed = true}, run,
                                     options, nullptr);
    StreamedRoots<RuntimeUnknowns> y;
    y.parameters = p;
    y.seed = run.seed;
    if (!run.ranks.first()) return y;
    y = detail::stream_roots(std::move(paths), p, problem.properties, problem.equations, run, take);
    y.seconds = begin.seconds();
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/stream_definitions.hpp>
#endif
