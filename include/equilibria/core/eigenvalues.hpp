/// \file
/// Eigenvalues of small real matrices without symmetry: Householder reduction to Hessenberg form, then Francis's
/// implicit double shifts, so that non-real eigenvalues come as exact conjugates. Source: Golub and Van Loan, Matrix
/// Computations, algorithms 7.4.2, 7.5.1 and 7.5.2. Eigen's solver is as good and takes ten seconds to compile.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {

template <class Real>
class HessenbergQr {
public:
    [[gnu::cold]] HessenbergQr(std::size_t n, std::vector<Real> a) : n_(n), a_(std::move(a)) { reduce(); }

    /// NaN where the shifts do not converge, which no matrix is known for.
    [[gnu::cold]] std::vector<std::complex<Real>> eigenvalues() {
        constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
        std::vector<std::complex<Real>> y(n_, {none, none});
        int steps = 0;
        for (std::size_t end = n_; end > 0;) {
            const std::size_t first = block(end), size = end - first;
            if (size > 2) {
                if (++steps > most_steps) break;
                step(first, end - 1, steps % 10 == 0);
                continue;
            }
            if (size == 1)
                y[first] = at(first, first);
            else
                std::tie(y[first], y[first + 1]) = pair(first);
            end = first;
            steps = 0;
        }
        return y;
    }

private:
    static constexpr int most_steps = 60;  ///< an eigenvalue; two to three are the rule

    Real& at(std::size_t i, std::size_t j) { return a_[i * n_ + j]; }

    /// The reflection I - beta v v^T, v_0 = 1, that turns x into a multiple of the first unit vector.
    void reflect(std::vector<Real> x) {
        Real below = 0;
        for (std::size_t k = 1; k < x.size(); ++k) below += x[k] * x[k];
        beta_ = 0;
        v_ = std::move(x);
        if (below > 0) {
            const Real size = std::sqrt(v_[0] * v_[0] + below);
            const Real pivot = v_[0] <= 0 ? v_[0] - size : -below / (v_[0] + size);
            beta_ = 2 * pivot * pivot / (below + pivot * pivot);
            for (Real& entry : v_) entry /= pivot;
        }
        v_[0] = 1;
    }
    /// To the rows from `row` on, in the columns [first, last).
    void from_left(std::size_t row, std::size_t first, std::size_t last) {
        for (std::size_t j = first; j < last; ++j) {
            Real sum = 0;
            for (std::size_t k = 0; k < v_.size(); ++k) sum += v_[k] * at(row + k, j);
            for (std::size_t k = 0; k < v_.size(); ++k) at(row + k, j) -= beta_ * sum * v_[k];
        }
    }
    /// To the columns from `column` on, in the rows [first, last).
    void from_right(std::size_t column, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Real sum = 0;
            for (std::size_t k = 0; k < v_.size(); ++k) sum += v_[k] * at(i, column + k);
            for (std::size_t k = 0; k < v_.size(); ++k) at(i, column + k) -= beta_ * sum * v_[k];
        }
    }

    void reduce() {
        for (std::size_t k = 0; k + 2 < n_; ++k) {
            std::vector<Real> x;
            for (std::size_t i = k + 1; i < n_; ++i) x.push_back(at(i, k));
            reflect(std::move(x));
            from_left(k + 1, k, n_);
            from_right(k + 1, 0, n_);
            for (std::size_t i = k + 2; i < n_; ++i) at(i, k) = 0;
        }
    }
    /// Where the block begins that ends before `end`: an entry below the diagonal that is rounding becomes 0.
    std::size_t block(std::size_t end) {
        for (std::size_t k = end - 1; k > 0; --k) {
            const Real size = std::abs(at(k - 1, k - 1)) + std::abs(at(k, k));
            if (std::abs(at(k, k - 1)) <= std::numeric_limits<Real>::epsilon() * (size > 0 ? size : 1)) {
                at(k, k - 1) = 0;
                return k;
            }
        }
        return 0;
    }
    /// A double shift by the eigenvalues of the last two rows; `exceptional`: by others, where those go round in
    /// circles.
    void step(std::size_t first, std::size_t last, bool exceptional) {
        Real sum = at(last - 1, last - 1) + at(last, last);
        Real product = at(last - 1, last - 1) * at(last, last) - at(last - 1, last) * at(last, last - 1);
        if (exceptional) {
            const Real size = std::abs(at(last, last - 1)) + std::abs(at(last - 1, last - 2));
            sum = Real(1.5) * size;
            product = size * size;
        }
        const Real a = at(first, first), b = at(first, first + 1), c = at(first + 1, first);
        std::vector<Real> x{a * a + b * c - sum * a + product, c * (a + at(first + 1, first + 1) - sum),
                            c * at(first + 2, first + 1)};
        for (std::size_t k = first; k < last; ++k) {
            const std::size_t size = std::min<std::size_t>(3, last + 1 - k);
            if (k > first) {
                x.clear();
                for (std::size_t i = 0; i < size; ++i) x.push_back(at(k + i, k - 1));
            }
            reflect(x);
            from_left(k, k > first ? k - 1 : first, last + 1);
            from_right(k, first, std::min(k + 4, last + 1));
            for (std::size_t i = 1; k > first && i < size; ++i) at(k + i, k - 1) = 0;
        }
    }
    /// The eigenvalues of the two rows from k on.
    std::pair<std::complex<Real>, std::complex<Real>> pair(std::size_t k) {
        const Real d = at(k + 1, k + 1), half = (at(k, k) - d) / 2, product = at(k, k + 1) * at(k + 1, k);
        const Real square = half * half + product;
        if (square < 0) {
            const std::complex<Real> z(d + half, std::sqrt(-square));
            return {z, std::conj(z)};
        }
        const Real larger = half + std::copysign(std::sqrt(square), half);
        return {d + larger, larger != 0 ? d - product / larger : d};
    }

    std::size_t n_;
    std::vector<Real> a_;  // row after row
    std::vector<Real> v_;
    Real beta_ = 0;
};

}  // namespace detail

/// The eigenvalues, in no order, of the n x n matrix with these entries, row after row or column after column. All are
/// NaN where an entry is not finite. Throws InvalidArgument where there are not n * n entries.
template <class Real>
[[gnu::cold]] std::vector<std::complex<Real>> eigenvalues(std::size_t n, std::vector<Real> entries) {
    require(entries.size() == n * n, "entries", entries.size(), "must be n * n = " + std::to_string(n * n));
    Real size = 0;
    bool finite = true;
    for (const Real& a : entries) {
        finite = finite && std::isfinite(a);
        size = std::max(size, std::abs(a));
    }
    constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
    if (!finite) return std::vector<std::complex<Real>>(n, {none, none});
    if (size > 0)
        for (Real& a : entries) a /= size;
    auto y = detail::HessenbergQr<Real>(n, std::move(entries)).eigenvalues();
    for (auto& z : y) z *= size;
    return y;
}

}  // namespace equilibria
