/// \file
/// See enumerate/named_families.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/named_families.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/nearby_solution.hpp>
#include <equilibria/homotopy/polish.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/start/total_degree_start.hpp>
#include <equilibria/system/laurent_terms.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace equilibria::detail {

/// The terms of a system, which do not move.
EQUILIBRIA_INLINE std::vector<LaurentColumn> columns_at_rest(const SparseSystem& system) {
    std::vector<LaurentColumn> y;
    const auto equations = laurent_terms(system);
    for (std::size_t i = 0; i < equations.size(); ++i)
        for (const auto& t : equations[i])
            y.push_back({static_cast<int>(i), t.exponents, t.coefficient, t.coefficient});
    return y;
}
EQUILIBRIA_INLINE bool digits_tell_families(const SparseSystem& system) {
    const auto n = static_cast<std::size_t>(system.sizes().unknowns);
    std::vector<double> least(n, std::numeric_limits<double>::infinity()), most(n);
    for (const SparseTerm& t : system.terms()) {
        if (t.coefficient == 0) continue;
        const auto i = static_cast<std::size_t>(t.equation);
        least[i] = std::min(least[i], std::abs(t.coefficient));
        most[i] = std::max(most[i], std::abs(t.coefficient));
    }
    for (std::size_t i = 0; i < n; ++i)
        if (least[i] < 1e-24 * most[i]) return false;
    return true;
}
EQUILIBRIA_INLINE void keep_families(const SparseSystem& system, const std::vector<Root<RuntimeUnknowns>>& roots,
                                     FoundFamilies& found) {
    if (found.families.empty()) return;
    const auto columns = columns_at_rest(system);
    const bool told = digits_tell_families(system);
    std::erase_if(found.families, [&](const Family<RuntimeUnknowns>& family) {
        for (std::size_t k = 0; told && k < family.points.size(); ++k) {
            const auto& point = family.points[k];
            // a coordinate that is 0 on a multiple curve is known to a root of the rounding
            for (const double small : {1e-6, 1e-3})
                if (nearby_solution(system.sizes(), columns, laurent_point(point.neighbour, system.sizes()), 1e-3,
                                    small))
                    return false;
        }
        for (const auto& point : family.points)
            for (std::size_t k = 0; k < roots.size(); ++k)
                if (roots[k].path == point.path) found.on_one[k] = 0;
        return true;
    });
}

/// Generic combinations of the equations, as many as unknowns but for d, and d generic hyperplanes.
EQUILIBRIA_INLINE SparseSystem sliced(const SparseSystem& system, int d, Generator& generator) {
    const int n = system.sizes().unknowns;
    std::vector<SparseTerm> terms;
    for (int i = 0; i < n - d; ++i) {
        std::map<SparseMonomial, double> sum;
        std::vector<double> weight;
        for (int k = 0; k < n; ++k)
            weight.push_back((k == i ? 1 : uniform(generator, -1, 1)) / system.scale()[static_cast<std::size_t>(k)]);
        for (const SparseTerm& t : system.terms())
            sum[t.monomial] += weight[static_cast<std::size_t>(t.equation)] * t.coefficient;
        for (const auto& [monomial, c] : sum)
            if (c != 0) terms.push_back({i, monomial, c});
    }
    for (int i = n - d; i < n; ++i)
        for (int u = -1; u < n; ++u) {
            std::vector<int> codes(static_cast<std::size_t>(n));
            if (u >= 0) codes[static_cast<std::size_t>(u)] = 1;
            const double size = uniform(generator, 0.4, 1);
            terms.push_back({i, SparseMonomial(std::move(codes)), uniform(generator) < 0.5 ? size : -size});
        }
    return {system.sizes(), std::move(terms)};
}

