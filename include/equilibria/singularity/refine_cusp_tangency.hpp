/// \file
/// Lips and beak-to-beak: where a curve of cusps in three parameters x, y, z is tangent to a plane z = const, by
/// Newton's method in Y = (q, v, x, y), z and mu,
///
///     G = (F, J v, (v . v - 1) / 2) = 0,    mu^T dG/dY = 0,    mu . mu = 1.
///
/// The equations say that z is stationary on the surface of folds; its second-order form there names the point. Where
/// it fails: singularity_newton.hpp. Where the third derivative is not 0, or the fourth is 0 (swallowtails, at which
/// the curve turns in z as well), the kind is `undecided`. Sources: Arnold, Catastrophe Theory, chapter 9; Govaerts,
/// Numerical Methods for Bifurcations of Dynamical Equilibria.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/core/taylor.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

/// The cusp near q and p at which the curve of cusps in the parameters number X, Y and Z is tangent to the plane
/// z = const: lips or beak-to-beak, named by the second-order form. v as in refine_singularity. Throws InvalidArgument
/// for arguments that are not finite.
template <PotentialModel M, int X, int Y, int Z, class S = double>
Singularity<M, S> refine_cusp_tangency(const Unknowns<M>& q, const Parameters<M, S>& p,
                                       const std::optional<Unknowns<M>>& v = std::nullopt) {
    // u = (q, v, x, y, z), of which Y is all but z; then mu
    constexpr int n = n_unknowns<M>, rows = 2 * n + 1, unknowns = 2 * n + 3, size = unknowns + rows;
    detail::check_active<M, X, Y, Z>();
    using D = Dual<S, unknowns>;
    using D2 = Dual<D, unknowns>;
    using Series = Taylor<D2, 1>;
    auto at = detail::singularity_at<M, S>(q, p);
    if (v) require_finite(*v, "v");
    const Unknowns<M> null = v ? detail::normalized(*v) : detail::weakest_directions<1, M>(q, detail::to_double(p))[0];
    require_finite(null, "v");
    Array<S, size> y;
    for (int i = 0; i < n; ++i) y[i] = at.q[i], y[n + i] = S(null[i]);
    y[2 * n] = p[X], y[2 * n + 1] = p[Y], y[2 * n + 2] = p[Z];

    const auto surface = [&](const Array<S, size>& now) {
        Array<D2, unknowns> u;
        for (int j = 0; j < unknowns; ++j) {
            u[j] = D2(D::variable(now[j], j));
            u[j].derivative[j] = D(1.0);
        }
        const auto parameters = detail::with_active<M, X, Y, Z>(at.p, u, 2 * n);
        Unknowns<M, Series> along;
        Parameters<M, Series> constant;
        for (int i = 0; i < n; ++i) along[i] = Series::variable(u[i], u[n + i]);
        for (int k = 0; k < constant.size(); ++k) constant[k] = Series(parameters[k]);
        const auto f = equations<M, Series>(along, constant);
        Array<D2, rows> g;
        g[2 * n] = D2(-0.5);
        for (int i = 0; i < n; ++i) {
            g[i] = f[i].coefficient[0];
            g[n + i] = f[i].coefficient[1];
            g[2 * n] = g[2 * n] + 0.5 * u[n + i] * u[n + i];
        }
        return g;
    };
    // the singular values of dG/dY, and of its transpose
    const auto decomposed = [&](const Array<D2, rows>& g, bool transposed) {
        SingularValues::Vector a;
        if (transposed)
            for (int i = 0; i < rows; ++i)
                for (int j = 0; j <= rows; ++j) a.emplace_back(detail::to_double(g[i].value.derivative[j]));
        else
            for (int j = 0; j <= rows; ++j)
                for (int i = 0; i <= rows; ++i)
                    a.emplace_back(i < rows ? detail::to_double(g[i].value.derivative[j]) : 0.0);
        for (const auto& x : a)
            if (!std::isfinite(x.real())) a.assign(a.size(), 0.0);
        return SingularValues(rows + 1, transposed ? rows : rows + 1, std::move(a));
    };
    const auto left = decomposed(surface(y), true).right(rows - 1);
    for (int i = 0; i < rows; ++i) y[unknowns + i] = S(left[static_cast<std::size_t>(i)].real());

    const auto evaluate = [&](const Array<S, size>& now, Array<S, size>& r, detail::SquareArray<S, size>& jacobian) {
        const auto g = surface(now);
        r = Array<S, size>{};
        jacobian = detail::SquareArray<S, size>{};
        const int last = size - 1;
        r[last] = S(-0.5);
        for (int i = 0; i < rows; ++i) {
            const S& mu = now[unknowns + i];
            r[i] = g[i].value.value;
            r[last] = r[last] + 0.5 * mu * mu;
            jacobian[last][unknowns + i] = mu;
            for (int j = 0; j < unknowns; ++j) {
                jacobian[i][j] = g[i].value.derivative[j];
                if (j == unknowns - 1) continue;
                r[rows + j] = r[rows + j] + mu * g[i].value.derivative[j];
                jacobian[rows + j][unknowns + i] = g[i].value.derivative[j];
                for (int k = 0; k < unknowns; ++k)
                    jacobian[rows + j][k] = jacobian[rows + j][k] + mu * g[i].derivative[j].derivative[k];
            }
        }
        return true;
    };
    detail::newton(y, at, evaluate);
    if (!(at.correction < S(1e3))) return at;
    Array<S, size> r;
    detail::SquareArray<S, size> jacobian;
    evaluate(y, r, jacobian);
    at.residual = detail::largest(r);
    Unknowns<M> border;
    for (int i = 0; i < n; ++i) {
        at.q[i] = y[i];
        border[i] = detail::to_double(y[n + i]);
    }
    at.p = detail::with_active<M, X, Y, Z>(p, y, 2 * n);
    if (!detail::fill_evidence(at, detail::normalized(border))) at.converged = false;

    // d2 z [t, t] = -mu^T G_YY[t, t] / mu^T G_z on the kernel of dG/dY
    const auto g = surface(y);
    const auto values = decomposed(g, false);
    const SingularValues::Vector t[] = {values.right(rows), values.right(rows - 1)};
    double slope = 0, form[3] = {};
    for (int i = 0; i < rows; ++i)
        slope += detail::to_double(y[unknowns + i]) * detail::to_double(g[i].value.derivative[unknowns - 1]);
    for (int j = 0; j <= rows; ++j)
        for (int k = 0; k <= rows; ++k) {
            const double entry = detail::to_double(jacobian[rows + j][k]);
            const auto t_j = static_cast<std::size_t>(j), t_k = static_cast<std::size_t>(k);
            form[0] -= t[0][t_j].real() * entry * t[0][t_k].real() / slope;
            form[1] -= t[0][t_j].real() * entry * t[1][t_k].real() / slope;
            form[2] -= t[1][t_j].real() * entry * t[1][t_k].real() / slope;
        }
    const double mean = (form[0] + form[2]) / 2, radius = std::hypot((form[0] - form[2]) / 2, form[1]);
    at.form = {mean - radius, mean + radius};
    const double least = std::min(std::abs(at.form[0]), std::abs(at.form[1]));
    if (at.converged && at.nullity == 1 && !detail::decides(at, 3) && detail::decides(at, 4) &&
        least > 1e-6 * (std::abs(mean) + radius))
        at.kind = at.form[0] * at.form[1] > 0 ? SingularityKind::lips : SingularityKind::beak_to_beak;
    return at;
}

}  // namespace equilibria
