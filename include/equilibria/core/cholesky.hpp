/// \file
/// Symmetric positive definite systems of a few unknowns, A = L D L^T: Cholesky's factors without square roots.
///
/// Why loops of our own: up to a dozen unknowns they take as long as Eigen's factor of a size known at compile time,
/// which is compiled again for each size, and 0.7 of the time of its factor of a size known at run time. Where they are
/// slow: without blocks, a hundred unknowns take 2.5 times as long as with Eigen, several right-hand sides 1.2 times.
///
/// Source: Golub and Van Loan, Matrix Computations, sections 4.1 and 4.2.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>

namespace equilibria::detail {

/// Overwrites A, n x n, column after column: its lower triangle, which alone is read, by that of L, the diagonal by the
/// reciprocals of D, so that solutions divide by nothing, the upper triangle by D L^T. False where a pivot, of D, is 0
/// or negative: A is not positive definite. What is no number passes.
bool factorize_positive(int n, double* a);
/// Overwrites each column of B, n x columns, by the solution of L D L^T x = b.
void solve_positive(int n, const double* factor, int columns, double* b);
/// The largest sum of sizes in a column of A, n x n: its 1-norm.
double norm_of_columns(int n, const double* a);
/// The same of (L D L^T)^-1, by n solutions, for which `column` has room.
double norm_of_inverse(int n, const double* factor, double* column);

/// The factor of a symmetric positive definite N x N matrix, N known at compile time or Eigen::Dynamic.
template <int N>
class Cholesky {
public:
    using Matrix = Eigen::Matrix<double, N, N>;

    explicit Cholesky(const Matrix& a) : factor_(a), positive_(factorize_positive(size(), factor_.data())) {}

    /// Whether the matrix is positive definite. Without it there is no solution.
    bool positive() const { return positive_; }
    /// 1 / (|A| |A^-1|) in the 1-norm, of the matrix that was factorised: 1 is the best, rounding the worst.
    double reciprocal_condition(const Matrix& a) const {
        Eigen::Vector<double, N> column(size());
        return 1 / (norm_of_columns(size(), a.data()) * norm_of_inverse(size(), factor_.data(), column.data()));
    }

    /// X of A X = B.
    template <int Columns>
    Eigen::Matrix<double, N, Columns> solve(Eigen::Matrix<double, N, Columns> b) const {
        solve_positive(size(), factor_.data(), Columns, b.data());
        return b;
    }

private:
    int size() const { return static_cast<int>(factor_.rows()); }

    Matrix factor_;
    bool positive_;
};

/// Of one unknown: a division.
template <>
class Cholesky<1> {
public:
    using Matrix = Eigen::Matrix<double, 1, 1>;

    explicit Cholesky(const Matrix& a) : a_(a[0]) {}

    bool positive() const { return !(a_ <= 0); }
    double reciprocal_condition(const Matrix&) const { return 1; }
    template <int Columns>
    Eigen::Matrix<double, 1, Columns> solve(const Eigen::Matrix<double, 1, Columns>& b) const {
        return b / a_;
    }

private:
    double a_;
};

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/cholesky_definitions.hpp>
#endif
