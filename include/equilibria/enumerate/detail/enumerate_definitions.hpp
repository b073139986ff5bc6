/// \file
/// See enumerate/enumerate.hpp.
#pragma once

#include <utility>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/paths/merge.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE RootSet<RuntimeUnknowns> root_set_of(PathSet paths, const RuntimeArray<double>& p,
                                                       const ModelProperties<RuntimeUnknowns>& model,
                                                       const PolynomialHomotopy& homotopy,
                                                       const RealEquations& equations, const RunOptions& run) {
    auto [counts, failures] = account_for(paths);
    const double tracking_seconds = paths.effort.tracking_seconds;
    std::vector<Root<RuntimeUnknowns>> roots;
    {
        PathSet done = std::move(paths);  // many paths have large records
        roots = merge(done);
    }
    auto [isolated, families, regular_paths] = split_families(std::move(roots), homotopy, run.executor);
    auto real = classify(isolated, equations, model.reflection_symmetric, run.executor);
    RootSet<RuntimeUnknowns> set{.parameters = p,
                                 .seed = run.seed,
                                 .paths = counts.with_singular(regular_paths),
                                 .roots = std::move(isolated),
                                 .equilibria = std::move(real.equilibria),
                                 .families = std::move(families),
                                 .failures = std::move(failures),
                                 .alarms = {},
                                 .largest_real_imaginary = real.largest_real_imaginary,
                                 .smallest_nonreal_imaginary = real.smallest_nonreal_imaginary,
                                 .tracking_seconds = tracking_seconds,
                                 .seconds = 0,
                                 .model = model};
    set.alarms = check_alarms(set, run.executor);
    return set;
}

}  // namespace equilibria::detail
