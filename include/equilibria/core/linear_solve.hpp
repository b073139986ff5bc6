/// \file
/// Small complex linear systems, over packs of lanes (one system a lane) and over scalars.
///
/// Two factorisations. LDL^T without pivoting for complex symmetric matrices costs half of an LU and needs no exchange
/// of rows, which lanes can do only by selecting every entry; a vanishing pivot gives an inf or NaN, which every
/// acceptance test refuses, and a small one a poor solution, which Newton's contraction test refuses. LU with partial
/// pivoting for everything else, and wherever the first was refused.
#pragma once

#include <iterator>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria {

namespace detail {
/// Calls work(n), with an Extent<n> for packs of up to four unknowns, whose loops are short: they are unrolled.
template <class R>
void with_extent(int n, auto&& work) {
    if constexpr (is_pack<R>) {
        if (n == 2) return work(Extent<2>());
        if (n == 3) return work(Extent<3>());
        if (n == 4) return work(Extent<4>());
    }
    work(Extent<at_run_time>(n));
}
}  // namespace detail

/// LDL^T of a complex symmetric matrix (not Hermitian: the Jacobian of an analytic gradient). Only the entries on and
/// above the diagonal, a[i][j] with i <= j, are read.
template <class R>
class SymmetricFactorization {
public:
    using Z = Complex<R>;  ///< type of the entries

    explicit SymmetricFactorization(int n) : n_(n), l_(n) {}  ///< of n x n matrices

    /// Takes in a[i][j], i <= j; see above for a vanishing pivot.
    void factor(const auto& a) {
        for (int i = 0; i < n_; ++i)
            for (int j = i; j < n_; ++j) l_[i][j] = a[i][j];
        detail::with_extent<R>(n_, [l = l_[0]](const auto extent) {
            const int n = extent;
            for (int k = 0; k < n; ++k) {
                Z* const row_k = l + k * n;
                const Z pivot = inverse(row_k[k]);
                for (int i = k + 1; i < n; ++i) {
                    Z* const row_i = l + i * n;
                    const Z f = row_k[i] * pivot;
                    for (int j = i; j < n; ++j) row_i[j] -= f * row_k[j];
                }
                for (int i = k + 1; i < n; ++i) row_k[i] *= pivot;
                row_k[k] = pivot;
            }
        });
    }
    /// Overwrites b with the solution.
    void solve(auto& b) const {
        detail::with_extent<R>(n_, [l = l_[0], x = std::begin(b)](const auto extent) {
            const int n = extent;
            for (int i = 1; i < n; ++i) {
                Z y = x[i];
                for (int k = 0; k < i; ++k) y -= l[k * n + i] * x[k];
                x[i] = y;
            }
            for (int k = n - 1; k >= 0; --k) {
                const Z* const row = l + k * n;
                Z y = x[k] * row[k];
                for (int i = k + 1; i < n; ++i) y -= row[i] * x[i];
                x[k] = y;
            }
        });
    }

private:
    int n_;
    RuntimeMatrix<Z> l_;  // the transposed unit factor above the diagonal, the inverse pivots on it
};

/// LU with partial pivoting.
template <class R>
class PivotedFactorization {
public:
    using Z = Complex<R>;                       ///< type of the entries
    using Mask = typename LaneTraits<R>::Mask;  ///< of the lanes in which two rows are exchanged

    explicit PivotedFactorization(int n) : n_(n), l_(n), exchange_(n), column_(n) {}  ///< of n x n matrices

