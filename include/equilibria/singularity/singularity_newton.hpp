/// \file
/// What the refinements of singularities share: Newton's method with exact derivatives, in the digits of the
/// parameters' scalar (double or a multiprecision float), and the evidence that it collects, in double.
///
/// The Jacobians are regular at points of just the kind that is sought whose parameters unfold them (`versality` is not
/// 0), and convergence is quadratic. Where it fails: at points of a higher kind, and where the parameters do not
/// unfold, convergence is linear or absent, and `converged` false.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/core/symmetric_eigen.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

namespace detail {

inline constexpr int evidence_order = 7;

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
        if (!(abs(x) <= y)) y = abs(x);
    return y;
}

/// Newton's method, y = y - jacobian^-1 r with evaluate(y, r, jacobian), which is false where it cannot; what it did
/// goes into `at`.
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

/// The unit eigenvectors of J of the `Count` eigenvalues of least size, in double.
template <int Count, PotentialModel M>
Array<Unknowns<M>, Count> weakest_directions(const Unknowns<M>& q, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    const SymmetricEigen<Eigen::MatrixXd> eigen(Eigen::MatrixXd(jacobian<M, double>(q, p)));
    Array<int, n> order;
    for (int i = 0; i < n; ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return std::abs(eigen.values(a)) < std::abs(eigen.values(b)); });
    Array<Unknowns<M>, Count> y;
    for (int c = 0; c < Count; ++c)
        for (int i = 0; i < n; ++i) y[c][i] = eigen.vectors(i, order[c]);
    return y;
}

/// The number of eigenvalues of J that are 0 to 1e-8 of `scale` or of the largest.
template <PotentialModel M>
int nullity(const Unknowns<M>& q, const Parameters<M>& p, double scale) {
    const Eigen::VectorXd values = symmetric_eigenvalues(Eigen::MatrixXd(jacobian<M, double>(q, p))).cwiseAbs();
    return static_cast<int>((values.array() <= 1e-8 * std::max(scale, values.maxCoeff())).count());
}

/// `versality` of the Jacobian of Newton's system, whose first Rows equations are F and whose last columns are the
/// parameters', with the border W of the null space: F is solved for q across W.
template <int Rows, int Corank, int N, class S>
double versality(const SquareArray<S, N>& jacobian, const Array<Array<double, Rows>, Corank>& w) {
    constexpr int conditions = N - Rows, size = Corank + conditions;
    Array<Array<double, N>, N> a;
    for (int i = 0; i < N; ++i) a[i] = to_double(jacobian[i]);
    SquareArray<double, Rows + Corank> bordered;
    for (int i = 0; i < Rows; ++i) {
        for (int j = 0; j < Rows; ++j) bordered[i][j] = a[i][j];
        for (int c = 0; c < Corank; ++c) bordered[i][Rows + c] = -w[c][i], bordered[Rows + c][i] = w[c][i];
    }
    SquareArray<double, size> unfolding;  // by columns
    const auto conditions_along = [&](const auto& z, auto& column) {
        for (int k = 0; k < conditions; ++k)
            for (int i = 0; i < Rows; ++i) column[Corank + k] += a[Rows + k][i] * z[i];
    };
    const auto scale = [](auto& column, double by) {
        if (by > 0)
            for (double& x : column) x /= by;
    };
    double largest_along_null = 0;
    for (int c = 0; c < Corank; ++c) {
        conditions_along(w[c], unfolding[c]);
        largest_along_null = std::max(largest_along_null, std::sqrt(dot(unfolding[c], unfolding[c])));
    }
    for (int c = 0; c < Corank; ++c) scale(unfolding[c], largest_along_null);
    const DenseFactorization<double, Rows + Corank> factors(bordered);
    if (!factors.regular()) return 0;
    for (int k = 0; k < conditions; ++k) {
        auto& column = unfolding[Corank + k];
        Array<double, Rows + Corank> b;
        double whole = 0;
        for (int i = 0; i < N; ++i) whole += a[i][Rows + k] * a[i][Rows + k];
        for (int i = 0; i < Rows; ++i) b[i] = -a[i][Rows + k];
        b = factors.solve(b);
        for (int c = 0; c < Corank; ++c) column[c] = b[Rows + c];
        conditions_along(b, column);
        for (int i = 0; i < conditions; ++i) column[Corank + i] += a[Rows + i][Rows + k];
        scale(column, std::sqrt(whole));
    }
    SingularValues::Vector entries;
    for (const auto& column : unfolding) entries.insert(entries.end(), column.begin(), column.end());
    for (const auto& x : entries)
        if (!std::isfinite(x.real())) return 0;
    return SingularValues(size, size, std::move(entries))[size - 1];
}

template <PotentialModel M, class S>
Singularity<M, S> singularity_at(const Unknowns<M>& q, const Parameters<M, S>& p) {
    require_finite(q, "q");
    require_finite(p, "p");
    Singularity<M, S> at;
    at.q = in_digits_of<S>(q);
    at.p = p;
    return at;
}

template <class M, int... Active>
constexpr void check_active() {
    static_assert(((Active >= 0 && Active < n_parameters<M>)&&...), "equilibria: no such parameter");
    constexpr int active[] = {Active...};
    constexpr bool different = [&] {
        for (std::size_t i = 0; i < sizeof...(Active); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (active[i] == active[j]) return false;
        return true;
    }();
    static_assert(different, "equilibria: the active parameters must be different ones");
}

/// p with the active ones y[first], y[first + 1], ..
template <class M, int... Active, class S, class T, int N>
Parameters<M, T> with_active(const Parameters<M, S>& p, const Array<T, N>& y, int first) {
    Parameters<M, T> lifted;
    for (int k = 0; k < p.size(); ++k) lifted[k] = T(p[k]);
    ((lifted[Active] = y[first++]), ...);
    return lifted;
}

/// Taylor coefficients of the reduced potential next to the entries of J: what 0 is measured by.
template <PotentialModel M, class S>
double scale_of(const Singularity<M, S>& at) {
    double y = jacobian<M, double>(to_double(at.q), to_double(at.p)).cwiseAbs().maxCoeff(), factorial = 2;
    for (int k = 3; k <= 8; ++k) {
        factorial *= k;
        y = std::max(y, std::abs(to_double(at.derivative(k))) / factorial);
    }
    return y;
}

/// v, the derivatives along it and the nullity; the reduced series along v, or nothing at a second null vector.
template <PotentialModel M, class S>
std::optional<ReducedSeries<M, evidence_order, S>> fill_evidence(Singularity<M, S>& at, const Unknowns<M>& border) {
    at.v = in_digits_of<S>(border);
    auto series = reduced_series<M, evidence_order, S>(at.q, at.v, at.p);
    if (series.regular) {
        at.v = normalized(series.curve[1]);
        series = reduced_series<M, evidence_order, S>(at.q, at.v, at.p);
        for (int k = 3; k <= 8; ++k) at.derivatives[k - 3] = series.derivative(k);
    }
    at.nullity = nullity<M>(to_double(at.q), to_double(at.p), scale_of(at));
    if (!series.regular) return std::nullopt;
    return series;
}

/// Whether phi^(k) is no rounding of 0.
template <PotentialModel M, class S>
bool decides(const Singularity<M, S>& at, int k) {
    double factorial = 1;
    for (int j = 2; j <= k; ++j) factorial *= j;
    return std::abs(to_double(at.derivative(k))) > 1e-6 * factorial * scale_of(at);
}

}  // namespace detail

}  // namespace equilibria
