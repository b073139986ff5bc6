/// \file
/// See enumerate/families.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/detail/family_finder.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/newton_in_digits.hpp>
#include <equilibria/homotopy/polish.hpp>

namespace equilibria::detail {

/// The equations of the target as a system for a FamilyProbe, near a point whose coordinates have the sizes `unit`.
EQUILIBRIA_INLINE FamilyProbe::System family_system(const PolynomialHomotopy& homotopy,
                                                    const std::vector<double>& unit) {
    return [&homotopy, sizes = homotopy.sizes(), unit](const FamilyProbe::Vector& q, FamilyProbe::Vector& f,
                                                       FamilyProbe::Vector& j) {
        const int n = sizes.unknowns;
        constexpr auto at = [](int i) { return static_cast<std::size_t>(i); };
        SizedArray<std::complex<double>, at_run_time> place(n);
        for (int i = 0; i < n; ++i) place[i] = unit[at(i)] * q[at(i)];
        const auto point = point_of<RuntimeUnknowns>(place, sizes);
        Polisher<PolynomialHomotopy>::Workspace<double> with(homotopy);
        Polisher(homotopy).linearize(point, with);
        f.assign(at(n), 0.0);
        j.assign(at(n * n), 0.0);
        for (int r = 0; r < n; ++r) {
            f[at(r)] = lane(with.f[r], 0) / with.size[r];
            for (int c = 0; c < n; ++c) j[at(c * n + r)] = lane(with.j[r][c], 0) * unit[at(c)] / with.size[r];
        }
    };
}

/// Whether a root that is badly conditioned in double is regular nevertheless, and no probe is needed. Rounded
/// coefficients may have regular solutions where exact ones have a family: with a condition beyond the digits of these.
EQUILIBRIA_INLINE bool is_regular_in_digits(const Root<RuntimeUnknowns>& root, const PolynomialHomotopy& homotopy) {
    constexpr double largest_condition = 1e12;
    auto point = point_of<RuntimeUnknowns>(root.q, homotopy.sizes());
    RuntimePoint<DoubleDouble> q;
    copy_lane(point, 0, q, 0);
    if (!converges_in_digits(homotopy, q)) return false;
    copy_lane(q, 0, point, 0);
    Polisher<PolynomialHomotopy>::Workspace<double> with(homotopy);
    PolishedEvidence evidence;
    Polisher(homotopy).assess(point, &evidence, with);
    return evidence.condition < largest_condition;
}

EQUILIBRIA_INLINE FoundFamilies find_families(const PolynomialHomotopy& homotopy,
                                              const std::vector<Root<RuntimeUnknowns>>& roots,
                                              const Executor& executor) {
    const RuntimeSizes sizes = homotopy.sizes();
    const auto n = static_cast<std::size_t>(sizes.unknowns), angles = static_cast<std::size_t>(sizes.angles);
    // a root is probed in units of its own: in those of far ones families that pass it by would be near
    std::vector<std::vector<double>> units(roots.size(), std::vector<double>(n, 1.0));
    std::vector<double> unit(n, 1.0);
    std::vector<FamilyProbe::Vector> points(roots.size());
    for (std::size_t k = 0; k < roots.size(); ++k)
        for (std::size_t u = 0; u < n; ++u) {
            const auto& z = roots[k].q[static_cast<int>(u)];
            if (u >= angles) units[k][u] = std::max(1.0, std::abs(z));
            unit[u] = std::max(unit[u], units[k][u]);
            points[k].push_back(z / units[k][u]);
        }
    const auto probe_of = [&](std::size_t k) { return FamilyProbe(sizes.unknowns, family_system(homotopy, units[k])); };
    std::vector<FamilyProbe::Finding> found(roots.size());
    executor.for_blocks(roots.size(), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            if (!is_regular_in_digits(roots[k], homotopy)) found[k] = probe_of(k).at(points[k]);
    });
    // a point where the rank drops, on a surface that others have shown, may pass for one of a curve, or for isolated
    std::vector<int> dimensions;
    for (const auto& finding : found) dimensions.push_back(finding.dimension);
    std::ranges::sort(dimensions, std::greater{});
    dimensions.erase(std::unique(dimensions.begin(), dimensions.end()), dimensions.end());
    executor.for_blocks(roots.size(), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            for (const int d : dimensions)
                if (d <= found[k].dimension || probe_of(k).lies_on(points[k], d, found[k])) break;
    });
    // all in one set of units, in which walks lead from one to another
    const FamilyProbe probe(sizes.unknowns, family_system(homotopy, unit));
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const auto rescale = [&](FamilyProbe::Vector& v) {
            for (std::size_t u = 0; u < v.size(); ++u) v[u] *= units[k][u] / unit[u];
        };
        rescale(points[k]);
        rescale(found[k].neighbour);
        for (auto& t : found[k].tangent) rescale(t);
    }
    FoundFamilies y{{}, std::vector<std::uint8_t>(roots.size()), 0};
    std::vector<std::size_t> number;
    for (std::size_t k = 0; k < roots.size(); ++k)
        if (found[k].dimension > 0) {
            if (number.size() != k)
                std::swap(points[number.size()], points[k]), std::swap(found[number.size()], found[k]);
            number.push_back(k);
        }
    points.resize(number.size());
    found.resize(number.size());
    const auto scaled = [&](const FamilyProbe::Vector& q) {
        RuntimeArray<std::complex<double>> z(sizes.unknowns);
        for (std::size_t u = 0; u < n; ++u) z[static_cast<int>(u)] = unit[u] * q[u];
        return z;
    };
    std::vector<Family<RuntimeUnknowns>> families;
    std::vector<std::array<std::int64_t, 3>> keys;
    for (const auto& group : FamilyFinder(probe, sizes.unknowns, sizes.angles).groups(points, found)) {
        Family<RuntimeUnknowns> family{group.dimension, 0, std::nullopt, {}};
        for (const std::size_t m : group.members) {
            const FamilyProbe::Finding& finding = found[m];
            const auto& root = roots[number[m]];
            y.on_one[number[m]] = 1;
            if (root.status == PathStatus::finite) y.regular_paths += static_cast<std::uint64_t>(root.paths);
            FamilyPoint<RuntimeUnknowns> point{root.q,
                                               finding.nullity,
                                               {},
                                               scaled(finding.neighbour),
                                               finding.distance,
                                               finding.residual,
                                               root.condition,
                                               root.path,
                                               root.paths};
            for (const auto& t : finding.tangent) point.tangent.push_back(scaled(t));
            family.points.push_back(std::move(point));
        }
        if (group.real_point) {
            const auto at = scaled(*group.real_point);
            auto& real = family.real_point.emplace(sizes.unknowns);
            for (int u = 0; u < real.size(); ++u)
                real[u] = u < sizes.angles ? std::remainder(at[u].real(), 2 * std::numbers::pi) : at[u].real();
        }
        keys.push_back({-family.dimension, static_cast<std::int64_t>(family.points.front().path), 0});
        families.push_back(std::move(family));
    }
    y.families = in_order(sorted_order(keys), std::move(families));
    return y;
}

EQUILIBRIA_INLINE RootFamilies split_families(std::vector<Root<RuntimeUnknowns>> roots,
                                              const PolynomialHomotopy& homotopy, const Executor& executor) {
    std::vector<std::size_t> numbers;
    std::vector<Root<RuntimeUnknowns>> suspects;
    for (std::size_t k = 0; k < roots.size(); ++k)
        if (roots[k].status == PathStatus::singular || !(roots[k].condition < suspect_condition)) {
            numbers.push_back(k);
            suspects.push_back(roots[k]);
        }
    RootFamilies y;
    if (!suspects.empty()) {
        FoundFamilies found = find_families(homotopy, suspects, executor);
        y.families = std::move(found.families);
        y.regular_paths = found.regular_paths;
        std::size_t kept = 0, next = 0;
        for (std::size_t k = 0; k < roots.size(); ++k) {
            const bool suspected = next < numbers.size() && numbers[next] == k;
            if (suspected && found.on_one[next++]) continue;
            if (kept != k) roots[kept] = std::move(roots[k]);
            ++kept;
        }
        roots.resize(kept);
    }
    y.isolated = std::move(roots);
    return y;
}

}  // namespace equilibria::detail
