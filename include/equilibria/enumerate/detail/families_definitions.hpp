/// \file
/// See enumerate/families.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <equilibria/enumerate/detail/family_finder.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
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

EQUILIBRIA_INLINE std::vector<FoundFamily> find_families(const PolynomialHomotopy& homotopy,
                                                         const std::vector<FoundFamily::Vector>& solutions,
                                                         const Executor& executor) {
    const RuntimeSizes sizes = homotopy.sizes();
    const auto n = static_cast<std::size_t>(sizes.unknowns), angles = static_cast<std::size_t>(sizes.angles);
    std::vector<double> unit(n, 1.0);
    for (const auto& q : solutions)
        for (std::size_t u = angles; u < n; ++u) unit[u] = std::max(unit[u], std::abs(q[u]));
    const FamilyProbe probe(sizes.unknowns, family_system(homotopy, unit));
    std::vector<FamilyProbe::Vector> points(solutions.size());
    std::vector<FamilyProbe::Finding> found(solutions.size());
    executor.for_blocks(solutions.size(), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            for (std::size_t u = 0; u < n; ++u) points[k].push_back(solutions[k][u] / unit[u]);
            found[k] = probe.at(points[k]);
        }
    });
    std::vector<std::size_t> number;
    for (std::size_t k = 0; k < solutions.size(); ++k)
        if (found[k].dimension > 0) {
            if (number.size() != k)
                std::swap(points[number.size()], points[k]), std::swap(found[number.size()], found[k]);
            number.push_back(k);
        }
    points.resize(number.size());
    found.resize(number.size());
    const auto scaled = [&](FamilyProbe::Vector q) {
        for (std::size_t u = 0; u < n; ++u) q[u] *= unit[u];
        return q;
    };
    std::vector<FoundFamily> y;
    for (const auto& group : FamilyFinder(probe, sizes.unknowns, sizes.angles).groups(points, found)) {
        FoundFamily family{group.dimension, {}, std::nullopt};
        for (const std::size_t m : group.members) {
            const FamilyProbe::Finding& finding = found[m];
            FoundFamily::Member member{number[m],        finding.nullity, {}, scaled(finding.neighbour),
                                       finding.distance, finding.residual};
            for (const auto& t : finding.tangent) member.tangent.push_back(scaled(t));
            family.members.push_back(std::move(member));
        }
        if (group.real_point) {
            family.real_point = scaled(*group.real_point);
            for (std::size_t u = 0; u < angles; ++u) {
                auto& angle = (*family.real_point)[u];
                angle = std::remainder(angle.real(), 2 * std::numbers::pi);
            }
        }
        y.push_back(std::move(family));
    }
    return y;
}

}  // namespace equilibria::detail
