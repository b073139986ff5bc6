/// \file
/// All of the tree of tropical regeneration, depth first, by one thread or its branches by several. Cells are told in
/// the order of the tree either way: those of a branch that has ended before its turn wait.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/detail/cell_report.hpp>
#include <equilibria/polyhedral/detail/regeneration_node.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/regeneration_walk.hpp>
#include <equilibria/polyhedral/detail/table_integers.hpp>
#include <equilibria/polyhedral/mixed_cell.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <equilibria/run/executor.hpp>
#include <equilibria/run/mutex.hpp>

namespace equilibria::detail {

/// A cell that waits for its turn.
struct StoredCell {
    std::vector<std::array<int, 2>> edges;
    std::uint64_t volume;
    std::vector<std::int64_t> heights;
};

/// Follows a node and all below it, the first child first; tell(node, walk) of each cell says whether to go on. Goes on
/// as long as the walk has not counted more than the most volume, and is not cancelled.
template <class Tell>
bool follow_branch(RegenerationWalk& walk, std::vector<std::unique_ptr<RegenerationNode>>& stack, RegenerationNode& top,
                   std::uint64_t most, Tell&& tell) {
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
            if (walk.counted_more_than(most)) return false;
            --depth;
        }
        if (walk.cancelled()) return false;
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

/// Walks the whole tree; an empty sink: counts, up to about the most volume.
inline WalkCounts walk_tree(const Supports& supports, const RegenerationPlan& plan, const Executor& executor,
                            std::uint64_t most, const std::function<bool(const MixedCell&)>& sink, bool& complete) {
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
        complete = follow_branch(first, stack, root, most, [&](RegenerationNode& node, RegenerationWalk& walk) {
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
    Mutex mutex;
    std::atomic<bool> stopped = false;
    executor.for_blocks(branches.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            RegenerationWalk walk(plan);
            CellReport report(supports, plan);
            std::vector<std::unique_ptr<RegenerationNode>> stack;
            std::vector<StoredCell> found;
            std::uint64_t left = most;
            if (most != std::numeric_limits<std::uint64_t>::max()) {
                const Lock lock(mutex);
                if (counts.volume > most)
                    stopped = true;
                else
                    left -= counts.volume.convert_to<std::uint64_t>();
            }
            if (plan.cancelled()) stopped = true;
            if (!stopped)
                follow_branch(walk, stack, *branches[b], left, [&](RegenerationNode& node, RegenerationWalk& its) {
                    const auto cell = report.cell(node, its);
                    found.push_back({{cell.edges.begin(), cell.edges.end()},
                                     cell.volume,
                                     {cell.heights.begin(), cell.heights.end()}});
                    return !stopped;
                });
            branches[b].reset();
            Lock lock(mutex);
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
    complete = !stopped && !plan.cancelled();
    counts.add(told);
    return counts;
}

}  // namespace equilibria::detail
