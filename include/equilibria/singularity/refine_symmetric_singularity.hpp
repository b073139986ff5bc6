/// \file
/// Pitchforks of symmetric branches, and the points at which they degenerate: the kind B_{k+1} in k parameters, by
/// Newton's method in the parameters alone,
///
///     g_1 = g_3 = .. = g_{2k-1} = 0,
///
/// g the coefficients of the reduced gradient along the null vector, of which symmetry makes the even ones 0; on a
/// symmetric branch F = 0 whatever the parameters. Where it fails: singularity_newton.hpp; and for models without the
/// symmetry, where the kind is `undecided`.
/// Source: Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (B_k).
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

/// The pitchfork (one active parameter), tricritical (two) or tetracritical pitchfork (three) near p, on the symmetric
/// branch nearest to q: every angle 0 or pi. For models with the symmetry theta -> -theta at these parameters; else
/// `undecided`. v as in refine_singularity. Throws InvalidArgument for arguments that are not finite.
template <PotentialModel M, int... Active, class S = double>
requires(n_coordinates<M> ==
         0) Singularity<M, S> refine_symmetric_singularity(const Unknowns<M>& q, const Parameters<M, S>& p,
                                                           const std::optional<Unknowns<M>>& v = std::nullopt) {
    constexpr int n = n_unknowns<M>, k = sizeof...(Active), order = 2 * k - 1;
    static_assert(k >= 1 && k <= 3, "equilibria: one to three active parameters: pitchfork, tri-, tetracritical");
    detail::check_active<M, Active...>();
    using D = Dual<S, k>;
    using std::abs, std::atan;
    auto at = detail::singularity_at<M, S>(q, p);
    Unknowns<M> branch;
    for (int i = 0; i < n; ++i) {
        at.q[i] = std::cos(q[i]) < 0 ? S(4 * atan(S(1.0))) : S(0.0);
        branch[i] = detail::to_double(at.q[i]);
    }
    if (v) require_finite(*v, "v");
    Unknowns<M> border = v ? detail::normalized(*v) : detail::weakest_directions<1, M>(branch, detail::to_double(p))[0];
    require_finite(border, "v");
    detail::SquareArray<S, k> last;
    Array<S, k> y;
    int entry = 0;
    ((y[entry++] = p[Active]), ...);
    detail::newton(y, at, [&](const Array<S, k>& now, Array<S, k>& r, detail::SquareArray<S, k>& jacobian) {
        Array<D, k> variables;
        for (int j = 0; j < k; ++j) variables[j] = D::variable(now[j], j);
        Unknowns<M, D> lifted, l;
        for (int i = 0; i < n; ++i) lifted[i] = D(at.q[i]), l[i] = D(S(border[i]));
        const auto series =
            reduced_series<M, order, D>(lifted, l, detail::with_active<M, Active...>(at.p, variables, 0));
        if (!series.regular) return false;
        for (int j = 0; j < k; ++j) {
            r[j] = series.gradient[2 * j + 1].value;
            jacobian[j] = series.gradient[2 * j + 1].derivative;
        }
        last = jacobian;
        Unknowns<M> null;
        for (int i = 0; i < n; ++i) null[i] = detail::to_double(series.curve[1][i].value);
        border = detail::normalized(null);
        return std::isfinite(border[0]);
    });
    at.p = detail::with_active<M, Active...>(p, y, 0);
    if (!(at.correction < S(1e3))) return at;
    bool symmetric = false;
    if (const auto series = detail::fill_evidence(at, border)) {
        at.residual = detail::largest(series->force);
        const double scale = detail::scale_of(at);
        symmetric = detail::to_double(at.residual) <= 1e-9 * scale;
        for (int j = 1; j <= detail::evidence_order; ++j) {
            if (j % 2 == 0) symmetric = symmetric && std::abs(detail::to_double(series->gradient[j])) <= 1e-9 * scale;
            if (j % 2 == 1 && j <= order && !(abs(series->gradient[j]) <= at.residual))
                at.residual = abs(series->gradient[j]);
        }
    } else {
        at.converged = false;
    }
    at.versality = detail::versality<0, 0, k>(last, Array<Array<double, 0>, 0>{});
    constexpr SingularityKind kinds[] = {SingularityKind::pitchfork, SingularityKind::tricritical_pitchfork,
                                         SingularityKind::tetracritical_pitchfork};
    if (at.converged && symmetric && at.nullity == 1 && detail::decides(at, 2 * k + 2)) at.kind = kinds[k - 1];
    return at;
}

}  // namespace equilibria
