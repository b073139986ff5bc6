/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

#include <Eigen/SparseLU>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE double largest_entry(const Eigen::SparseMatrix<double>& k) {
    if (k.nonZeros() == 0) return 0;
    if (!k.isCompressed()) return largest_entry(Eigen::SparseMatrix<double>(k));
    return k.coeffs().isNaN().any() ? std::numeric_limits<double>::quiet_NaN() : k.coeffs().abs().maxCoeff();
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

EQUILIBRIA_INLINE Eigen::SparseMatrix<double> without(const Eigen::SparseMatrix<double>& k, Border border,
                                                      double corner) {
    Eigen::SparseMatrix<double> y = k;
    for (Eigen::Index c = 0; c < y.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(y, c); entry; ++entry)
            if (entry.row() == border.row || entry.col() == border.column) entry.valueRef() = 0;
    y.coeffRef(border.row, border.column) = corner;
    return y;
}

EQUILIBRIA_INLINE Eigen::MatrixXd symmetric_product(const Eigen::SparseMatrix<double>& k, const Eigen::MatrixXd& x) {
    // each column of k is a row: entries of the result are sums, several side by side
    Eigen::MatrixXd y(x.rows(), x.cols());
    const auto product = [&]<int N>(Eigen::Index first, std::integral_constant<int, N>) {
        const Eigen::Index columns = std::min<Eigen::Index>(N, x.cols() - first);
        Eigen::Matrix<double, Eigen::Dynamic, N, N == 1 ? Eigen::ColMajor : Eigen::RowMajor> some(x.rows(), N);
        if (columns < N) some.setZero();
        some.leftCols(columns) = x.middleCols(first, columns);
        for (Eigen::Index c = 0; c < k.outerSize(); ++c) {
            Eigen::Matrix<double, 1, N> sum = Eigen::Matrix<double, 1, N>::Zero();
            for (Eigen::SparseMatrix<double>::InnerIterator entry(k, c); entry; ++entry)
                sum += entry.value() * some.row(entry.row());
            for (Eigen::Index i = 0; i < columns; ++i) y(c, first + i) = sum(i);
        }
    };
    Eigen::Index c = 0;
    for (; x.cols() - c > 2; c += 4) product(c, std::integral_constant<int, 4>());
    if (x.cols() - c == 2) product(c, std::integral_constant<int, 2>());
    if (x.cols() - c == 1) product(c, std::integral_constant<int, 1>());
    return y;
}

/// L D L^T of a sparse K without its border, or L U.
template <class Number>
class BorderedFactors<Eigen::SparseMatrix<Number>> {
public:
    using Matrix = Eigen::SparseMatrix<Number>;
    using LU = Eigen::SparseLU<Matrix>;

    BorderedFactors(bool symmetric, int multipliers, MakeSymmetricFactors make)
        : symmetric_(symmetric), multipliers_(multipliers), factors_((make ? make : &sparse_ldlt)(multipliers)) {}

