/// \file
/// The equilibrium equations along one direction, reduced to one equation, as a power series: the method of Lyapunov
/// and Schmidt, or the splitting lemma where there is a potential, order by order.
///
/// With unit vectors l and u the curve q(xi) = q + xi l + z(xi), l . z = 0, along which F is a multiple of u,
///
///     F(q(xi), p) = g(xi) u,
///
/// carries all equilibria near q if the bordered matrix is regular, one a zero of g. Where there is a potential u = l,
/// and g = d phi / d xi of the reduced potential phi(xi) = V(q(xi), p). The coefficients follow from
///
///     [ J    -u ] [ z_k ]   [ -(F of the terms below k, coefficient k) ]
///     [ l^T   0 ] [ g_k ] = [  0                                       ]
///
/// whose matrix is factored once. At a degenerate equilibrium with l and u the null vectors of J and of its transpose
/// g_1 = 0, and the first coefficient that is not 0 names the singularity: g_2 fold (A2), g_3 cusp (A3), g_4
/// swallowtail (A4), g_5 butterfly (A5). Which l and u are taken does not matter for that, if the border is regular:
/// others are another coordinate on the same curve of reduced equilibria. The scalar S may be a dual: then the
/// coefficients come with their derivatives. Where it fails: a second null vector makes the bordered matrix singular,
/// and `regular` false. Sources: Golubitsky and Schaeffer, Singularities and Groups in Bifurcation Theory I, chapter
/// VII; Poston and Stewart, Catastrophe Theory and its Applications, 4.5.
#pragma once

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/taylor.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The reduced equation to the order Order; of the reduced potential the derivatives to Order + 1.
template <Model M, int Order, class S = double>
struct ReducedSeries {
    static_assert(Order >= 1, "equilibria: a reduced series has at least the order 1");

    /// g_k: g(xi) = sum g_k xi^k. g_0 = u . F(q, p); the part of F across u is taken off, as by a constant force.
    Array<S, Order + 1> gradient;
    Array<Unknowns<M, S>, Order + 1> curve;  ///< of q(xi); curve[1] is the null vector, with l . v = 1, where g_1 = 0
    Unknowns<M, S> force;                    ///< F(q, p)
    bool regular = false;                    ///< the bordered matrix; else the coefficients from 1 on mean nothing

    /// phi^(k) at xi = 0, for k = 1..Order + 1: the derivative of g of one order less.
    S derivative(int k) const {
        double factorial = 1;
        for (int j = 2; j < k; ++j) factorial *= j;
        return factorial * gradient[k - 1];
    }
};

/// The reduced equation at q along the unit vector l, F being a multiple of the unit vector u. q need not be an
/// equilibrium, nor degenerate.
template <Model M, int Order, class S = double>
ReducedSeries<M, Order, S> reduced_series(const Unknowns<M, S>& q, const Unknowns<M, S>& l, const Unknowns<M, S>& u,
                                          const Parameters<M, S>& p) {
    constexpr int n = n_unknowns<M>;
    using Series = Taylor<S, Order>;
    Unknowns<M, Series> along;
    Parameters<M, Series> constant;
    for (int i = 0; i < n; ++i) along[i] = Series(q[i]);
    for (int k = 0; k < p.size(); ++k) constant[k] = Series(p[k]);

    // J by columns: one instance of the model's function serves all
    Array<Array<S, n + 1>, n + 1> bordered;
    for (int j = 0; j < n; ++j) {
        auto column = along;
        column[j] = Series::variable(q[j]);
        const auto f = equations<M, Series>(column, constant);
        for (int i = 0; i < n; ++i) bordered[i][j] = f[i].coefficient[1];
        bordered[j][n] = -u[j];
        bordered[n][j] = l[j];
    }
    const detail::DenseFactorization<S, n + 1> factors(bordered);

    ReducedSeries<M, Order, S> y;
    y.regular = factors.regular();
    for (int i = 0; i < n; ++i) along[i] = Series::variable(q[i], l[i]);
    for (int k = 1; k <= Order; ++k) {
        const auto f = equations<M, Series>(along, constant);
        if (k == 1)
            for (int i = 0; i < n; ++i) {
                y.force[i] = f[i].coefficient[0];
                y.gradient[0] = y.gradient[0] + u[i] * f[i].coefficient[0];
            }
        if (!y.regular) break;
        Array<S, n + 1> b;
        for (int i = 0; i < n; ++i) b[i] = -f[i].coefficient[k];
        b = factors.solve(b);
        for (int i = 0; i < n; ++i) along[i].coefficient[k] = along[i].coefficient[k] + b[i];
        y.gradient[k] = b[n];
    }
    for (int k = 0; k <= Order; ++k)
        for (int i = 0; i < n; ++i) y.curve[k][i] = along[i].coefficient[k];
    return y;
}

/// The reduced potential at q along the unit vector l.
template <PotentialModel M, int Order, class S = double>
ReducedSeries<M, Order, S> reduced_series(const Unknowns<M, S>& q, const Unknowns<M, S>& l, const Parameters<M, S>& p) {
    return reduced_series<M, Order, S>(q, l, l, p);
}

}  // namespace equilibria
