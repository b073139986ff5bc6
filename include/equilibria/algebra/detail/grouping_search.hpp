/// \file
/// The multihomogeneous numbers of all set partitions of the unknowns, the work for common blocks done once.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace equilibria::detail {

/// Degrees of equations in sets of unknowns: [equation][set], a set's members the bits of its index.
struct DegreesInSets {
    int unknowns = 0;
    std::vector<int> degree;

    /// support: entries with `equation` and `monomial.degree(unknown)`. (Vectors here have their values given: clang 14
    /// has none of default values in constant expressions.)
    constexpr DegreesInSets(const auto& support, int n) : unknowns(n), degree(static_cast<std::size_t>(n) << n, 0) {
        std::vector<int> of_term(sets(), 0);
        for (const auto& term : support) {
            int* most = degree.data() + static_cast<std::size_t>(term.equation) * sets();
            for (std::size_t set = 1; set < sets(); ++set) {
                of_term[set] = of_term[set & (set - 1)] + term.monomial.degree(std::countr_zero(set));
                most[set] = std::max(most[set], of_term[set]);
            }
        }
    }

    constexpr std::size_t sets() const { return std::size_t{1} << unknowns; }
    constexpr int operator()(int equation, std::size_t set) const {
        return degree[static_cast<std::size_t>(equation) * sets() + set];
    }

    /// What no multihomogeneous number exceeds: the product over the equations of the sum of their degrees in each
    /// unknown.
    constexpr double most() const {
        double product = 1;
        for (int i = 0; i < unknowns; ++i) {
            double sum = 0;
            for (int u = 0; u < unknowns; ++u) sum += (*this)(i, std::size_t{1} << u);
            product *= sum;
        }
        return product;
    }
};

/// The number of a partition is a sum over the ways to hand each block as many equations as it has unknowns: of the
/// product, over the equations, of their degrees in their blocks (Wampler, Bezout number calculations for
/// multi-homogeneous polynomial systems, Appl. Math. Comput. 51 (1992)). Blocks are put down depth first, each with the
/// first unknown that is left, and ways[equations] is the sum for the blocks so far and these equations: partitions
/// share it as far as they share blocks. Count: an integer that holds every number (DegreesInSets::most), or PathCount.
template <class Count>
class GroupingSearch {
public:
    constexpr explicit GroupingSearch(const DegreesInSets& degree)
        : n_(degree.unknowns), sets_(degree.sets()), products_(sets_ * sets_, Count{}),
          grouping_(static_cast<std::size_t>(n_), 0),
          ways_(static_cast<std::size_t>(n_), std::vector<Count>(sets_, Count{})) {
        for (std::size_t set = 0; set < sets_; ++set) {
            for (int size = 0; size <= n_; ++size) {
                first_subset_.push_back(subsets_.size());
                std::size_t s = 0;
                do {
                    if (std::popcount(s) == size) subsets_.push_back(static_cast<unsigned>(s));
                    s = (s - set) & set;
                } while (s != 0);
            }
        }
        first_subset_.push_back(subsets_.size());
        for (std::size_t block = 1; block < sets_; ++block) {
            for_each_subset(sets_ - 1, std::popcount(block), [&](std::size_t equations) {
                Count product{1};
                for (std::size_t left = equations; left != 0; left &= left - 1)
                    product = product * Count{degree(std::countr_zero(left), block)};
                products_[block * sets_ + equations] = product;
            });
        }
        ways_[0][0] = Count{1};
    }

    /// visit(number, grouping, number of groups) for each partition; grouping: the group of each unknown, by the order
    /// of the groups' first unknowns.
    constexpr void for_each(auto visit) { for_each_from(0, 0, visit); }

private:
    int n_;
    std::size_t sets_;
    std::vector<Count> products_;           // [block][equations]
    std::vector<int> grouping_;             // of the unknowns in blocks
    std::vector<std::vector<Count>> ways_;  // [number of blocks][equations]
    std::vector<unsigned> subsets_;         // of each set, by size
    std::vector<std::size_t> first_subset_;

    constexpr void for_each_subset(std::size_t set, int size, auto visit) const {
        const std::size_t k = set * static_cast<std::size_t>(n_ + 1) + static_cast<std::size_t>(size);
        for (std::size_t i = first_subset_[k]; i < first_subset_[k + 1]; ++i) visit(std::size_t{subsets_[i]});
    }

    constexpr Count sum_over_ways(int blocks, std::size_t block, std::size_t equations) const {
        const Count* before = ways_[static_cast<std::size_t>(blocks)].data();
        const Count* product = products_.data() + block * sets_;
        Count sum{};
        for_each_subset(equations, std::popcount(block),
                        [&](std::size_t s) { sum = sum + before[equations ^ s] * product[s]; });
        return sum;
    }

    /// used: the unknowns in the `blocks` so far.
    constexpr void for_each_from(int blocks, std::size_t used, auto& visit) {
        const std::size_t left = (sets_ - 1) ^ used, first = left & (~left + 1), others = left ^ first;
        for (std::size_t more = others;; more = (more - 1) & others) {
            const std::size_t block = first | more;
            for (std::size_t s = block; s != 0; s &= s - 1)
                grouping_[static_cast<std::size_t>(std::countr_zero(s))] = blocks;
            if (block == left) {
                visit(sum_over_ways(blocks, block, sets_ - 1), grouping_, blocks + 1);
            } else {
                for_each_subset(sets_ - 1, std::popcount(used | block), [&](std::size_t equations) {
                    ways_[static_cast<std::size_t>(blocks + 1)][equations] = sum_over_ways(blocks, block, equations);
                });
                for_each_from(blocks + 1, used | block, visit);
            }
            if (more == 0) break;
        }
    }
};

}  // namespace equilibria::detail
