/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/orthonormalize.hpp>

namespace equilibria {

template <class Matrix>
BorderedSolver<Matrix>::BorderedSolver(bool symmetric, int multipliers, MakeSymmetricFactors make)
    : symmetric_(symmetric), factors_(std::make_unique<detail::BorderedFactors<Matrix>>(symmetric, multipliers, make)) {
}
template <class Matrix>
BorderedSolver<Matrix>::BorderedSolver(BorderedSolver&&) noexcept = default;
template <class Matrix>
BorderedSolver<Matrix>& BorderedSolver<Matrix>::operator=(BorderedSolver&&) noexcept = default;
template <class Matrix>
BorderedSolver<Matrix>::~BorderedSolver() = default;

template <class Matrix>
bool BorderedSolver<Matrix>::factor(Matrix&& k, Border border) {
    // Eigen's sparse matrices are copied where they are moved, and the last K's memory is not kept
    Matrix().swap(k_);
    k_.swap(k);
    size_ = detail::largest_entry(k_);
    return factor(border);
}

template <class Matrix>
bool BorderedSolver<Matrix>::factor(Border border) {
    border_ = border;
    factored_ = false;
    if (!std::isfinite(size_)) return false;
    const int sign = factors_->factor(k_, border_, size_ > 0 ? size_ : 1.0);
    if (sign != 0) sign_without_ = sign;
    factored_ = sign != 0;
    return factored_;
}

template <class Matrix>
BorderedSolutions BorderedSolver<Matrix>::solve(const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed,
                                                int rounds) const {
    return factors_->solve(k_, f, xi, transposed, rounds);
}

template <class Matrix>
double BorderedSolver<Matrix>::work_ratio() const {
    return factored_ ? factors_->work_ratio() : 0;
}

template <class Matrix>
std::optional<TangentInertia> BorderedSolver<Matrix>::inertia(double sigma) const {
    if (!symmetric_) return std::nullopt;
    return factors_->inertia(k_, sigma);
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
bool factor_with_border(BorderedSolver<Matrix>& solver, Matrix&& k, const Eigen::VectorXd& weights, int multipliers,
                        Border& border) {
    if (solver.factor(std::move(k), border)) return true;
    if (!std::isfinite(solver.largest_entry())) return false;
    border = border_for(solver.matrix(), weights, multipliers, solver.symmetric());
    return solver.factor(border);
}

/// WeakDirection::next, by subspace iteration from `guess` and generic vectors.
class NextDirections {
public:
    NextDirections(const Eigen::VectorXd& weights, int multipliers, const Eigen::MatrixXd& guess, int next)
        : equal_(weights), known_(guess.rows() == weights.size() && guess.cols() > next) {
        const Eigen::Index n = weights.size();
        equal_.tail(multipliers).setConstant(weights.head(n - multipliers).maxCoeff());
        v_.resize(n, next);
        for (int c = 0; c < next; ++c) {
            const Eigen::VectorXd generic = generic_vector(n, c + 1);
            v_.col(c) = generic / std::sqrt(generic.dot(equal_.cwiseProduct(generic)));
            if (known_) v_.col(c) = guess.col(1 + c) + 0.1 * v_.col(c);
        }
    }
    /// How many iterations it takes.
    int iterations() const { return known_ ? 2 : 3; }
    /// The right-hand sides of an iteration.
    Eigen::MatrixXd right() const { return equal_.asDiagonal() * v_; }
    /// What they led to: K^-1 of them, but for multiples of r.
    void take(const Eigen::MatrixXd& inverse) {
        v_ = inverse;
        orthonormalize(v_, equal_);
    }
    /// By Rayleigh and Ritz.
    template <class Matrix>
    void finish(const Matrix& k, WeakDirection& y) const {
        if (!v_.allFinite()) return;
        const Eigen::MatrixXd kv = symmetric_product(k, v_);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(v_.transpose() * kv);
        y.next = v_ * eigen.eigenvectors();
        y.next_eigenvalues = eigen.eigenvalues();
    }

private:
    Eigen::VectorXd equal_;
    bool known_;
    Eigen::MatrixXd v_;
};

/// See factor_at_weakest and weakest_direction. known: r, where the solver has K's factors with that border.
template <class Matrix>
std::optional<WeakDirection> search_weakest(BorderedSolver<Matrix>& solver, const BorderedSolution* known,
                                            const Eigen::VectorXd& weights, int multipliers, Border& border,
                                            const Eigen::MatrixXd& guess, int next) {
    const Matrix& k = solver.matrix();
    const Eigen::Index n = k.rows(), size = n - multipliers;
    if (size == 0) return std::nullopt;
    const bool symmetric = solver.symmetric();
    const Eigen::VectorXd root = weights.cwiseSqrt(), zero = Eigen::VectorXd::Zero(n);
    const auto normalize = [&](Eigen::VectorXd& v) {
        const double length = root.cwiseProduct(v).norm();
        if (std::isfinite(length) && length > 0) v /= length;
    };
    // K^-1 f by the border, up to length
    const auto inverse = [&](const BorderedSolution& f, const BorderedSolution& r) {
        return r.tau != 0 ? Eigen::VectorXd(f.x - f.tau / r.tau * r.x) : r.x;
    };
    const auto largest = [&](const Eigen::VectorXd& v, Eigen::Index now) {
        Eigen::Index best = 0;
        const auto entry = [&](Eigen::Index i) { return root(i) * std::abs(v(i)); };
        const Eigen::Index candidates = border_candidates(v, multipliers);
        for (Eigen::Index i = 1; i < candidates; ++i)
            if (entry(i) > entry(best)) best = i;
        return entry(best) > 2 * entry(now) || now >= candidates ? best : now;
    };
    Eigen::VectorXd start = generic_vector(n);
    int iterations = 3;
    if (guess.cols() > 0 && guess.rows() == n) {
        // not blind to another direction that has become the weakest
        normalize(start);
        start = guess.col(0) + 0.1 * start;
        iterations = 2;
    }
    int singular = 0;
    WeakDirection y;
    for (int round = 0; round < 4;) {
        if (!known && !solver.factor(border)) {
            if (++singular > 4 || !std::isfinite(solver.largest_entry())) return std::nullopt;
            if (singular == 1) {
                border = border_for(k, weights, multipliers, symmetric);
            } else if (singular == 2) {
                // without freedom to move K is regular without a multiplier alone
                border = border_for(k, Eigen::VectorXd::Ones(n), 0, symmetric);
            } else {
                border.column = border.row = (border.column + 1 + (singular * size) / 5) % size;
            }
            continue;
        }
        ++round;
        y.r = known ? *known : solver.solve(zero, 1);
        known = nullptr;
        y.direction = start;
        Border better;
        if (symmetric) {
            // all directions together
            std::optional<NextDirections> others;
            if (next > 0 && next <= size && y.r.tau != 0) others.emplace(weights, multipliers, guess, next);
            const int rounds = others ? std::max(iterations, others->iterations()) : iterations;
            for (int iteration = 0; iteration < rounds; ++iteration) {
                Eigen::MatrixXd right(n, others ? 1 + next : 1);
                right.col(0) = weights.cwiseProduct(y.direction);
                if (others) right.rightCols(next) = others->right();
                const BorderedSolutions f = solver.solve_roughly(right);
                y.direction = inverse(f[0], y.r);
                normalize(y.direction);
                if (others) others->take(f.x.rightCols(next) - y.r.x * (f.tau.tail(next) / y.r.tau).transpose());
            }
            if (others) others->finish(k, y);
            better.column = better.row = largest(y.direction, border.column);
        } else {
            const BorderedSolution l = solver.solve_transposed(zero, 1);
            y.left = start;
            for (int iteration = 0; iteration < iterations; ++iteration) {
                const Eigen::VectorXd from = weights.cwiseProduct(y.direction);
                y.direction = inverse(solver.solve(weights.cwiseProduct(y.left), 0), y.r);
                y.left = inverse(solver.solve_transposed(from, 0), l);
                normalize(y.left);
                normalize(y.direction);
            }
            better.column = largest(y.direction, border.column);
            // K without row j and column i is regular where entry (i, j) of K^-1 is not 0
            const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, better.column);
            better.row = largest(inverse(solver.solve_transposed(unit, 0), l), border.row);
        }
        if (better == border || singular >= 2) break;
        border = better;
    }
    if (solver.border() != border) {
        if (!solver.factor(border)) return std::nullopt;
        y.r = solver.solve(zero, 1);
    }
    y.eigenvalue = (symmetric ? y.direction : y.left).dot(k * y.direction);
    return y;
}

}  // namespace detail

template <class Matrix>
std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>& solver, Matrix&& k,
                                               const Eigen::VectorXd& weights, int multipliers, Border& border,
                                               const Eigen::MatrixXd& guess, int next) {
    if (!solver.factor(std::move(k), border)) {
        if (!std::isfinite(solver.largest_entry())) return std::nullopt;
        return detail::search_weakest(solver, nullptr, weights, multipliers, border, guess, next);
    }
    const BorderedSolution r = solver.solve(Eigen::VectorXd::Zero(solver.matrix().rows()), 1);
    return detail::search_weakest(solver, &r, weights, multipliers, border, guess, next);
}

template <class Matrix>
std::optional<WeakDirection> weakest_direction(BorderedSolver<Matrix>& solver, const BorderedSolution& r,
                                               const Eigen::VectorXd& weights, int multipliers, Border& border,
                                               const Eigen::MatrixXd& guess, int next) {
    return detail::search_weakest(solver, &r, weights, multipliers, border, guess, next);
}

}  // namespace equilibria
