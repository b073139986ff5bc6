/// \file
/// Folds, cusps, swallowtails and butterflies: the points of the kind A_{k+1} in k parameters, by Newton's method in
///
///     F(q, p) = 0,    g_1 = .. = g_k = 0,
///
/// g the coefficients of the reduced gradient along the null vector, with the border of the last iterate
/// (reduced_series.hpp). Derivatives are duals through that series. Where it fails: singularity_newton.hpp.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8.
#pragma once

#include <cmath>
#include <optional>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

/// The point of the kind A_{k+1} near q and p, k the number of the active parameters: fold (1), cusp (2), swallowtail
/// (3), butterfly (4). v: about the null vector; else the eigenvector of the eigenvalue of least size. Throws
/// InvalidArgument for arguments that are not finite.
template <PotentialModel M, int... Active, class S = double>
Singularity<M, S> refine_singularity(const Unknowns<M>& q, const Parameters<M, S>& p,
                                     const std::optional<Unknowns<M>>& v = std::nullopt) {
    constexpr int n = n_unknowns<M>, k = sizeof...(Active), size = n + k;
    static_assert(k >= 1 && k <= 4, "equilibria: one to four active parameters: fold, cusp, swallowtail, butterfly");
    detail::check_active<M, Active...>();
    using D = Dual<S, size>;
    auto at = detail::singularity_at<M, S>(q, p);
    if (v) require_finite(*v, "v");
    Unknowns<M> border = v ? detail::normalized(*v) : detail::weakest_directions<1, M>(q, detail::to_double(p))[0];
    require_finite(border, "v");
    const Unknowns<M> first = border;
    detail::SquareArray<S, size> last;
    Array<S, size> y;
    int entry = 0;
    for (const S& x : at.q) y[entry++] = x;
    ((y[entry++] = p[Active]), ...);
    detail::newton(y, at, [&](const Array<S, size>& now, Array<S, size>& r, detail::SquareArray<S, size>& jacobian) {
        Array<D, size> variables;
        for (int j = 0; j < size; ++j) variables[j] = D::variable(now[j], j);
        Unknowns<M, D> lifted, l;
        for (int i = 0; i < n; ++i) lifted[i] = variables[i], l[i] = D(S(border[i]));
        const auto series = reduced_series<M, k, D>(lifted, l, detail::with_active<M, Active...>(at.p, variables, n));
        if (!series.regular) return false;
        for (int i = 0; i < size; ++i) {
            const D& f = i < n ? series.force[i] : series.gradient[i - n + 1];
            r[i] = f.value;
            jacobian[i] = f.derivative;
        }
        last = jacobian;
        Unknowns<M> null;
        for (int i = 0; i < n; ++i) null[i] = detail::to_double(series.curve[1][i].value);
        border = detail::normalized(null);
        return std::isfinite(border[0]);
    });
    for (int i = 0; i < n; ++i) at.q[i] = y[i];
    at.p = detail::with_active<M, Active...>(p, y, n);
    if (!(at.correction < S(1e3))) return at;
    if (detail::dot(border, first) < 0)
        for (double& x : border) x = -x;
    if (const auto series = detail::fill_evidence(at, border)) {
        at.residual = detail::largest(series->force);
        for (int j = 1; j <= k; ++j) {
            using std::abs;
            if (!(abs(series->gradient[j]) <= at.residual)) at.residual = abs(series->gradient[j]);
        }
    } else {
        at.converged = false;
    }
    at.versality = detail::versality<n, 1, size>(last, Array<Unknowns<M>, 1>{{border}});
    constexpr SingularityKind kinds[] = {SingularityKind::fold, SingularityKind::cusp, SingularityKind::swallowtail,
                                         SingularityKind::butterfly};
    if (at.converged && at.nullity == 1 && detail::decides(at, k + 2)) at.kind = kinds[k - 1];
    return at;
}

}  // namespace equilibria
