/// \file
/// A cell in a stage of tropical regeneration, in a table of one of the kinds of integers, and its way into the next
/// stage.
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
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/detail/circuit_table.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/table_integers.hpp>

namespace equilibria::detail {

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

/// The table of stage k, of a cell of the stage before (k = 0: of simplices) whose layout and table these are and
/// which has no artificial point. The entries must fit: their magnitudes grow by d_k squared at most.
template <class Integer>
void scale_into_stage(const RegenerationPlan& plan, int k, const ColumnLayout& from, const CircuitTable<Integer>& old,
                      CircuitTable<Integer>& y) {
    const int n = plan.unknowns;
    const auto& to = plan.layouts[static_cast<std::size_t>(k)];
    const Integer d = k < n ? Integer(plan.degree[static_cast<std::size_t>(k)]) : Integer(1);
    const auto first_old = [&](int i) {
        return from.first[static_cast<std::size_t>(i)] + (i == from.stage ? from.artificial : 0);
    };
    y.reset(to);
    y.volume = d * old.volume;
    for (int i = 0; i < n; ++i) {
        const int shift = to.first[static_cast<std::size_t>(i)] - first_old(i);
        for (std::size_t end = 0; end < 2; ++end)
            y.edges[static_cast<std::size_t>(i)][end] = old.edges[static_cast<std::size_t>(i)][end] + shift;
    }
    for (int j = 0; j < n; ++j) {
        const Integer scale = j == k ? Integer(1) : d;
        const Integer* const x = old.row(j);
        Integer* const row = y.row(j);
        for (int i = 0; i < n; ++i) {
            const int begin = first_old(i), size = from.first[static_cast<std::size_t>(i) + 1] - begin;
            Integer* const out = row + to.first[static_cast<std::size_t>(i)];
            const Integer factor = i == k ? Integer(scale * d) : scale;
            if (factor == 1)
                std::copy(x + begin, x + begin + size, out);
            else
                for (int c = 0; c < size; ++c) out[c] = factor * x[begin + c];
            if (i != k) continue;
            Integer* next = out + size;
            for (const auto& terms : plan.sums[static_cast<std::size_t>(k)]) {
                Integer sum = 0;
                for (const auto& [l, c] : terms) sum += Integer(c) * x[begin + l];
                *next++ = scale * sum;
            }
        }
    }
}

/// From a cell without artificial points, of this layout, to this stage, in the narrowest integers that it is sure to
/// fit. The scratch node is anything.
template <class Integer>
void enter_stage_from(const RegenerationPlan& plan, RegenerationNode& node, RegenerationNode& scratch, int stage,
                      const ColumnLayout& from) {
    const auto& table = node.table<Integer>();
    UnlimitedInteger largest = 0;
    for (int j = 0; j < table.rows(); ++j) {
        if constexpr (is_unlimited<Integer>) {
            for (int k = 0; k < table.columns(); ++k)
                if (absolute_value(table.at(j, k)) > largest) largest = absolute_value(table.at(j, k));
        } else if (table.largest(j) > largest) {
            largest = table.largest(j);
        }
    }
    const UnlimitedInteger d = stage < plan.unknowns ? plan.degree[static_cast<std::size_t>(stage)] : 1;
    largest = (largest + table.volume) * d * d;  // entries for second points are within this too
    const auto enter_in = [&]<class To>(To) {
        auto& old = scratch.table<To>();
        if constexpr (std::is_same_v<To, Integer>)
            std::swap(old, node.table<To>());
        else
            old.assign(table);
        scale_into_stage(plan, stage, from, old, node.table<To>());
        node.width = TableInteger<To>::width;
    };
    if (largest <= plan.largest_narrow)
        enter_in(std::int32_t{});
    else if (largest <= plan.largest_wide)
        enter_in(std::int64_t{});
    else
        enter_in(UnlimitedInteger{});
    node.stage = stage;
}
inline void enter_stage(const RegenerationPlan& plan, RegenerationNode& node, RegenerationNode& scratch, int stage,
                        const ColumnLayout& from) {
    if (node.width == 0)
        enter_stage_from<std::int32_t>(plan, node, scratch, stage, from);
    else if (node.width == 1)
        enter_stage_from<std::int64_t>(plan, node, scratch, stage, from);
    else
        enter_stage_from<UnlimitedInteger>(plan, node, scratch, stage, from);
}

}  // namespace equilibria::detail
