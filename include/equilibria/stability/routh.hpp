/// \file
/// Routh's table of a real polynomial: how many of its roots lie right of the imaginary axis, and how many on it.
/// Sources: Routh, A Treatise on the Stability of a Given State of Motion (1877); Gantmacher, The Theory of Matrices
/// II, chapter XV; the first special case as of Benidir and Picinbono, Extended table for eliminating the singularities
/// in Routh's array, IEEE Trans. Automat. Control 35 (1990).
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <equilibria/stability/checks.hpp>

namespace equilibria {

/// The rows of a Routh table that need more than the rule of cross products.
enum class RouthSpecialCase {
    zero_in_first_column,  ///< a row that begins with zeros: it is added to itself, moved left over its k zeros, times
                           ///< (-1)^k
    zero_row,  ///< a row of zeros: the derivative of the row above, the auxiliary polynomial, takes its place
};

/// In words.
inline const char* to_string(RouthSpecialCase special) {
    return special == RouthSpecialCase::zero_row ? "zero row" : "zero in the first column";
}

/// The table of a polynomial of degree n: n + 1 rows, of which row k belongs to the power n - k.
template <class Polynomial>
struct RouthTable {
    using Scalar = typename Polynomial::Scalar;                   ///< of the coefficients
    static constexpr int n_rows = Polynomial::RowsAtCompileTime;  ///< n + 1
    /// As many as the first row needs.
    static constexpr int n_columns = n_rows == Eigen::Dynamic ? Eigen::Dynamic : (n_rows + 1) / 2;
    /// A row that was completed.
    struct Special {
        int row = 0;              ///< its number, from 0
        RouthSpecialCase kind{};  ///< why it had to be
    };

    Eigen::Matrix<Scalar, n_rows, n_columns> rows;  ///< as completed in the special cases
    std::vector<Special> special;                   ///< in the order of the rows
    int right_half_plane = 0;  ///< roots with a positive real part: sign changes down the first column
    int imaginary_axis = 0;    ///< roots on the imaginary axis, 0 among them, with their multiplicities
    /// How near the table came to a special case: the smallest first entry of a row over what it was the difference of.
    double margin = 1;

    auto first_column() const { return rows.col(0); }  ///< whose changes of sign are counted
    /// Roots with a negative real part.
    int left_half_plane() const { return static_cast<int>(rows.rows()) - 1 - right_half_plane - imaginary_axis; }
};

/// An entry counts as zero when it is below this share of the two products that it is the difference of.
inline constexpr double zero_routh_entry = 1e-11;

/// coefficients: real, from the highest power, which must not be 0, to the constant; at least two. Throws
/// InvalidArgument otherwise.
template <class Polynomial>
RouthTable<Polynomial> routh_table(const Polynomial& coefficients) {
    if constexpr (Polynomial::RowsAtCompileTime != Eigen::Dynamic) {
        const auto y = routh_table<Eigen::VectorX<typename Polynomial::Scalar>>(coefficients);
        RouthTable<Polynomial> typed{y.rows, {}, y.right_half_plane, y.imaginary_axis, y.margin};
        for (const auto& special : y.special) typed.special.push_back({special.row, special.kind});
        return typed;
    } else {
        using std::abs;
        using Scalar = typename Polynomial::Scalar;
        const auto size = coefficients.size(), columns = (size + 1) / 2;
        detail::require_polynomial(coefficients);
        RouthTable<Polynomial> y;
        auto& r = y.rows;
        r.setZero(size, columns);
        for (Eigen::Index k = 0; k < size; ++k) r(k % 2, k / 2) = coefficients[k];
        Eigen::Index first_zero_row = -1;

        for (Eigen::Index i = 1; i < size; ++i) {
            const Eigen::Index entries = (size - i + 1) / 2;
            if (i > 1)
                for (Eigen::Index j = 0; j < entries; ++j) {
                    const Scalar right = j + 1 < columns ? r(i - 1, j + 1) : Scalar(0);
                    const Scalar a = r(i - 2, j + 1), b = r(i - 2, 0) * right / r(i - 1, 0);
                    const Scalar difference = a - b, size_of_both = abs(a) + abs(b);
                    const bool zero = !(abs(difference) > zero_routh_entry * size_of_both);
                    r(i, j) = zero ? Scalar(0) : difference;
                    if (j == 0 && size_of_both > 0)
                        y.margin = std::min(y.margin, zero ? 0.0 : static_cast<double>(abs(difference) / size_of_both));
                }
            Eigen::Index zeros = 0;
            while (zeros < entries && r(i, zeros) == 0) ++zeros;
            if (zeros == entries) {
                y.special.push_back({static_cast<int>(i), RouthSpecialCase::zero_row});
                if (first_zero_row < 0) first_zero_row = i;
                const Eigen::Index power = size - i;
                for (Eigen::Index j = 0; j < entries; ++j) r(i, j) = r(i - 1, j) * static_cast<Scalar>(power - 2 * j);
            } else if (zeros > 0) {
                y.special.push_back({static_cast<int>(i), RouthSpecialCase::zero_in_first_column});
                const Scalar sign = zeros % 2 == 0 ? 1 : -1;
                for (Eigen::Index j = 0; j + zeros < entries; ++j) r(i, j) += sign * r(i, j + zeros);
            }
        }

        int below_zero_row = 0;
        for (Eigen::Index i = 1; i < size; ++i) {
            const bool change = (r(i, 0) < 0) != (r(i - 1, 0) < 0);
            y.right_half_plane += change;
            below_zero_row += change && first_zero_row >= 0 && i >= first_zero_row;
        }
        // The auxiliary polynomial holds all roots that come in pairs s, -s: those right of the axis have a mirror
        // image.
        if (first_zero_row >= 0) y.imaginary_axis = static_cast<int>(size - first_zero_row) - 2 * below_zero_row;
        return y;
    }
}

}  // namespace equilibria

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
/// \cond
extern template RouthTable<Eigen::VectorXd> routh_table(const Eigen::VectorXd&);
/// \endcond
}  // namespace equilibria
#endif
