/// \file
/// A cell at the end of a walk as its caller knows it: by the numbers of the caller's equations and points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/detail/regeneration_node.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/regeneration_walk.hpp>
#include <equilibria/polyhedral/detail/table_integers.hpp>
#include <equilibria/polyhedral/mixed_cell.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria::detail {

/// Reports cells to a sink, by the numbers of the caller.
class CellReport {
public:
    CellReport(const Supports& supports, const RegenerationPlan& plan)
        : plan_(plan), edges_(static_cast<std::size_t>(plan.unknowns)),
          heights_(static_cast<std::size_t>(supports.columns())) {
        for (const int equation : plan.order)
            for (int k = supports.first_column(equation); k < supports.first_column(equation + 1); ++k)
                column_.push_back(static_cast<std::size_t>(k));
    }

    MixedCell cell(RegenerationNode& node, RegenerationWalk& walk) {
        if (node.width == 0) return in<std::int32_t>(node, walk);
        if (node.width == 1) return in<std::int64_t>(node, walk);
        return in<UnlimitedInteger>(node, walk);
    }

private:
    template <class Integer>
    MixedCell in(RegenerationNode& node, RegenerationWalk& walk) {
        const auto& table = node.table<Integer>();
        const auto& layout = plan_.layouts.back();
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const auto [low, high] = std::minmax(table.edges[i][0], table.edges[i][1]);
            edges_[static_cast<std::size_t>(plan_.order[i])] = {low - layout.first[i], high - layout.first[i]};
        }
        const auto& heights = walk.heights<Integer>();
        for (std::size_t k = 0; k < column_.size(); ++k) {
            if constexpr (!std::is_same_v<Integer, std::int32_t>)
                if (heights[k] > std::numeric_limits<std::int64_t>::max())
                    require(false, "lifting", UnlimitedInteger(heights[k]).str(),
                            "must give the points of all cells volume times height below 2^63: take a smaller one");
            heights_[column_[k]] = converted<std::int64_t>(heights[k]);
        }
        if constexpr (is_unlimited<Integer>)
            require(table.volume <= std::numeric_limits<std::uint64_t>::max(), "supports", table.volume.str(),
                    "must have mixed cells of volumes below 2^64");
        return {edges_, converted<std::uint64_t>(table.volume), heights_};
    }

    const RegenerationPlan& plan_;
    std::vector<std::size_t> column_;
    std::vector<std::array<int, 2>> edges_;
    std::vector<std::int64_t> heights_;
};

}  // namespace equilibria::detail
