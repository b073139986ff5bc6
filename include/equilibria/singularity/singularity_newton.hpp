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

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>

namespace equilibria::detail {

template <class S, int N>
using SquareArray = Array<Array<S, N>, N>;

template <class S>
double to_double(const S& a) {
    return static_cast<double>(a);
}
template <class S, int N>
Array<double, N> to_double(const Array<S, N>& a) {
    Array<double, N> y;
    for (int k = 0; k < N; ++k) y[k] = static_cast<double>(a[k]);
    return y;
}
template <class S, class T, int N>
Array<S, N> in_digits_of(const Array<T, N>& a) {
    Array<S, N> y;
    for (int k = 0; k < N; ++k) y[k] = S(a[k]);
    return y;
}
template <class S, int N>
S dot(const Array<S, N>& a, const Array<S, N>& b) {
    S sum(0.0);
    for (int k = 0; k < N; ++k) sum = sum + a[k] * b[k];
    return sum;
}
template <class S, int N>
Array<S, N> normalized(Array<S, N> a) {
    using std::sqrt;
    const S size = sqrt(dot(a, a));
    for (S& x : a) x = x / size;
    return a;
}
/// The largest absolute value; NaN where one is.
template <class S, int N>
S largest(const Array<S, N>& a) {
    using std::abs;
    S y(0.0);
    for (const S& x : a)
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
template <class S, int N, class At, class Evaluate>
void newton(Array<S, N>& y, At& at, Evaluate&& evaluate) {
    using std::abs;
    const S rounding = std::numeric_limits<S>::epsilon();
    Array<S, N> r;
    SquareArray<S, N> jacobian;
    while (at.steps < 50) {
        ++at.steps;
        if (!evaluate(y, r, jacobian)) break;
        const DenseFactorization<S, N> factors(jacobian);
        if (!factors.regular()) break;
        const Array<S, N> step = factors.solve(r);
        Array<S, N> relative = step;
        for (int k = 0; k < N; ++k) {
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
