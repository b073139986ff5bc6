/// \file
/// See continuation/factorization/sparse_ldlt.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria {

struct SparseLDLT::Factors {
    using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

    explicit Factors(int multipliers) : multipliers_(multipliers) {}

    bool factor(const Matrix& k) {
        const bool known = has_pattern(k);
        if (!known) order(k);
        permuted_.selfadjointView<Eigen::Upper>() = k.selfadjointView<Eigen::Lower>().twistedBy(order_);
        if (!known) ldlt_.analyzePattern(permuted_);
        ldlt_.factorize(permuted_);
        return ldlt_.info() == Eigen::Success;
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& f) const {
        const Eigen::VectorXd permuted = order_ * f;
        return order_.inverse() * ldlt_.solve(permuted);
    }
    int negative() const {
        const auto d = ldlt_.vectorD();
        return static_cast<int>((d.array() < 0).count());
    }
    Eigen::Index fill() const { return ldlt_.matrixL().nestedExpression().nonZeros(); }

    bool has_pattern(const Matrix& k) const {
        return k.isCompressed() && k.outerSize() + 1 == static_cast<Eigen::Index>(columns_.size()) &&
               std::equal(columns_.begin(), columns_.end(), k.outerIndexPtr()) &&
               std::equal(rows_.begin(), rows_.end(), k.innerIndexPtr());
    }
    void order(const Matrix& k) {
        columns_.clear();
        if (k.isCompressed()) {
            columns_.assign(k.outerIndexPtr(), k.outerIndexPtr() + k.outerSize() + 1);
            rows_.assign(k.innerIndexPtr(), k.innerIndexPtr() + k.nonZeros());
        }
        const int size = static_cast<int>(k.rows()), own = size - multipliers_;
        Matrix block = k.topLeftCorner(own, own);
        Permutation inverse(own);  // place -> unknown
        if (own > 0) Eigen::AMDOrdering<int>()(block, inverse);
        std::vector<int> place(static_cast<std::size_t>(own));
        for (int i = 0; i < own; ++i) place[static_cast<std::size_t>(inverse.indices()(i))] = i;
        // each multiplier after the last of its constraint's unknowns
        std::vector<std::vector<int>> following(static_cast<std::size_t>(own) + 1);
        for (int m = own; m < size; ++m) {
            int last = -1;
            for (Matrix::InnerIterator entry(k, m); entry; ++entry)
                if (entry.row() < own) last = std::max(last, place[static_cast<std::size_t>(entry.row())]);
            following[static_cast<std::size_t>(last + 1)].push_back(m);
        }
        order_.resize(size);
        int next = 0;
        for (int i = 0; i <= own; ++i) {
            if (i > 0) order_.indices()(inverse.indices()(i - 1)) = next++;
            for (const int m : following[static_cast<std::size_t>(i)]) order_.indices()(m) = next++;
        }
    }

    int multipliers_;
    std::vector<int> columns_, rows_;  // the pattern of the matrices that order_ is for
    Permutation order_;                // unknown -> place
    Matrix permuted_;
    Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt_;
};

EQUILIBRIA_INLINE SparseLDLT::SparseLDLT(int multipliers) : factors_(std::make_unique<Factors>(multipliers)) {}
EQUILIBRIA_INLINE SparseLDLT::SparseLDLT(SparseLDLT&&) noexcept = default;
EQUILIBRIA_INLINE SparseLDLT& SparseLDLT::operator=(SparseLDLT&&) noexcept = default;
EQUILIBRIA_INLINE SparseLDLT::~SparseLDLT() = default;

EQUILIBRIA_INLINE bool SparseLDLT::factor(const Matrix& k) { return factors_->factor(k); }
EQUILIBRIA_INLINE Eigen::VectorXd SparseLDLT::solve(const Eigen::VectorXd& f) const { return factors_->solve(f); }
EQUILIBRIA_INLINE int SparseLDLT::negative() const { return factors_->negative(); }
EQUILIBRIA_INLINE Eigen::Index SparseLDLT::fill() const { return factors_->fill(); }

}  // namespace equilibria
