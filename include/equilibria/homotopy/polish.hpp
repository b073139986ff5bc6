/// \file
/// Newton's method at t = 1, on all lanes at once, and the condition number of the Jacobian there.
///
/// The residual is the model's own function, not its polynomial form: what is polished is a solution of the equations
/// that the user wrote. (A system that is data has its polynomials alone.)
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <type_traits>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/path_status.hpp>

namespace equilibria {

namespace detail {

/// H: a homotopy of a system that is data.
template <class H>
class Polisher {
public:
    template <class T>
    using Vector = SizedArray<T, at_run_time>;
    template <class T>
    using Matrix = RuntimeMatrix<T>;

    explicit Polisher(const H& h) : h_(&h), n_(h.sizes().unknowns) {}

    /// What polishing works with; made once for many points.
    template <class R>
    struct Workspace {
        explicit Workspace(const H& h)
            : evaluation(h), first(h.sizes().unknowns, is_pack<R> && h.symmetric()), lu(h.sizes().unknowns),
              f(h.sizes().unknowns), unit(h.sizes().unknowns), size(h.sizes().unknowns), row_sum(h.sizes().unknowns),
              j(h.sizes().unknowns) {}

        /// The one that the trackers use anyway.
        typename H::template Evaluation<R, std::conditional_t<is_pack<R>, R, Complex<R>>> evaluation;
        RuntimeFactorization<R> first;  ///< without pivots in lanes, where the last correction tells how good it was
        PivotedFactorization<R> lu;
        Vector<Complex<R>> f;
        Vector<R> unit, size, row_sum;
        Matrix<Complex<R>> j;
        RuntimePoint<R> next;
    };

    /// Polishes the points q in place, one a lane, by Newton's method: on the polynomials from wherever a tracker
    /// left them, in whatever precision; then, with the last Jacobian, on the system's own equations, whose correction
    /// is rounding where those before were small. Where it is not, again.
    template <class R>
    void run(RuntimePoint<R>& q, PolishedEvidence* evidence, Workspace<R>& with) const {
        for (int round = 0; round < 2; ++round) {
            with.evaluation.target_jacobian(q, with.f, with.j);
            complete(with.j);
            with.first.factor(with.j);
            correct_by(with.first, q, with);
        }
        R last = polish(q, evidence, with);
        for (int round = 0; round < 2; ++round) {
            const auto far = mask_and(last > R{} + 1e-24, last < R{} + 1e-4);
            if (no_lane(far)) break;
            RuntimePoint<R> again = q;
            PolishedEvidence there[LaneTraits<R>::width];
            const R left = polish(again, there, with);
            take_where(far, again, q);
            last = select(far, left, last);
            for (int k = 0; k < LaneTraits<R>::width; ++k)
                if (mask_lane(far, k)) evidence[k] = there[k];
        }
    }

    /// The evidence at the points q as they are.
    template <class R>
    void assess(const RuntimePoint<R>& q, PolishedEvidence* evidence, Workspace<R>& with) const {
        linearize(q, with);
        with.lu.factor(with.j);
        tell(evidence, largest_residual(with.f), R{}, with);
    }

    /// Moves a point near a singular solution by least squares, damped where the equations do not determine it:
    /// singular values of the Jacobian, in the units of unknowns and equations, count from 1e-4 on. Returns the
    /// relative residual there: max_i |F_i(q)| / (size of the terms of F_i).
    double correct_determined(RuntimePoint<double>& q, Workspace<double>& with) const {
        auto& [evaluation, first, lu, f, unit, size, row_sum, j, next] = with;
        const int n = n_;
        Matrix<Complex<double>> normal(n);
        Vector<Complex<double>> d(n);
        linearize(q, with);
        for (int i = 0; i < n; ++i) {
            f[i] = (1 / size[i]) * f[i];
            for (int u = 0; u < n; ++u) j[i][u] = (unit[u] / size[i]) * j[i][u];
        }
        for (int u = 0; u < n; ++u) {
            d[u] = {};
            for (int i = 0; i < n; ++i) d[u] -= conj(j[i][u]) * f[i];
            for (int v = 0; v < n; ++v) {
                normal[u][v] = {u == v ? 1e-8 : 0.0, 0.0};
                for (int i = 0; i < n; ++i) normal[u][v] += conj(j[i][u]) * j[i][v];
            }
        }
        lu.factor(normal);
        lu.solve(d);
        for (int u = 0; u < n; ++u) d[u] = unit[u] * d[u];
        correct(q, d);
        linearize(q, with);
        double y = 0;
        for (int i = 0; i < n; ++i) y = std::max(y, std::sqrt(norm2(f[i])) / size[i]);
        return y;
    }