/// Points of all families of dimension d on one generic plane, distinct; nothing where there are too many paths.
EQUILIBRIA_INLINE std::optional<std::vector<Root<RuntimeUnknowns>>> witness_points(const SparseSystem& system,
                                                                                   const PolynomialHomotopy& homotopy,
                                                                                   int d, const RunOptions& run,
                                                                                   const TrackerOptions& options,
                                                                                   std::uint64_t most_paths) {
    Generator generator(run.seed + 0x51ed270b * static_cast<std::uint64_t>(d));
    const SparseSystem on_plane = sliced(system, d, generator);
    const PathCount paths = total_degree_count(on_plane);
    if (paths.saturated || static_cast<std::uint64_t>(paths.value) > most_paths) return {};
    const auto found = solve_total_degree(on_plane, run, options, nullptr);
    const auto columns = columns_at_rest(system);
    std::vector<Root<RuntimeUnknowns>> y;
    std::vector<std::vector<std::complex<double>>> places;
    Polisher<PolynomialHomotopy>::Workspace<double> with(homotopy);
    for (const auto& root : found.roots) {
        PolishedEvidence evidence;
        Polisher(homotopy).assess(point_of<RuntimeUnknowns>(root.q, system.sizes()), &evidence, with);
        // a regular point of the plane's system is known to rounding: others of its points are near to curves by chance
        const bool regular = root.status == PathStatus::finite && root.condition < 1e8;
        if (!(evidence.residual < (regular ? 1e-11 : 1e-6))) continue;
        const auto on_family = nearby_solution(system.sizes(), columns, laurent_point(root.q, system.sizes()), 1e-3);
        if (!on_family) continue;
        // a multiple curve meets the plane in multiple points, each known to a root of the rounding
        const double near = regular ? 1e-6 : 1e-3;
        const auto end = laurent_point(root.q, system.sizes());
        const bool known = std::ranges::any_of(places, [&](const auto& other) {
            double apart = 0;
            for (std::size_t u = 0; u < other.size(); ++u)
                apart = std::max(apart, std::min(std::abs(other[u] - (*on_family)[u]), std::abs(other[u] - end[u])) /
                                            (1 + std::abs(other[u])));
            return apart < near;
        });
        if (known) continue;
        places.push_back(*on_family);
        y.push_back(root);
        y.back().status = PathStatus::singular;
        y.back().condition = evidence.condition;
    }
    return y;
}

EQUILIBRIA_INLINE FoundFamilies name_families(const SparseSystem& system,
                                              const std::vector<Root<RuntimeUnknowns>>& suspects, const RunOptions& run,
                                              const TrackerOptions& options, std::uint64_t most_paths) {
    if (!digits_tell_families(system)) return {{}, std::vector<std::uint8_t>(suspects.size()), 0};
    const PathCount degree = total_degree_count(system);
    std::vector<Root<RuntimeUnknowns>> all = suspects;
    const bool tracked = std::ranges::all_of(system.degrees(), [](int d) { return d > 0; }) && !degree.saturated &&
                         static_cast<std::uint64_t>(degree.value) <= most_paths;
    if (tracked)
        for (const auto& root : solve_total_degree(system, run, options, nullptr).roots)
            if (root.status == PathStatus::singular) all.push_back(root);
    const bool on_planes = tracked && system.sizes().angles == 0;
    if (all.empty() && !on_planes) return {};
    Generator generator(run.seed);
    std::vector<int> degrees = system.degrees();
    for (int& d : degrees) d = std::max(d, 1);
    const TotalDegreeStart start(TotalDegreeKind::general, system.sizes(), degrees, system.scale(), generator);
    const PolynomialHomotopy homotopy = total_degree_homotopy(system, start, degrees);
    auto y = find_families(homotopy, all, run.executor);
    keep_families(system, all, y);
    if (on_planes) {
        const std::size_t known = all.size();
        std::vector<std::pair<std::uint64_t, int>> witnesses;  // by a path number of their own
        // also of dimensions that no path ended on: it may meet a family at infinity
        int most = y.families.empty() ? system.sizes().unknowns - 1 : 1;
        for (const auto& family : y.families) most = std::max(most, family.dimension);
        for (int d = 1; d <= most; ++d)
            if (const auto points = witness_points(system, homotopy, d, run, options, most_paths))
                for (auto root : *points) {
                    root.path = (std::uint64_t{1} << 62) + all.size();
                    witnesses.emplace_back(root.path, d);
                    all.push_back(std::move(root));
                }
        if (!witnesses.empty()) {
            y = find_families(homotopy, all, run.executor);
            keep_families(system, all, y);
        }
        y.on_one.resize(known);
        for (auto& family : y.families) {
            FamilyPoint<RuntimeUnknowns> on_plane = family.points.front();
            std::erase_if(family.points, [&](const FamilyPoint<RuntimeUnknowns>& point) {
                const auto at = std::ranges::find(witnesses, point.path, &std::pair<std::uint64_t, int>::first);
                if (at == witnesses.end()) return false;
                family.degree += at->second == family.dimension;
                return true;
            });
            if (!family.points.empty()) continue;
            on_plane.path = 0;
            on_plane.paths = 0;  // none of the system's own ended here
            family.points.push_back(std::move(on_plane));
        }
    }
    y.on_one.resize(suspects.size());
    return y;
}

}  // namespace equilibria::detail
