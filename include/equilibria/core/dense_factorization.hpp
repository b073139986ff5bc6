/// \file
/// Dense linear systems of compile-time size over any scalar: doubles, multiprecision floats, duals and power series,
/// whose solutions come with their derivatives. For packs of lanes see linear_solve.hpp.
#pragma once

#include <cmath>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
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

/// LU with row exchanges of a matrix over any scalar, series and duals included.
template <class S, int N>
class DenseFactorization {
public:
    using Matrix = Array<Array<S, N>, N>;

    explicit DenseFactorization(const Matrix& a) : a_(a) {
        using std::swap;
        for (int k = 0; k < N; ++k) {
            int best = k;
            for (int i = k + 1; i < N; ++i)
                if (magnitude(a_[i][k]) > magnitude(a_[best][k])) best = i;
            exchange_[k] = best;
            if (!(magnitude(a_[best][k]) > decltype(magnitude(a_[best][k]))(0))) return;
            if (best != k) swap(a_[k], a_[best]);
            for (int i = k + 1; i < N; ++i) {
                const S f = a_[i][k] / a_[k][k];
                a_[i][k] = f;
                for (int j = k + 1; j < N; ++j) a_[i][j] = a_[i][j] - f * a_[k][j];
            }
        }
        regular_ = true;
    }

    /// Whether no pivot vanished.
    bool regular() const { return regular_; }

    Array<S, N> solve(Array<S, N> b) const {
        using std::swap;
        for (int k = 0; k < N; ++k)
            if (exchange_[k] != k) swap(b[k], b[exchange_[k]]);
        for (int k = 0; k < N; ++k)
            for (int j = 0; j < k; ++j) b[k] = b[k] - a_[k][j] * b[j];
        for (int k = N - 1; k >= 0; --k) {
            for (int j = k + 1; j < N; ++j) b[k] = b[k] - a_[k][j] * b[j];
            b[k] = b[k] / a_[k][k];
        }
        return b;
    }

private:
    Matrix a_;
    Array<int, N> exchange_{};
    bool regular_ = false;
};

}  // namespace detail

}  // namespace equilibria
