/// \file
/// Opt-in: CHOLMOD for the sparse symmetric tangents of large problems. Needs SuiteSparse (Debian: libsuitesparse-dev),
/// linked with -lcholmod.
///
///     const Structure shell(model, {.factors = cholmod});
///
/// Positive definite matrices, as of a structure before its first critical point, by L L^T on dense blocks; others by
/// L D L^T without pivoting, one column after the other, which is slower and gives the inertia. Source: Chen, Davis,
/// Hager, Rajamanickam, Algorithm 887: CHOLMOD, supernodal sparse Cholesky factorization and update/downdate, ACM
/// Trans. Math. Softw. 35 (2008).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/continuation/factorization/symmetric_factors.hpp>

namespace equilibria {

/// L L^T, or else L D L^T, by CHOLMOD, in the order of SparseLDLT.
class CholmodFactors final : public SymmetricFactors {
public:
    /// multipliers: how many of the last unknowns are; with any there is no try of L L^T.
    explicit CholmodFactors(int multipliers = 0) : multipliers_(multipliers) {}

    /// Of a whole matrix too.
    using SymmetricFactors::factor;
    /// False where a pivot is 0 or not finite.
    bool factor(const Matrix& k, const RemovedUnknown& removed) override {
        Matrix now = removed.unknown < 0 ? k : detail::without(k, {removed.unknown, removed.unknown}, removed.corner);
        now.makeCompressed();
        if (!same_pattern(now, k_)) {
            order_ = order_with_multipliers(now, multipliers_, minimum_degree);
            definite_.forget();
            indefinite_.forget();
        }
        k_ = std::move(now);
        negative_ = 0;
        is_definite_ = multipliers_ == 0 && definite_.factor(k_, order_);
        return is_definite_ || (indefinite_.factor(k_, order_) && indefinite_.count_negative(negative_));
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const override {
        return is_definite_ ? Eigen::MatrixXd(definite_.solve(f)) : Eigen::MatrixXd(indefinite_.solve(f));
    }
    int negative() const override { return negative_; }
    Eigen::Index fill() const override { return is_definite_ ? definite_.entries() : indefinite_.entries(); }
    double work() const override { return is_definite_ ? definite_.work() : indefinite_.work(); }

private:
    /// Of compressed matrices.
    static bool same_pattern(const Matrix& a, const Matrix& b) {
        return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
               std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
               std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
    }

    /// With an order of ours.
    template <class Base>
    class Ordered : public Base {
    public:
        Ordered() {
            this->cholmod().print = 0;  // a pivot that is not positive is an answer, not a message
            this->cholmod().nmethods = 1;
            this->cholmod().method[0].ordering = CHOLMOD_GIVEN;
        }
        /// The analysis.
        void forget() {
            if (this->m_cholmodFactor) cholmod_free_factor(&this->m_cholmodFactor, &this->cholmod());
            this->m_cholmodFactor = nullptr;
        }
        double work() const { return work_; }
        bool factor(const Matrix& k, std::vector<int>& order) {
            if (!this->m_cholmodFactor) {
                auto view = Eigen::viewAsCholmod(k.selfadjointView<Eigen::Lower>());
                this->m_cholmodFactor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &this->cholmod());
                this->m_analysisIsOk = this->m_isInitialized = this->m_cholmodFactor != nullptr;
                if (!this->m_cholmodFactor) throw std::runtime_error("CHOLMOD: the analysis ended without memory");
                work_ = this->cholmod().fl / 2;
            }
            this->factorize(k);
            return this->info() == Eigen::Success;
        }

    private:
        double work_ = 0;
    };
    struct Definite : Ordered<Eigen::CholmodSupernodalLLT<Matrix>> {
        Eigen::Index entries() const { return static_cast<Eigen::Index>(m_cholmodFactor->xsize); }
    };
    struct Indefinite : Ordered<Eigen::CholmodSimplicialLDLT<Matrix>> {
        Eigen::Index entries() const { return static_cast<Eigen::Index>(m_cholmodFactor->nzmax); }
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

    int multipliers_;
    Matrix k_;
    std::vector<int> order_;
    Definite definite_;
    Indefinite indefinite_;
    bool is_definite_ = false;
    int negative_ = 0;
};

/// What a problem names to have its tangents factored by CHOLMOD.
inline std::unique_ptr<SymmetricFactors> cholmod(int multipliers) {
    return std::make_unique<CholmodFactors>(multipliers);
}

}  // namespace equilibria
