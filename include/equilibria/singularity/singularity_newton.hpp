/// \file
/// Newton's method of all refinements of singularities, with exact derivatives (duals), in the digits of the
/// parameters' scalar: double or a multiprecision float (core/multiprecision.hpp).
///
/// The Jacobians are regular at points of just the kind that is sought whose parameters unfold them (`versality` is not
/// 0), and convergence is quadratic. Where it fails: at points of a higher kind, and where the parameters do not
/// unfold, convergence is linear or absent, and `converged` false.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria::detail {

template <class S, int N>
using SquareArray = Array<Array<S, N>, N>;

/// A vector or square matrix like V, over the scalar T.
template <class V, class T>
struct Rebound;
template <class S, int N, class T>
struct Rebound<Array<S, N>, T> {
    using type = Array<T, N>;
    static constexpr int extent = N;
    static type of(int) { return type(); }
    static SquareArray<T, N> square(int) { return SquareArray<T, N>(); }
};
template <class S, class T>
struct Rebound<RuntimeArray<S>, T> {
    using type = RuntimeArray<T>;
    static constexpr int extent = at_run_time;
    static type of(int size) { return type(size); }
    static RuntimeMatrix<T> square(int size) { return RuntimeMatrix<T>(size); }
};
template <class V>
using EntryOf = std::remove_cvref_t<decltype(std::declval<const V&>()[0])>;

// Of vectors of a size known at compile time or at run time.

template <class S>
requires(!requires(const S& a) { a[0]; })
double to_double(const S& a) {
    return static_cast<double>(a);
}
template <class V>
requires requires(const V& a) { a[0]; }
typename Rebound<V, double>::type to_double(const V& a) {
    auto y = Rebound<V, double>::of(a.size());
    for (int k = 0; k < a.size(); ++k) y[k] = static_cast<double>(a[k]);
    return y;
}
template <class S, class V>
typename Rebound<V, S>::type in_digits_of(const V& a) {
    auto y = Rebound<V, S>::of(a.size());
    for (int k = 0; k < a.size(); ++k) y[k] = S(a[k]);
    return y;
}
template <class V>
EntryOf<V> dot(const V& a, const V& b) {
    EntryOf<V> sum(0.0);
    for (int k = 0; k < a.size(); ++k) sum = sum + a[k] * b[k];
    return sum;
}
template <class V>
V normalized(V a) {
    using std::sqrt;
    const auto size = sqrt(dot(a, a));
    for (auto& x : a) x = x / size;
    return a;
}
/// The largest absolute value; NaN where one is.
template <class V>
EntryOf<V> largest(const V& a) {
    using std::abs;
    EntryOf<V> y(0.0);
    for (const auto& x : a)
        if (!(abs(x) <= y)) {
            y = abs(x);
            if (!(y == y)) return y;
        }
    return y;
}

/// The unknowns as independent variables.
template <class S, int N>
Array<Dual<S, N>, N> independent(const Array<S, N>& y) {
    Array<Dual<S, N>, N> u;
    for (int k = 0; k < N; ++k) u[k] = Dual<S, N>::variable(y[k], k);
    return u;
}
/// Values and derivatives apart.
template <class S, int N>
void split_duals(const Array<Dual<S, N>, N>& f, Array<S, N>& values, SquareArray<S, N>& jacobian) {
    for (int i = 0; i < N; ++i) values[i] = f[i].value, jacobian[i] = f[i].derivative;
}

/// Newton's method, y = y - jacobian^-1 r with evaluate(y, r, jacobian), which is false where it cannot; what it did
/// goes into the members steps, correction and converged of `at`. It ends after 50 steps, and where a step is larger
/// than 1e3, relative to the unknown where that is above 1.
template <class V, class At, class Evaluate>
void newton_method(V& y, At& at, Evaluate&& evaluate) {
    using std::abs;
    using S = EntryOf<V>;
    const S rounding = std::numeric_limits<S>::epsilon();
    V r = Rebound<V, S>::of(y.size());
    auto jacobian = Rebound<V, S>::square(y.size());
    while (at.steps < 50) {
        ++at.steps;
        if (!evaluate(y, r, jacobian)) break;
        const DenseFactorization<S, Rebound<V, S>::extent> factors(jacobian);
        if (!factors.regular()) break;
        const V step = factors.solve(r);
        V relative = step;
        for (int k = 0; k < y.size(); ++k) {
            y[k] = y[k] - step[k];
            if (abs(y[k]) > S(1.0)) relative[k] = step[k] / y[k];
        }
        const S before = at.correction;
        at.correction = largest(relative);
        at.converged = at.correction <= 4096 * rounding;
        // once more after the last digit, while it still helps
        if (at.converged && (at.correction <= 16 * rounding || (at.steps > 1 && !(at.correction < before / 2)))) break;
        if (!(at.correction < S(1e3))) {
            at.converged = false;
            break;
        }
    }
}

}  // namespace equilibria::detail
