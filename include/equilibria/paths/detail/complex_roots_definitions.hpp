/// \file
/// See paths/complex_roots.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <equilibria/core/random.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/start/linear_product.hpp>
#include <equilibria/start/solved_instance.hpp>
#include <equilibria/start/total_degree_start.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PolynomialHomotopy detail::total_degree_homotopy(const SparseSystem& system,
                                                                   const TotalDegreeStart& start,
                                                                   const std::vector<int>& degrees) {
    return PolynomialHomotopy({.sizes = system.sizes(),
                               .terms = system.terms(),
                               .from = {},
                               .forms = {.terms = start.system().terms(), .products = {}},
                               .scale = system.scale(),
                               .degrees = degrees});
}

EQUILIBRIA_INLINE ComplexRoots<> complex_roots(PathSet paths) {
    auto [counts, failures] = account_for(paths);
    return {counts, merge(paths), std::move(failures), {}, {}};
}

EQUILIBRIA_INLINE ComplexRoots<> solve_total_degree(const SparseSystem& system, const RunOptions& run,
                                                    const TrackerOptions& options, MoreDigits<> resort) {
    options.validate();
    for (std::size_t i = 0; i < system.degrees().size(); ++i)
        require(system.degrees()[i] > 0, "degree of equation " + std::to_string(i), system.degrees()[i],
                "must be at least 1");
    require(!total_degree_count(system).saturated, "system", "a total degree above 2^62",
            "must have fewer paths than can be numbered");
    Generator generator(run.seed);
    const TotalDegreeStart start(TotalDegreeKind::general, system.sizes(), system.degrees(), system.scale(), generator);
    return complex_roots(detail::total_degree_homotopy(system, start, system.degrees()), start, run, options, resort);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_multihomogeneous(const SparseSystem& system, std::span<const int> grouping,
                                                        const RunOptions& run, const TrackerOptions& options,
                                                        MoreDigits<> resort) {
    options.validate();
    Generator generator(run.seed), forms(run.seed);
    const LinearProduct start(system, grouping, unit_complex(generator), forms);
    return complex_roots(PolynomialHomotopy(system, start), start, run, options, resort);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_from(const std::vector<Root<RuntimeUnknowns>>& roots, const SparseSystem& from,
                                            const SparseSystem& to, const RunOptions& run,
                                            const TrackerOptions& options) {
    options.validate();
    SolvedInstance::Points points;
    points.reserve(roots.size());
    for (const auto& root : roots) points.push_back(root.q);
    Generator generator(run.seed);
    const SolvedInstance start(from, to, unit_complex(generator), std::move(points));
    return complex_roots(PolynomialHomotopy(to, start), start, run, options);
}

}  // namespace equilibria
