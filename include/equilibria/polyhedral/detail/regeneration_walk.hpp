/// \file
/// The way down the tree of tropical regeneration. A node is a cell with its table; all that its children need is in
/// it, so that the walk goes on in place where there is one child, and copies a table where there are two. The memory
/// is that of the branches not yet followed, and any node can be followed on its own.
///
/// Source: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/detail/circuit_table.hpp>
#include <equilibria/polyhedral/detail/first_wall.hpp>
#include <equilibria/polyhedral/detail/regeneration_node.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/table_integers.hpp>

namespace equilibria::detail {

/// Follows nodes until they divide or end. One a thread.
class RegenerationWalk {
public:
    enum class Event { divided, cell, ended };

    explicit RegenerationWalk(const RegenerationPlan& plan) : plan_(plan) {}

    /// How all begins: the node of stage 0.
    RegenerationNode root() {
        RegenerationNode y;
        const auto layout = plan_.simplices();
        y.narrow = plan_.simplices_table(layout);
        enter_stage(plan_, y, scratch_, 0, layout);
        return y;
    }

    /// Goes down from this node. divided: its first child is in `child`, its second one in the node's place. cell: the
    /// node is a cell of the target, with the heights of heights(). ended: nothing is left of it.
    Event advance(RegenerationNode& node, RegenerationNode& child) {
        for (;;) {
            const auto event = node.width == 0   ? follow<std::int32_t>(node, child)
                               : node.width == 1 ? follow<std::int64_t>(node, child)
                                                 : follow<UnlimitedInteger>(node, child);
            if (event) return *event;
        }
    }

    /// Volume times heights above the cell of the last event, by columns of the last layout.
    template <class Integer>
    std::vector<typename TableInteger<Integer>::Height>& heights() {
        if constexpr (is_unlimited<Integer>)
            return unlimited_heights_;
        else if constexpr (sizeof(Integer) == 8)
            return wide_heights_;
        else
            return narrow_heights_;
    }

    /// Cells without a lifting, and the sum of their volumes: they are counted, and not made.
    std::uint64_t counted = 0;
    UnlimitedInteger counted_volume() const { return large_volume_ + sum_; }
    /// Nothing is more than the largest number.
    bool cancelled() const { return plan_.cancelled(); }
    bool counted_more_than(std::uint64_t most) const {
        return most != std::numeric_limits<std::uint64_t>::max() && (sum_ > most || large_volume_ > most);
    }
    std::array<std::uint64_t, 3> exchanges = {};

private:
    /// An event, or none: the node's stage or kind of integers has changed.
    template <class Integer>
    std::optional<Event> follow(RegenerationNode& node, RegenerationNode& child) {
        auto& table = node.table<Integer>();
        const int stage = node.stage;
        const auto& layout = plan_.layouts[static_cast<std::size_t>(stage)];
        const bool to_target = stage == plan_.unknowns;
        const bool counts = !to_target && stage == plan_.last_stage();
        for (;;) {
            int column = -1;
            bool may_count = false;
            if (to_target) {
                if (!compute_heights(layout, table)) {
                    node.widen();
                    return {};
                }
                const auto& height = heights<Integer>();
                candidates_.clear();
                for (int k = 0; k < layout.columns(); ++k)
                    if (height[static_cast<std::size_t>(k)] < 0) candidates_.push_back(k);
                if (candidates_.empty()) return Event::cell;
                using Height = typename TableInteger<Integer>::Height;
                column = first_wall<typename TableInteger<Integer>::HeightProduct>(
                    layout, table, candidates_,
                    [&height](int k) { return Height(-height[static_cast<std::size_t>(k)]); });
            } else {
                const auto edge = table.edges[static_cast<std::size_t>(stage)];
                const bool first = layout.is_artificial(edge[0]), second = layout.is_artificial(edge[1]);
                if (!first && !second) {
                    enter_stage(plan_, node, scratch_, stage + 1, layout);
                    return {};
                }
                if (!first && !table.swap_ends(layout, stage, plan_.limit<Integer>())) {
                    node.widen();
                    return {};
                }
                may_count = counts && !(first && second);
                column = first && second ? wall_of_new_columns(layout, table) : wall_of_sinking_edge(layout, table);
                if (column < 0) return Event::ended;
            }

            const int i = layout.configuration[static_cast<std::size_t>(column)];
            const auto edge = table.edges[static_cast<std::size_t>(i)];
            const Integer entry = table.at(i, column);
            const bool positive = entry > 0, other_positive = entry < table.volume;
            // of two parents of a cell that has lost both their different points the one with the earlier point goes on
            bool first = positive && (entry <= table.volume || edge[1] < column);
            const bool second = other_positive && (entry >= 0 || edge[0] < column);
            if (may_count && first && i == stage && !layout.is_artificial(column)) {
                count(entry);
                ++exchanges[static_cast<std::size_t>(node.width)];
                first = false;
            }
            if (!first && !second) return Event::ended;
            if (first && second) {
                child.copy(node);
                exchange(child, layout, column, 0);
                exchange(node, layout, column, 1);
                return Event::divided;
            }
            exchange(node, layout, column, first ? 0 : 1);
            if (node.width != TableInteger<Integer>::width) return {};
        }
    }

