/// \file
/// Small complex linear systems, over packs of lanes (one system a lane) and over scalars. N: their size at compile
/// time, or at_run_time.
///
/// Two factorisations. LDL^T without pivoting for complex symmetric matrices costs half of an LU and needs no exchange
/// of rows, which lanes can do only by selecting every entry; a vanishing pivot gives an inf or NaN, which every
/// acceptance test refuses, and a small one a poor solution, which Newton's contraction test refuses. LU with partial
/// pivoting for everything else, and wherever the first was refused.
#pragma once

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
            const Z pivot = inverse(l_[k][k]);
            for (int i = k + 1; i < n; ++i) {
                const Z f = l_[k][i] * pivot;
                for (int j = i; j < n; ++j) l_[i][j] -= f * l_[k][j];
            }
            for (int i = k + 1; i < n; ++i) l_[k][i] *= pivot;
            l_[k][k] = pivot;
        }
    }
    /// Overwrites b with the solution.
    void solve(auto& b) const {
        const int n = n_;
        for (int k = 0; k < n; ++k)
            for (int i = k + 1; i < n; ++i) b[i] -= l_[k][i] * b[k];
        for (int k = n - 1; k >= 0; --k) {
            b[k] *= l_[k][k];
            for (int i = k + 1; i < n; ++i) b[k] -= l_[k][i] * b[i];
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
            for (int i = k + 1; i < n; ++i) {
                const Mask m = exchange_[k][i].mask = norm2(l_[i][k]) > norm2(l_[k][k]);
                for (int j = 0; j < n; ++j) exchange(m, l_[k][j], l_[i][j]);
            }
            l_[k][k] = inverse(l_[k][k]);
            for (int i = k + 1; i < n; ++i) {
                l_[i][k] *= l_[k][k];
                for (int j = k + 1; j < n; ++j) l_[i][j] -= l_[i][k] * l_[k][j];
            }
        }
    }
    /// Overwrites b with the solution.
    void solve(auto& b) const {
        const int n = n_;
        for (int k = 0; k < n; ++k)
            for (int i = k + 1; i < n; ++i) exchange(exchange_[k][i].mask, b[k], b[i]);
        for (int k = 0; k < n; ++k)
            for (int i = k + 1; i < n; ++i) b[i] -= l_[i][k] * b[k];
        for (int k = n - 1; k >= 0; --k) {
            for (int j = k + 1; j < n; ++j) b[k] -= l_[k][j] * b[j];
            b[k] *= l_[k][k];
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
