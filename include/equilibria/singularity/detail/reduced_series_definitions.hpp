/// \file
/// See singularity/reduced_series.hpp.
#pragma once

#include <type_traits>

#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/singularity/reduced_series.hpp>

namespace equilibria {

namespace detail {

/// The coefficients as a series of this order, what is missing being 0; T is S or its dual.
template <class S, class T>
class JetOf {
public:
    static Jet<S> constant(const T& value) { return with(Jet<S>(part(value)), 0, value); }
    static Jet<S> variable(const T& value, const T& slope) {
        return with(with(Jet<S>::variable(part(value), part(slope), 1), 0, value), 1, slope);
    }
    /// Of the curve, its coefficients to order - 1 for the unknown i.
    static Jet<S> along(const RuntimeArray<RuntimeArray<T>>& curve, int i, int order) {
        auto y = Jet<S>::variable(S(0.0), S(0.0), order);
        for (int k = 0; k < order; ++k) {
            const T& c = curve[k][i];
            y.set(k, part(c));
            y = with(y, k, c);
        }
        return y;
    }
    static T coefficient(const Jet<S>& a, int k) {
        if constexpr (std::is_same_v<S, T>)
            return a.value(k);
        else
            return a.coefficient(k);
    }

private:
    static const S& part(const T& a) {
        if constexpr (std::is_same_v<S, T>)
            return a;
        else
            return a.value;
    }
    static Jet<S> with(Jet<S> a, int k, const T& c) {
        if constexpr (!std::is_same_v<S, T>) a.move(k, c.derivative);
        return a;
    }
};

/// J(q, p).
template <class S, class T>
RuntimeMatrix<T> jacobian_over(const ModelFunctions<S>& functions, const RuntimeArray<T>& q, const RuntimeArray<T>& p) {
    if constexpr (std::is_same_v<S, T>) {
        return jacobian(functions, q, p);
    } else {
        using J = JetOf<S, T>;
        const int n = functions.unknowns();
        RuntimeArray<Jet<S>> constant(p.size());
        for (int k = 0; k < p.size(); ++k) constant[k] = J::constant(p[k]);
        RuntimeMatrix<T> y(n);
        for (int c = 0; c < n; ++c) {
            RuntimeArray<Jet<S>> column(n);
            for (int i = 0; i < n; ++i) column[i] = J::variable(q[i], T(i == c ? 1.0 : 0.0));
            const auto f = functions.equations(column, constant);
            for (int r = 0; r < n; ++r) y[r][c] = J::coefficient(f[r], 1);
        }
        return y;
    }
}

}  // namespace detail

template <class S, class T>
ReducedSeries<T> reduced_series(const ModelFunctions<S>& functions, int order, const RuntimeArray<T>& q,
                                const RuntimeArray<T>& l, const RuntimeArray<T>& u, const RuntimeArray<T>& p) {
    using J = detail::JetOf<S, T>;
    const int n = functions.unknowns();
    const RuntimeMatrix<T> jacobian = detail::jacobian_over(functions, q, p);
    RuntimeMatrix<T> bordered(n + 1);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) bordered[i][j] = jacobian[i][j];
        bordered[i][n] = -u[i];
        bordered[n][i] = l[i];
    }
    const detail::DenseFactorization<T, at_run_time> factors(bordered);

    ReducedSeries<T> y;
    y.regular = factors.regular();
    y.force = RuntimeArray<T>(n);
    y.gradient = RuntimeArray<T>(order + 1);
    y.curve = RuntimeArray<RuntimeArray<T>>(order + 1);
    for (auto& coefficient : y.curve) coefficient = RuntimeArray<T>(n);
    y.curve[0] = q;
    y.curve[1] = l;
    RuntimeArray<Jet<S>> along(n), constant(p.size());
    for (int k = 0; k < p.size(); ++k) constant[k] = J::constant(p[k]);
    for (int k = 1; k <= order; ++k) {
        // the coefficient k of q(xi) but for z_k, which is not known yet: l, or 0
        for (int i = 0; i < n; ++i) along[i] = k == 1 ? J::variable(q[i], l[i]) : J::along(y.curve, i, k);
        const auto f = functions.equations(along, constant);
        if (k == 1)
            for (int i = 0; i < n; ++i) {
                y.force[i] = J::coefficient(f[i], 0);
                y.gradient[0] = y.gradient[0] + u[i] * y.force[i];
            }
        if (!y.regular) break;
        RuntimeArray<T> b(n + 1);
        for (int i = 0; i < n; ++i) b[i] = -J::coefficient(f[i], k);
        b = factors.solve(b);
        auto& coefficient = y.curve[k];
        for (int i = 0; i < n; ++i) coefficient[i] = coefficient[i] + b[i];
        y.gradient[k] = b[n];
    }
    return y;
}

#ifdef EQUILIBRIA_COMPILED
namespace detail {
using FourDirections = Dual<double, Jet<double>::directions>;
}
extern template ReducedSeries<double> reduced_series(const ModelFunctions<double>&, int, const RuntimeArray<double>&,
                                                     const RuntimeArray<double>&, const RuntimeArray<double>&,
                                                     const RuntimeArray<double>&);
extern template ReducedSeries<detail::FourDirections> reduced_series(const ModelFunctions<double>&, int,
                                                                     const RuntimeArray<detail::FourDirections>&,
                                                                     const RuntimeArray<detail::FourDirections>&,
                                                                     const RuntimeArray<detail::FourDirections>&,
                                                                     const RuntimeArray<detail::FourDirections>&);
#endif

}  // namespace equilibria
