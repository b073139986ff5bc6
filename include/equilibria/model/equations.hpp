/// \file
/// A model's potential V and its equilibrium equations F(q, p), the gradient of V where there is one, by automatic
/// differentiation of its own function. The unknowns q are the angles in radians, then the plain coordinates.
/// Everything is generic over the scalar S: double, a multiprecision float, a complex number with sin and cos, a dual.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// Angles in radians, then plain coordinates.
template <class M, class S = double>
using Unknowns = Array<S, n_unknowns<M>>;

namespace detail {

/// The unknowns as independent variables, at points of the circles: by angles in radians, then by coordinates.
template <class M, class S>
constexpr void independent_at(const AnglesOf<M, S>& theta, const CoordinatesOf<M, S>& x,
                              AnglesOf<M, Dual<S, n_unknowns<M>>>& angle,
                              CoordinatesOf<M, Dual<S, n_unknowns<M>>>& coordinate) {
    using D = Dual<S, n_unknowns<M>>;
    for (int i = 0; i < theta.size(); ++i) {
        angle[i] = {D(theta[i].c), D(theta[i].s)};
        angle[i].c.derivative[i] = -theta[i].s;
        angle[i].s.derivative[i] = theta[i].c;
    }
    for (int j = 0; j < x.size(); ++j) coordinate[j] = D::variable(x[j], theta.size() + j);
}

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
        independent_at<M, S>(theta, x, angle, coordinate);
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

/// F with J for its derivatives.
template <class M, class S>
Unknowns<M, Dual<S, n_unknowns<M>>> equations_and_slopes(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    using D = Dual<S, n_unknowns<M>>;
    AnglesOf<M, S> theta;
    CoordinatesOf<M, S> x;
    AnglesOf<M, D> angle;
    CoordinatesOf<M, D> coordinate;
    split<M, S>(q, theta, x);
    independent_at<M, S>(theta, x, angle, coordinate);
    if constexpr (std::is_arithmetic_v<S>)
        return equations_at<M, D>(angle, coordinate, p);
    else
        return equations_at<M, D>(angle, coordinate, lifted<M, S, n_unknowns<M>>(p));
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

}  // namespace equilibria
