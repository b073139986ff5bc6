/// \file
/// Which roots of an enumeration lie on families of solutions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria::detail {

/// A root that is worse conditioned than this is probed, even if it passed for regular.
inline constexpr double suspect_condition = 1e5;

/// The families that some of a number of roots lie on.
struct FoundFamilies {
    std::vector<Family<RuntimeUnknowns>> families;  ///< surfaces first, then by path
    std::vector<std::uint8_t> on_one;               ///< which of the roots lie on a family
    std::uint64_t regular_paths = 0;                ///< of those that had passed for regular
};
/// Each root is probed, and those on a family connected by walks on it. homotopy: to the system whose roots they are.
FoundFamilies find_families(const PolynomialHomotopy& homotopy, const std::vector<Root<RuntimeUnknowns>>& roots,
                            const Executor& executor);

template <class M>
[[gnu::cold]] Family<M> typed(const Family<RuntimeUnknowns>& family) {
    Family<M> y{family.dimension, std::nullopt, {}};
    if (family.real_point) y.real_point = equilibria::typed<M>(*family.real_point);
    for (const auto& from : family.points) {
        auto& to = y.points.emplace_back();
        to = {equilibria::typed<M>(from.q),
              from.nullity,
              {},
              equilibria::typed<M>(from.neighbour),
              from.distance,
              from.residual,
              from.condition,
              from.path,
              from.paths};
        for (const auto& t : from.tangent) to.tangent.push_back(equilibria::typed<M>(t));
    }
    return y;
}

/// The roots that are isolated, and the families that the others lie on.
template <class M>
struct RootFamilies {
    std::vector<Root<M>> isolated;    ///< in the order of the roots
    std::vector<Family<M>> families;  ///< as of FoundFamilies
    std::uint64_t regular_paths = 0;
};

/// Tells the roots that lie on families of solutions from those that are isolated. homotopy: to the model's system.
template <class M>
[[gnu::cold]] RootFamilies<M> split_families(std::vector<Root<M>> roots, const PolynomialHomotopy& homotopy,
                                             const Executor& executor) {
    std::vector<std::size_t> numbers;
    std::vector<Root<RuntimeUnknowns>> suspects;
    for (std::size_t k = 0; k < roots.size(); ++k)
        if (roots[k].status == PathStatus::singular || !(roots[k].condition < suspect_condition)) {
            numbers.push_back(k);
            suspects.push_back(untyped(roots[k]));
        }
    RootFamilies<M> y;
    if (!suspects.empty()) {
        const FoundFamilies found = find_families(homotopy, suspects, executor);
        for (const auto& family : found.families) y.families.push_back(typed<M>(family));
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

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/families_definitions.hpp>
#endif
