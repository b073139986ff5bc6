/// \file
/// A homotopy with linear coefficients in logarithms of its unknowns, with the digits of R: for paths that grow or
/// shrink by powers of 1 - t. See homotopy/path_limit.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <set>
#include <type_traits>
#include <vector>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/laurent_column.hpp>

namespace equilibria::detail {

/// The binary exponent of |z|, roughly; a large negative number of 0.
template <class R>
int size_exponent(const Complex<R>& z) {
    const auto of = [](const R& x) {
        if constexpr (std::is_same_v<R, DoubleDouble>) {
            return x.high() == 0 ? -100000 : std::isfinite(x.high()) ? std::ilogb(x.high()) : 100000;
        } else {
            using std::frexp;
            int e = 0;
            const R m = frexp(x, &e);
            if (!(m == m) || !isfinite(x)) return 100000;
            return m == R(0) ? -100000 : e;
        }
    };
    return std::max(of(z.re), of(z.im));
}
template <class R>
R times_power_of_two(const R& x, int e) {
    if constexpr (std::is_same_v<R, DoubleDouble>)
        return {std::ldexp(x.high(), e), std::ldexp(x.low(), e)};
    else
        return ldexp(x, e);
}
template <class R>
std::complex<double> rounded(const Complex<R>& z) {
    return {static_cast<double>(z.re), static_cast<double>(z.im)};
}

/// The terms (1 - r) to + r from, r = 1 - t, their sums and the derivatives of these by log z and by r.
template <class R>
class LogarithmicHomotopy {
public:
    using Z = Complex<R>;

    static constexpr bool double_double = std::is_same_v<R, DoubleDouble>;
    /// A residual that is rounding, against the size of the terms.
    static constexpr double vanishing = double_double ? 1e-24 : 1e-45;

    LogarithmicHomotopy(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns)
        : n_(sizes.unknowns), angles_(sizes.angles), columns_(&columns), highest_(at(n_)), lowest_(at(n_)),
          powers_(at(n_)), f_(n_), by_r_(n_), j_(n_), lu_(n_), exponent_(at(n_)), sum_(at(n_)), terms_(columns.size()) {
        for (const LaurentColumn& c : columns) {
            from_.emplace_back(R(c.from.real()), R(c.from.imag()));
            to_.emplace_back(R(c.to.real()), R(c.to.imag()));
            for (std::size_t u = 0; u < at(n_); ++u) {
                highest_[u] = std::max(highest_[u], c.exponents[u]);
                lowest_[u] = std::min(lowest_[u], c.exponents[u]);
            }
        }
        for (std::size_t u = 0; u < at(n_); ++u) {
            powers_[u].resize(at(highest_[u] - lowest_[u] + 1));
            std::set<int> needed{0};
            for (const LaurentColumn& c : columns) needed.insert(c.exponents[u]);
            needed_.emplace_back(needed.begin(), needed.end());
            most_whole_ = std::max({most_whole_, highest_[u], -lowest_[u]});
        }
        for (int k = -most_whole_; k <= most_whole_; ++k) whole_.push_back(R(k));
    }

protected:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// z^k by squaring, k > 0.
    static Z power_of(Z z, int k) {
        Z y = z;
        int bit = 1;
        while (2 * bit <= k) bit *= 2;
        for (bit /= 2; bit > 0; bit /= 2) {
            y = y * y;
            if (k & bit) y = y * z;
        }
        return y;
    }
    /// Powers of each unknown, those of its exponents, each from the one before; those of an unknown that is 0 too.
    void set_powers(const std::vector<Z>& z) {
        for (std::size_t u = 0; u < at(n_); ++u) {
            auto& p = powers_[u];
            const auto& needed = needed_[u];
            const auto of = [&](int e) -> Z& { return p[at(e - lowest_[u])]; };
            const auto zero = at(static_cast<int>(std::ranges::lower_bound(needed, 0) - needed.begin()));
            of(0) = Z(1.0);
            for (std::size_t k = zero + 1; k < needed.size(); ++k)
                of(needed[k]) = of(needed[k - 1]) * power_of(z[u], needed[k] - needed[k - 1]);
            if (zero > 0) {
                const Z back = inverse(z[u]);
                for (std::size_t k = zero; k-- > 0;)
                    of(needed[k]) = of(needed[k + 1]) * power_of(back, needed[k + 1] - needed[k]);
            }
        }
    }
    const Z& power(std::size_t u, int e) const { return powers_[u][at(e - lowest_[u])]; }

