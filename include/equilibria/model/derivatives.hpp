/// \file
/// Exact derivatives of a model's equations F(q, p) (equations.hpp), by automatic differentiation of its own function:
/// J = dF/dq (the Hessian of V, where there is a potential), and higher ones. Everything is generic over the scalar S:
/// double, a multiprecision float, a complex number with sin and cos, a dual.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// n x n, by unknowns: angles, then coordinates.
template <class M, class S = double>
using UnknownMatrix = Eigen::Matrix<S, n_unknowns<M>, n_unknowns<M>>;

/// J(q, p) = dF/dq, n x n: the Hessian of the potential where there is one.
template <Model M, class S = double>
UnknownMatrix<M, S> jacobian(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    constexpr int n = n_unknowns<M>;
    const auto f = equations<M, Dual<S, n>>(detail::variables<M, S>(q), detail::lifted<M, S, n>(p));
    UnknownMatrix<M, S> j;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) j(r, c) = f[r].derivative[c];
    return j;
}

/// dF/dp_k, one entry an unknown.
template <Model M, class S = double>
Unknowns<M, S> parameter_derivative(const Unknowns<M, S>& q, const Parameters<M, S>& p, int k) {
    Unknowns<M, Dual<S, 1>> y;
    for (int i = 0; i < q.size(); ++i) y[i] = q[i];
    auto lifted = detail::lifted<M, S, 1>(p);
    lifted[k].derivative[0] = S(1.0);
    const auto f = equations<M, Dual<S, 1>>(y, lifted);
    Unknowns<M, S> d;
    for (int i = 0; i < q.size(); ++i) d[i] = f[i].derivative[0];
    return d;
}

/// Derivatives of F along one direction v of the unknowns and one direction w of the parameters:
/// d^k/de^k F(q + e v, p + e w) at e = 0, for k = Order.
template <int Order, Model M, class S = double>
Unknowns<M, S> directional_derivative(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p,
                                      const Parameters<M, S>& w = Parameters<M, S>()) {
    if constexpr (Order == 0) {
        return equations<M, S>(q, p);
    } else {
        using D = Dual<S, 1>;
        Unknowns<M, D> y, z;
        Parameters<M, D> r, u;
        for (int i = 0; i < q.size(); ++i) y[i] = q[i], y[i].derivative[0] = v[i], z[i] = v[i];
        for (int k = 0; k < p.size(); ++k) r[k] = p[k], r[k].derivative[0] = w[k], u[k] = w[k];
        const auto f = directional_derivative<Order - 1, M, D>(y, z, r, u);
        Unknowns<M, S> d;
        for (int i = 0; i < q.size(); ++i) d[i] = f[i].derivative[0];
        return d;
    }
}

/// F'' contracted with v: the n x n matrix d/de J(q + e v, p). With a potential, V'''[v, ., .].
template <Model M, class S = double>
UnknownMatrix<M, S> jacobian_derivative(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    using D = Dual<S, 1>;
    Unknowns<M, D> y;
    for (int i = 0; i < q.size(); ++i) y[i] = q[i], y[i].derivative[0] = v[i];
    const UnknownMatrix<M, D> j = jacobian<M, D>(y, detail::lifted<M, S, 1>(p));
    return j.unaryExpr([](const D& d) { return d.derivative[0]; });
}

/// dJ/dp_k, n x n.
template <Model M, class S = double>
UnknownMatrix<M, S> jacobian_parameter_derivative(const Unknowns<M, S>& q, const Parameters<M, S>& p, int k) {
    using D = Dual<S, 1>;
    Unknowns<M, D> y;
    for (int i = 0; i < q.size(); ++i) y[i] = q[i];
    auto lifted = detail::lifted<M, S, 1>(p);
    lifted[k].derivative[0] = S(1.0);
    const UnknownMatrix<M, D> j = jacobian<M, D>(y, lifted);
    return j.unaryExpr([](const D& d) { return d.derivative[0]; });
}

/// V'''[v, v, v] and V''''[v, v, v, v], the third and fourth directional derivatives of the potential.
/// \{
template <PotentialModel M, class S = double>
S third_derivative(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    const auto f = directional_derivative<2, M, S>(q, v, p);
    S sum(0.0);
    for (int i = 0; i < v.size(); ++i) sum = sum + f[i] * v[i];
    return sum;
}
template <PotentialModel M, class S = double>
S fourth_derivative(const Unknowns<M, S>& q, const Unknowns<M, S>& v, const Parameters<M, S>& p) {
    const auto f = directional_derivative<3, M, S>(q, v, p);
    S sum(0.0);
    for (int i = 0; i < v.size(); ++i) sum = sum + f[i] * v[i];
    return sum;
}
/// \}

}  // namespace equilibria
