/// \file
/// Hurwitz's matrix of a real polynomial and its leading principal minors. Sources: Hurwitz, Ueber die
/// Bedingungen, unter welchen eine Gleichung nur Wurzeln mit negativen reellen Theilen besitzt, Math. Ann. 46 (1895);
/// Gantmacher, The Theory of Matrices II, chapter XV, sections 6 and 8.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/stability/checks.hpp>

namespace equilibria {

/// For a polynomial a_0 s^n + ... + a_n: the n x n matrix with entries a_(2j - i), i and j from 1, and its minors.
template <class Polynomial>
struct HurwitzCriterion {
    using Scalar = typename Polynomial::Scalar;  ///< of the coefficients
    /// n; dynamic where the polynomial's size is.
    static constexpr int degree =
        Polynomial::RowsAtCompileTime == Eigen::Dynamic ? Eigen::Dynamic : Polynomial::RowsAtCompileTime - 1;

    Eigen::Matrix<Scalar, degree, degree> matrix;  ///< Hurwitz's, n x n
    Eigen::Vector<Scalar, degree> minors;          ///< Delta_1 .. Delta_n; 0 where rounding hides the sign
    /// Roots with a positive real part. Nothing where the last minors are zero: then there are roots s and -s.
    std::optional<int> right_half_plane;

    /// Whether all roots lie left of the imaginary axis: a_0 > 0 and all minors positive, or the like for a_0 < 0.
    bool stable() const { return right_half_plane == 0; }
};

/// coefficients: as of routh_table.
template <class Polynomial>
HurwitzCriterion<Polynomial> hurwitz_criterion(const Polynomial& coefficients) {
    if constexpr (Polynomial::RowsAtCompileTime != Eigen::Dynamic) {
        const auto y = hurwitz_criterion<Eigen::VectorX<typename Polynomial::Scalar>>(coefficients);
        return {y.matrix, y.minors, y.right_half_plane};
    } else {
        using std::abs;
        using Scalar = typename Polynomial::Scalar;
        const Eigen::Index n = coefficients.size() - 1;
        detail::require_polynomial(coefficients);
        HurwitzCriterion<Polynomial> y;
        y.matrix.setZero(n, n);
        y.minors.resize(n);
        for (Eigen::Index i = 1; i <= n; ++i)
            for (Eigen::Index j = 1; j <= n; ++j)
                if (const auto k = 2 * j - i; k >= 0 && k <= n) y.matrix(i - 1, j - 1) = coefficients[k];

        for (Eigen::Index k = 1; k <= n; ++k) {
            Eigen::MatrixX<Scalar> leading = y.matrix.topLeftCorner(k, k);
            // Columns and rows scaled to one: then the condition number tells whether the sign can be trusted.
            Scalar factor = 1;
            for (Eigen::Index j = 0; j < k; ++j) {
                const Scalar column = leading.col(j).norm();
                if (column > 0) leading.col(j) /= column, factor *= column;
            }
            for (Eigen::Index i = 0; i < k; ++i) {
                const Scalar row = leading.row(i).norm();
                if (row > 0) leading.row(i) /= row, factor *= row;
            }
            const Eigen::PartialPivLU<Eigen::MatrixX<Scalar>> lu(leading);
            const auto rounding = static_cast<Scalar>(8 * k) * Eigen::NumTraits<Scalar>::epsilon();
            y.minors[k - 1] = lu.rcond() > rounding ? lu.determinant() * factor : Scalar(0);
        }
        if (y.minors[n - 1] == 0) return y;

        // Sign variations in a_0, Delta_1, Delta_2 / Delta_1, Delta_3 / Delta_2, ...: those in a_0, Delta_1, Delta_3,
        // ... and in 1, Delta_2, Delta_4, ... Behind a minor in one of these, the signs of h zeros are (-1)^(j (j - 1)
        // / 2) of its own, j = 1 .. h (Frobenius: the two hold the leading minors of Hankel matrices).
        int variations = 0;
        for (Eigen::Index first = 0; first < 2; ++first) {
            int before = first == 0 && coefficients[0] < 0 ? -1 : 1, start = before, run = 0;
            for (Eigen::Index k = first; k < n; k += 2) {
                if (y.minors[k] == 0)
                    ++run;
                else
                    run = 0, start = y.minors[k] < 0 ? -1 : 1;
                const int sign = run * (run - 1) / 2 % 2 == 0 ? start : -start;
                variations += sign != before;
                before = sign;
            }
        }
        y.right_half_plane = variations;
        return y;
    }
}

}  // namespace equilibria

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
/// \cond
extern template HurwitzCriterion<Eigen::VectorXd> hurwitz_criterion(const Eigen::VectorXd&);
/// \endcond
}  // namespace equilibria
#endif
