/// \file
/// See polyhedral/mixed_cells.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/tree_walk.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>

namespace equilibria {

namespace detail {

/// One after another: that with the least product of its degree, by which a partial mixed volume grows at most, and of
/// 1 more than the unknowns that no equation before it has, so that neighbours in a network follow one another.
inline std::vector<int> chosen_order(const Supports& supports) {
    const auto n = static_cast<std::size_t>(supports.unknowns());
    std::vector<int> left(n), order;
    std::iota(left.begin(), left.end(), 0);
    const RegenerationPlan plan(supports, left);
    std::vector<char> has(n, 0);
    const auto new_unknowns = [&](std::size_t equation) {
        std::vector<std::size_t> y;
        for (std::size_t l = 0; l < n; ++l)
            if (!has[l] && std::any_of(plan.points[equation].begin(), plan.points[equation].end(),
                                       [l](const auto& point) { return point[l] != 0; }))
                y.push_back(l);
        return y;
    };
    while (!left.empty()) {
        auto best = left.begin();
        double least = std::numeric_limits<double>::infinity();
        for (auto it = left.begin(); it != left.end(); ++it) {
            const auto i = static_cast<std::size_t>(*it);
            const double cost = static_cast<double>(plan.degree[i]) * (1 + static_cast<double>(new_unknowns(i).size()));
            if (cost >= least) continue;
            least = cost;
            best = it;
        }
        for (const auto l : new_unknowns(static_cast<std::size_t>(*best))) has[l] = 1;
        order.push_back(*best);
        left.erase(best);
    }
    return order;
}

inline RegenerationPlan plan_of(const Supports& supports, const MixedCellOptions& options) {
    const auto n = static_cast<std::size_t>(supports.unknowns());
    if (!options.order.empty()) {
        require(options.order.size() == n, "options.order.size()", options.order.size(),
                "must be the number of equations, " + std::to_string(n) + ", or 0");
        std::vector<char> taken(n, 0);
        for (const int equation : options.order) {
            require(equation >= 0 && equation < supports.unknowns() && !taken[static_cast<std::size_t>(equation)],
                    "options.order", equation, "must have each number of an equation, from 0 on, once");
            taken[static_cast<std::size_t>(equation)] = 1;
        }
    }
    require(options.largest_narrow >= 1, "options.largest_narrow", options.largest_narrow, "must be at least 1");
    require(options.largest_wide >= 1, "options.largest_wide", options.largest_wide, "must be at least 1");
    RegenerationPlan y(supports, options.order.empty() ? chosen_order(supports) : options.order);
    y.largest_narrow = options.largest_narrow;
    y.largest_wide = options.largest_wide;
    y.cancel = options.cancel;
    return y;
}

inline MixedVolume result_of(const RegenerationPlan& plan, const WalkCounts& counts, bool complete) {
    require(counts.volume <= std::numeric_limits<std::uint64_t>::max(), "supports", counts.volume.str(),
            "must have a mixed volume below 2^64");
    MixedVolume y;
    y.value = counts.volume.convert_to<std::uint64_t>();
    y.cells = counts.cells;
    y.exchanges_by_width = counts.exchanges;
    y.exchanges = counts.exchanges[0] + counts.exchanges[1] + counts.exchanges[2];
    y.order = plan.order;
    y.complete = complete;
    return y;
}

EQUILIBRIA_INLINE MixedVolume walk_mixed_cells(const Supports& supports, const Lifting& lifting,
                                               const std::function<bool(const MixedCell&)>& sink,
                                               const MixedCellOptions& options) {
    require(lifting.size() == static_cast<std::size_t>(supports.columns()), "lifting.size()", lifting.size(),
            "must be the number of columns of the supports, " + std::to_string(supports.columns()));
    constexpr auto highest = std::int64_t{1} << 60;
    for (std::size_t k = 0; k < lifting.size(); ++k)
        require(lifting[k] >= -highest && lifting[k] <= highest, "lifting[" + std::to_string(k) + "]", lifting[k],
                "must be from -2^60 to 2^60");
    auto plan = plan_of(supports, options);
    plan.go_to(supports, lifting);
    bool complete = true;
    const auto counts =
        walk_tree(supports, plan, options.executor, std::numeric_limits<std::uint64_t>::max(), sink, complete);
    return result_of(plan, counts, complete);
}

}  // namespace detail

EQUILIBRIA_INLINE MixedVolume mixed_volume(const Supports& supports, const MixedCellOptions& options) {
    const auto plan = detail::plan_of(supports, options);
    bool complete = true;
    auto counts = detail::walk_tree(supports, plan, options.executor, options.most_volume, {}, complete);
    constexpr auto any = std::numeric_limits<std::uint64_t>::max();
    if (options.most_volume != any && counts.volume > options.most_volume)
        counts.volume = options.most_volume, complete = false;
    return detail::result_of(plan, counts, complete);
}

}  // namespace equilibria
