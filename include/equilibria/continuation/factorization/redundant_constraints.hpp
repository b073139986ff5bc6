/// \file
/// Constraints that say what others say already: over-constrained mechanisms, whose multipliers have no values. A dead
/// point looks the same.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// The constraints of a tangent K that others could repeat, from the rows of its last unknowns, their multipliers.
/// Those of unknowns that carry an energy of their own, an entry on K's diagonal (a force with its flexibility), are
/// independent of all others and not among them.
class ConstraintGradients {
public:
    /// weights: of the unknowns, as the continuation's problem has them; lengths are theirs.
    /// \{
    ConstraintGradients(const Eigen::MatrixXd& k, int multipliers, const Eigen::VectorXd& weights);
    ConstraintGradients(const Eigen::SparseMatrix<double>& k, int multipliers, const Eigen::VectorXd& weights);
    /// \}

    int count() const { return static_cast<int>(multipliers_.size()); }  ///< constraints that are compared

    /// Those that depend on constraints before them to 1e-9: multipliers from 0, rising. The time may grow with the
    /// cube of their number.
    std::vector<int> redundant() const;
    /// How many depend on others: singular values of the unit gradients below 3e-7. For thousands of constraints.
    std::size_t redundant_count() const;

private:
    Eigen::SparseMatrix<double> gradients_;  // columns of length 1
    std::vector<int> multipliers_;           // theirs
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/factorization/detail/redundant_constraints_definitions.hpp>
#endif
