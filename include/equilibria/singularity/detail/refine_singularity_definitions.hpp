/// \file
/// See singularity/refine_singularity.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

/// The equations of a kind and their derivatives. Unknowns y: q (but on a symmetric branch, whose q is fixed), then the
/// active parameters.
template <class S>
class DefiningSystem {
public:
    /// null: about the unit null vector at q and p.
    DefiningSystem(const ModelFunctions<S>& functions, SingularityKind kind, std::span<const int> active,
                   const RuntimeArray<S>& q, const RuntimeArray<S>& p, const RuntimeArray<double>& null)
        : functions_(&functions), kind_(kind), active_(active.begin(), active.end()), q_(q), p_(p), null_(null),
          n_(functions.unknowns()), moving_(row().symmetric ? 0 : n_), size_(moving_ + static_cast<int>(active.size())),
          jacobian_(size_) {}

    int size() const { return size_; }
    RuntimeArray<S> packed() const {
        RuntimeArray<S> y(size_);
        for (int k = 0; k < moving_; ++k) y[k] = q_[k];
        for (int k = moving_; k < size_; ++k) y[k] = p_[active(k)];
        return y;
    }
    RuntimeArray<S> unknowns(const RuntimeArray<S>& y) const {
        RuntimeArray<S> q = q_;
        for (int i = 0; i < moving_; ++i) q[i] = y[i];
        return q;
    }
    RuntimeArray<S> parameters(const RuntimeArray<S>& y) const {
        RuntimeArray<S> p = p_;
        for (int k = moving_; k < size_; ++k) p[active(k)] = y[k];
        return p;
    }

    /// The equations r and their Jacobian at y; the null vector there borders the next evaluation.
    bool operator()(const RuntimeArray<S>& y, RuntimeArray<S>& r, RuntimeMatrix<S>& jacobian) {
        const auto q = unknowns(y), p = parameters(y);
        left_ = null_;
        if (!functions_->has_potential()) left_ = left_null_vector(rounded_jacobian(*functions_, q, p), null_, false);
        RuntimeArray<double> null(n_);
        for (int first = 0; first < size_; first += directions) {
            const auto f = values(unknowns_over(q, first), parameters_over(p, first), null);
            if (f.size() == 0) return false;
            for (int i = 0; i < size_; ++i) {
                r[i] = f[i].value;
                for (int d = 0; d < directions && first + d < size_; ++d) jacobian[i][first + d] = f[i].derivative[d];
            }
        }
        for (int i = 0; i < size_; ++i)
            for (int j = 0; j < size_; ++j) jacobian_[i][j] = static_cast<double>(jacobian[i][j]);
        null_ = normalized(null);
        return std::isfinite(null_[0]);
    }

    const RuntimeArray<double>& null() const { return null_; }
    double versality() const {
        if (row().symmetric) return detail::versality(jacobian_, 0, {}, {});
        return detail::versality(jacobian_, n_, {null_}, {left_});
    }

private:
    static constexpr int directions = Jet<S>::directions;
    using D = Dual<S, directions>;

    const SingularityClass& row() const { return class_of(kind_); }
    int active(int unknown) const { return active_[static_cast<std::size_t>(unknown - moving_)]; }

    /// q and p, the unknowns number first, first + 1, .. being the independent variables.
    RuntimeArray<D> unknowns_over(const RuntimeArray<S>& q, int first) const {
        RuntimeArray<D> y = in_digits_of<D>(q);
        for (int u = first; u < std::min(moving_, first + directions); ++u) y[u].derivative[u - first] = S(1.0);
        return y;
    }
    RuntimeArray<D> parameters_over(const RuntimeArray<S>& p, int first) const {
        RuntimeArray<D> y = in_digits_of<D>(p);
        for (int u = std::max(moving_, first); u < std::min(size_, first + directions); ++u)
            y[active(u)].derivative[u - first] = S(1.0);
        return y;
    }
    static RuntimeArray<D> lifted(const RuntimeArray<double>& a) {
        RuntimeArray<D> y(a.size());
        for (int i = 0; i < a.size(); ++i) y[i] = D(S(a[i]));
        return y;
    }

    /// The equations at q and p; none where the border is singular. null becomes the null vector there.
    RuntimeArray<D> values(const RuntimeArray<D>& q, const RuntimeArray<D>& p, RuntimeArray<double>& null) const {
        const auto series = reduced_series<S, D>(*functions_, row().order(), q, lifted(null_), lifted(left_), p);
        if (!series.regular) return {};
        RuntimeArray<D> f(size_);
        for (int i = 0; i < moving_; ++i) f[i] = series.force[i];
        for (int j = 1; j <= row().vanishing; ++j)
            f[moving_ + j - 1] = series.gradient[row().symmetric ? 2 * j - 1 : j];
        if (kind_ == SingularityKind::extremal_fold) f[size_ - 1] = dot(series.curve[1], slope_by(active_[1], q, p));
        for (int i = 0; i < n_; ++i) null[i] = static_cast<double>(series.curve[1][i].value);
        return f;
    }
    /// dF/dp_k.
    RuntimeArray<D> slope_by(int k, const RuntimeArray<D>& q, const RuntimeArray<D>& p) const {
        using J = JetOf<S, D>;
        RuntimeArray<Jet<S>> at(q.size()), along(p.size());
        for (int i = 0; i < q.size(); ++i) at[i] = J::constant(q[i]);
        for (int i = 0; i < p.size(); ++i) along[i] = i == k ? J::variable(p[i], D(1.0)) : J::constant(p[i]);
        const auto f = functions_->equations(at, along);
        RuntimeArray<D> y(f.size());
        for (int i = 0; i < f.size(); ++i) y[i] = J::coefficient(f[i], 1);
        return y;
    }

