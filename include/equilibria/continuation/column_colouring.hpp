/// \file
/// Columns of a sparse matrix that are found together: no two of the same colour have an entry in the same row, so that
/// the product with the sum of a colour's unit vectors holds each of their entries alone. A Jacobian then takes a
/// directional derivative a colour.
///
/// Greedy colouring of the columns in their order, and from the one with most neighbours down; the better one is taken.
/// A row of m entries needs m colours: of a band, as many as its width, which is then the least; of an equation that
/// depends on all unknowns as many as there are, and no group saves anything. Sources: Curtis, Powell and Reid, On the
/// estimation of sparse Jacobian matrices, IMA J. Appl. Math. 13 (1974) 117-119; Gebremedhin, Manne and Pothen, What
/// color is your Jacobian?, SIAM Review 47 (2005) 629-705.
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// The columns of a sparse matrix in groups without a row in common.
struct ColumnColouring {
    std::vector<int> colour;  ///< of each column, from 0
    int colours = 0;          ///< how many there are
};

/// Colours the columns of a matrix by its pattern: stored zeros count as entries.
ColumnColouring colour_columns(const Eigen::SparseMatrix<double>& pattern);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/column_colouring_definitions.hpp>
#endif
