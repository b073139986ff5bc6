/// \file
/// Folds, cusps, swallowtails, butterflies (A_{k+1}), pitchforks to the tetracritical one (B_{k+1}) and extremal points
/// of curves of folds, to as many digits as the scalar has, by Newton's method in (q, p_1 .. p_k)
///
///     A_{k+1}: F(q, p) = 0,  g_1 = .. = g_k = 0             extremal: F(q, p) = 0,  g_1 = 0,  v . dF/dp_2 = 0
///
/// and, where F = 0 whatever the parameters, on a branch that the mirror image theta -> -theta leaves as it is, in the
/// parameters alone
///
///     B_{k+1}: g_1 = g_3 = .. = g_{2k-1} = 0,
///
/// g the coefficients of the reduced gradient along the null vector v (reduced_series.hpp), with the border of the last
/// iterate; symmetry makes the even ones 0. Derivatives are duals through that series. Give parameters to all digits of
/// a multiprecision scalar, 3/10 as S(3) / 10.
/// Where it fails: singularity_newton.hpp; and on a branch without the symmetry, where the kind is `undecided`.
/// Sources: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8; Arnold, Gusein-Zade and
/// Varchenko, Singularities of Differentiable Maps I (A_k, B_k).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

/// The equations of a kind and their derivatives. Unknowns y: q (but on a symmetric branch, whose q is fixed), then the
/// active parameters.
template <Model M, SingularityKind Kind, class S, int... Active>
class DefiningSystem {
public:
    static constexpr SingularityClass row = class_of(Kind);
    static constexpr int n = n_unknowns<M>, moving = row.symmetric ? 0 : n;
    static constexpr int size = moving + static_cast<int>(sizeof...(Active));
    using Vector = Array<S, size>;

    /// null: about the unit null vector at q and p.
    DefiningSystem(const Unknowns<M, S>& q, const Parameters<M, S>& p, const Unknowns<M>& null)
        : q_(q), p_(p), null_(null) {}

    Vector packed() const {
        Vector y;
        int k = 0;
        for (; k < moving; ++k) y[k] = q_[k];
        ((y[k++] = p_[Active]), ...);
        return y;
    }
    template <class T>
    Unknowns<M, T> unknowns(const Array<T, size>& y) const {
        Unknowns<M, T> q;
        for (int i = 0; i < n; ++i) {
            if constexpr (row.symmetric)
                q[i] = T(q_[i]);
            else
                q[i] = y[i];
        }
        return q;
    }
    template <class T>
    Parameters<M, T> parameters(const Array<T, size>& y) const {
        return lifted_with_active<Active...>(p_, y, moving);
    }

    /// The equations r and their Jacobian at y; the null vector there borders the next evaluation.
    bool operator()(const Vector& y, Vector& r, SquareArray<S, size>& jacobian) {
        using D = Dual<S, size>;
        const Array<D, size> u = independent(y);
        const auto q = unknowns<D>(u);
        const auto p = parameters<D>(u);
        left_ = PotentialModel<M> ? null_
                                  : left_null_vector<M>(rounded_jacobian<M>(unknowns<S>(y), parameters<S>(y)), null_);
        const auto series = reduced_series<M, row.order(), D>(q, lifted<D>(null_), lifted<D>(left_), p);
        if (!series.regular) return false;
        Array<D, size> f;
        for (int i = 0; i < moving; ++i) f[i] = series.force[i];
        for (int j = 1; j <= row.vanishing; ++j) f[moving + j - 1] = series.gradient[row.symmetric ? 2 * j - 1 : j];
        if constexpr (Kind == SingularityKind::extremal_fold) {
            constexpr int parameter[] = {Active...};
            f[size - 1] = dot(series.curve[1], parameter_derivative<M, D>(q, p, parameter[1]));
        }
        split_duals(f, r, jacobian);
        jacobian_ = jacobian;
        Unknowns<M> null;
        for (int i = 0; i < n; ++i) null[i] = to_double(series.curve[1][i].value);
        null_ = normalized(null);
        return std::isfinite(null_[0]);
    }

    const Unknowns<M>& null() const { return null_; }
    double versality() const {
        if constexpr (row.symmetric) {
            return detail::versality<0, 0, size>(jacobian_, {}, {});
        } else {
            using Border = Array<Unknowns<M>, 1>;
            return detail::versality<n, 1, size>(jacobian_, Border{{null_}}, Border{{left_}});
        }
    }

private:
    template <class D>
    static Unknowns<M, D> lifted(const Unknowns<M>& a) {
        Unknowns<M, D> y;
        for (int i = 0; i < n; ++i) y[i] = D(S(a[i]));
        return y;
    }

    Unknowns<M, S> q_;
    Parameters<M, S> p_;
    Unknowns<M> null_, left_;
    SquareArray<S, size> jacobian_;
};

