/// \file
/// See continuation/column_colouring.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <equilibria/continuation/column_colouring.hpp>

namespace equilibria {

namespace detail {

/// Each column in turn takes the least colour that none of its neighbours has.
EQUILIBRIA_INLINE ColumnColouring greedy_colouring(const Eigen::SparseMatrix<double>& by_columns,
                                                   const Eigen::SparseMatrix<double, Eigen::RowMajor>& by_rows,
                                                   const std::vector<int>& order) {
    const auto at = [](int k) { return static_cast<std::size_t>(k); };
    ColumnColouring y;
    y.colour.assign(order.size(), -1);
    std::vector<int> taken_by;  // of each colour the last column that may not have it
    for (const int c : order) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(by_columns, c); entry; ++entry)
            for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator beside(by_rows, entry.row()); beside;
                 ++beside) {
                const int colour = y.colour[at(static_cast<int>(beside.col()))];
                if (colour >= 0) taken_by[at(colour)] = c;
            }
        int colour = 0;
        while (colour < y.colours && taken_by[at(colour)] == c) ++colour;
        if (colour == y.colours) {
            ++y.colours;
            taken_by.push_back(-1);
        }
        y.colour[at(c)] = colour;
    }
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE ColumnColouring colour_columns(const Eigen::SparseMatrix<double>& pattern) {
    const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = pattern;
    std::vector<int> order(static_cast<std::size_t>(pattern.cols()));
    std::iota(order.begin(), order.end(), 0);
    ColumnColouring y = detail::greedy_colouring(pattern, by_rows, order);
    // no colouring has fewer colours than a row has entries
    int least = 0;
    for (Eigen::Index r = 0; r < by_rows.rows(); ++r)
        least = std::max(least, static_cast<int>(by_rows.innerVector(r).nonZeros()));
    if (y.colours <= least) return y;
    std::vector<Eigen::Index> neighbours(order.size(), 0);
    for (Eigen::Index c = 0; c < pattern.cols(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(pattern, c); entry; ++entry)
            neighbours[static_cast<std::size_t>(c)] += by_rows.innerVector(entry.row()).nonZeros();
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return neighbours[static_cast<std::size_t>(a)] > neighbours[static_cast<std::size_t>(b)];
    });
    ColumnColouring other = detail::greedy_colouring(pattern, by_rows, order);
    return other.colours < y.colours ? std::move(other) : std::move(y);
}

}  // namespace equilibria
