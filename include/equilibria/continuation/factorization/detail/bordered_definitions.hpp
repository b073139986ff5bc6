/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>

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

}  // namespace detail

template <class Matrix>
BorderedSolver<Matrix>::BorderedSolver(bool symmetric, int multipliers, MakeSymmetricFactors make)
    : symmetric_(symmetric), without_(std::make_unique<detail::BorderedFactors<Matrix>>(symmetric, multipliers, make)) {
}
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
inline Eigen::Index border_candidates(const Eigen::VectorXd& direction, int multipliers) {
    const Eigen::Index own = direction.size() - multipliers;
    return direction.head(own).norm() < 0.01 * direction.norm() ? direction.size() : own;
}

/// A border for a K of which none is known: where the weakest directions are large, by inverse iteration with K, its
/// diagonal disturbed so that it is regular.
template <class Matrix>
Border border_for(const Matrix& k, const Eigen::VectorXd& weights, int multipliers, bool symmetric) {
    const Eigen::VectorXd noise = 1e-8 * largest_entry(k) * generic_vector(k.rows(), 1);
    Matrix disturbed = k;
    disturbed += Matrix(noise.asDiagonal());
    typename BorderedFactors<Matrix>::LU lu;
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
    if (solver.border() != border) {
        if (!solver.factor(k, border)) return std::nullopt;
        y.r = solver.solve(zero, 1);
    }
    y.eigenvalue = (symmetric ? y.direction : y.left).dot(k * y.direction);
    return y;
}

}  // namespace equilibria