/// Whether F and the even coefficients of the reduced gradient vanish, to 1e-9 of the largest coefficient: on a branch
/// that the mirror image leaves as it is.
template <Model M, class S>
bool is_symmetric(const Singularity<M, S>& at, const ReducedSeries<M, evidence_order, S>& series) {
    const double small = 1e-9 * scale_of(at);
    bool yes = to_double(largest(series.force)) <= small;
    for (int j = 2; j <= evidence_order; j += 2) yes = yes && std::abs(to_double(series.gradient[j])) <= small;
    return yes;
}

/// Residual, evidence and kind of a point that Newton's method has moved to, whose null vector is about `null`.
template <Model M, class S>
void name_by_series(Singularity<M, S>& at, const SingularityClass& row, const Unknowns<M>& null) {
    using std::abs;
    const auto series = fill_evidence(at, null);
    if (!series) {
        at.converged = false;
        return;
    }
    at.residual = largest(series->force);
    for (int j = 1; j <= row.order(); j += row.symmetric ? 2 : 1)
        if (!(abs(series->gradient[j]) <= at.residual)) at.residual = abs(series->gradient[j]);
    const bool decided = at.nullity == 1 && decides(at, row.deciding());
    if (at.converged && decided && (!row.symmetric || is_symmetric(at, *series))) at.kind = row.kind;
}

/// The equilibrium of the symmetric branch nearest to q, every angle 0 or pi, to all digits of S.
template <Model M, class S>
Unknowns<M, S> nearest_symmetric_branch(const Unknowns<M>& q) {
    using std::atan;
    Unknowns<M, S> branch;
    for (int i = 0; i < branch.size(); ++i) branch[i] = std::cos(q[i]) < 0 ? S(4 * atan(S(1.0))) : S(0.0);
    return branch;
}

}  // namespace detail

/// The singularity of the given kind near q (radians, coordinates) and p, in the parameters number Active.., as many as
/// the table of kinds says: fold and pitchfork one, cusp, tricritical pitchfork and extremal fold two, swallowtail and
/// tetracritical pitchfork three, butterfly four. Of an extremal fold the first one is extremal on the curve of folds
/// in the plane of both. Pitchforks are sought on the symmetric branch nearest to q, every angle 0 or pi, which must be
/// one of equilibria. v: about the null vector, of any length; else what J shortens most.
///
/// The result is of the kind if it says so; else `undecided`, `converged` or not. Throws InvalidArgument for arguments
/// that are not finite. Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8.
template <Model M, SingularityKind Kind, int... Active, class S = double>
Singularity<M, S> refine_singularity(const Unknowns<M>& q, const Parameters<M, S>& p,
                                     const std::optional<Unknowns<M>>& v = std::nullopt) {
    constexpr SingularityClass row = class_of(Kind);
    static_assert(row.by_series(),
                  "equilibria: umbilics, lips and beak-to-beak have a refinement of their own, "
                  "refine_umbilic and refine_cusp_tangency; other kinds none");
    static_assert(sizeof...(Active) == static_cast<std::size_t>(row.parameters),
                  "equilibria: this kind of singularity has another number of active parameters");
    static_assert(!row.symmetric || n_coordinates<M> == 0, "equilibria: symmetric branches are those of angles alone");
    static_assert(Kind != SingularityKind::extremal_fold || PotentialModel<M>,
                  "equilibria: extremal points are refined for models with a potential");
    require_finite(q, "q");
    require_finite(p, "p");
    if (v) require_finite(*v, "v");
    auto at = singularity_at<M, Active...>(SingularityKind::undecided, detail::in_digits_of<S>(q), p);
    if constexpr (row.symmetric) at.q = detail::nearest_symmetric_branch<M, S>(q);
    const Unknowns<M> first = v ? detail::normalized(*v) : null_vector<M>(detail::rounded_jacobian<M>(at.q, p));
    if (v) require_finite(first, "v");

    detail::DefiningSystem<M, Kind, S, Active...> system(at.q, p, first);
    auto y = system.packed();
    detail::newton(y, at, system);
    at.q = system.template unknowns<S>(y);
    at.p = system.template parameters<S>(y);
    if (!(at.correction < S(1e3))) return at;
    Unknowns<M> null = system.null();
    if (detail::dot(null, first) < 0)
        for (double& x : null) x = -x;
    detail::name_by_series(at, row, null);
    at.versality = system.versality();
    if constexpr (Kind == SingularityKind::extremal_fold) {
        using std::abs;
        constexpr int parameter[] = {Active...};
        const S slope = detail::dot(at.v, parameter_derivative<M, S>(at.q, at.p, parameter[1]));
        if (!(abs(slope) <= at.residual)) at.residual = abs(slope);
        at.extremal = parameter[0];
        at.versality = 0;
    }
    return at;
}

}  // namespace equilibria
