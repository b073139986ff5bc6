/// \file
/// Newton's method at t = 1, on all lanes at once, and the condition number of the Jacobian there.
///
/// The residual is the model's own function, not its polynomial form: what is polished is a solution of the equations
/// that the user wrote. (A system that is data has its polynomials alone.)
#pragma once

#include <algorithm>
#include <complex>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/path_status.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

namespace detail {

template <class H>
class Polisher {
public:
    using M = typename H::System;
    static constexpr int n = n_unknowns<M>;

    explicit Polisher(const H& h) : h_(&h), scale_(h.scale()) {}

    /// Polishes the points q in place, one a lane.
    template <class R>
    void run(Point<M, R>& q, PolishedEvidence* evidence) const {
        using Z = Complex<R>;
        typename H::template Evaluation<R, Time<R>> evaluation(*h_);
        PivotedFactorization<R, n> lu;
        Z f[n], j[n][n];
        R last = broadcast<R>(0.0);
        for (int round = 0; round < 3; ++round) {
            evaluation.jacobian(q, Time<R>{} + 1.0, f, j);
            h_->residual(q, f);
            complete(j);
            lu.factor(j);
            for (Z& entry : f) entry = -entry;
            lu.solve(f);
            last = correction_size(q, f);
            const Point<M, R> next = corrected<M, R>(q, f);
            const auto small = last < R{} + 1e-4;  // otherwise this is not polishing: keep the point, tell the size
            q = select(small, next, q);
        }
        assess(q, evidence);
        for (int k = 0; k < LaneTraits<R>::width; ++k)
            evidence[k].correction = std::sqrt(static_cast<double>(lane(last, k)));
    }

    /// The evidence at the points q as they are.
    template <class R>
    void assess(const Point<M, R>& q, PolishedEvidence* evidence) const {
        typename H::template Evaluation<R, Time<R>> evaluation(*h_);
        Complex<R> f[n], j[n][n];
        evaluation.jacobian(q, Time<R>{} + 1.0, f, j);
        h_->residual(q, f);
        complete(j);
        R unit[n], size[n];
        measure(q, j, unit, size);
        const R condition = scaled_condition(unit, size, j);
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            evidence[k] = {0, static_cast<double>(lane(condition, k)), 0};
            for (int i = 0; i < n; ++i)
                evidence[k].residual = std::max(evidence[k].residual, std::abs(lane(f[i], k)) / scale_[i]);
            if (!(evidence[k].condition < 1e300)) evidence[k].condition = 1e300;
        }
    }

    /// Moves a point near a singular solution by least squares, damped where the equations do not determine it:
    /// singular values of the Jacobian, in the units of unknowns and equations, count from 1e-4 on. Returns the
    /// relative residual there: max_i |F_i(q)| / (size of the terms of F_i).
    double correct_determined(Point<M, double>& q) const {
        Complex<double> f[n], j[n][n], normal[n][n], d[n];
        double unit[n], size[n], y = 0;
        linearize(q, f, j, unit, size);
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
        PivotedFactorization<double, n> lu;
        lu.factor(normal);
        lu.solve(d);
        for (int u = 0; u < n; ++u) d[u] = unit[u] * d[u];
        q = corrected<M, double>(q, d);
        linearize(q, f, j, unit, size);
        for (int i = 0; i < n; ++i) y = std::max(y, std::sqrt(norm2(f[i])) / size[i]);
        return y;
    }

    /// The residual and the Jacobian at q, and the size of each equation's terms there: see `measure`.
    void linearize(const Point<M, double>& q, Complex<double> (&f)[n], Complex<double> (&j)[n][n],
                   double (&size)[n]) const {
        double unit[n];
        linearize(q, f, j, unit, size);
    }

private:
    /// Of the evaluations that the trackers use anyway.
    template <class R>
    using Time = std::conditional_t<is_pack<R>, R, Complex<R>>;

    void linearize(const Point<M, double>& q, Complex<double> (&f)[n], Complex<double> (&j)[n][n], double (&unit)[n],
                   double (&size)[n]) const {
        typename H::template Evaluation<double, Complex<double>> evaluation(*h_);
        evaluation.jacobian(q, Complex<double>(1.0), f, j);
        h_->residual(q, f);
        complete(j);
        measure(q, j, unit, size);
    }
    template <class R>
    static void complete(Complex<R> (&j)[n][n]) {
        if constexpr (H::symmetric)
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
    }
    /// The unit that each unknown's error is measured in, 1 for an angle and 1 + |x| for a coordinate, as in
    /// correction_size; and the size of each equation's terms: the row's sum of |J| times the units, or the equation's
    /// largest coefficient where that is more: measured by itself, a row of rounding errors would look regular.
    template <class R>
    void measure(const Point<M, R>& q, const Complex<R> (&j)[n][n], R (&unit)[n], R (&size)[n]) const {
        for (int u = 0; u < n; ++u) unit[u] = u < n_angles<M> ? R{} + 1.0 : R(1.0 + square_root(unknown_size2(q, u)));
        for (int r = 0; r < n; ++r) {
            R sum = broadcast<R>(0.0);
            for (int c = 0; c < n; ++c) sum = sum + unit[c] * square_root(norm2(j[r][c]));
            const R least = R{} + scale_[r];
            size[r] = select(sum < least, least, sum);  // a NaN stays
        }
    }
    /// || E^-1 J^-1 D || in the infinity norm, E and D being the units of the unknowns and the sizes of the equations.
    template <class R>
    R scaled_condition(const R (&unit)[n], const R (&size)[n], Complex<R> (&j)[n][n]) const {
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) j[r][c] = (1.0 / size[r]) * j[r][c];
        PivotedFactorization<R, n> lu;
        lu.factor(j);
        R row_sum[n];
        for (R& sum : row_sum) sum = broadcast<R>(0.0);
        for (int c = 0; c < n; ++c) {
            Complex<R> e[n];
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

    const H* h_;
    Array<double, n> scale_;
};

}  // namespace detail
}  // namespace equilibria
