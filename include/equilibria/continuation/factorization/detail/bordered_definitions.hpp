/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria {

namespace detail {

/// K with the border's row and column replaced by zeros and, where they cross, `corner`. The pattern of a sparse K
/// stays, so that it is analysed once, where the entry of the corner is stored.
template <class Matrix>
Matrix without(const Matrix& k, Border border, double corner) {
    Matrix y = k;
    if constexpr ((!BorderedSolver<Matrix>::sparse)) {
        y.row(border.row).setZero();
        y.col(border.column).setZero();
        y(border.row, border.column) = corner;
    } else {
        for (Eigen::Index c = 0; c < y.outerSize(); ++c)
            for (typename Matrix::InnerIterator entry(y, c); entry; ++entry)
                if (entry.row() == border.row || entry.col() == border.column) entry.valueRef() = 0;
        y.coeffRef(border.row, border.column) = corner;
    }
    return y;
}

EQUILIBRIA_INLINE double largest_entry(const Eigen::MatrixXd& k) {
    if (k.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
    return k.size() > 0 ? k.cwiseAbs().maxCoeff() : 0;
}
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

EQUILIBRIA_INLINE double largest_force(const Eigen::MatrixXd& k, const Eigen::VectorXd& weights, Eigen::Index own) {
    double y = 0;
    for (Eigen::Index c = 0; c < own; ++c) y = std::max(y, k.col(c).cwiseAbs().maxCoeff() / std::sqrt(weights(c)));
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

// Templates, so that a program compiles what it uses of both.

/// L U of a dense K without its border.
template <class Matrix>
class BorderedFactors {
public:
    BorderedFactors(bool, int) {}

    /// The sign of the determinant, 0 where it is singular to working precision.
    int factor(const Matrix& without) {
        lu_.compute(without);
        const double determinant_sign = lu_.permutationP().determinant() < 0 ? -1 : 1;
        double sign = determinant_sign, smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (Eigen::Index k = 0; k < without.rows(); ++k) {
            const double pivot = lu_.matrixLU()(k, k);
            if (pivot < 0) sign = -sign;
            smallest = std::min(smallest, std::abs(pivot));
            largest = std::max(largest, std::abs(pivot));
        }
        if (!(smallest > 4 * std::numeric_limits<double>::epsilon() * largest)) return 0;
        return sign < 0 ? -1 : 1;
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& f, bool transposed) const {
        return transposed ? Eigen::VectorXd(lu_.transpose().solve(f)) : Eigen::VectorXd(lu_.solve(f));
    }
    /// Of a symmetric K, the border included.
    static std::optional<TangentInertia> inertia(const Matrix& k, double) {
        TangentInertia y;
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(k, Eigen::EigenvaluesOnly);
        const Eigen::VectorXd& values = eigen.eigenvalues();  // in increasing order
        y.negative = static_cast<int>((values.array() < 0).count());
        if (y.negative > 0) y.below = values(y.negative - 1);
        if (y.negative < values.size()) y.above = values(y.negative);
        return y;
    }

private:
    Eigen::PartialPivLU<Matrix> lu_;
};

/// L D L^T of a sparse K without its border, or L U.
template <class Number>
class BorderedFactors<Eigen::SparseMatrix<Number>> {
public:
    using Matrix = Eigen::SparseMatrix<Number>;
    BorderedFactors(bool symmetric, int multipliers) : symmetric_(symmetric), ldlt_(multipliers) {}

    /// The sign of the determinant, 0 where it is singular to working precision.
    int factor(const Matrix& without) {
        negative_.reset();
        use_lu_ = !symmetric_;
        if (symmetric_) {
            use_lu_ = !ldlt_.factor(without) || !safe(without);
            if (!use_lu_) {
                negative_ = ldlt_.negative();
                return *negative_ % 2 == 0 ? 1 : -1;
            }
        }
        lu_.compute(without);
        if (lu_.info() != Eigen::Success) return 0;
        return lu_.signDeterminant() < 0 ? -1 : 1;
    }
    Eigen::VectorXd solve(const Eigen::VectorXd& f, bool transposed) const {
        if (!use_lu_) return ldlt_.solve(f);
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
    using LU = Eigen::SparseLU<Matrix>;

    /// Whether the factors without pivoting reproduce a vector.
    bool safe(const Matrix& without) const {
        const Eigen::VectorXd f = Eigen::VectorXd::Ones(without.rows());
        const Eigen::VectorXd x = ldlt_.solve(f);
        const double size = largest_entry(without) * x.lpNorm<Eigen::Infinity>() + 1;
        return (without * x - f).template lpNorm<Eigen::Infinity>() < 1e-9 * size;
    }

    bool symmetric_, use_lu_ = false;
    std::optional<int> negative_;
    SparseLDLT ldlt_;
    LU lu_;
};

}  // namespace detail

template <class Matrix>
BorderedSolver<Matrix>::BorderedSolver(bool symmetric, int multipliers)
    : symmetric_(symmetric), without_(std::make_unique<detail::BorderedFactors<Matrix>>(symmetric, multipliers)) {}
template <class Matrix>
BorderedSolver<Matrix>::BorderedSolver(BorderedSolver&&) noexcept = default;
template <class Matrix>
BorderedSolver<Matrix>& BorderedSolver<Matrix>::operator=(BorderedSolver&&) noexcept = default;
template <class Matrix>
BorderedSolver<Matrix>::~BorderedSolver() = default;

template <class Matrix>
bool BorderedSolver<Matrix>::factor(const Matrix& k, Border border) {
    k_ = k;
    border_ = border;
    const double size = detail::largest_entry(k);
    if (!std::isfinite(size)) return false;
    column_ = k_.col(border.column);
    row_ = k_.transpose().col(border.row);
    const int sign = without_->factor(detail::without(k, border, size > 0 ? size : 1.0));
    if (sign != 0) sign_without_ = sign;
    return sign != 0;
}

template <class Matrix>
std::optional<TangentInertia> BorderedSolver<Matrix>::inertia(double sigma) const {
    if (!symmetric_) return std::nullopt;
    return without_->inertia(k_, sigma);
}

template <class Matrix>
BorderedSolution BorderedSolver<Matrix>::solve(const Eigen::VectorXd& f, double xi, bool transposed) const {
    // of B^T, row and column change places
    const Eigen::VectorXd &row = transposed ? column_ : row_, &column = transposed ? row_ : column_;
    const Eigen::Index j = transposed ? border_.column : border_.row, i = transposed ? border_.row : border_.column;
    BorderedSolution y{Eigen::VectorXd::Zero(f.size()), 0};
    Eigen::VectorXd rest = f - xi * column;
    // the second round removes the rounding of the first
    for (int round = 0; round < 2; ++round) {
        rest(j) = 0;
        y.x += without_->solve(rest, transposed);
        y.x(i) = xi;
        if (round == 0) rest = f - apply(y.x, transposed);
    }
    y.tau = f(j) - row.dot(y.x);
    return y;
}

template <class Matrix>
Eigen::VectorXd BorderedSolver<Matrix>::apply(const Eigen::VectorXd& x, bool transposed) const {
    return transposed ? Eigen::VectorXd(k_.transpose() * x) : Eigen::VectorXd(k_ * x);
}

namespace detail {

/// How many of the unknowns may hold the border: multipliers, the last ones, only where the weakest direction is one of
/// multipliers alone, at a dead point of a mechanism.
EQUILIBRIA_INLINE Eigen::Index border_candidates(const Eigen::VectorXd& direction, int multipliers) {
    const Eigen::Index own = direction.size() - multipliers;
    return direction.head(own).norm() < 0.01 * direction.norm() ? direction.size() : own;
}

/// A border for a K of which none is known: where the weakest directions are large, by inverse iteration with K, its
/// diagonal disturbed so that it is regular.
template <class Matrix>
Border border_for(const Matrix& k, const Eigen::VectorXd& weights, int multipliers, bool symmetric) {
    using LU = std::conditional_t<(!BorderedSolver<Matrix>::sparse), Eigen::PartialPivLU<Eigen::MatrixXd>,
                                  Eigen::SparseLU<Eigen::SparseMatrix<double>>>;
    const Eigen::VectorXd noise = 1e-8 * largest_entry(k) * generic_vector(k.rows(), 1);
    Matrix disturbed = k;
    disturbed += Matrix(noise.asDiagonal());
    LU lu;
    lu.compute(disturbed);
    Eigen::VectorXd right = generic_vector(k.rows()), left = right;
    for (int iteration = 0; iteration < 3; ++iteration) {
        const Eigen::VectorXd from_right = weights.cwiseProduct(right), from_left = weights.cwiseProduct(left);
        right = lu.solve(symmetric ? from_right : from_left);
        left = symmetric ? right : Eigen::VectorXd(lu.transpose().solve(from_right));
        right.normalize();
        left.normalize();
    }
    Border y;
    const Eigen::VectorXd root = weights.cwiseSqrt();
    root.cwiseProduct(right).head(border_candidates(right, multipliers)).cwiseAbs().maxCoeff(&y.column);
    y.row = y.column;
    if (!symmetric) {
        // K without row j and column i is regular where entry (i, j) of K^-1 is not 0
        left = lu.transpose().solve(Eigen::VectorXd::Unit(k.rows(), y.column));
        root.cwiseProduct(left).head(border_candidates(left, multipliers)).cwiseAbs().maxCoeff(&y.row);
    }
    return y;
}

template <class Matrix>
bool factor_with_border(BorderedSolver<Matrix>& solver, const Matrix& k, const Eigen::VectorXd& weights,
                        int multipliers, Border& border) {
    if (solver.factor(k, border)) return true;
    if (!std::isfinite(largest_entry(k))) return false;
    border = border_for(k, weights, multipliers, solver.symmetric());
    return solver.factor(k, border);
}

}  // namespace detail

template <class Matrix>
std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>& solver, const Matrix& k,
                                               const Eigen::VectorXd& weights, int multipliers, Border& border) {
    const Eigen::Index size = k.rows() - multipliers;
    if (size == 0) return std::nullopt;
    const bool symmetric = solver.symmetric();
    const Eigen::VectorXd root = weights.cwiseSqrt(), zero = Eigen::VectorXd::Zero(k.rows());
    const auto normalize = [&](Eigen::VectorXd& v) {
        const double length = root.cwiseProduct(v).norm();
        if (std::isfinite(length) && length > 0) v /= length;
    };
    // K^-1 f by the border, up to length
    const auto inverse = [&](const BorderedSolution& f, const BorderedSolution& r) {
        return r.tau != 0 ? Eigen::VectorXd(f.x - f.tau / r.tau * r.x) : r.x;
    };
    int singular = 0;
    WeakDirection y;
    for (int round = 0; round < 4;) {
        if (!solver.factor(k, border)) {
            if (++singular > 4 || !std::isfinite(detail::largest_entry(k))) return std::nullopt;
            if (singular == 1) {
                border = detail::border_for(k, weights, multipliers, symmetric);
            } else if (singular == 2) {
                // without freedom to move K is regular without a multiplier alone
                border = detail::border_for(k, Eigen::VectorXd::Ones(k.rows()), 0, symmetric);
            } else {
                border.column = border.row = (border.column + 1 + (singular * size) / 5) % size;
            }
            continue;
        }
        ++round;
        y.r = solver.solve(zero, 1);
        const BorderedSolution l = symmetric ? BorderedSolution{} : solver.solve_transposed(zero, 1);
        y.direction = detail::generic_vector(k.rows());
        if (!symmetric) y.left = y.direction;
        for (int iteration = 0; iteration < 3; ++iteration) {
            if (symmetric) {
                y.direction = inverse(solver.solve(weights.cwiseProduct(y.direction), 0), y.r);
            } else {
                const Eigen::VectorXd from = weights.cwiseProduct(y.direction);
                y.direction = inverse(solver.solve(weights.cwiseProduct(y.left), 0), y.r);
                y.left = inverse(solver.solve_transposed(from, 0), l);
                normalize(y.left);
            }
            normalize(y.direction);
        }
        const auto largest = [&](const Eigen::VectorXd& v, Eigen::Index now) {
            Eigen::Index best = 0;
            const auto entry = [&](Eigen::Index i) { return root(i) * std::abs(v(i)); };
            const Eigen::Index candidates = detail::border_candidates(v, multipliers);
            for (Eigen::Index i = 1; i < candidates; ++i)
                if (entry(i) > entry(best)) best = i;
            return entry(best) > 2 * entry(now) || now >= candidates ? best : now;
        };
        Border better;
        better.column = largest(y.direction, border.column);
        better.row = better.column;
        if (!symmetric) {
            // K without row j and column i is regular where entry (i, j) of K^-1 is not 0
            const Eigen::VectorXd unit = Eigen::VectorXd::Unit(k.rows(), better.column);
            better.row = largest(inverse(solver.solve_transposed(unit, 0), l), border.row);
        }
        if (better == border || singular >= 2) break;
        border = better;
    }
    if (solver.border() != border && !solver.factor(k, border)) return std::nullopt;
    y.r = solver.solve(zero, 1);
    y.eigenvalue = (symmetric ? y.direction : y.left).dot(k * y.direction);
    return y;
}

#ifdef EQUILIBRIA_COMPILED
template class BorderedSolver<Eigen::MatrixXd>;
template class BorderedSolver<Eigen::SparseMatrix<double>>;
template std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Eigen::MatrixXd>&, const Eigen::MatrixXd&,
                                                        const Eigen::VectorXd&, int, Border&);
template std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Eigen::SparseMatrix<double>>&,
                                                        const Eigen::SparseMatrix<double>&, const Eigen::VectorXd&, int,
                                                        Border&);
template bool detail::factor_with_border(BorderedSolver<Eigen::MatrixXd>&, const Eigen::MatrixXd&,
                                         const Eigen::VectorXd&, int, Border&);
template bool detail::factor_with_border(BorderedSolver<Eigen::SparseMatrix<double>>&,
                                         const Eigen::SparseMatrix<double>&, const Eigen::VectorXd&, int, Border&);
#endif

}  // namespace equilibria
