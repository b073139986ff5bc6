/// \file
/// Small complex linear systems of compile-time size, over packs of lanes (one system a lane) and over scalars.
///
/// Two factorisations. LDL^T without pivoting for complex symmetric matrices costs half of an LU and needs no exchange
/// of rows, which lanes can do only by selecting every entry; a vanishing pivot gives an inf or NaN, which every
/// acceptance test refuses, and a small one a poor solution, which Newton's contraction test refuses. LU with partial
/// pivoting for everything else, and wherever the first was refused.
#pragma once

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>

namespace equilibria {

/// LDL^T of a complex symmetric matrix (not Hermitian: the Jacobian of an analytic gradient). Only the entries on and
/// above the diagonal, a[i][j] with i <= j, are read.
template <class R, int N>
class SymmetricFactorization {
public:
    using Z = Complex<R>;

    void factor(const Z (&a)[N][N]) {
        for (int i = 0; i < N; ++i)
            for (int j = i; j < N; ++j) l_[i][j] = a[i][j];
        for (int k = 0; k < N; ++k) {
            const Z pivot = inverse(l_[k][k]);
            for (int i = k + 1; i < N; ++i) {
                const Z f = l_[k][i] * pivot;
                for (int j = i; j < N; ++j) l_[i][j] -= f * l_[k][j];
            }
            for (int i = k + 1; i < N; ++i) l_[k][i] *= pivot;
            l_[k][k] = pivot;
        }
    }
    /// Overwrites b with the solution.
    void solve(Z (&b)[N]) const {
        for (int k = 0; k < N; ++k)
            for (int i = k + 1; i < N; ++i) b[i] -= l_[k][i] * b[k];
        for (int k = N - 1; k >= 0; --k) {
            b[k] *= l_[k][k];
            for (int i = k + 1; i < N; ++i) b[k] -= l_[k][i] * b[i];
        }
    }

private:
    Z l_[N][N];  // the transposed unit factor above the diagonal, the inverse pivots on it
};

/// LU with partial pivoting.
template <class R, int N>
class PivotedFactorization {
public:
    using Z = Complex<R>;
    using Mask = typename LaneTraits<R>::Mask;

    void factor(const Z (&a)[N][N]) {
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j) l_[i][j] = a[i][j];
        for (int k = 0; k < N; ++k) {
            for (int i = k + 1; i < N; ++i) {
                const Mask m = exchange_[k][i] = norm2(l_[i][k]) > norm2(l_[k][k]);
                for (int j = 0; j < N; ++j) exchange(m, l_[k][j], l_[i][j]);
            }
            l_[k][k] = inverse(l_[k][k]);
            for (int i = k + 1; i < N; ++i) {
                l_[i][k] *= l_[k][k];
                for (int j = k + 1; j < N; ++j) l_[i][j] -= l_[i][k] * l_[k][j];
            }
        }
    }
    /// Overwrites b with the solution.
    void solve(Z (&b)[N]) const {
        for (int k = 0; k < N; ++k)
            for (int i = k + 1; i < N; ++i) exchange(exchange_[k][i], b[k], b[i]);
        for (int k = 0; k < N; ++k)
            for (int i = k + 1; i < N; ++i) b[i] -= l_[i][k] * b[k];
        for (int k = N - 1; k >= 0; --k) {
            for (int j = k + 1; j < N; ++j) b[k] -= l_[k][j] * b[j];
            b[k] *= l_[k][k];
        }
    }

private:
    static void exchange(const Mask& m, Z& a, Z& b) {
        const Z t = select(m, b, a);
        b = select(m, a, b);
        a = t;
    }

    Z l_[N][N];  // unit lower factor below the diagonal, upper above it, inverse pivots on it
    Mask exchange_[N][N];
};

}  // namespace equilibria