    /// The system's own equations at q and the Jacobian there, with the units and sizes that they are measured in.
    template <class R>
    void linearize(const RuntimePoint<R>& q, Workspace<R>& with) const {
        evaluate(q, with);
        measure(q, with.j, with.unit, with.size);
    }

private:
    template <class R>
    void evaluate(const RuntimePoint<R>& q, Workspace<R>& with) const {
        with.evaluation.target_jacobian(q, with.f, with.j);
        h_->residual(q, with.f);
        complete(with.j);
    }
    /// f: the system's own equations at q.
    template <class R>
    void evaluate_residual(const RuntimePoint<R>& q, Workspace<R>& with) const {
        if (!h_->has_own_equations()) with.evaluation.target_value(q, with.f);
        h_->residual(q, with.f);
    }
    /// Newton's correction of q, f being the residual there; returns the square of its size. A large one is not
    /// polishing: the point is kept.
    template <class R>
    R correct_by(const auto& factors, RuntimePoint<R>& q, Workspace<R>& with) const {
        R all = R{};
        for (int i = 0; i < n_; ++i) with.f[i] = -with.f[i];
        factors.solve(with.f);
        for (int i = 0; i < n_; ++i) all = all + norm2(with.f[i]);
        const R size = correction_size(q, with.f) + (all - all);  // a NaN stays
        with.next = q;
        correct(with.next, with.f);
        take_where(size < R{} + 1e-4, with.next, q);
        return size;
    }
    /// Newton's method on the polynomials at q; a second correction by the same Jacobian, on the system's own
    /// equations, whose size squared is returned; and the evidence.
    template <class R>
    R polish(RuntimePoint<R>& q, PolishedEvidence* evidence, Workspace<R>& with) const {
        with.evaluation.target_jacobian(q, with.f, with.j);
        complete(with.j);
        measure(q, with.j, with.unit, with.size);
        with.lu.factor(with.j);
        correct_by(with.lu, q, with);
        evaluate_residual(q, with);
        const R residual = largest_residual(with.f);
        const R last = correct_by(with.lu, q, with);
        tell(evidence, residual, last, with);
        return last;
    }
    /// The square of max_i |f_i| / (largest coefficient of F_i).
    template <class R>
    R largest_residual(const Vector<Complex<R>>& f) const {
        R y = R{};
        for (int i = 0; i < n_; ++i) y = lane_max(y, norm2((1 / h_->scale()[index(i)]) * f[i]));
        return y;
    }
    /// residual, last: squared. The condition is that of the Jacobian factored last.
    template <class R>
    void tell(PolishedEvidence* evidence, const R& residual, const R& last, Workspace<R>& with) const {
        const R condition = scaled_condition(with);
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            evidence[k] = {std::sqrt(static_cast<double>(lane(residual, k))), static_cast<double>(lane(condition, k)),
                           std::sqrt(static_cast<double>(lane(last, k)))};
            if (!(evidence[k].condition < 1e300)) evidence[k].condition = 1e300;
        }
    }
    void complete(auto& j) const {
        if (!h_->symmetric()) return;
        const int n = n_;
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
    }
    /// The unit that each unknown's error is measured in, 1 for an angle and 1 + |x| for a coordinate, as in
    /// correction_size; and the size of each equation's terms: the row's sum of |J| times the units, or the equation's
    /// largest coefficient where that is more: measured by itself, a row of rounding errors would look regular.
    template <class R>
    void measure(const RuntimePoint<R>& q, const auto& j, auto& unit, auto& size) const {
        const int n = n_;
        for (int u = 0; u < n; ++u) unit[u] = u < q.c.size() ? R{} + 1.0 : R(1.0 + square_root(unknown_size2(q, u)));
        for (int r = 0; r < n; ++r) size[r] = broadcast<R>(0.0);
        for (int r = 0; r < n; ++r)
            for (int c = h_->symmetric() ? r : 0; c < n; ++c) {
                const R entry = square_root(norm2(j[r][c]));
                size[r] = size[r] + unit[c] * entry;
                if (h_->symmetric() && c > r) size[c] = size[c] + unit[r] * entry;
            }
        for (int r = 0; r < n; ++r) {
            const R least = R{} + h_->scale()[index(r)];
            size[r] = select(size[r] < least, least, size[r]);  // a NaN stays
        }
    }
    /// || E^-1 J^-1 D || in the infinity norm, E and D being the units of the unknowns and the sizes of the equations.
    template <class R>
    R scaled_condition(Workspace<R>& with) const {
        with.lu.sum_inverse(with.size, with.row_sum);
        R largest = broadcast<R>(0.0);
        for (int r = 0; r < n_; ++r) {
            const R sum = with.row_sum[r] / with.unit[r];
            largest = lane_max(sum, largest) + (sum - sum);  // a NaN stays
        }
        return largest;
    }

    /// Of scales, which are an Array or a std::vector.
    static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

    const H* h_;
    int n_;
};

}  // namespace detail
}  // namespace equilibria
