/// \file
/// Which roots of an enumeration lie on families of solutions.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria::detail {

/// A family that some of a number of solutions lie on, whatever the system.
struct FoundFamily {
    using Vector = std::vector<std::complex<double>>;
    struct Member {
        std::size_t number;  ///< of the solution
        /// As of a FamilyPoint.
        int nullity;
        std::vector<Vector> tangent;
        Vector neighbour;
        double distance, residual;
    };
    int dimension;
    std::vector<Member> members;
    std::optional<Vector> real_point;
};

/// The families on which some of the solutions lie, complex angles, then coordinates, of F of the homotopy. Each of
/// them is probed, those of a family connected by walks on it.
std::vector<FoundFamily> find_families(const PolynomialHomotopy& homotopy,
                                       const std::vector<FoundFamily::Vector>& solutions, const Executor& executor);

/// A root that is worse conditioned than this is probed, even if it passed for regular.
inline constexpr double suspect_condition = 1e5;

/// The roots that are isolated, and the families that the others lie on.
template <class M>
struct RootFamilies {
    std::vector<Root<M>> isolated;    ///< in the order of the roots
    std::vector<Family<M>> families;  ///< surfaces first, then by path
    std::uint64_t regular_paths = 0;  ///< of points on families that had passed for regular roots
};

/// Tells the roots that lie on families of solutions from those that are isolated. homotopy: to the model's system.
template <class M>
RootFamilies<M> split_families(std::vector<Root<M>> roots, const PolynomialHomotopy& homotopy,
                               const Executor& executor) {
    std::vector<std::size_t> suspects;
    std::vector<FoundFamily::Vector> solutions;
    for (std::size_t k = 0; k < roots.size(); ++k)
        if (roots[k].status == PathStatus::singular || !(roots[k].condition < suspect_condition)) {
            suspects.push_back(k);
            solutions.emplace_back(roots[k].q.begin(), roots[k].q.end());
        }
    RootFamilies<M> y;
    if (suspects.empty()) {
        y.isolated = std::move(roots);
        return y;
    }
    const auto unknowns = [](const FoundFamily::Vector& q) { return typed<M>(RuntimeArray<std::complex<double>>(q)); };
    std::vector<bool> on_family(roots.size());
    for (const FoundFamily& found : find_families(homotopy, solutions, executor)) {
        Family<M> family{found.dimension, std::nullopt, {}};
        for (const auto& member : found.members) {
            const std::size_t k = suspects[member.number];
            const Root<M>& root = roots[k];
            on_family[k] = true;
            if (root.status == PathStatus::finite) y.regular_paths += static_cast<std::uint64_t>(root.paths);
            FamilyPoint<M> point{
                root.q,         member.nullity, {},        unknowns(member.neighbour), member.distance, member.residual,
                root.condition, root.path,      root.paths};
            for (const auto& t : member.tangent) point.tangent.push_back(unknowns(t));
            family.points.push_back(point);
        }
        if (found.real_point) {
            RuntimeArray<double> real(homotopy.sizes().unknowns);
            for (int u = 0; u < real.size(); ++u) real[u] = (*found.real_point)[static_cast<std::size_t>(u)].real();
            family.real_point = typed<M>(std::move(real));
        }
        y.families.push_back(std::move(family));
    }
    for (std::size_t k = 0; k < roots.size(); ++k)
        if (!on_family[k]) y.isolated.push_back(roots[k]);
    std::vector<std::array<std::int64_t, 3>> keys;
    for (const auto& f : y.families)
        keys.push_back({-f.dimension, static_cast<std::int64_t>(f.points.front().path), 0});
    y.families = in_order(sorted_order(keys), std::move(y.families));
    return y;
}

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/families_definitions.hpp>
#endif
