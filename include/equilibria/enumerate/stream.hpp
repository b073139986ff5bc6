/// \file
/// Enumerations that do not fit into memory: roots are handed to a function instead of kept, and the checkpoint is
/// where the endpoints wait until all paths are done. Only then is it known which paths had run into another one's
/// endpoint.
///
/// What stays in memory: 24 + 8 + 1 bytes a tracked path while coincident endpoints are looked for (a key, the sizes
/// and the number of each), 5 a tracked path for the merging, and the endpoints that were tracked again.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/run/elapsed.hpp>

namespace equilibria {

/// What is known of an enumeration whose roots were handed on: RootSet without the roots.
template <Model M>
struct StreamedRoots {
    Parameters<M> parameters;
    std::uint64_t seed = 0;
    PathCounts paths;
    std::vector<FailedPath<M>> failures;
    std::uint64_t distinct = 0, real = 0, degenerate = 0;
    /// Nondegenerate equilibria of each index 0 .. n.
    std::vector<std::int64_t> by_index = std::vector<std::int64_t>(static_cast<std::size_t>(n_unknowns<M>) + 1);
    double largest_real_imaginary = 0;  ///< as of RootSet
    double smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();
    /// Poincare-Hopf's alone; the others look at all roots at once, which are not kept.
    Alarms alarms;
    double tracking_seconds = 0, seconds = 0;

    CountVerdict verdict() const {
        return {&paths, &alarms, distinct, degenerate, by_index, n_coordinates<M> == 0 && PotentialModel<M>};
    }
    bool cancelled() const { return verdict().cancelled(); }
    bool morse_applies() const { return verdict().morse_applies(); }
    bool morse() const { return verdict().morse(); }
    /// As RootSet::clean.
    bool clean() const { return verdict().clean(); }
};

/// What takes streamed roots: the equilibrium is nullptr where the root is not real.
template <class T, class M>
concept RootTaker = std::invocable<T&, const Root<M>&, const Equilibrium<M>*>;

/// `enumerate`, with the roots handed to take(root, equilibrium) one after the other. A mirror image comes after its
/// original, otherwise they come by path number; roots that are their own mirror images are last. Sorted by path they
/// are those of `enumerate`, bit by bit.
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
    auto [counts, failures] = account_for<M>(paths);
    StreamedRoots<M> set;
    set.parameters = p;
    set.seed = run.seed;
    set.paths = counts;
    set.failures = std::move(failures);
    set.tracking_seconds = paths.effort.tracking_seconds;
    const detail::RealModelEquations<M> equations(p);
    detail::RootClassifier classifier(equations);
    if (!set.cancelled())
        merge<M>(paths, [&](const Root<M>& root) {
            ++set.distinct;
            const double imaginary = detail::largest_imaginary(root);
            Unknowns<M> q;
            if (!classifier.is_real(detail::view(root), {q.begin(), q.end()})) {
                set.smallest_nonreal_imaginary = std::min(set.smallest_nonreal_imaginary, imaginary);
                take(root, static_cast<const Equilibrium<M>*>(nullptr));
                return;
            }
            const Equilibrium<M> e = detail::equilibrium_of(root, q, classifier.classify({q.begin(), q.end()}));
            ++set.real;
            set.degenerate += e.degenerate();
            if (!e.degenerate()) ++set.by_index[static_cast<std::size_t>(e.index)];
            set.largest_real_imaginary = std::max(set.largest_real_imaginary, imaginary);
            take(root, &e);
        });
    set.alarms.poincare_hopf =
        detail::poincare_hopf(set.by_index, n_coordinates<M> == 0, set.degenerate == 0 && set.paths.singular == 0);
    set.seconds = begin.seconds();
    return set;
}

}  // namespace equilibria
