/// \file
/// What factors the sparse symmetric tangents of a problem, which are indefinite beyond its first critical point. A
/// problem chooses by its function symmetric_factors(): SparseLDLT where it has none, or what an opt-in header brings
/// (factorization/mumps.hpp, cholmod.hpp, nested_dissection.hpp).
#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace equilibria {

/// An unknown whose row and column are zeros but for `corner`, whatever the matrix holds there.
struct RemovedUnknown {
    Eigen::Index unknown = -1;  ///< -1: none
    double corner = 1;          ///< the entry where row and column cross
};

/// Factors of one matrix after another, mostly of one pattern.
class SymmetricFactors {
public:
    using Matrix = Eigen::SparseMatrix<double>;  ///< both triangles or the lower one

    virtual ~SymmetricFactors() = default;

    /// Of k without an unknown, of which the entries on and below the diagonal are read. Quicker where k has the
    /// pattern of the one before it. False where it is singular to working precision.
    virtual bool factor(const Matrix& k, const RemovedUnknown& removed) = 0;
    bool factor(const Matrix& k) { return factor(k, RemovedUnknown{}); }  ///< of the whole k
    /// k^-1 f, of each column of f, after `factor` returned true.
    virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const = 0;
    /// Negative pivots, after `factor` returned true: negative eigenvalues.
    virtual int negative() const = 0;
    /// Entries of the factors.
    virtual Eigen::Index fill() const = 0;
    /// Multiplications of a factorisation of the last pattern; 0: not known.
    virtual double work() const { return 0; }
    /// Whether pivots are chosen so that the solutions can be trusted.
    virtual bool pivots() const { return false; }
};

/// Makes the factors of matrices of which so many of the last unknowns are Lagrange multipliers, with zeros on the
/// diagonal.
using MakeSymmetricFactors = std::unique_ptr<SymmetricFactors> (*)(int multipliers);

}  // namespace equilibria
