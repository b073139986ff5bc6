/// \file
/// Dense linear systems over any scalar, of a size known at compile time or at run time: doubles, multiprecision
/// floats, duals and power series, whose solutions come with their derivatives. For packs of lanes see
/// linear_solve.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/core/taylor.hpp>

namespace equilibria {

namespace detail {

/// The size of a scalar's value, for the choice of a pivot.
template <class S>
auto magnitude(const S& a) {
    using std::abs;
    return abs(a);
}
template <class T, int N>
auto magnitude(const Dual<T, N>& a) {
    return magnitude(a.value);
}
template <class T, int Order>
auto magnitude(const Taylor<T, Order>& a) {
    return magnitude(a.coefficient[0]);
}

/// LU with row exchanges of a matrix over any scalar, series and duals included. N may be at_run_time.
template <class S, int N>
class DenseFactorization {
public:
    using Matrix = std::conditional_t<N == at_run_time, RuntimeMatrix<S>, Array<Array<S, N>, N>>;
    using Vector = std::conditional_t<N == at_run_time, RuntimeArray<S>, Array<S, N>>;

    /// Of n by n matrices, one after the other.
    explicit DenseFactorization(int n) : n_(n), a_(n), exchange_(n) {}
    explicit DenseFactorization(const Matrix& a) : n_(a.size()), a_(a), exchange_(n_) { decompose(); }

    void factor(const Matrix& a) {
        a_ = a;
        decompose();
    }

    /// Whether no pivot vanished.
    bool regular() const { return regular_; }

    Vector solve(Vector b) const {
        solve_in_place(b);
        return b;
    }
    /// Overwrites b with the solution.
    void solve_in_place(Vector& b) const {
        using std::swap;
        for (int k = 0; k < n_; ++k)
            if (exchange_[k] != k) swap(b[k], b[exchange_[k]]);
        for (int k = 0; k < n_; ++k)
            for (int j = 0; j < k; ++j) b[k] = b[k] - a_[k][j] * b[j];
        for (int k = n_ - 1; k >= 0; --k) {
            for (int j = k + 1; j < n_; ++j) b[k] = b[k] - a_[k][j] * b[j];
            b[k] = b[k] / a_[k][k];
        }
    }

private:
    void decompose() {
        regular_ = false;
        for (int k = 0; k < n_; ++k) {
            int best = k;
            for (int i = k + 1; i < n_; ++i)
                if (magnitude(a_[i][k]) > magnitude(a_[best][k])) best = i;
            exchange_[k] = best;
            if (!(magnitude(a_[best][k]) > decltype(magnitude(a_[best][k]))(0))) return;
            if (best != k) std::swap_ranges(&a_[k][0], &a_[k][0] + n_, &a_[best][0]);
            for (int i = k + 1; i < n_; ++i) {
                const S f = a_[i][k] / a_[k][k];
                a_[i][k] = f;
                for (int j = k + 1; j < n_; ++j) a_[i][j] = a_[i][j] - f * a_[k][j];
            }
        }
        regular_ = true;
    }

    Extent<N> n_;
    Matrix a_;
    SizedArray<int, N> exchange_;
    bool regular_ = false;
};

}  // namespace detail

}  // namespace equilibria