    /// Terms, equations and their derivatives by the logarithms of the unknowns and by r, each equation divided by a
    /// power of two near its largest term. plain: coordinates that are 0 take derivatives by themselves.
    bool linearize(const std::vector<Z>& z, const R& r, const std::vector<char>* plain = nullptr) {
        set_powers(z);
        std::fill(exponent_.begin(), exponent_.end(), -100000);
        std::vector<Z> product(columns_->size()), coefficient(columns_->size());
        for (std::size_t k = 0; k < columns_->size(); ++k) {
            const LaurentColumn& c = (*columns_)[k];
            Z p(1.0);
            for (std::size_t u = 0; u < at(n_); ++u)
                if (c.exponents[u] != 0) p *= power(u, c.exponents[u]);
            product[k] = p;
            coefficient[k] = to_[k] + r * (from_[k] - to_[k]);
            terms_[k] = coefficient[k] * p;
            const int e = size_exponent(terms_[k]);
            if (e >= 100000) return false;
            exponent_[at(c.equation)] = std::max(exponent_[at(c.equation)], e);
        }
        for (int& e : exponent_)
            if (e == -100000) e = 0;  // all terms are 0
        if constexpr (double_double)
            for (const int e : exponent_)
                if (e > 900 || e < -800) return false;
        for (int i = 0; i < n_; ++i) {
            f_[i] = by_r_[i] = Z(0.0);
            sum_[at(i)] = 0;
            for (int u = 0; u < n_; ++u) j_[i][u] = Z(0.0);
        }
        for (std::size_t k = 0; k < columns_->size(); ++k) {
            const LaurentColumn& c = (*columns_)[k];
            const int i = c.equation, e = -exponent_[at(i)];
            const Z t = scaled(terms_[k], e);
            terms_[k] = t;
            f_[i] += t;
            sum_[at(i)] += std::abs(rounded(t));
            by_r_[i] += (from_[k] - to_[k]) * scaled(product[k], e);
            for (int u = 0; u < n_; ++u) {
                const int power_of_u = c.exponents[at(u)];
                if (power_of_u == 0) continue;
                if (plain && (*plain)[at(u)]) {
                    if (power_of_u != 1) continue;  // at 0
                    Z p(1.0);
                    for (std::size_t v = 0; v < at(n_); ++v)
                        if (v != at(u) && c.exponents[v] != 0) p *= power(v, c.exponents[v]);
                    j_[i][u] += scaled(coefficient[k] * p, e);
                } else {
                    j_[i][u] += whole(power_of_u) * t;
                }
            }
        }
        return true;
    }
    /// A small integer, which takes time to convert.
    const R& whole(int k) const { return whole_[at(k + most_whole_)]; }
    static Z scaled(const Z& z, int e) { return {times_power_of_two(z.re, e), times_power_of_two(z.im, e)}; }

    /// f_ becomes -J^-1 f; its largest size is returned.
    double newton_step() {
        lu_.factor(j_);
        for (int i = 0; i < n_; ++i) f_[i] = -f_[i];
        lu_.solve(f_);
        double size = 0;
        for (int u = 0; u < n_; ++u) {
            const double one = std::abs(rounded(f_[u]));
            if (!(one <= size)) size = one;  // a NaN stays
        }
        return size;
    }
    /// d zeta / d s at z.
    bool slope(const std::vector<Z>& z, const R& r, std::vector<Z>& d) {
        if (!linearize(z, r)) return false;
        lu_.factor(j_);
        for (int i = 0; i < n_; ++i) f_[i] = r * by_r_[i];
        lu_.solve(f_);
        d.assign(at(n_), Z(0.0));
        for (int u = 0; u < n_; ++u) {
            d[at(u)] = f_[u];
            if (!(std::abs(rounded(f_[u])) < 1e6)) return false;
        }
        return true;
    }
    /// exp(d) - 1 to all digits: by its series, of a small fraction of d.
    static Z growth_factor(Z d) {
        int halvings = 0;
        for (double size = std::abs(rounded(d)); size > 0.05; size /= 2) ++halvings;
        d = scaled(d, -halvings);
        Z sum = d, term = d;
        for (int k = 2; k < (double_double ? 18 : 34); ++k) {
            term = (term * d) / R(k);
            sum += term;
        }
        for (; halvings > 0; --halvings) sum = sum * (sum + 2.0);
        return sum;
    }
    double relative_residual() const {
        double y = 0;
        for (int i = 0; i < n_; ++i) y = std::max(y, std::abs(rounded(f_[i])) / std::max(sum_[at(i)], 1e-300));
        return y;
    }
    int n_, angles_;
    const std::vector<LaurentColumn>* columns_;
    std::vector<Z> from_, to_;
    std::vector<int> highest_, lowest_;
    std::vector<std::vector<int>> needed_;  ///< the exponents of each unknown, and 0, ascending
    std::vector<std::vector<Z>> powers_;
    int most_whole_ = 0;
    std::vector<R> whole_;
    SizedArray<Z, at_run_time> f_, by_r_;
    RuntimeMatrix<Z> j_;
    PivotedFactorization<R> lu_;
    std::vector<int> exponent_;
    std::vector<double> sum_;
    std::vector<Z> terms_;
};

}  // namespace equilibria::detail
