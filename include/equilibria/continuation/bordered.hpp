/// \file
/// The linear algebra of a step of continuation: one factorisation for everything, also at a singular tangent.
///
///     B = [ K      e_i ]      B [ x   ]   [ f  ]
///         [ e_i^T  0   ],       [ tau ] = [ xi ]
///
/// is regular where K has at most a simple null vector phi with phi_i != 0, thus at folds and simple bifurcations. What
/// is factored is K without its row and column i ("displacement control of unknown i"), never the nearly singular K.
/// Then
///     B [r; sigma] = [0; 1]         sigma = -det K / det K without i: 0 at every singular point, smooth, signed;
///                                   r is the null vector there, with r_i = 1
///     B [s; -mu] = [-dg/dp; 0]      mu = r^T dg/dp for a symmetric K: 0 at bifurcations alone
///     (mu r + sigma s, sigma)       is a tangent of the branch, at folds as well
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <equilibria/continuation/problem.hpp>

namespace equilibria {

/// [x; tau] of a bordered system.
struct BorderedSolution {
    Eigen::VectorXd x;
    double tau = 0;
};

namespace detail {

/// K with row and column i replaced by those of the unit matrix (times `diagonal`), dense or sparse.
inline Eigen::MatrixXd without(const Eigen::MatrixXd& k, Eigen::Index i, double diagonal) {
    Eigen::MatrixXd y = k;
    y.row(i).setZero();
    y.col(i).setZero();
    y(i, i) = diagonal;
    return y;
}
/// The pattern of K stays, so that it is analysed once.
inline Eigen::SparseMatrix<double> without(const Eigen::SparseMatrix<double>& k, Eigen::Index i, double diagonal) {
    Eigen::SparseMatrix<double> y = k;
    for (Eigen::Index c = 0; c < y.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(y, c); entry; ++entry)
            if (entry.row() == i || entry.col() == i) entry.valueRef() = entry.row() == entry.col() ? diagonal : 0.0;
    return y;
}

/// The largest absolute value; NaN where one is.
inline double largest_entry(const Eigen::MatrixXd& k) {
    if (k.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
    return k.size() == 0 ? 0 : k.cwiseAbs().maxCoeff();
}
inline double largest_entry(const Eigen::SparseMatrix<double>& k) {
    double y = 0;
    for (Eigen::Index c = 0; c < k.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(k, c); entry; ++entry)
            if (std::isnan(entry.value()))
                return entry.value();
            else
                y = std::max(y, std::abs(entry.value()));
    return y;
}

}  // namespace detail

/// Solves with B; Matrix is Eigen::MatrixXd, or Eigen::SparseMatrix<double> with every entry of its diagonal stored.
///
/// A symmetric sparse K is factored as L D L^T without pivoting, which gives its inertia. Where that is not safe (the
/// solution's residual tells) L U is taken instead, and of the inertia its parity is known alone.
template <class Matrix>
class BorderedSolver {
public:
    static constexpr bool sparse = !std::is_same_v<Matrix, Eigen::MatrixXd>;

    explicit BorderedSolver(bool symmetric) : symmetric_(symmetric) {}

    /// Factors K without i. False where that is singular to working precision, or K not finite.
    bool factor(const Matrix& k, Eigen::Index i) {
        k_ = k;
        i_ = i;
        const double size = detail::largest_entry(k);
        if (!std::isfinite(size)) return false;
        without_ = detail::without(k, i, size > 0 ? size : 1.0);
        column_ = k_.col(i);
        column_(i) = 0;
        row_ = row_rest_ = Eigen::VectorXd(k_.transpose().col(i));
        row_rest_(i) = 0;
        negative_.reset();
        if constexpr (sparse)
            return factor_sparse();
        else
            return factor_dense();
    }

    Eigen::Index pinned() const { return i_; }

    BorderedSolution solve(const Eigen::VectorXd& f, double xi) const { return solve(f, xi, false); }
    /// With B^T.
    BorderedSolution solve_transposed(const Eigen::VectorXd& f, double xi) const { return solve(f, xi, true); }

    /// The number of negative eigenvalues of a symmetric K; nothing where it cannot be told. sigma: that of this K.
    std::optional<int> negative(double sigma) const {
        if constexpr (sparse) {
            if (!negative_) return std::nullopt;
            return *negative_ + (sigma > 0 ? 1 : 0);
        } else {
            if (!symmetric_) return std::nullopt;
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k_, Eigen::EigenvaluesOnly);
            return static_cast<int>((eigen.eigenvalues().array() < 0).count());
        }
    }
    /// The sign of det K; sigma: that of this K.
    int sign_of_determinant(double sigma) const { return sigma > 0 ? -sign_without_ : sign_without_; }

private:
    bool factor_dense() {
        dense_.compute(without_);
        const double determinant_sign = dense_.permutationP().determinant() < 0 ? -1 : 1;
        double sign = determinant_sign, smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (Eigen::Index k = 0; k < without_.rows(); ++k) {
            const double pivot = dense_.matrixLU()(k, k);
            if (pivot < 0) sign = -sign;
            smallest = std::min(smallest, std::abs(pivot));
            largest = std::max(largest, std::abs(pivot));
        }
        sign_without_ = sign < 0 ? -1 : 1;
        return smallest > 4 * std::numeric_limits<double>::epsilon() * largest;
    }
    bool factor_sparse() {
        use_lu_ = !symmetric_;
        if (symmetric_) {
            if (!analysed_) ldlt_.analyzePattern(without_), analysed_ = true;
            ldlt_.factorize(without_);
            use_lu_ = ldlt_.info() != Eigen::Success || !safe();
            if (!use_lu_) {
                const auto d = ldlt_.vectorD();
                negative_ = static_cast<int>((d.array() < 0).count());
                sign_without_ = *negative_ % 2 == 0 ? 1 : -1;
                return true;
            }
        }
        lu_.compute(without_);
        if (lu_.info() != Eigen::Success) return false;
        sign_without_ = lu_.signDeterminant() < 0 ? -1 : 1;
        return true;
    }
    /// Whether the factors without pivoting reproduce a vector.
    bool safe() const {
        const Eigen::VectorXd f = Eigen::VectorXd::Ones(without_.rows());
        const Eigen::VectorXd x = ldlt_.solve(f);
        const double size = detail::largest_entry(without_) * x.template lpNorm<Eigen::Infinity>() + 1;
        return (without_ * x - f).template lpNorm<Eigen::Infinity>() < 1e-9 * size;
    }

