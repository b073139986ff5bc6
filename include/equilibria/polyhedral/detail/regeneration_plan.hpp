/// \file
/// The stages of tropical regeneration. Stage k has the supports of the equations before k, the artificial simplex d_k
/// L and the support of equation k together, and simplices L for those after it; the artificial points sink until no
/// cell has one. A last stage, where there is a lifting, leads from the lexicographic one to it.
///
/// Source: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016), in particular its section on
/// regeneration.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/detail/circuit_table.hpp>
#include <equilibria/polyhedral/detail/table_integers.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria::detail {

/// What all nodes of a walk share.
struct RegenerationPlan {
    int unknowns = 0;
    /// The equation of each stage.
    std::vector<int> order;
    /// Of each stage: its equation's points, moved so that the least coordinates are 0, and their largest degree d_k.
    std::vector<std::vector<std::vector<std::int64_t>>> points;
    std::vector<std::int64_t> degree;
    /// Of each stage and point d_k times it as a sum of the points of d_k L: their numbers and factors, not 0.
    std::vector<std::vector<std::vector<std::pair<int, std::int64_t>>>> sums;
    /// The layout of each stage, and of the equations' supports alone.
    std::vector<ColumnLayout> layouts;
    /// Heights to go to at last, larger ones above, of each column of the last layout; empty: there is no last stage.
    std::vector<std::int64_t> target;
    std::int64_t largest_target = 0;
    std::int32_t largest_narrow = std::numeric_limits<std::int32_t>::max();
    std::int64_t largest_wide = std::numeric_limits<std::int64_t>::max();
    const std::atomic<bool>* cancel = nullptr;  ///< ends the walk where it is true

    bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }

    RegenerationPlan(const Supports& supports, std::vector<int> equation_order)
        : unknowns(supports.unknowns()), order(std::move(equation_order)) {
        const auto n = static_cast<std::size_t>(unknowns);
        for (const int equation : order) {
            const auto& given = supports.equations()[static_cast<std::size_t>(equation)];
            std::vector<std::int64_t> least(given[0].begin(), given[0].end());
            for (const auto& a : given)
                for (std::size_t l = 0; l < n; ++l) least[l] = std::min<std::int64_t>(least[l], a[l]);
            auto& mine = points.emplace_back();
            auto& most = degree.emplace_back(1);
            for (const auto& a : given) {
                auto& moved = mine.emplace_back(n);
                std::int64_t sum = 0;
                for (std::size_t l = 0; l < n; ++l) sum += moved[l] = a[l] - least[l];
                most = std::max(most, sum);
            }
        }
        for (std::size_t stage = 0; stage < n; ++stage) {
            auto& its = sums.emplace_back();
            for (const auto& point : points[stage]) {
                auto& sum = its.emplace_back();
                std::int64_t rest = degree[stage];
                for (std::size_t l = 0; l < n; ++l) {
                    if (point[l] != 0) sum.emplace_back(static_cast<int>(l) + 1, point[l]);
                    rest -= point[l];
                }
                if (rest != 0) sum.emplace_back(0, rest);
            }
        }
        for (int stage = 0; stage <= unknowns; ++stage) {
            std::vector<int> sizes;
            for (int i = 0; i < unknowns; ++i)
                sizes.push_back((i <= stage ? static_cast<int>(points[static_cast<std::size_t>(i)].size()) : 0) +
                                (i >= stage ? unknowns + 1 : 0));
            layouts.push_back(
                ColumnLayout::of(sizes, stage < unknowns ? stage : -1, stage < unknowns ? unknowns + 1 : 0));
        }
    }

    /// With a last stage, to this lifting, a height for each column of the supports, smaller ones above.
    void go_to(const Supports& supports, const std::vector<std::int64_t>& lifting) {
        for (const int equation : order)
            for (int k = supports.first_column(equation); k < supports.first_column(equation + 1); ++k) {
                target.push_back(-lifting[static_cast<std::size_t>(k)]);
                largest_target = std::max(largest_target, absolute_value(target.back()));
            }
    }

    int last_stage() const { return target.empty() ? unknowns - 1 : unknowns; }
    template <class Integer>
    Integer limit() const {
        if constexpr (is_unlimited<Integer>)
            return 0;  // none
        else if constexpr (sizeof(Integer) == 8)
            return largest_wide;
        else
            return largest_narrow;
    }

    /// How all begins: a simplex for each equation, and of them the one cell {e_0, e_1}, .., {e_n-1, e_n} with e_0 = 0.
    ColumnLayout simplices() const {
        return ColumnLayout::of(std::vector<int>(static_cast<std::size_t>(unknowns), unknowns + 1), -1, 0);
    }
    CircuitTable<std::int32_t> simplices_table(const ColumnLayout& layout) const {
        CircuitTable<std::int32_t> y(layout);
        y.volume = 1;
        for (int i = 0; i < unknowns; ++i) {
            const int first = layout.first[static_cast<std::size_t>(i)];
            y.edges[static_cast<std::size_t>(i)] = {first + i, first + i + 1};
            for (int l = 0; l <= unknowns; ++l) {  // e_l - e_i+1 as a sum of edges' vectors
                for (int j = l; j <= i; ++j) y.row(j)[first + l] = 1;
                for (int j = i + 1; j < l; ++j) y.row(j)[first + l] = -1;
            }
        }
        return y;
    }
};

}  // namespace equilibria::detail
