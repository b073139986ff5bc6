/// \file
/// L D L^T of a sparse symmetric matrix without pivoting, which gives its inertia: by the multifrontal method, whose
/// work is on dense blocks. Its last unknowns may be Lagrange multipliers, with zeros on the diagonal: the
/// fill-reducing order of the others is kept, and each multiplier follows the last unknown that its constraint holds.
/// Where the others' block is positive definite no pivot is 0 then, if the constraints are independent.
/// Source: Duff and Reid, The multifrontal solution of indefinite sparse symmetric linear equations, ACM Trans. Math.
/// Softw. 9 (1983).
#pragma once

#include <memory>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/symmetric_factors.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// An order of elimination that leaves few entries, of the unknowns of a matrix with the entries of both triangles:
/// which unknown is at each place.
using EliminationOrder = std::vector<int> (*)(const SymmetricFactors::Matrix& k);

/// By approximate minimum degree (Eigen's): quick, and good up to some 1e5 unknowns.
std::vector<int> minimum_degree(const SymmetricFactors::Matrix& k);

/// The order `by` of all but the last `multipliers` unknowns, and each of these right after the last unknown that its
/// constraint holds: which unknown is at each place.
std::vector<int> order_with_multipliers(const SymmetricFactors::Matrix& k, int multipliers, EliminationOrder by);

/// L D L^T by the multifrontal method, without pivoting.
class SparseLDLT final : public SymmetricFactors {
public:
    /// order: of the unknowns that are no multipliers.
    explicit SparseLDLT(int multipliers = 0, EliminationOrder order = minimum_degree);
    /// Moved with its factors.
    /// \{
    SparseLDLT(SparseLDLT&&) noexcept;
    SparseLDLT& operator=(SparseLDLT&&) noexcept;
    /// \}
    ~SparseLDLT() override;

    /// Of a whole matrix too.
    using SymmetricFactors::factor;
    /// False where a pivot is 0 or not finite.
    bool factor(const Matrix& k, const RemovedUnknown& removed) override;
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const override;
    int negative() const override;
    /// Entries of L below its diagonal.
    Eigen::Index fill() const override;
    double work() const override;

private:
    struct Factors;

    std::unique_ptr<Factors> factors_;
};

/// The factors of a problem that names none.
inline std::unique_ptr<SymmetricFactors> sparse_ldlt(int multipliers) {
    return std::make_unique<SparseLDLT>(multipliers);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/factorization/detail/sparse_ldlt_definitions.hpp>
#endif
