/// \file
/// The analysis of a sparse symmetric matrix before it is factored: the elimination tree of an order of its unknowns,
/// and the supernodes, neighbouring columns of L with the same rows below them, which are factored as dense blocks.
///
/// Small supernodes are merged with their parents where that stores few zeros. Sources: Liu, The multifrontal method
/// for sparse matrix solution: theory and practice, SIAM Review 34 (1992); Davis, Direct Methods for Sparse Linear
/// Systems (2006), chapter 4; Ashcraft and Grimes, The influence of relaxed supernode partitions on the multifrontal
/// method, ACM Trans. Math. Softw. 15 (1989).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

namespace equilibria::detail {

/// Places are numbers of unknowns in the order of elimination.
class Supernodes {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// Of a block of columns of L.
    struct Node {
        int first = 0, width = 0;  ///< its columns
        int rows = 0;              ///< how many, those of its columns among them
        int parent = -1;           ///< the node that its update goes to; -1: of a root
        std::size_t row = 0;       ///< where its rows begin in rows() and relative()
        std::size_t panel = 0;     ///< where its entries of L begin, a column of `rows` entries after the other
        int below() const { return rows - width; }
    };

    Supernodes() = default;
    /// k: entries above the diagonal are not read. place: of each unknown, which changes: the elimination tree is
    /// walked through depth first.
    Supernodes(const Matrix& k, std::vector<int>& place) {
        const std::size_t n = place.size();
        std::vector<int> parent(n, -1), count(n, 1);
        make_tree(neighbours(k, place, false), parent, count);
        const std::vector<int> moved = depth_first(parent, count);
        for (int& p : place) p = moved[at(p)];
        const std::vector<int> own_parent = std::exchange(parent, std::vector<int>(n)), own_count = count;
        for (std::size_t j = 0; j < n; ++j) {
            parent[at(moved[j])] = own_parent[j] < 0 ? -1 : moved[at(own_parent[j])];
            count[at(moved[j])] = own_count[j];
        }
        make_nodes(parent, count);
        make_rows(neighbours(k, place, true));
        make_relative();
        make_entries(k, place);
        for (const Node& node : nodes_)
            for (int below = node.below(); below < node.rows; ++below) work_ += 0.5 * below * (below + 3.0);
    }

