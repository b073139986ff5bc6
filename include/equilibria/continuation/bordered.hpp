/// \file
/// The linear algebra of a step of continuation: one factorisation for everything, also at a singular tangent.
///
///     B = [ K      e_j ]      B [ x   ]   [ f  ]
///         [ e_i^T  0   ],       [ tau ] = [ xi ]
///
/// is regular where K has at most a simple null vector phi, with phi_i != 0, and a left one psi with psi_j != 0, thus
/// at folds and simple bifurcations. For a symmetric K j = i. What is factored is K without its row j and column i
/// ("displacement control of unknown i"), never the nearly singular K. Then
///     B [r; sigma] = [0; 1]         sigma = -det K / det K without them: 0 at every singular point, smooth, signed;
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
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <equilibria/continuation/problem.hpp>
#include <equilibria/continuation/sparse_ldlt.hpp>

namespace equilibria {

/// [x; tau] of a bordered system.
struct BorderedSolution {
    Eigen::VectorXd x;
    double tau = 0;
};

/// Where e_i and e_j of B have their ones: the same place for a symmetric K.
struct Border {
    Eigen::Index row = 0;     ///< j
    Eigen::Index column = 0;  ///< i
    friend bool operator==(const Border&, const Border&) = default;
};

/// The inertia of a symmetric K. Its eigenvalues next to 0 are not known of a sparse one.
struct TangentInertia {
    int negative = 0;
    double below = -std::numeric_limits<double>::infinity(), above = std::numeric_limits<double>::infinity();
};

namespace detail {

template <class Matrix>
inline constexpr bool is_dense_matrix = !std::is_same_v<typename Matrix::StorageKind, Eigen::Sparse>;

/// K with the border's row and column replaced by zeros and, where they cross, `corner`. The pattern of a sparse K
/// stays, so that it is analysed once, where the entry of the corner is stored.
template <class Matrix>
Matrix without(const Matrix& k, Border border, double corner) {
    Matrix y = k;
    if constexpr (is_dense_matrix<Matrix>) {
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

/// The largest absolute value; NaN where one is.
template <class Matrix>
double largest_entry(const Matrix& k) {
    double y = 0;
    if constexpr (is_dense_matrix<Matrix>) {
        if (k.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
        if (k.size() > 0) y = k.cwiseAbs().maxCoeff();
    } else {
        for (Eigen::Index c = 0; c < k.outerSize(); ++c)
            for (typename Matrix::InnerIterator entry(k, c); entry; ++entry)
                if (std::isnan(entry.value()))
                    return entry.value();
                else
                    y = std::max(y, std::abs(entry.value()));
    }
    return y;
}

/// The largest of |K_ij| u_j over the first `own` unknowns j, u_j = 1 / sqrt(w_j) being what makes one of size 1 by the
/// weights.
template <class Matrix>
double largest_force(const Matrix& k, const Eigen::VectorXd& weights, Eigen::Index own) {
    double y = 0;
    for (Eigen::Index c = 0; c < own; ++c) {
        double column = 0;
        for (typename Matrix::InnerIterator entry(k, c); entry; ++entry)
            column = std::max(column, std::abs(entry.value()));
        y = std::max(y, column / std::sqrt(weights(c)));
    }
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
    static constexpr bool sparse = !detail::is_dense_matrix<Matrix>;

    /// multipliers: how many of the last unknowns are.
    explicit BorderedSolver(bool symmetric, int multipliers = 0) : symmetric_(symmetric), ldlt_(multipliers) {}
    bool symmetric() const { return symmetric_; }

    /// Factors K without the border's row and column. False where that is singular to working precision, or K not
    /// finite.
    bool factor(const Matrix& k, Border border) {
        k_ = k;
        border_ = border;
        const double size = detail::largest_entry(k);
        if (!std::isfinite(size)) return false;
        without_ = detail::without(k, border, size > 0 ? size : 1.0);
        column_ = k_.col(border.column);
        row_ = k_.transpose().col(border.row);
        negative_.reset();
        if constexpr (sparse)
            return factor_sparse();
        else
            return factor_dense();
    }

    Border border() const { return border_; }

    BorderedSolution solve(const Eigen::VectorXd& f, double xi) const { return solve(f, xi, false); }
    /// With B^T.
    BorderedSolution solve_transposed(const Eigen::VectorXd& f, double xi) const { return solve(f, xi, true); }

    /// The inertia of a symmetric K; nothing where it cannot be told. sigma: that of this K.
    std::optional<TangentInertia> inertia(double sigma) const {
        TangentInertia y;
        if constexpr (sparse) {
            if (!negative_) return std::nullopt;
            y.negative = *negative_ + (sigma > 0 ? 1 : 0);
        } else {
            if (!symmetric_) return std::nullopt;
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k_, Eigen::EigenvaluesOnly);
            const Eigen::VectorXd& values = eigen.eigenvalues();  // in increasing order
            y.negative = static_cast<int>((values.array() < 0).count());
            if (y.negative > 0) y.below = values(y.negative - 1);
            if (y.negative < values.size()) y.above = values(y.negative);
        }
        return y;
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
            use_lu_ = !ldlt_.factor(without_) || !safe();
            if (!use_lu_) {
                negative_ = ldlt_.negative();
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
        // of B^T, row and column change places
        const Eigen::VectorXd &row = transposed ? column_ : row_, &column = transposed ? row_ : column_;
        const Eigen::Index j = transposed ? border_.column : border_.row, i = transposed ? border_.row : border_.column;
        BorderedSolution y{Eigen::VectorXd::Zero(f.size()), 0};
        Eigen::VectorXd rest = f - xi * column;
        // the second round removes the rounding of the first
        for (int round = 0; round < 2; ++round) {
            rest(j) = 0;
            y.x += solve_without(rest, transposed);
            y.x(i) = xi;
            if (round == 0) rest = f - apply(y.x, transposed);
        }
        y.tau = f(j) - row.dot(y.x);
        return y;
    }
    Eigen::VectorXd apply(const Eigen::VectorXd& x, bool transposed) const {
        return transposed ? Eigen::VectorXd(k_.transpose() * x) : Eigen::VectorXd(k_ * x);
    }

    struct None {
        explicit None(int = 0) {}
    };
    using LU = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

    bool symmetric_, use_lu_ = false;
    Matrix k_, without_;
    Border border_;
    Eigen::VectorXd column_, row_;  ///< of K at the border
    int sign_without_ = 1;
    std::optional<int> negative_;  ///< of a sparse K without the border
    std::conditional_t<sparse, None, Eigen::PartialPivLU<Eigen::MatrixXd>> dense_;
    std::conditional_t<sparse, SparseLDLT, None> ldlt_;
    std::conditional_t<sparse, LU, None> lu_;
};

/// The direction in which K is weakest, and the factorisation of K without its largest entry.
struct WeakDirection {
    BorderedSolution r;         ///< [r; sigma] of that border
    Eigen::VectorXd direction;  ///< by inverse iteration, of length 1 by the weights
    Eigen::VectorXd left;       ///< the same of K^T; empty for a symmetric K
    double eigenvalue = 0;      ///< left^T K direction: for a symmetric K its Rayleigh quotient by the weights
};

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
    using LU = std::conditional_t<is_dense_matrix<Matrix>, Eigen::PartialPivLU<Eigen::MatrixXd>,
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

/// Factors K with the given border, or, where that is singular, with another one, which `border` is then. False where
/// that is singular too, or K not finite.
template <class Matrix>
bool factor_with_border(BorderedSolver<Matrix>& solver, const Matrix& k, const Eigen::VectorXd& weights,
                        int multipliers, Border& border) {
    if (solver.factor(k, border)) return true;
    if (!std::isfinite(largest_entry(k))) return false;
    border = border_for(k, weights, multipliers, solver.symmetric());
    return solver.factor(k, border);
}

}  // namespace detail

/// Factors K with the border at an unknown (and a row) in which the weakest direction is large; `border` is where the
/// search starts and where it ends. `multipliers`: how many of the last unknowns are. Nothing where all
/// of some borders are singular: nullity 2 or more, or K not finite.
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

}  // namespace equilibria
