/// \file
/// The stages of tropical regeneration. Stage k has the supports of the equations before k, the artificial simplex d_k
/// L and the support of equation k together, and simplices L for those after it; the artificial points sink until no
/// cell has one. A last stage, where there is a lifting, leads from the lexicographic one to it.
///
/// The support of equation k lies within d_k L, so that a cell of the stage before, whose table is scaled, is a cell of
/// stage k, and its new columns are combinations of those of the simplex: the table of one cell alone has to be known.
///
/// Source: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016), in particular its section on
/// regeneration.
#pragma once

#include <algorithm>
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
    /// The layout of each stage, and of the equations' supports alone.
    std::vector<ColumnLayout> layouts;
    /// Heights to go to at last, larger ones above, of each column of the last layout; empty: there is no last stage.
    std::vector<std::int64_t> target;
    std::int64_t largest_target = 0;
    std::int32_t largest_narrow = std::numeric_limits<std::int32_t>::max();
    std::int64_t largest_wide = std::numeric_limits<std::int64_t>::max();

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
                largest_target = std::max(largest_target, magnitude(target.back()));
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

    /// The table of stage k, of a cell of the stage before (k = 0: of simplices) whose layout and table these are and
    /// which has no artificial point. The entries must fit: their magnitudes grow by d_k squared at most.
    template <class Integer>
    void enter_stage(int k, const ColumnLayout& from, const CircuitTable<Integer>& old,
                     CircuitTable<Integer>& y) const {
        const auto& to = layouts[static_cast<std::size_t>(k)];
        const Integer d = k < unknowns ? Integer(degree[static_cast<std::size_t>(k)]) : Integer(1);
        const auto first_old = [&](int i) {
            return from.first[static_cast<std::size_t>(i)] + (i == from.stage ? from.artificial : 0);
        };
        y.reset(to);
        y.volume = d * old.volume;
        for (int i = 0; i < unknowns; ++i) {
            const int shift = to.first[static_cast<std::size_t>(i)] - first_old(i);
            for (std::size_t end = 0; end < 2; ++end)
                y.edges[static_cast<std::size_t>(i)][end] = old.edges[static_cast<std::size_t>(i)][end] + shift;
        }
        for (int j = 0; j < unknowns; ++j) {
            const Integer scale = j == k ? Integer(1) : d;
            const Integer* const x = old.row(j);
            Integer* const row = y.row(j);
            for (int i = 0; i < unknowns; ++i) {
                const int begin = first_old(i), size = from.first[static_cast<std::size_t>(i) + 1] - begin;
                Integer* const out = row + to.first[static_cast<std::size_t>(i)];
                const Integer factor = i == k ? Integer(scale * d) : scale;
                for (int c = 0; c < size; ++c) out[c] = factor * x[begin + c];
                if (i != k) continue;
                for (const auto& point : points[static_cast<std::size_t>(k)]) {
                    Integer rest = d, sum = 0;
                    for (int l = 0; l < unknowns; ++l) {
                        const std::int64_t exponent = point[static_cast<std::size_t>(l)];
                        if (exponent == 0) continue;
                        rest -= Integer(exponent);
                        sum += Integer(exponent) * x[begin + l + 1];
                    }
                    sum += rest * x[begin];
                    out[size + (&point - points[static_cast<std::size_t>(k)].data())] = scale * sum;
                }
            }
        }
    }
};

/// A cell in a stage, in a table of one of the kinds of integers.
struct RegenerationNode {
    int stage = 0;
    int width = 0;
    CircuitTable<std::int32_t> narrow;
    CircuitTable<std::int64_t> wide;
    CircuitTable<UnlimitedInteger> unlimited;

    template <class Integer>
    CircuitTable<Integer>& table() {
        if constexpr (is_unlimited<Integer>)
            return unlimited;
        else if constexpr (sizeof(Integer) == 8)
            return wide;
        else
            return narrow;
    }
    /// To the next kind of integers.
    void widen() {
        if (width++ == 0)
            wide.assign(narrow);
        else
            unlimited.assign(wide);
    }
    /// The table and place of another node.
    void copy(const RegenerationNode& other) {
        stage = other.stage;
        width = other.width;
        if (width == 0)
            narrow = other.narrow;
        else if (width == 1)
            wide = other.wide;
        else
            unlimited = other.unlimited;
    }
};

}  // namespace equilibria::detail