    Eigen::VectorXd solve_without(const Eigen::VectorXd& f, bool transposed) const {
        if constexpr (sparse) {
            if (!use_lu_) return ldlt_.solve(f);
            // SparseLU's transposed view is not const in Eigen 3.4
            return transposed ? Eigen::VectorXd(const_cast<LU&>(lu_).transpose().solve(f))
                              : Eigen::VectorXd(lu_.solve(f));
        } else {
            return transposed ? Eigen::VectorXd(dense_.transpose().solve(f)) : Eigen::VectorXd(dense_.solve(f));
        }
    }

    BorderedSolution solve(const Eigen::VectorXd& f, double xi, bool transposed) const {
        const Eigen::VectorXd& column = transposed ? row_rest_ : column_;
        BorderedSolution y{Eigen::VectorXd::Zero(f.size()), 0};
        Eigen::VectorXd rest = f - xi * column;
        // the second round removes the rounding of the first
        for (int round = 0; round < 2; ++round) {
            rest(i_) = 0;
            y.x += solve_without(rest, transposed);
            y.x(i_) = xi;
            if (round == 0) rest = f - apply(y.x, transposed);
        }
        y.tau = f(i_) - (transposed ? k_.col(i_).dot(y.x) : row_.dot(y.x));
        return y;
    }
    Eigen::VectorXd apply(const Eigen::VectorXd& x, bool transposed) const {
        return transposed ? Eigen::VectorXd(k_.transpose() * x) : Eigen::VectorXd(k_ * x);
    }

    struct None {};
    using LDLT = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
    using LU = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

    bool symmetric_, analysed_ = false, use_lu_ = false;
    Matrix k_, without_;
    Eigen::Index i_ = 0;
    Eigen::VectorXd column_, row_, row_rest_;  ///< number i of K; `column_` and `row_rest_` without the diagonal
    int sign_without_ = 1;
    std::optional<int> negative_;  ///< of a sparse K without i
    std::conditional_t<sparse, None, Eigen::PartialPivLU<Eigen::MatrixXd>> dense_;
    std::conditional_t<sparse, LDLT, None> ldlt_;
    std::conditional_t<sparse, LU, None> lu_;
};

/// The direction in which K is weakest, and the factorisation of K without its largest entry.
struct WeakDirection {
    BorderedSolution r;         ///< [r; sigma] of that border
    Eigen::VectorXd direction;  ///< by inverse iteration, of length 1 by the weights
    double eigenvalue = 0;      ///< its Rayleigh quotient by the weights
};

/// Factors K with the border at an unknown in which the weakest direction is large; `pinned` is where the search starts
/// and where it ends. `multipliers`: how many of the last unknowns must not be chosen. Nothing where all of some
/// borders are singular: nullity 2 or more, or K not finite.
template <class Matrix>
std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>& solver, const Matrix& k,
                                               const Eigen::VectorXd& weights, int multipliers, Eigen::Index& pinned) {
    const Eigen::Index size = k.rows() - multipliers;
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const auto length = [&](const Eigen::VectorXd& v) { return root.cwiseProduct(v).norm(); };
    const Eigen::VectorXd start = detail::generic_vector(k.rows());
    int singular = 0;
    WeakDirection y;
    for (int round = 0; round < 4;) {
        if (!solver.factor(k, pinned)) {
            if (++singular > 4 || size == 0) return std::nullopt;
            pinned = (pinned + 1 + (singular * size) / 5) % size;
            continue;
        }
        ++round;
        y.r = solver.solve(Eigen::VectorXd::Zero(k.rows()), 1);
        y.direction = start;
        for (int iteration = 0; iteration < 3; ++iteration) {
            const BorderedSolution f = solver.solve(weights.cwiseProduct(y.direction), 0);
            y.direction = y.r.tau != 0 ? Eigen::VectorXd(f.x - f.tau / y.r.tau * y.r.x) : y.r.x;
            const double size_now = length(y.direction);
            if (!std::isfinite(size_now) || size_now == 0) break;
            y.direction /= size_now;
        }
        Eigen::Index best = 0;
        const auto entry = [&](Eigen::Index i) { return root(i) * std::abs(y.direction(i)); };
        for (Eigen::Index i = 1; i < size; ++i)
            if (entry(i) > entry(best)) best = i;
        if (!(entry(best) > 2 * entry(pinned))) break;
        pinned = best;
    }
    if (solver.pinned() != pinned && !solver.factor(k, pinned)) return std::nullopt;
    y.r = solver.solve(Eigen::VectorXd::Zero(k.rows()), 1);
    y.eigenvalue = y.direction.dot(k * y.direction);
    return y;
}

}  // namespace equilibria