    const std::vector<Node>& nodes() const { return nodes_; }
    /// Of each node in turn: the places of its rows, ascending.
    const std::vector<int>& rows() const { return rows_; }
    /// Beside each row below a node's columns, which row of its parent it is.
    const std::vector<int>& relative() const { return relative_; }
    /// Entries of all panels.
    std::size_t panel_size() const { return panel_size_; }
    /// Of each stored entry of k on and below the diagonal, where in the panels it belongs.
    const std::vector<std::ptrdiff_t>& entries() const { return entries_; }
    /// Entries of the updates that wait for their parents, at most at a time, where nodes are factored in turn.
    std::size_t most_waiting() const {
        std::size_t now = 0, most = 0;
        std::vector<std::size_t> of_children(nodes_.size(), 0);
        for (std::size_t s = 0; s < nodes_.size(); ++s) {
            const std::size_t own = at(nodes_[s].below()) * at(nodes_[s].below());
            now += own - of_children[s];
            most = std::max(most, now);
            if (nodes_[s].parent >= 0) of_children[at(nodes_[s].parent)] += own;
        }
        return most;
    }
    /// Entries of L that are not zero by structure, below its diagonal.
    Eigen::Index fill() const { return fill_; }
    /// Multiplications of a factorisation: half the square of the entries of each column of the panels.
    double work() const { return work_; }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    /// Lists of places, one a place.
    struct Lists {
        std::vector<std::size_t> first;
        std::vector<int> places;
        std::span<const int> operator[](std::size_t j) const {
            return {places.data() + first[j], places.data() + first[j + 1]};
        }
    };
    /// Of each place those that it shares an entry with, earlier or later ones.
    static Lists neighbours(const Matrix& k, const std::vector<int>& place, bool later) {
        Lists y;
        y.first.assign(place.size() + 1, 0);
        const auto each = [&](const auto& take) {
            for (int c = 0; c < k.outerSize(); ++c)
                for (Matrix::InnerIterator entry(k, c); entry; ++entry) {
                    if (entry.row() <= entry.col()) continue;
                    const auto [low, high] = std::minmax(place[at(c)], place[at(static_cast<int>(entry.row()))]);
                    later ? take(at(low), high) : take(at(high), low);
                }
        };
        each([&](std::size_t of, int) { ++y.first[of + 1]; });
        std::partial_sum(y.first.begin(), y.first.end(), y.first.begin());
        y.places.resize(y.first.back());
        std::vector<std::size_t> next(y.first.begin(), y.first.end() - 1);
        each([&](std::size_t of, int other) { y.places[next[of]++] = other; });
        return y;
    }
    /// The elimination tree, and the entries of each column of L, its diagonal among them.
    static void make_tree(const Lists& earlier, std::vector<int>& parent, std::vector<int>& count) {
        const int n = static_cast<int>(parent.size());
        std::vector<int> ancestor(parent.size(), -1), seen(parent.size(), -1);
        for (int j = 0; j < n; ++j)
            for (int p : earlier[at(j)])
                while (p != -1 && p < j) {
                    const int next = std::exchange(ancestor[at(p)], j);
                    if (next == -1) parent[at(p)] = j;
                    p = next;
                }
        for (int j = 0; j < n; ++j) {
            seen[at(j)] = j;
            for (int p : earlier[at(j)])
                for (; seen[at(p)] != j; p = parent[at(p)]) {
                    ++count[at(p)];
                    seen[at(p)] = j;
                }
        }
    }
    /// Where each place moves to: children before their parents, and the one of the longest column right before.
    static std::vector<int> depth_first(const std::vector<int>& parent, const std::vector<int>& count) {
        const int n = static_cast<int>(parent.size());
        std::vector<std::vector<int>> children(parent.size() + 1);  // the last: roots
        for (int j = 0; j < n; ++j) children[at(parent[at(j)] < 0 ? n : parent[at(j)])].push_back(j);
        std::vector<int> moved(parent.size());
        std::vector<std::pair<int, std::size_t>> open{{n, 0}};
        int next = 0;
        while (!open.empty()) {
            auto& [j, child] = open.back();
            auto& own = children[at(j)];
            if (child == 0)
                std::stable_sort(own.begin(), own.end(), [&](int a, int b) { return count[at(a)] < count[at(b)]; });
            if (child < own.size()) {
                open.emplace_back(own[child++], 0);
                continue;
            }
            if (j < n) moved[at(j)] = next++;
            open.pop_back();
        }
        return moved;
    }
    /// Columns with the same rows below them, and those that are merged with their parents.
    void make_nodes(const std::vector<int>& parent, const std::vector<int>& count) {
        const int n = static_cast<int>(parent.size());
        struct Merged {
            Node node;
            int after;        // the place that its update goes to
            long long zeros;  // that are stored
        };
        std::vector<Merged> merged;
        for (int j = 0; j < n;) {
            int end = j + 1;
            while (end < n && parent[at(end - 1)] == end && count[at(end - 1)] == count[at(end)] + 1) ++end;
            Merged next{{.first = j, .width = end - j, .rows = count[at(j)]}, parent[at(end - 1)], 0};
            fill_ += static_cast<Eigen::Index>(next.node.width) * next.node.rows -
                     static_cast<Eigen::Index>(next.node.width) * (next.node.width + 1) / 2;
            // with the node right before it, whose parent this is
            while (!merged.empty() && merged.back().after >= j && merged.back().after < end) {
                const Merged& child = merged.back();
                const int width = child.node.width + next.node.width, rows = child.node.width + next.node.rows;
                const long long zeros =
                    child.zeros + next.zeros + static_cast<long long>(child.node.width) * (rows - child.node.rows);
                const double share = static_cast<double>(zeros) / (static_cast<double>(width) * rows);
                if (share > (width <= 8 ? 0.5 : width <= 24 ? 0.15 : 0.03)) break;
                next.node.first = child.node.first;
                next.node.width = width;
                next.node.rows = rows;
                next.zeros = zeros;
                merged.pop_back();
            }
            merged.push_back(next);
            j = end;
        }
        node_of_.resize(at(n));
        for (const Merged& m : merged) {
            std::fill_n(node_of_.begin() + m.node.first, m.node.width, static_cast<int>(nodes_.size()));
            nodes_.push_back(m.node);
        }
        std::size_t row = 0;
        for (std::size_t s = 0; s < merged.size(); ++s) {
            Node& node = nodes_[s];
            if (merged[s].after >= 0) node.parent = node_of_[at(merged[s].after)];
            node.row = row;
            row += at(node.rows);
            node.panel = panel_size_;
            panel_size_ += at(node.rows) * at(node.width);
        }
        rows_.resize(row);
    }
    void make_rows(const Lists& later) {
        std::vector<std::vector<int>> children(nodes_.size());
        std::vector<int> seen(node_of_.size(), -1);
        for (std::size_t s = 0; s < nodes_.size(); ++s) {
            const Node& node = nodes_[s];
            const int end = node.first + node.width;
            int* own = rows_.data() + node.row;
            int rows = 0;
            for (int j = node.first; j < end; ++j) own[rows++] = j;
            const auto add = [&](int place) {
                if (place < end || seen[at(place)] == static_cast<int>(s)) return;
                seen[at(place)] = static_cast<int>(s);
                own[rows++] = place;
            };
            for (int j = node.first; j < end; ++j)
                for (const int place : later[at(j)]) add(place);
            for (const int c : children[s]) {
                const Node& child = nodes_[at(c)];
                for (int r = child.width; r < child.rows; ++r) add(rows_[child.row + at(r)]);
            }
            std::sort(own, own + rows);
            if (node.parent >= 0) children[at(node.parent)].push_back(static_cast<int>(s));
        }
    }
    void make_relative() {
        relative_.assign(rows_.size(), -1);
        for (const Node& node : nodes_) {
            if (node.parent < 0) continue;
            const Node& parent = nodes_[at(node.parent)];
            const int* to = rows_.data() + parent.row;
            int k = 0;
            for (int r = node.width; r < node.rows; ++r) {
                while (to[k] != rows_[node.row + at(r)]) ++k;
                relative_[node.row + at(r)] = k;
            }
        }
    }
    void make_entries(const Matrix& k, const std::vector<int>& place) {
        entries_.reserve((place.size() + static_cast<std::size_t>(k.nonZeros()) + 1) / 2);
        for (int c = 0; c < k.outerSize(); ++c)
            for (Matrix::InnerIterator entry(k, c); entry; ++entry) {
                if (entry.row() < entry.col()) continue;
                const auto [low, high] = std::minmax(place[at(c)], place[at(static_cast<int>(entry.row()))]);
                const Node& node = nodes_[at(node_of_[at(low)])];
                const int* own = rows_.data() + node.row;
                const auto row = std::lower_bound(own, own + node.rows, high) - own;
                entries_.push_back(static_cast<std::ptrdiff_t>(node.panel) +
                                   static_cast<std::ptrdiff_t>(low - node.first) * node.rows + row);
            }
    }

    std::vector<Node> nodes_;
    std::vector<int> node_of_, rows_, relative_;
    std::vector<std::ptrdiff_t> entries_;
    std::size_t panel_size_ = 0;
    Eigen::Index fill_ = 0;
    double work_ = 0;
};

}  // namespace equilibria::detail