    /// Takes in a[i][j] and factorises; each lane exchanges rows of its own. A singular matrix gives infinities or
    /// NaNs.
    void factor(const auto& a) {
        const int n = n_;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) l_[i][j] = a[i][j];
        for (int k = 0; k < n; ++k) {
            auto&& row_k = l_[k];
            for (int i = k + 1; i < n; ++i) {
                auto&& row_i = l_[i];
                const Mask m = norm2(row_i[k]) > norm2(row_k[k]);
                exchange_[k][i] = {m, !no_lane(m)};
                if (!exchange_[k][i].any) continue;
                for (int j = 0; j < n; ++j) exchange(m, row_k[j], row_i[j]);
            }
            row_k[k] = inverse(row_k[k]);
            for (int i = k + 1; i < n; ++i) {
                auto&& row_i = l_[i];
                row_i[k] *= row_k[k];
                for (int j = k + 1; j < n; ++j) row_i[j] -= row_i[k] * row_k[j];
            }
        }
    }
    /// Overwrites b with the solution.
    void solve(auto& b) const {
        Z* const x = std::begin(b);
        permute(x);
        substitute(x, 0);
    }
    /// y[r][c] becomes (a^-1)_rc.
    void inverse_into(auto& y) {
        for (int c = 0; c < n_; ++c) {
            for (int r = 0; r < n_; ++r) column_[r] = Z{broadcast<R>(r == c ? 1.0 : 0.0), broadcast<R>(0.0)};
            substitute(&column_[0], c);
            for (int r = 0; r < n_; ++r) y[r][c] = column_[r];
        }
        for (int k = n_ - 1; k >= 0; --k)
            for (int i = n_ - 1; i > k; --i)
                if (exchange_[k][i].any)
                    for (int r = 0; r < n_; ++r) exchange(exchange_[k][i].mask, y[r][k], y[r][i]);
    }
    /// sums[r] = sum over c of |(a^-1)_rc| weights[c]; overwrites the weights.
    void sum_inverse(auto& weights, auto& sums) {
        R* const w = std::begin(weights);
        permute(w);
        for (int r = 0; r < n_; ++r) sums[r] = broadcast<R>(0.0);
        for (int c = 0; c < n_; ++c) {
            for (int r = 0; r < n_; ++r) column_[r] = Z{broadcast<R>(r == c ? 1.0 : 0.0), broadcast<R>(0.0)};
            substitute(&column_[0], c);
            for (int r = 0; r < n_; ++r) sums[r] = sums[r] + w[c] * square_root(norm2(column_[r]));
        }
    }

private:
    template <class T>
    static void exchange(const Mask& m, T& a, T& b) {
        const T t = select(m, b, a);
        b = select(m, a, b);
        a = t;
    }
    /// x becomes P x.
    void permute(auto* x) const {
        for (int k = 0; k < n_; ++k) {
            auto&& exchanged = exchange_[k];
            for (int i = k + 1; i < n_; ++i)
                if (exchanged[i].any) exchange(exchanged[i].mask, x[k], x[i]);
        }
    }
    /// x becomes (L U)^-1 x; its entries before `first` are 0.
    void substitute(Z* x, int first) const {
        for (int i = first + 1; i < n_; ++i) {
            auto&& row = l_[i];
            Z y = x[i];
            for (int k = first; k < i; ++k) y -= row[k] * x[k];
            x[i] = y;
        }
        for (int k = n_ - 1; k >= 0; --k) {
            auto&& row = l_[k];
            Z y = x[k];
            for (int j = k + 1; j < n_; ++j) y -= row[j] * x[j];
            x[k] = y * row[k];
        }
    }

    struct Exchange {
        Mask mask;
        bool any;  // in some lane
    };

    int n_;
    RuntimeMatrix<Z> l_;  // unit lower factor below the diagonal, upper above it, inverse pivots on it
    RuntimeMatrix<Exchange> exchange_;
    RuntimeArray<Z> column_;
};

/// Either of them, chosen at run time.
template <class R>
class RuntimeFactorization {
public:
    /// Of n by n matrices. symmetric: LDL^T without pivoting.
    RuntimeFactorization(int n, bool symmetric)
        : symmetric_(symmetric), ldl_(symmetric ? n : 0), lu_(symmetric ? 0 : n) {}

    /// Takes in the n x n matrix a; see the two factorisations.
    void factor(const auto& a) { symmetric_ ? ldl_.factor(a) : lu_.factor(a); }
    void solve(auto& b) const { symmetric_ ? ldl_.solve(b) : lu_.solve(b); }  ///< overwrites b with the solution

private:
    bool symmetric_;
    SymmetricFactorization<R> ldl_;
    PivotedFactorization<R> lu_;
};

}  // namespace equilibria
