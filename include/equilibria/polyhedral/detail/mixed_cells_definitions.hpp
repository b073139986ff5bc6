/// \file
/// See polyhedral/mixed_cells.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/regeneration_walk.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>

namespace equilibria {

namespace detail {

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

/// A cell that waits for its turn.
struct StoredCell {
    std::vector<std::array<int, 2>> edges;
    std::uint64_t volume;
    std::vector<std::int64_t> heights;
};

/// Follows a node and all below it, the first child first; tell(node, walk) of each cell says whether to go on.
template <class Tell>
bool follow_branch(RegenerationWalk& walk, std::vector<std::unique_ptr<RegenerationNode>>& stack, RegenerationNode& top,
                   Tell&& tell) {
    if (stack.empty()) stack.push_back(std::make_unique<RegenerationNode>());
    stack[0]->copy(top);
    std::size_t depth = 1;
    while (depth != 0) {
        if (stack.size() == depth) stack.push_back(std::make_unique<RegenerationNode>());
        const auto event = walk.advance(*stack[depth - 1], *stack[depth]);
        if (event == RegenerationWalk::Event::divided) {
            ++depth;
        } else {
            if (event == RegenerationWalk::Event::cell && !tell(*stack[depth - 1], walk)) return false;
            --depth;
        }
    }
    return true;
}

/// So many branches or more whose cells one after another are those of the tree, where it has as many.
inline std::vector<std::unique_ptr<RegenerationNode>> divide_tree(RegenerationWalk& walk, std::size_t branches) {
    std::vector<std::unique_ptr<RegenerationNode>> nodes, next;
    nodes.push_back(std::make_unique<RegenerationNode>(walk.root()));
    std::vector<char> ended{0}, next_ended;
    for (bool divides = true; divides && nodes.size() < branches;) {
        divides = false;
        next.clear();
        next_ended.clear();
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            auto child = std::make_unique<RegenerationNode>();
            const auto event = ended[k] ? RegenerationWalk::Event::cell : walk.advance(*nodes[k], *child);
            if (event == RegenerationWalk::Event::ended) continue;
            if (event == RegenerationWalk::Event::divided) {
                divides = true;
                next.push_back(std::move(child));
                next_ended.push_back(0);
            }
            next.push_back(std::move(nodes[k]));
            next_ended.push_back(event == RegenerationWalk::Event::cell);
        }
        nodes.swap(next);
        ended.swap(next_ended);
    }
    return nodes;
}

/// Puts a walk's counts into a result.
struct WalkCounts {
    UnlimitedInteger volume = 0;
    std::uint64_t cells = 0;
    std::array<std::uint64_t, 3> exchanges = {};

    void add(const WalkCounts& other) {
        volume += other.volume;
        cells += other.cells;
    }
    void add(const RegenerationWalk& walk) {
        volume += walk.counted_volume();
        cells += walk.counted;
        for (std::size_t w = 0; w < 3; ++w) exchanges[w] += walk.exchanges[w];
    }
};

/// Walks the whole tree; an empty sink: counts.
inline WalkCounts walk_tree(const Supports& supports, const RegenerationPlan& plan, const Executor& executor,
                            const std::function<bool(const MixedCell&)>& sink, bool& complete) {
    WalkCounts counts, told;  // `told` changes where no lock is held, by one at a time
    for (const auto& points : plan.points)
        if (points.size() == 1) return counts;  // no edge, no cell
    RegenerationWalk first(plan);
    const auto tell = [&](const MixedCell& cell) {
        told.volume += cell.volume;
        ++told.cells;
        return sink(cell);
    };
    if (executor.workers() == 1) {
        CellReport report(supports, plan);
        std::vector<std::unique_ptr<RegenerationNode>> stack;
        auto root = first.root();
        complete = follow_branch(first, stack, root, [&](RegenerationNode& node, RegenerationWalk& walk) {
            return tell(report.cell(node, walk));
        });
        counts.add(first);
        counts.add(told);
        return counts;
    }
    // the branches' cells are told in the order of the branches, those found early wait
    auto branches = divide_tree(first, std::size_t{64} * executor.workers());
    counts.add(first);
    std::vector<std::vector<StoredCell>> waiting(branches.size());
    std::vector<char> done(branches.size(), 0);
    std::size_t turn = 0;
    bool telling = false;
    std::mutex mutex;
    std::atomic<bool> stopped = false;
    executor.for_blocks(branches.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            RegenerationWalk walk(plan);
            CellReport report(supports, plan);
            std::vector<std::unique_ptr<RegenerationNode>> stack;
            std::vector<StoredCell> found;
            if (!stopped)
                follow_branch(walk, stack, *branches[b], [&](RegenerationNode& node, RegenerationWalk& its) {
                    const auto cell = report.cell(node, its);
                    found.push_back({{cell.edges.begin(), cell.edges.end()},
                                     cell.volume,
                                     {cell.heights.begin(), cell.heights.end()}});
                    return !stopped;
                });
            branches[b].reset();
            std::unique_lock lock(mutex);
            counts.add(walk);
            waiting[b] = std::move(found);
            done[b] = 1;
            if (telling) continue;  // another one sees to it
            telling = true;
            while (turn < done.size() && done[turn] && !stopped) {
                const auto cells = std::move(waiting[turn++]);
                lock.unlock();
                try {
                    for (const auto& cell : cells)
                        if (!tell({cell.edges, cell.volume, cell.heights})) {
                            stopped = true;
                            break;
                        }
                } catch (...) {
                    stopped = true;
                    throw;
                }
                lock.lock();
            }
            telling = false;
        }
    });
    complete = !stopped;
    counts.add(told);
    return counts;
}

/// By the number of points times the degree: the partial mixed volumes grow with the degrees, and what a support with
/// few points has less than its simplex it has for all later stages.
inline std::vector<int> chosen_order(const Supports& supports) {
    std::vector<int> given;
    for (int i = 0; i < supports.unknowns(); ++i) given.push_back(i);
    const RegenerationPlan plan(supports, given);
    std::stable_sort(given.begin(), given.end(), [&](int a, int b) {
        const auto size = [&](int i) {
            return static_cast<double>(plan.points[static_cast<std::size_t>(i)].size()) *
                   static_cast<double>(plan.degree[static_cast<std::size_t>(i)]);
        };
        return size(a) < size(b);
    });
    return given;
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
    const auto counts = walk_tree(supports, plan, options.executor, sink, complete);
    return result_of(plan, counts, complete);
}

}  // namespace detail

EQUILIBRIA_INLINE bool MixedCell::fine() const {
    const auto zeros = static_cast<std::size_t>(std::count(heights.begin(), heights.end(), std::int64_t{0}));
    return zeros == 2 * edges.size();
}

EQUILIBRIA_INLINE MixedVolume mixed_volume(const Supports& supports, const MixedCellOptions& options) {
    const auto plan = detail::plan_of(supports, options);
    bool complete = true;
    const auto counts = detail::walk_tree(supports, plan, options.executor, {}, complete);
    return detail::result_of(plan, counts, complete);
}

}  // namespace equilibria
