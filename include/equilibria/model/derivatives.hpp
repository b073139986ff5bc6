/// \file
/// Exact derivatives of a model, by automatic differentiation of its own function. The unknowns q are the angles in
/// radians, then the plain coordinates; F(q, p) are the equilibrium equations (the gradient of the potential V where
/// there is one), J = dF/dq (then the Hessian of V). Everything is generic over the scalar S: double, a multiprecision
/// float, a complex number with sin and cos, a dual.
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

template <class M, class S = double>
using Unknowns = Array<S, n_unknowns<M>>;
template <class M, class S = double>
using UnknownMatrix = Eigen::Matrix<S, n_unknowns<M>, n_unknowns<M>>;

namespace detail {

/// The model's equations at points of the circles: the residual the trackers polish with.
/// theta: points (c, s); x: coordinates; the result has one entry an unknown.
template <class M, class S, class P>
constexpr Unknowns<M, S> equations_at(const AnglesOf<M, S>& theta, const CoordinatesOf<M, S>& x, const P& p) {
    constexpr int n = n_unknowns<M>;
    Unknowns<M, S> f;
    if constexpr (PotentialModel<M>) {
        using D = Dual<S, n>;
        AnglesOf<M, D> angle;
        CoordinatesOf<M, D> coordinate;
        for (int i = 0; i < theta.size(); ++i) {
            angle[i] = {D(theta[i].c), D(theta[i].s)};
            angle[i].c.derivative[i] = -theta[i].s;
            angle[i].s.derivative[i] = theta[i].c;
        }
        for (int j = 0; j < x.size(); ++j) coordinate[j] = D::variable(x[j], theta.size() + j);
        const D v = call_potential(M{}, angle, coordinate, p);
        f = v.derivative;
    } else {
        const auto values = call_equations(M{}, theta, x, p);
        for (int i = 0; i < n; ++i) f[i] = S(values[static_cast<std::size_t>(i)]);
    }
    return f;
}

template <class M, class S>
void split(const Unknowns<M, S>& q, AnglesOf<M, S>& theta, CoordinatesOf<M, S>& x) {
    using std::cos, std::sin;
    for (int i = 0; i < theta.size(); ++i) theta[i] = {S(cos(q[i])), S(sin(q[i]))};
    for (int j = 0; j < x.size(); ++j) x[j] = q[theta.size() + j];
}

template <class M, class S, int N>
Parameters<M, Dual<S, N>> lifted(const Parameters<M, S>& p) {
    Parameters<M, Dual<S, N>> y;
    for (int k = 0; k < p.size(); ++k) y[k] = p[k];
    return y;
}

/// The unknowns as independent variables.
template <class M, class S>
Unknowns<M, Dual<S, n_unknowns<M>>> variables(const Unknowns<M, S>& q) {
    Unknowns<M, Dual<S, n_unknowns<M>>> y;
    for (int i = 0; i < q.size(); ++i) y[i] = Dual<S, n_unknowns<M>>::variable(q[i], i);
    return y;
}
template <class M, class S, int N>
Unknowns<M, Dual<S, N>> constants(const Unknowns<M, S>& q) {
    Unknowns<M, Dual<S, N>> y;
    for (int i = 0; i < q.size(); ++i) y[i] = q[i];
    return y;
}

}  // namespace detail

/// V(q, p).
template <PotentialModel M, class S = double>
S potential(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    detail::AnglesOf<M, S> theta;
    detail::CoordinatesOf<M, S> x;
    detail::split<M, S>(q, theta, x);
    return S(detail::call_potential(M{}, theta, x, p));
}

/// F(q, p): the equilibrium equations, one entry an unknown.
template <Model M, class S = double>
Unknowns<M, S> equations(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    detail::AnglesOf<M, S> theta;
    detail::CoordinatesOf<M, S> x;
    detail::split<M, S>(q, theta, x);
    return detail::equations_at<M, S>(theta, x, p);
}

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

}  // namespace equilibria
