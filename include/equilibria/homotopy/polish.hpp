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
            : evaluation(h), lu(h.sizes().unknowns), f(h.sizes().unknowns), column(h.sizes().unknowns),
              unit(h.sizes().unknowns), size(h.sizes().unknowns), row_sum(h.sizes().unknowns), j(h.sizes().unknowns) {}

        /// The one that the trackers use anyway.
        typename H::template Evaluation<R, std::conditional_t<is_pack<R>, R, Complex<R>>> evaluation;
        PivotedFactorization<R> lu;
        Vector<Complex<R>> f, column;
        Vector<R> unit, size, row_sum;
        Matrix<Complex<R>> j;
        RuntimePoint<R> next;
    };

    /// Polishes the points q in place, one a lane.
    template <class R>
    void run(RuntimePoint<R>& q, PolishedEvidence* evidence, Workspace<R>& with) const {
        auto& [evaluation, lu, f, column, unit, size, row_sum, j, next] = with;
        R last = broadcast<R>(0.0);
        auto asked = mask_not(last < last);  // all
        for (int round = 0; round < 4; ++round) {
            if (round == 3) {  // where there was farther to go, as from single precision
                asked = mask_and(last > R{} + 1e-16, last < R{} + 1e-10);
                if (all_lanes(mask_not(asked))) break;
            }
            evaluate(q, with);
            lu.factor(j);
            for (int i = 0; i < n_; ++i) f[i] = -f[i];
            lu.solve(f);
            last = select(asked, correction_size(q, f), last);
            // a large one is not polishing: keep the point, tell the size
            const auto small = mask_and(asked, last < R{} + 1e-4);
            next = q;
            correct(next, f);
            take_where(small, next, q);
        }
        assess(q, evidence, with);
        for (int k = 0; k < LaneTraits<R>::width; ++k)
            evidence[k].correction = std::sqrt(static_cast<double>(lane(last, k)));
    }

    /// The evidence at the points q as they are.
    template <class R>
    void assess(const RuntimePoint<R>& q, PolishedEvidence* evidence, Workspace<R>& with) const {
        linearize(q, with);
        const R condition = scaled_condition(with);
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            evidence[k] = {0, static_cast<double>(lane(condition, k)), 0};
            for (int i = 0; i < n_; ++i)
                evidence[k].residual =
                    std::max(evidence[k].residual, std::abs(lane(with.f[i], k)) / h_->scale()[index(i)]);
            if (!(evidence[k].condition < 1e300)) evidence[k].condition = 1e300;
        }
    }

    /// Moves a point near a singular solution by least squares, damped where the equations do not determine it:
    /// singular values of the Jacobian, in the units of unknowns and equations, count from 1e-4 on. Returns the
    /// relative residual there: max_i |F_i(q)| / (size of the terms of F_i).
    double correct_determined(RuntimePoint<double>& q, Workspace<double>& with) const {
        auto& [evaluation, lu, f, d, unit, size, row_sum, j, next] = with;
        const int n = n_;
        Matrix<Complex<double>> normal(n);
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
        for (int r = 0; r < n; ++r) {
            R sum = broadcast<R>(0.0);
            for (int c = 0; c < n; ++c) sum = sum + unit[c] * square_root(norm2(j[r][c]));
            const R least = R{} + h_->scale()[index(r)];
            size[r] = select(sum < least, least, sum);  // a NaN stays
        }
    }
    /// || E^-1 J^-1 D || in the infinity norm, E and D being the units of the unknowns and the sizes of the equations.
    template <class R>
    R scaled_condition(Workspace<R>& with) const {
        auto& [evaluation, lu, f, e, unit, size, row_sum, j, next] = with;
        const int n = n_;
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) j[r][c] = (1.0 / size[r]) * j[r][c];
        lu.factor(j);
        for (R& sum : row_sum) sum = broadcast<R>(0.0);
        for (int c = 0; c < n; ++c) {
            for (int r = 0; r < n; ++r) e[r] = {broadcast<R>(r == c ? 1.0 : 0.0), broadcast<R>(0.0)};
            lu.solve(e);
            for (int r = 0; r < n; ++r) row_sum[r] = row_sum[r] + square_root(norm2(e[r]));
        }
        R largest = broadcast<R>(0.0);
        for (int r = 0; r < n; ++r) {
            const R sum = row_sum[r] / unit[r];
            largest = select(largest > sum, largest, sum);  // keeps a NaN
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
