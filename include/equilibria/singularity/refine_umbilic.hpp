/// \file
/// Umbilics, the points of corank 2 in three parameters, by Newton's method in
///
///     F(q, p) = 0,    C = 0,    J X = W C,    W^T X = I,
///
/// where the reduced 2 x 2 Hessian C is that of the bordering by an orthonormal basis W of the weakest plane. What
/// names them is the cubic of the potential on the null space. Where it fails: singularity_newton.hpp.
/// Source: Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (D_4).
#pragma once

#include <cmath>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

/// The discriminant of a x^3 + 3 b x^2 y + 3 c x y^2 + d y^3, over 27 and the rotation-invariant norm^4.
template <class S>
double cubic_discriminant(const Array<S, 4>& cubic) {
    const auto [a, b, c, d] = to_double(cubic).elements;
    const double square = a * a + 3 * b * b + 3 * c * c + d * d;
    if (!(square > 0)) return 0;
    return (3 * b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - a * a * d * d + 6 * a * b * c * d) /
           (square * square);
}

}  // namespace detail

/// The umbilic near q and p, corank 2, in the parameters number X, Y and Z; named by the discriminant of its cubic.
/// Throws InvalidArgument for arguments that are not finite.
template <PotentialModel M, int X, int Y, int Z, class S = double>
requires(n_unknowns<M> >= 2) Singularity<M, S> refine_umbilic(const Unknowns<M>& q, const Parameters<M, S>& p) {
    constexpr int n = n_unknowns<M>, size = n + 3;
    detail::check_active<M, X, Y, Z>();
    using D = Dual<S, size>;
    auto at = detail::singularity_at<M, S>(q, p);
    Array<Unknowns<M, S>, 2> w;
    const auto weakest = detail::weakest_directions<2, M>(q, detail::to_double(p));
    for (int c = 0; c < 2; ++c) w[c] = detail::in_digits_of<S>(weakest[c]);
    detail::SquareArray<S, size> last;
    Array<S, size> y;
    for (int i = 0; i < n; ++i) y[i] = at.q[i];
    y[n] = p[X], y[n + 1] = p[Y], y[n + 2] = p[Z];
    const auto evaluate = [&](const Array<S, size>& now, Array<S, size>& r, detail::SquareArray<S, size>& jacobian) {
        Array<D, size> variables;
        for (int j = 0; j < size; ++j) variables[j] = D::variable(now[j], j);
        Unknowns<M, D> lifted;
        for (int i = 0; i < n; ++i) lifted[i] = variables[i];
        const auto parameters = detail::with_active<M, X, Y, Z>(at.p, variables, n);
        const auto force = equations<M, D>(lifted, parameters);
        const auto hessian = equilibria::jacobian<M, D>(lifted, parameters);
        detail::SquareArray<D, n + 2> bordered;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) bordered[i][j] = hessian(i, j);
            for (int c = 0; c < 2; ++c) bordered[i][n + c] = D(-w[c][i]), bordered[n + c][i] = D(w[c][i]);
        }
        const detail::DenseFactorization<D, n + 2> factors(bordered);
        if (!factors.regular()) return false;
        Array<D, n + 2> solution[2];
        for (int c = 0; c < 2; ++c) {
            solution[c][n + c] = D(1.0);
            solution[c] = factors.solve(solution[c]);
        }
        const D* conditions[] = {&solution[0][n], &solution[1][n], &solution[1][n + 1]};
        for (int i = 0; i < size; ++i) {
            const D& f = i < n ? force[i] : *conditions[i - n];
            r[i] = f.value;
            jacobian[i] = f.derivative;
        }
        last = jacobian;
        for (int c = 0; c < 2; ++c)
            for (int i = 0; i < n; ++i) w[c][i] = solution[c][i].value;
        w[0] = detail::normalized(w[0]);
        const S along = detail::dot(w[0], w[1]);
        for (int i = 0; i < n; ++i) w[1][i] = w[1][i] - along * w[0][i];
        w[1] = detail::normalized(w[1]);
        return true;
    };
    detail::newton(y, at, evaluate);
    if (!(at.correction < S(1e3))) return at;
    Array<S, size> r;
    detail::SquareArray<S, size> jacobian;
    if (!evaluate(y, r, jacobian)) at.converged = false;
    at.residual = detail::largest(r);
    for (int i = 0; i < n; ++i) at.q[i] = y[i];
    at.p = detail::with_active<M, X, Y, Z>(p, y, n);
    at.v = w[0];
    at.w = w[1];
    const auto second_v = directional_derivative<2, M, S>(at.q, at.v, at.p);
    const auto second_w = directional_derivative<2, M, S>(at.q, at.w, at.p);
    at.cubic = {detail::dot(second_v, at.v), detail::dot(second_v, at.w), detail::dot(second_w, at.v),
                detail::dot(second_w, at.w)};
    at.discriminant = detail::cubic_discriminant(at.cubic);
    const double cubic = detail::to_double(detail::largest(at.cubic));
    at.nullity = detail::nullity<M>(detail::to_double(at.q), detail::to_double(at.p), cubic);
    Array<Unknowns<M>, 2> plane;
    for (int c = 0; c < 2; ++c) plane[c] = detail::to_double(w[c]);
    at.versality = detail::versality<n, 2, size>(last, plane);
    if (at.converged && at.nullity == 2 && std::abs(at.discriminant) > 1e-8)
        at.kind = at.discriminant > 0 ? SingularityKind::elliptic_umbilic : SingularityKind::hyperbolic_umbilic;
    return at;
}

}  // namespace equilibria
