/// \file
/// See enumerate/stream.hpp.
#pragma once

#include <algorithm>
#include <utility>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/detail/mirror_images.hpp>
#include <equilibria/enumerate/stream.hpp>
#include <equilibria/paths/merge.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE StreamedRoots<RuntimeUnknowns> stream_roots(PathSet paths, const RuntimeArray<double>& p,
                                                              const ModelProperties<RuntimeUnknowns>& model,
                                                              const RealEquations& equations, const RunOptions& run,
                                                              const RuntimeRootTaker& take) {
    auto [counts, failures] = account_for(paths);
    StreamedRoots<RuntimeUnknowns> set;
    set.parameters = p;
    set.seed = run.seed;
    set.paths = counts;
    set.failures = std::move(failures);
    set.by_index.resize(static_cast<std::size_t>(model.sizes.unknowns) + 1);
    set.tracking_seconds = paths.effort.tracking_seconds;
    set.model = model;
    RootClassifier classifier(equations);
    struct Last {  // the image of a root comes next
        Root<RuntimeUnknowns> root;
        bool real = false;
        RuntimeArray<double> q;
        Classification found;
    } last;
    if (!set.cancelled())
        merge(paths, [&](const Root<RuntimeUnknowns>& root) {
            ++set.distinct;
            const double imaginary = largest_imaginary(root);
            if (model.reflection_symmetric && last.root.q.size() > 0 &&
                MirrorImages::are_images(view(last.root).q, view(root).q)) {
                if (last.real) last.q = mirrored(std::move(last.q));
            } else {
                last.q.resize(model.sizes.unknowns);
                last.real = classifier.is_real(view(root), {last.q.begin(), last.q.end()});
                if (last.real) last.found = classifier.classify({last.q.begin(), last.q.end()});
            }
            last.root = root;
            if (!last.real) {
                set.smallest_nonreal_imaginary = std::min(set.smallest_nonreal_imaginary, imaginary);
                take(root, nullptr);
                return;
            }
            const auto e = equilibrium_of(root, last.q, last.found);
            ++set.real;
            set.degenerate += e.degenerate();
            if (!e.degenerate()) ++set.by_index[static_cast<std::size_t>(e.index)];
            set.largest_real_imaginary = std::max(set.largest_real_imaginary, imaginary);
            take(root, &e);
        });
    set.alarms.poincare_hopf =
        poincare_hopf(set.by_index, model.sizes.coordinates == 0, set.degenerate == 0 && set.paths.singular == 0);
    return set;
}

}  // namespace equilibria::detail
