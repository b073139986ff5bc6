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

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/eigenvalue_counts.hpp>
#include <equilibria/continuation/factorization/symmetric_factors.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// [x; tau] of a bordered system.
struct BorderedSolution {
    Eigen::VectorXd x;  ///< the unknowns
    double tau = 0;     ///< the border's unknown
};

/// Of several right hand sides, a column each.
struct BorderedSolutions {
    Eigen::MatrixXd x;    ///< a column for each right hand side
    Eigen::VectorXd tau;  ///< an entry for each
    BorderedSolution operator[](Eigen::Index k) const { return {x.col(k), tau(k)}; }  ///< the k-th of them
};

/// Where e_i and e_j of B have their ones: the same place for a symmetric K.
struct Border {
    Eigen::Index row = 0;     ///< j
    Eigen::Index column = 0;  ///< i
    /// The same places.
    friend bool operator==(const Border&, const Border&) = default;
};

/// The inertia of a symmetric K.
struct TangentInertia {
    int negative = 0;              ///< negative eigenvalues
    EigenvalueCounts eigenvalues;  ///< of a dense K; else empty
};

namespace detail {

/// The largest absolute value; NaN where one is.
double largest_entry(const Eigen::MatrixXd& k);
double largest_entry(const Eigen::SparseMatrix<double>& k);

/// The largest of |K_ij| u_j over the first `own` unknowns j, u_j = 1 / sqrt(w_j) being what makes one of size 1 by the
/// weights.
double largest_force(const Eigen::MatrixXd& k, const Eigen::VectorXd& weights, Eigen::Index own);
double largest_force(const Eigen::SparseMatrix<double>& k, const Eigen::VectorXd& weights, Eigen::Index own);

/// K with the border's row and column replaced by zeros and, where they cross, `corner`. Its pattern stays, so that it
/// is analysed once, where the entry of the corner is stored.
Eigen::SparseMatrix<double> without(const Eigen::SparseMatrix<double>& k, Border border, double corner);

/// k x of a symmetric k.
Eigen::MatrixXd symmetric_product(const Eigen::SparseMatrix<double>& k, const Eigen::MatrixXd& x);
inline Eigen::MatrixXd symmetric_product(const Eigen::MatrixXd& k, const Eigen::MatrixXd& x) { return k * x; }

/// What a BorderedSolver factors with; k is the same in all three, size its largest entry:
///     int factor(k, border, size)
///         the sign of det K without the border's row and column, a positive entry where they cross; 0 where that is
///         singular to working precision
///     BorderedSolutions solve(k, f, xi, transposed, rounds)
///         with B or B^T, for each column of f and its xi; rounds: 1 for a rough solution, else 2
///     std::optional<TangentInertia> inertia(k, sigma)
///     double work_ratio()
template <class Matrix>
class BorderedFactors;

}  // namespace detail

/// Solves with B; Matrix is Eigen::MatrixXd, or Eigen::SparseMatrix<double> with every entry of its diagonal stored.
///
/// A symmetric sparse K is factored as L D L^T, which gives its inertia: without pivoting, or by what the problem
/// chooses. Where that is not safe (the solution's residual tells) L U is taken instead, and of the inertia its parity
/// is known alone.
template <class Matrix>
class BorderedSolver {
public:
    static constexpr bool sparse = std::is_same_v<Matrix, Eigen::SparseMatrix<double>>;  ///< K is sparse

    /// multipliers: how many of the last unknowns are. make: what factors a sparse symmetric K; null: SparseLDLT.
    explicit BorderedSolver(bool symmetric, int multipliers = 0, MakeSymmetricFactors make = nullptr);
    /// Moved with its factors.
    /// \{
    BorderedSolver(BorderedSolver&&) noexcept;
    BorderedSolver& operator=(BorderedSolver&&) noexcept;
    /// \}
    ~BorderedSolver();
    bool symmetric() const { return symmetric_; }  ///< whether K was promised to be symmetric

    /// Factors K, which it takes, without the border's row and column. False where that is singular to working
    /// precision, or K not finite.
    bool factor(Matrix&& k, Border border);
    /// Factors the last K with another border.
    bool factor(Border border);

