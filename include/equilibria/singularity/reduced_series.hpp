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
/// others are another coordinate on the same curve of reduced equilibria. Scalars may be duals: then the coefficients
/// come with their derivatives. Where it fails: a second null vector makes the bordered matrix singular, and `regular`
/// false. Sources: Golubitsky and Schaeffer, Singularities and Groups in Bifurcation Theory I, chapter VII; Poston and
/// Stewart, Catastrophe Theory and its Applications, 4.5.
#pragma once

#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/jet.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/model_functions.hpp>

namespace equilibria {

/// The reduced equation to some order; of the reduced potential the derivatives to one order more. T: the scalar of the
/// model's functions, or a dual over it.
template <class T>
struct ReducedSeries {
    /// g_k: g(xi) = sum g_k xi^k. g_0 = u . F(q, p); the part of F across u is taken off, as by a constant force.
    RuntimeArray<T> gradient;
    RuntimeArray<RuntimeArray<T>> curve;  ///< of q(xi); curve[1] is the null vector, with l . v = 1, where g_1 = 0
    RuntimeArray<T> force;                ///< F(q, p)
    bool regular = false;                 ///< the bordered matrix; else the coefficients from 1 on mean nothing

    /// phi^(k) at xi = 0, for k = 1 .. order + 1: the derivative of g of one order less.
    T derivative(int k) const {
        double factorial = 1;
        for (int j = 2; j < k; ++j) factorial *= j;
        return factorial * gradient[k - 1];
    }
};

/// The reduced equation at q along the unit vector l, F being a multiple of the unit vector u. q need not be an
/// equilibrium, nor degenerate. order: 1 to Jet's highest. T: S, or its dual along Jet's directions.
template <class S, class T>
ReducedSeries<T> reduced_series(const ModelFunctions<S>& functions, int order, const RuntimeArray<T>& q,
                                const RuntimeArray<T>& l, const RuntimeArray<T>& u, const RuntimeArray<T>& p);

/// The same of a model.
template <Model M, int Order, class S = double>
ReducedSeries<S> reduced_series(const Unknowns<M, S>& q, const Unknowns<M, S>& l, const Unknowns<M, S>& u,
                                const Parameters<M, S>& p) {
    static_assert(Order >= 1 && Order <= Jet<S>::highest, "equilibria: a reduced series has an order of 1 to 7");
    return reduced_series(functions_of<M, S>(), Order, runtime_array(q), runtime_array(l), runtime_array(u),
                          runtime_array(p));
}
/// The reduced potential at q along the unit vector l.
template <PotentialModel M, int Order, class S = double>
ReducedSeries<S> reduced_series(const Unknowns<M, S>& q, const Unknowns<M, S>& l, const Parameters<M, S>& p) {
    return reduced_series<M, Order, S>(q, l, l, p);
}

}  // namespace equilibria

#include <equilibria/singularity/detail/reduced_series_definitions.hpp>