    const ModelFunctions<S>* functions_;
    SingularityKind kind_;
    std::vector<int> active_;
    RuntimeArray<S> q_, p_;
    RuntimeArray<double> null_, left_;
    int n_, moving_, size_;
    RuntimeMatrix<double> jacobian_;
};

/// Whether F and the even coefficients of the reduced gradient vanish, to 1e-9 of the largest coefficient: on a branch
/// that the mirror image leaves as it is.
template <class S>
bool is_symmetric(const ReducedSeries<S>& series, double scale) {
    const double small = 1e-9 * scale;
    bool yes = to_double(largest(series.force)) <= small;
    for (int j = 2; j <= evidence_order; j += 2) yes = yes && std::abs(to_double(series.gradient[j])) <= small;
    return yes;
}

/// Residual, evidence and kind of a point that Newton's method has moved to, whose null vector is about `null`.
template <class S>
void name_by_series(const ModelFunctions<S>& functions, RuntimeSingularity<S>& at, const SingularityClass& row,
                    const RuntimeArray<double>& null) {
    using std::abs;
    const auto series = fill_evidence(functions, at, null);
    if (!series) {
        at.converged = false;
        return;
    }
    at.residual = largest(series->force);
    for (int j = 1; j <= row.order(); j += row.symmetric ? 2 : 1) {
        const S& g = series->gradient[j];
        if (!(abs(g) <= at.residual)) at.residual = abs(g);
    }
    const double scale = scale_of(functions, at);
    const bool decided = at.nullity == 1 && decides(at, row.deciding(), scale);
    if (at.converged && decided && (!row.symmetric || is_symmetric(*series, scale))) at.kind = row.kind;
}

/// The equilibrium of the symmetric branch nearest to q, every angle 0 or pi, to all digits of S.
template <class S>
RuntimeArray<S> nearest_symmetric_branch(const RuntimeArray<double>& q) {
    using std::atan;
    RuntimeArray<S> branch(q.size());
    for (int i = 0; i < branch.size(); ++i) branch[i] = std::cos(q[i]) < 0 ? S(4 * atan(S(1.0))) : S(0.0);
    return branch;
}

/// A point that Newton's method moved to, with the system there.
template <class S>
struct Located {
    RuntimeSingularity<S> at;
    std::optional<DefiningSystem<S>> system;  ///< where the last step was not too large
    RuntimeArray<double> null;                ///< about the null vector, on the side of the one at the start
};

template <class S>
Located<S> located(const ModelFunctions<S>& functions, SingularityKind kind, std::span<const int> active,
                   const RuntimeArray<double>& q, const RuntimeArray<S>& p,
                   const std::optional<RuntimeArray<double>>& v) {
    require_finite(q, "q");
    require_finite(p, "p");
    if (v) require_finite(*v, "v");
    auto at = singularity_at<S>(SingularityKind::undecided, active, in_digits_of<S>(q), p);
    if (class_of(kind).symmetric) at.q = nearest_symmetric_branch<S>(q);
    const auto first = v ? normalized(*v) : null_vector(rounded_jacobian(functions, at.q, p));
    if (v) require_finite(first, "v");

    DefiningSystem<S> system(functions, kind, active, at.q, p, first);
    auto y = system.packed();
    newton_method(y, at, system);
    at.q = system.unknowns(y);
    at.p = system.parameters(y);
    auto null = system.null();
    if (dot(null, first) < 0)
        for (double& x : null) x = -x;
    at.v = in_digits_of<S>(null);
    if (!(at.correction < S(1e3))) return {std::move(at), std::nullopt, null};
    return {std::move(at), std::move(system), null};
}

}  // namespace detail

template <class S>
RuntimeSingularity<S> locate_singularity(const ModelFunctions<S>& functions, SingularityKind kind,
                                         std::span<const int> active, const RuntimeArray<double>& q,
                                         const RuntimeArray<S>& p, const std::optional<RuntimeArray<double>>& v) {
    return detail::located(functions, kind, active, q, p, v).at;
}

template <class S>
RuntimeSingularity<S> refine_singularity(const ModelFunctions<S>& functions, SingularityKind kind,
                                         std::span<const int> active, const RuntimeArray<double>& q,
                                         const RuntimeArray<S>& p, const std::optional<RuntimeArray<double>>& v) {
    auto [at, system, null] = detail::located(functions, kind, active, q, p, v);
    if (!system) return at;
    detail::name_by_series(functions, at, class_of(kind), null);
    at.versality = system->versality();
    if (kind == SingularityKind::extremal_fold) {
        using std::abs;
        const S slope = detail::dot(at.v, parameter_derivatives(functions, at.q, at.p, active[1]).first);
        if (!(abs(slope) <= at.residual)) at.residual = abs(slope);
        at.extremal = active[0];
        at.versality = 0;
    }
    return at;
}

#ifdef EQUILIBRIA_COMPILED
extern template RuntimeSingularity<double> locate_singularity(const ModelFunctions<double>&, SingularityKind,
                                                              std::span<const int>, const RuntimeArray<double>&,
                                                              const RuntimeArray<double>&,
                                                              const std::optional<RuntimeArray<double>>&);
extern template RuntimeSingularity<double> refine_singularity(const ModelFunctions<double>&, SingularityKind,
                                                              std::span<const int>, const RuntimeArray<double>&,
                                                              const RuntimeArray<double>&,
                                                              const std::optional<RuntimeArray<double>>&);
#endif

}  // namespace equilibria