    /// The last K.
    const Matrix& matrix() const { return k_; }
    /// Its largest absolute value; NaN where one is.
    double largest_entry() const { return size_; }
    Border border() const { return border_; }  ///< of the last factorisation

    /// x and tau of the right hand side [f; xi], with iterative refinement.
    BorderedSolution solve(const Eigen::VectorXd& f, double xi) const {
        return solve(f, Eigen::VectorXd::Constant(1, xi), false)[0];
    }
    /// Of each column of f with its xi: quicker than one after the other.
    BorderedSolutions solve(const Eigen::MatrixXd& f, const Eigen::VectorXd& xi) const { return solve(f, xi, false); }
    /// Without iterative refinement.
    BorderedSolutions solve_roughly(const Eigen::MatrixXd& f, const Eigen::VectorXd& xi) const {
        return solve(f, xi, false, 1);
    }
    /// With xi = 0.
    BorderedSolutions solve_roughly(const Eigen::MatrixXd& f) const {
        return solve_roughly(f, Eigen::VectorXd::Zero(f.cols()));
    }
    /// With B^T.
    BorderedSolution solve_transposed(const Eigen::VectorXd& f, double xi) const {
        return solve(f, Eigen::VectorXd::Constant(1, xi), true)[0];
    }

    /// Multiplications of the last factorisation over those of a solution; 0 where there is none, or it is not known.
    double work_ratio() const;

    /// The inertia of a symmetric K; nothing where it cannot be told. sigma: that of this K.
    std::optional<TangentInertia> inertia(double sigma) const;
    /// The sign of det K; sigma: that of this K.
    int sign_of_determinant(double sigma) const { return sigma > 0 ? -sign_without_ : sign_without_; }

private:
    BorderedSolutions solve(const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed, int rounds = 2) const;

    bool symmetric_;
    Matrix k_;
    double size_ = 0;
    Border border_;
    int sign_without_ = 1;
    bool factored_ = false;
    std::unique_ptr<detail::BorderedFactors<Matrix>> factors_;
};

/// The direction in which K is weakest, and the factorisation of K without its largest entry.
struct WeakDirection {
    BorderedSolution r;         ///< [r; sigma] of that border
    Eigen::VectorXd direction;  ///< by inverse iteration, of length 1 by the weights
    Eigen::VectorXd left;       ///< the same of K^T; empty for a symmetric K
    double eigenvalue = 0;      ///< left^T K direction: for a symmetric K its Rayleigh quotient by the weights
    /// Of a symmetric K the directions, where they were asked for, in which it is weakest when multipliers weigh as
    /// much as the others, a column each of length 1 by these weights.
    Eigen::MatrixXd next;
    Eigen::VectorXd next_eigenvalues;  ///< Rayleigh quotients of `next`
};

namespace detail {

/// Factors K with the given border, or, where that is singular, with another one, which `border` is then. False where
/// that is singular too, or K not finite.
template <class Matrix>
bool factor_with_border(BorderedSolver<Matrix>& solver, Matrix&& k, const Eigen::VectorXd& weights, int multipliers,
                        Border& border);

}  // namespace detail

/// Factors K with the border at an unknown (and a row) in which the weakest direction is large; `border` is where the
/// search starts and where it ends. `multipliers`: how many of the last unknowns are. Nothing where all
/// of some borders are singular: nullity 2 or more, or K not finite. guess: a direction that may be the weakest, as
/// that of a K nearby.
template <class Matrix>
std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>& solver, Matrix&& k,
                                               const Eigen::VectorXd& weights, int multipliers, Border& border,
                                               const Eigen::MatrixXd& guess = {}, int next = 0);

/// The same of the K that the solver has factored with `border`, where it has solved for r.
template <class Matrix>
std::optional<WeakDirection> weakest_direction(BorderedSolver<Matrix>& solver, const BorderedSolution& r,
                                               const Eigen::VectorXd& weights, int multipliers, Border& border,
                                               const Eigen::MatrixXd& guess, int next);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/factorization/detail/bordered_definitions.hpp>
#include <equilibria/continuation/factorization/detail/dense_factors_definitions.hpp>
#include <equilibria/continuation/factorization/detail/sparse_factors_definitions.hpp>
#endif
