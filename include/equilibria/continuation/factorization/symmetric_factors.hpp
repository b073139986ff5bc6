/// \file
/// What factors the sparse symmetric tangents of a problem, which are indefinite beyond its first critical point. A
/// problem chooses by its function symmetric_factors(): SparseLDLT where it has none, or what an opt-in header brings
/// (factorization/mumps.hpp).
#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace equilibria {

/// Factors of one matrix after another, mostly of one pattern.
class SymmetricFactors {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    virtual ~SymmetricFactors() = default;

    /// Of k, of which the entries on and below the diagonal are read. Quicker where it has the pattern of the one
    /// before it. False where it is singular to working precision.
    virtual bool factor(const Matrix& k) = 0;
    /// k^-1 f, after `factor` returned true.
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& f) const = 0;
    /// Negative pivots, after `factor` returned true: negative eigenvalues.
    virtual int negative() const = 0;
    /// Entries of the factors.
    virtual Eigen::Index fill() const = 0;
    /// Whether pivots are chosen so that the solutions can be trusted.
    virtual bool pivots() const { return false; }
};

/// Makes the factors of matrices of which so many of the last unknowns are Lagrange multipliers, with zeros on the
/// diagonal.
using MakeSymmetricFactors = std::unique_ptr<SymmetricFactors> (*)(int multipliers);

}  // namespace equilibria
