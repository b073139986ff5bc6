/// \file
/// Which wall of its cone a cell is left by: the ratio test of tropical homotopies, lexicographic, so that there are no
/// ties and no cell is met twice.
///
/// Source: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016).
#pragma once

#include <cstddef>
#include <vector>

#include <equilibria/polyhedral/detail/circuit_table.hpp>

namespace equilibria::detail {

/// Keeps those candidates k whose value(k) / weight(k) is smallest, in their order; at least one.
template <class Product, class Value, class Weight>
void keep_smallest(std::vector<int>& candidates, Value&& value, Weight&& weight) {
    std::size_t kept = 1;
    auto best = value(candidates[0]);
    auto best_weight = weight(candidates[0]);
    for (std::size_t c = 1; c < candidates.size(); ++c) {
        const int k = candidates[c];
        const auto x = value(k);
        if (!(x == 0 && best == 0)) {
            const auto mine = weight(k);
            const Product left = Product(x) * Product(best_weight), right = Product(best) * Product(mine);
            if (right < left) continue;
            if (left < right) {
                kept = 0;
                best = x;
                best_weight = mine;
            }
        }
        candidates[kept++] = k;
    }
    candidates.resize(kept);
}

/// Of the candidates, in ascending order and not empty, the column whose inequality c_k . omega >= 0 fails first, where
/// omega is infinitesimal and lexicographic: the smallest c_k / weight(k). The others are lost.
template <class Product, class Integer, class Weight>
int first_wall(const ColumnLayout& layout, const CircuitTable<Integer>& table, std::vector<int>& candidates,
               Weight&& weight) {
    // the entries of c_k that are not 0: those of D^-1, and minus the volume at k
    for (int j = 0; j < layout.configurations(); ++j) {
        const auto& edge = table.edges[static_cast<std::size_t>(j)];
        const int lower = edge[0] < edge[1] ? 0 : 1;
        if (candidates.size() == 1 || candidates[0] < edge[static_cast<std::size_t>(lower)]) return candidates[0];
        const Integer* const row = table.row(j);
        if (candidates[0] >= layout.first[static_cast<std::size_t>(j) + 1]) {
            // of other configurations: entries for the two ends are opposite, and ties for the one are ties for the
            // other
            bool any = false;
            for (const int k : candidates) any |= row[k] != 0;
            if (!any) continue;
            if (lower == 0)
                keep_smallest<Product>(candidates, [row](int k) { return row[k]; }, weight);
            else
                keep_smallest<Product>(candidates, [row](int k) { return Integer(-row[k]); }, weight);
            continue;
        }
        for (const int end : {lower, 1 - lower}) {
            if (candidates.size() == 1 || candidates[0] < edge[static_cast<std::size_t>(end)]) return candidates[0];
            keep_smallest<Product>(candidates, [&](int k) { return table.entry(layout, j, end, k); }, weight);
        }
    }
    return candidates[0];
}

}  // namespace equilibria::detail