    int factor(const Matrix& k, Border border, double corner) {
        border_ = border;
        column_ = k.col(border.column);
        if (symmetric_)
            row_ = column_;
        else
            row_ = k.transpose().col(border.row);
        negative_.reset();
        negative_of_k_.reset();
        use_lu_ = !symmetric_;
        if (symmetric_) {
            use_lu_ = !factors_->factor(k, {border.row, corner}) || !(factors_->pivots() || safe(k, border, corner));
            if (!use_lu_) {
                negative_ = factors_->negative();
                return *negative_ % 2 == 0 ? 1 : -1;
            }
            if (multipliers_ == 0) negative_of_k_ = negative_beside(k, corner);
        }
        lu_.compute(without(k, border, corner));
        if (lu_.info() != Eigen::Success) return 0;
        return lu_.signDeterminant() < 0 ? -1 : 1;
    }
    BorderedSolutions solve(const Matrix& k, const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed,
                            int rounds) const {
        // of B^T, row and column change places
        const Eigen::VectorXd &row = transposed ? column_ : row_, &column = transposed ? row_ : column_;
        const Eigen::Index j = transposed ? border_.column : border_.row, i = transposed ? border_.row : border_.column;
        BorderedSolutions y{Eigen::MatrixXd::Zero(f.rows(), f.cols()), {}};
        Eigen::MatrixXd rest = f;
        for (Eigen::Index c = 0; c < f.cols(); ++c)
            if (xi(c) != 0) rest.col(c) -= xi(c) * column;
        // the second round removes the rounding of the first
        for (int round = 0; round < rounds; ++round) {
            if (round > 0) rest = f - product(k, y.x, transposed);
            rest.row(j).setZero();
            y.x += solve_without(rest, transposed);
            y.x.row(i) = xi.transpose();
        }
        y.tau = f.row(j).transpose() - y.x.transpose() * row;
        return y;
    }
    std::optional<TangentInertia> inertia(const Matrix&, double sigma) const {
        TangentInertia y;
        if (negative_of_k_) {
            y.negative = *negative_of_k_;
            return y;
        }
        if (!negative_) return std::nullopt;
        y.negative = *negative_ + (sigma > 0 ? 1 : 0);
        return y;
    }
    double work_ratio() const {
        return use_lu_ || factors_->fill() == 0 ? 0 : factors_->work() / (2.0 * static_cast<double>(factors_->fill()));
    }

private:
    /// Negative eigenvalues of K where it cannot be factored without the border, or without pivoting: those of K with a
    /// small diagonal added, and taken off, if both have as many.
    std::optional<int> negative_beside(const Matrix& k, double corner) {
        std::optional<int> y;
        const Eigen::VectorXd generic = generic_vector(k.rows()).cwiseAbs(), ones = Eigen::VectorXd::Ones(k.rows());
        for (const double sign : {1.0, -1.0}) {
            Matrix beside = k;
            for (Eigen::Index j = 0; j < k.rows(); ++j)
                beside.coeffRef(j, j) += sign * corner * (1e-7 + 1e-6 * generic(j));
            if (!factors_->factor(beside)) return std::nullopt;
            const Eigen::MatrixXd x = factors_->solve(ones), left = symmetric_product(beside, x) - ones;
            const double size = corner * x.lpNorm<Eigen::Infinity>() + 1;
            if (!(left.lpNorm<Eigen::Infinity>() < 1e-9 * size)) return std::nullopt;
            if (y && *y != factors_->negative()) return std::nullopt;
            y = factors_->negative();
        }
        return y;
    }
    /// Of K without the border.
    Eigen::MatrixXd solve_without(const Eigen::MatrixXd& f, bool transposed) const {
        if (!use_lu_) return factors_->solve(f);
        // SparseLU's transposed view is not const in Eigen 3.4
        return transposed ? Eigen::MatrixXd(const_cast<LU&>(lu_).transpose().solve(f)) : Eigen::MatrixXd(lu_.solve(f));
    }
    Eigen::MatrixXd product(const Matrix& k, const Eigen::MatrixXd& x, bool transposed) const {
        if (symmetric_) return symmetric_product(k, x);
        return transposed ? Eigen::MatrixXd(k.transpose() * x) : Eigen::MatrixXd(k * x);
    }
    /// Whether the factors reproduce a vector: without pivoting they may not. corner: the largest entry of k.
    bool safe(const Matrix& k, Border border, double corner) const {
        Eigen::MatrixXd x = factors_->solve(Eigen::VectorXd::Ones(k.rows()));
        const double size = corner * x.lpNorm<Eigen::Infinity>() + 1, at_border = x(border.row);
        x(border.row) = 0;
        Eigen::MatrixXd left = symmetric_product(k, x);
        left(border.row) = corner * at_border;
        left.array() -= 1;
        return left.lpNorm<Eigen::Infinity>() < 1e-9 * size;
    }

    bool symmetric_, use_lu_ = false;
    int multipliers_;
    std::optional<int> negative_;       ///< of K without the border
    std::optional<int> negative_of_k_;  ///< where that has no factors
    std::unique_ptr<SymmetricFactors> factors_;
    LU lu_;
    Border border_;
    Eigen::VectorXd column_, row_;  // of K at the border
};

}  // namespace equilibria::detail
