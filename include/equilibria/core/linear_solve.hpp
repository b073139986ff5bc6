/// \file
/// Small complex linear systems, over packs of lanes (one system a lane) and over scalars. N: their size at compile
/// time, or at_run_time.
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

/// LDL^T of a complex symmetric matrix (not Hermitian: the Jacobian of an analytic gradient). Only the entries on and
/// above the diagonal, a[i][j] with i <= j, are read.
template <class R, int N>
class SymmetricFactorization {
public:
    using Z = Complex<R>;

    explicit SymmetricFactorization(int n = N) : n_(n), l_(n) {}

    void factor(const auto& a) {
        const int n = n_;
        for (int i = 0; i < n; ++i)
            for (int j = i; j < n; ++j) l_[i][j] = a[i][j];
        for (int k = 0; k < n; ++k) {
            auto&& row_k = l_[k];
            const Z pivot = inverse(row_k[k]);
            for (int i = k + 1; i < n; ++i) {
                auto&& row_i = l_[i];
                const Z f = row_k[i] * pivot;
                for (int j = i; j < n; ++j) row_i[j] -= f * row_k[j];
            }
            for (int i = k + 1; i < n; ++i) row_k[i] *= pivot;
            row_k[k] = pivot;
        }
    }
    /// Overwrites b with the solution.
    void solve(auto& b) const {
        const int n = n_;
        Z* x = std::begin(b);
        for (int k = 0; k < n; ++k) {
            auto&& row = l_[k];
            for (int i = k + 1; i < n; ++i) x[i] -= row[i] * x[k];
        }
        for (int k = n - 1; k >= 0; --k) {
            auto&& row = l_[k];
            x[k] *= row[k];
            for (int i = k + 1; i < n; ++i) x[k] -= row[i] * x[i];
        }
    }

private:
    Extent<N> n_;
    SizedMatrix<Z, N> l_;  // the transposed unit factor above the diagonal, the inverse pivots on it
};

/// LU with partial pivoting.
template <class R, int N>
class PivotedFactorization {
public:
    using Z = Complex<R>;
    using Mask = typename LaneTraits<R>::Mask;

    explicit PivotedFactorization(int n = N) : n_(n), l_(n), exchange_(n) {}

    void factor(const auto& a) {
        const int n = n_;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) l_[i][j] = a[i][j];
        for (int k = 0; k < n; ++k) {
            auto&& row_k = l_[k];
            for (int i = k + 1; i < n; ++i) {
                auto&& row_i = l_[i];
                const Mask m = exchange_[k][i].mask = norm2(row_i[k]) > norm2(row_k[k]);
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
        const int n = n_;
        Z* x = std::begin(b);
        for (int k = 0; k < n; ++k) {
            auto&& exchanged = exchange_[k];
            for (int i = k + 1; i < n; ++i) exchange(exchanged[i].mask, x[k], x[i]);
        }
        for (int k = 0; k < n; ++k)
            for (int i = k + 1; i < n; ++i) x[i] -= l_[i][k] * x[k];
        for (int k = n - 1; k >= 0; --k) {
            auto&& row = l_[k];
            for (int j = k + 1; j < n; ++j) x[k] -= row[j] * x[j];
            x[k] *= row[k];
        }
    }

private:
    static void exchange(const Mask& m, Z& a, Z& b) {
        const Z t = select(m, b, a);
        b = select(m, a, b);
        a = t;
    }

    struct Exchange {
        Mask mask;  // std::vector<bool> would pack them
    };

    Extent<N> n_;
    SizedMatrix<Z, N> l_;  // unit lower factor below the diagonal, upper above it, inverse pivots on it
    SizedMatrix<Exchange, N> exchange_;
};

/// Either of them, chosen at run time.
template <class R>
class RuntimeFactorization {
public:
    /// Of n by n matrices. symmetric: LDL^T without pivoting.
    RuntimeFactorization(int n, bool symmetric)
        : symmetric_(symmetric), ldl_(symmetric ? n : 0), lu_(symmetric ? 0 : n) {}

    void factor(const auto& a) { symmetric_ ? ldl_.factor(a) : lu_.factor(a); }
    void solve(auto& b) const { symmetric_ ? ldl_.solve(b) : lu_.solve(b); }

private:
    bool symmetric_;
    SymmetricFactorization<R, at_run_time> ldl_;
    PivotedFactorization<R, at_run_time> lu_;
};

}  // namespace equilibria
