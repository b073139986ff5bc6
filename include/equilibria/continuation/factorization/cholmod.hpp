/// \file
/// Opt-in: CHOLMOD for the sparse symmetric tangents of large problems. Needs SuiteSparse (Debian: libsuitesparse-dev),
/// linked with -lcholmod.
///
///     const Structure shell(model, {.factors = cholmod});
///
/// Positive definite matrices, as of a structure before its first critical point, by L L^T on dense blocks; others by
/// L D L^T without pivoting, one column after the other, which is slower and gives the inertia. Of structures with
/// Lagrange multipliers most are refused, since a multiplier may be eliminated before its unknowns. Source: Chen,
/// Davis, Hager, Rajamanickam, Algorithm 887: CHOLMOD, supernodal sparse Cholesky factorization and update/downdate,
/// ACM Trans. Math. Softw. 35 (2008).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/symmetric_factors.hpp>

namespace equilibria {

/// L L^T, or else L D L^T, by CHOLMOD.
class CholmodFactors final : public SymmetricFactors {
public:
    CholmodFactors() {
        // a pivot that is not positive is an answer, not a message
        definite_.cholmod().print = indefinite_.cholmod().print = 0;
    }

    using SymmetricFactors::factor;
    /// False where a pivot is 0 or not finite.
    bool factor(const Matrix& k, const RemovedUnknown& removed) override {
        const bool same = take(k, removed);
        negative_ = 0;
        if (!same) {
            definite_.analyzePattern(k_);
            analysed_ = false;
        }
        definite_.factorize(k_);
        is_definite_ = definite_.info() == Eigen::Success;
        if (is_definite_) return true;
        if (!analysed_) indefinite_.analyzePattern(k_);
        analysed_ = true;
        indefinite_.factorize(k_);
        return indefinite_.info() == Eigen::Success && indefinite_.count_negative(negative_);
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const override {
        return is_definite_ ? Eigen::MatrixXd(definite_.solve(f)) : Eigen::MatrixXd(indefinite_.solve(f));
    }
    int negative() const override { return negative_; }
    Eigen::Index fill() const override { return is_definite_ ? definite_.fill() : indefinite_.fill(); }

private:
    class Definite : public Eigen::CholmodSupernodalLLT<Matrix> {
    public:
        Eigen::Index fill() const { return static_cast<Eigen::Index>(m_cholmodFactor->xsize); }
    };
    class Indefinite : public Eigen::CholmodSimplicialLDLT<Matrix> {
    public:
        Eigen::Index fill() const { return static_cast<Eigen::Index>(m_cholmodFactor->nzmax); }
        /// Of the pivots; false where one is 0 or not finite.
        bool count_negative(int& negative) const {
            const auto* first = static_cast<const int*>(m_cholmodFactor->p);
            const auto* values = static_cast<const double*>(m_cholmodFactor->x);
            for (std::size_t j = 0; j < m_cholmodFactor->n; ++j) {
                const double pivot = values[first[j]];
                if (!(std::abs(pivot) > 0) || !std::isfinite(1 / pivot)) return false;
                if (pivot < 0) ++negative;
            }
            return true;
        }
    };

    /// Whether k has the pattern of the last matrix.
    bool take(const Matrix& k, const RemovedUnknown& removed) {
        const bool same = k_.rows() == k.rows() && k_.nonZeros() == k.nonZeros() && k.isCompressed() &&
                          std::equal(k.outerIndexPtr(), k.outerIndexPtr() + k.outerSize() + 1, k_.outerIndexPtr()) &&
                          std::equal(k.innerIndexPtr(), k.innerIndexPtr() + k.nonZeros(), k_.innerIndexPtr());
        k_ = k;
        k_.makeCompressed();
        if (removed.unknown < 0) return same;
        for (int c = 0; c < k_.outerSize(); ++c)
            for (Matrix::InnerIterator entry(k_, c); entry; ++entry)
                if (entry.row() == removed.unknown || c == removed.unknown)
                    entry.valueRef() = entry.row() == c ? removed.corner : 0;
        return same;
    }

    Matrix k_;
    Definite definite_;
    Indefinite indefinite_;
    bool is_definite_ = false, analysed_ = false;
    int negative_ = 0;
};

/// What a problem names to have its tangents factored by CHOLMOD.
inline std::unique_ptr<SymmetricFactors> cholmod(int /*multipliers*/) { return std::make_unique<CholmodFactors>(); }

}  // namespace equilibria
