/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <Eigen/SparseLU>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE double largest_entry(const Eigen::SparseMatrix<double>& k) {
    double y = 0;
    for (Eigen::Index c = 0; c < k.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(k, c); entry; ++entry)
            if (std::isnan(entry.value()))
                return entry.value();
            else
                y = std::max(y, std::abs(entry.value()));
    return y;
}

EQUILIBRIA_INLINE double largest_force(const Eigen::SparseMatrix<double>& k, const Eigen::VectorXd& weights,
                                       Eigen::Index own) {
    double y = 0;
    for (Eigen::Index c = 0; c < own; ++c) {
        double column = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(k, c); entry; ++entry)
            column = std::max(column, std::abs(entry.value()));
        y = std::max(y, column / std::sqrt(weights(c)));
    }
    return y;
}

/// L D L^T of a sparse K without its border, or L U.
template <class Number>
class BorderedFactors<Eigen::SparseMatrix<Number>> {
public:
    using Matrix = Eigen::SparseMatrix<Number>;
    using LU = Eigen::SparseLU<Matrix>;

    BorderedFactors(bool symmetric, int multipliers, MakeSymmetricFactors make)
        : symmetric_(symmetric), factors_((make ? make : &sparse_ldlt)(multipliers)) {}

    /// The sign of the determinant, 0 where it is singular to working precision.
    int factor(const Matrix& without) {
        negative_.reset();
        use_lu_ = !symmetric_;
        if (symmetric_) {
            use_lu_ = !factors_->factor(without) || !(factors_->pivots() || safe(without));
            if (!use_lu_) {
                negative_ = factors_->negative();
                return *negative_ % 2 == 0 ? 1 : -1;
            }
        }
        lu_.compute(without);
        if (lu_.info() != Eigen::Success) return 0;
        return lu_.signDeterminant() < 0 ? -1 : 1;
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& f, bool transposed) const {
        if (!use_lu_) return factors_->solve(f);
        // SparseLU's transposed view is not const in Eigen 3.4
        return transposed ? Eigen::VectorXd(const_cast<LU&>(lu_).transpose().solve(f)) : Eigen::VectorXd(lu_.solve(f));
    }
    std::optional<TangentInertia> inertia(const Matrix&, double sigma) const {
        if (!negative_) return std::nullopt;
        TangentInertia y;
        y.negative = *negative_ + (sigma > 0 ? 1 : 0);
        return y;
    }

private:
    /// Whether the factors reproduce a vector: without pivoting they may not.
    bool safe(const Matrix& without) const {
        const Eigen::VectorXd f = Eigen::VectorXd::Ones(without.rows());
        const Eigen::VectorXd x = factors_->solve(f);
        const double size = largest_entry(without) * x.lpNorm<Eigen::Infinity>() + 1;
        return (without * x - f).template lpNorm<Eigen::Infinity>() < 1e-9 * size;
    }

    bool symmetric_, use_lu_ = false;
    std::optional<int> negative_;
    std::unique_ptr<SymmetricFactors> factors_;
    LU lu_;
};

}  // namespace equilibria::detail
