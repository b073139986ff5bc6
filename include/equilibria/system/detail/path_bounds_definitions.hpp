/// \file
/// See system/path_bounds.hpp.
#pragma once

#include <cstddef>

#include <equilibria/core/error.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PathCount total_degree_count(const SparseSystem& system) {
    PathCount product{1, false};
    for (std::size_t i = 0; i < system.degrees().size(); ++i)
        product =
            product * PathCount{(static_cast<int>(i) < system.sizes().angles ? 2 : 1) * system.degrees()[i], false};
    return product;
}

EQUILIBRIA_INLINE PathCount multihomogeneous_number(const SparseSystem& system, std::span<const int> grouping) {
    const std::size_t n = system.degrees().size();
    require(grouping.size() == n, "grouping", grouping.size(), "must have a group for each unknown");
    return detail::multihomogeneous_number(system.terms(), system.sizes().angles, grouping, std::vector<int>(n),
                                           std::vector(n, std::vector<int>(n)));
}

EQUILIBRIA_INLINE GroupingNumber<std::vector<int>> smallest_multihomogeneous_number(const SparseSystem& system) {
    GroupingNumber<std::vector<int>> best{total_degree_count(system), std::vector<int>(system.degrees().size()),
                                          ComparedGroupings::one};
    detail::compare_groupings(best, system.terms(), system.sizes().angles, [&](const std::vector<int>& grouping) {
        return multihomogeneous_number(system, grouping);
    });
    return best;
}

}  // namespace equilibria
