/// \file
/// Singular values of small complex matrices of any size, by one-sided Jacobi rotations: columns are turned pairwise
/// until they are orthogonal. Small singular values come out to high relative accuracy, which a rank needs; and a real
/// matrix has real vectors. Source: Golub and Van Loan, Matrix Computations, 8.6; Demmel
/// and Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13 (1992).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace equilibria {

/// A = U diag(sigma) V^H for a matrix of rows x columns, rows >= columns.
class SingularValues {
public:
    using Vector = std::vector<std::complex<double>>;  ///< a vector, or a matrix column after column

    /// a: column after column.
    [[gnu::cold]] SingularValues(int rows, int columns, Vector a)
        : rows_(static_cast<std::size_t>(rows)), columns_(static_cast<std::size_t>(columns)), a_(std::move(a)) {
        v_.assign(columns_ * columns_, 0.0);
        for (std::size_t k = 0; k < columns_; ++k) v_[k * columns_ + k] = 1.0;
        for (int sweep = 0; sweep < 60 && rotated(); ++sweep) {
        }
        for (std::size_t k = 0; k < columns_; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < rows_; ++i) sum += std::norm(a_[k * rows_ + i]);
            values_.push_back(std::sqrt(sum));
        }
        order_.resize(columns_);
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t i, std::size_t j) { return std::pair(-values_[i], i) < std::pair(-values_[j], j); });
    }

    int size() const { return static_cast<int>(columns_); }  ///< number of singular values: of columns
    /// The singular value number k, the largest first.
    double operator[](int k) const { return values_[order_[static_cast<std::size_t>(k)]]; }
    /// The unit right singular vector of value number k.
    [[gnu::cold]] Vector right(int k) const {
        const auto first = v_.begin() + static_cast<std::ptrdiff_t>(order_[static_cast<std::size_t>(k)] * columns_);
        return Vector(first, first + static_cast<std::ptrdiff_t>(columns_));
    }
    /// How many singular values are above `share` of the largest.
    int rank(double share) const {
        int r = 0;
        while (r < size() && (*this)[r] > share * (*this)[0]) ++r;
        return r;
    }
    /// The shortest x of least |A x - b|, A being taken to have the given rank.
    [[gnu::cold]] Vector solve(const Vector& b, int rank) const {
        Vector x(columns_);
        for (int k = 0; k < rank; ++k) {
            const std::size_t at = order_[static_cast<std::size_t>(k)];
            std::complex<double> along = 0;
            for (std::size_t i = 0; i < rows_; ++i) along += std::conj(a_[at * rows_ + i]) * b[i];
            along /= values_[at] * values_[at];
            for (std::size_t i = 0; i < columns_; ++i) x[i] += along * v_[at * columns_ + i];
        }
        return x;
    }

private:
    /// One sweep over all pairs of columns; whether any was turned.
    [[gnu::cold]] bool rotated() {
        bool any = false;
        for (std::size_t i = 0; i < columns_; ++i)
            for (std::size_t j = i + 1; j < columns_; ++j) {
                // products written out: those of std::complex ask for NaNs
                double ii = 0, jj = 0, re = 0, im = 0;
                for (std::size_t k = 0; k < rows_; ++k) {
                    const auto x = a_[i * rows_ + k], y = a_[j * rows_ + k];
                    ii += std::norm(x), jj += std::norm(y);
                    re += x.real() * y.real() + x.imag() * y.imag();
                    im += x.real() * y.imag() - x.imag() * y.real();
                }
                const double size = std::sqrt(re * re + im * im);
                if (!(size > 2 * std::numeric_limits<double>::epsilon() * std::sqrt(ii) * std::sqrt(jj))) continue;
                any = true;
                const double zeta = (jj - ii) / (2 * size);
                const double t = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));  // tan, the angle
                const double c = 1 / std::sqrt(1 + t * t), s = c * t;
                re /= size, im /= -size;
                const auto turn = [&](Vector& m, std::size_t length) {
                    for (std::size_t k = 0; k < length; ++k) {
                        const auto x = m[i * length + k], other = m[j * length + k];
                        const std::complex<double> y(re * other.real() - im * other.imag(),
                                                     re * other.imag() + im * other.real());
                        m[i * length + k] = c * x - s * y;
                        m[j * length + k] = s * x + c * y;
                    }
                };
                turn(a_, rows_);
                turn(v_, columns_);
            }
        return any;
    }

    std::size_t rows_, columns_;
    Vector a_, v_;  // U diag(sigma) and V, column after column
    std::vector<double> values_;
    std::vector<std::size_t> order_;
};

}  // namespace equilibria