    /// Both points of the stage's edge are artificial: all new columns are above the cell's plane, and equally so.
    template <class Integer>
    int wall_of_new_columns(const ColumnLayout& layout, const CircuitTable<Integer>& table) {
        const auto s = static_cast<std::size_t>(layout.stage);
        candidates_.clear();
        for (int k = layout.first[s] + layout.artificial; k < layout.first[s + 1]; ++k) candidates_.push_back(k);
        return first_wall<Integer>(layout, table, candidates_, [](int) { return Integer(1); });
    }
    /// The first point of the stage's edge sinks, and the plane with it: the entries for it say how fast.
    template <class Integer>
    int wall_of_sinking_edge(const ColumnLayout& layout, const CircuitTable<Integer>& table) {
        const Integer* const row = table.row(layout.stage);
        const int columns = layout.columns(), begin = layout.first[static_cast<std::size_t>(layout.stage)],
                  end = begin + layout.artificial;
        candidates_.resize(static_cast<std::size_t>(columns));
        int* next = candidates_.data();
        const auto add = [&](int from, int to, const Integer& above) {
            for (int k = from; k < to; ++k) {  // without a branch, which would be guessed wrong
                *next = k;
                next += row[k] > above;
            }
        };
        add(0, begin, 0);
        add(begin, end, table.volume);
        add(end, columns, 0);
        candidates_.resize(static_cast<std::size_t>(next - candidates_.data()));
        if (candidates_.empty()) return -1;
        return first_wall<typename TableInteger<Integer>::Product>(layout, table, candidates_, [&](int k) {
            return k >= begin && k < end ? Integer(row[k] - table.volume) : row[k];
        });
    }

    /// Volume times what each column is below the cell's plane, at the target. False: a sum might not fit.
    template <class Integer>
    bool compute_heights(const ColumnLayout& layout, CircuitTable<Integer>& table) {
        using Height = typename TableInteger<Integer>::Height;
        const auto& w = plan_.target;
        auto& y = heights<Integer>();
        const auto of = [&w](int column) { return w[static_cast<std::size_t>(column)]; };
        if constexpr (!is_unlimited<Integer>) {
            double sum = 4 * static_cast<double>(table.volume) * static_cast<double>(plan_.largest_target);
            for (int j = 0; j < table.rows(); ++j) {
                const auto& edge = table.edges[static_cast<std::size_t>(j)];
                sum += static_cast<double>(table.largest(j)) *
                       static_cast<double>(absolute_value(of(edge[0]) - of(edge[1])));
            }
            if (sum >= TableInteger<Integer>::largest_height) return false;
        }
        y.resize(static_cast<std::size_t>(table.columns()));
        for (int i = 0; i < table.rows(); ++i) {
            const Height plane = of(table.edges[static_cast<std::size_t>(i)][1]);
            for (int k = layout.first[static_cast<std::size_t>(i)]; k < layout.first[static_cast<std::size_t>(i) + 1];
                 ++k)
                y[static_cast<std::size_t>(k)] = Height(table.volume) * (plane - of(k));
        }
        for (int j = 0; j < table.rows(); ++j) {
            const auto& edge = table.edges[static_cast<std::size_t>(j)];
            const Height rise = of(edge[0]) - of(edge[1]);
            const Integer* const row = table.row(j);
            for (std::size_t k = 0; k < y.size(); ++k) y[k] += Height(row[k]) * rise;
        }
        return true;
    }

    /// In the narrowest integers that the result is sure to fit.
    void exchange(RegenerationNode& node, const ColumnLayout& layout, int column, int leaving) {
        if (node.width == 0 && !node.narrow.exchange(layout, column, leaving, plan_.largest_narrow))
            node.widen();
        else if (node.width == 0)
            return void(++exchanges[0]);
        if (node.width == 1 && !node.wide.exchange(layout, column, leaving, plan_.largest_wide))
            node.widen();
        else if (node.width == 1)
            return void(++exchanges[1]);
        node.unlimited.exchange(layout, column, leaving, 0);
        ++exchanges[2];
    }

    template <class Integer>
    void count(const Integer& volume) {
        ++counted;
        if constexpr (is_unlimited<Integer>) {
            large_volume_ += volume;
        } else {
            sum_ += static_cast<std::uint64_t>(volume);
            if (sum_ >> 62 != 0) {
                large_volume_ += sum_;
                sum_ = 0;
            }
        }
    }

    const RegenerationPlan& plan_;
    std::uint64_t sum_ = 0;
    UnlimitedInteger large_volume_ = 0;
    RegenerationNode scratch_;
    std::vector<int> candidates_;
    std::vector<std::int64_t> narrow_heights_;
    std::vector<Int128> wide_heights_;
    std::vector<UnlimitedInteger> unlimited_heights_;
};

}  // namespace equilibria::detail
