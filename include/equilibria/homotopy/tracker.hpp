/// \file
/// Predictor, corrector and step control, on all lanes of a pack at once; one lane (a scalar type) is the same code.
///
/// Predictor: Taylor coefficients q_1, q_2, q_3 of the path from one factorisation of the Jacobian, then a Pade(2,1)
/// approximant an unknown; local order 4. Corrector: one Newton step and one simplified step with the same
/// factorisation; their quotient Theta = |second| / |first| is half of Newton's Lipschitz figure times the error of
/// the prediction. A prediction is taken only if Theta is far below 1, that is, if it is an approximate zero of this
/// path; that is what keeps a path from jumping to its neighbour. Step: what makes Theta its target (Theta grows with
/// the fourth power of the step), and at most a part of the distance to the nearest pole of the path, |q_2| / |q_3|.
/// Sources: Timme, Mixed precision path tracking for polynomial homotopy continuation; Telen, Van Barel, Verschelde,
/// A robust numerical path tracking algorithm.
///
/// Where it fails: at singular points of the path; t = 1 is left to the endgame.
#pragma once

#include <cmath>
#include <type_traits>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/path_status.hpp>
#include <equilibria/homotopy/tracker_options.hpp>

namespace equilibria {

namespace detail {

/// One predictor-corrector step for all lanes. The driver owns t, the refilling of lanes and the end of paths.
///
/// H: a homotopy. Time: R, and the path runs along the reals; or Complex<R>, and it runs along the segment t = origin +
/// tau direction.
template <class H, class R, class Time = R, bool Pivoted = !H::symmetric>
class Stepper {
public:
    using M = typename H::System;
    using Z = Complex<R>;
    using Mask = typename LaneTraits<R>::Mask;
    static constexpr int n = n_unknowns<M>;
    using Factorization = std::conditional_t<Pivoted, PivotedFactorization<R, n>, SymmetricFactorization<R, n>>;

    Stepper(const H& h, const TrackerOptions& options)
        : options_(options), evaluation_(h), origin_(Time{}), direction_(Time{} + 1.0) {}

    /// The segment that tau in [0, 1] runs along.
    void set_segment(const Time& origin, const Time& direction) {
        origin_ = origin;
        direction_ = direction;
    }

    /// Newton corrections up to this size are no cause for concern: they may be rounding.
    void set_noise(const R& size) { noise2_ = size * size; }

    struct Outcome {
        Point<M, R> q;  ///< the corrected point at tau + h
        Mask accepted;
        R next_step;  ///< what the step control proposes, from this point if accepted, else again from the old one
        R step;       ///< the step that was tried: at most the one asked for
    };

    /// Taylor coefficients at (q, tau), which is first corrected by one Newton step for free.
    void expand(Point<M, R>& q, const R& tau) {
        Z f[n], j[n][n];
        evaluation_.jacobian(q, time(tau), f, j);
        complete(j);
        lu_.factor(j);
        for (Z& entry : f) entry = -entry;
        lu_.solve(f);
        rounding2_ = lane_min(16.0 * correction_size(q, f), noise2_);
        q = corrected<M, R>(q, f);
        evaluation_.taylor_right_side(1, taylor_[0]);
        for (Z& entry : taylor_[0]) entry = scaled(entry);
        solve_order(1);
        evaluation_.taylor_right_side(2, taylor_[1]);
        for (Z& entry : taylor_[1]) entry = scaled(scaled(entry));
        solve_order(2);
        evaluation_.taylor_right_side(3, taylor_[2]);
        for (Z& entry : taylor_[2]) entry = scaled(scaled(scaled(entry)));
        lu_.solve(taylor_[2]);
        find_pole(q);
    }

    /// A first step for a new path, from its Taylor coefficients.
    R first_step() const { return lane_min(R{} + 0.1, options_.pole_fraction * pole_); }

    /// Predicts and corrects from (q, tau), after `expand`, with a step of at most h.
    Outcome step(const Point<M, R>& q, const R& tau, const R& h_asked) {
        Outcome y;
        // NaN in pole_ must not pass: the comparison is false for it and leaves a NaN step, which is refused below
        const R limit = options_.pole_fraction * pole_;
        const R h = y.step = select(h_asked < limit, h_asked, limit);
        Z d[n];
        R turn = broadcast<R>(0.0);
        for (int u = 0; u < n; ++u) {
            d[u] = predicted(u, h);
            if (u < n_angles<M>) turn = lane_max(turn, norm2(d[u]));
        }
        const R largest = options_.largest_turn * options_.largest_turn + R{};
        const Mask short_enough = turn < largest;
        y.q = moved<M, R>(q, d);
        Z f[n], j[n][n];
        evaluation_.jacobian(y.q, time(tau + h), f, j);
        complete(j);
        lu_.factor(j);
        for (Z& entry : f) entry = -entry;
        lu_.solve(f);
        const R first = correction_size(y.q, f);
        y.q = corrected<M, R>(y.q, f);
        evaluation_.value(y.q, time(tau + h), f);
        for (Z& entry : f) entry = -entry;
        lu_.solve(f);
        // what the third correction at the last point still changed is rounding: far out it would look like a bad step
        const R second = lane_max(correction_size(y.q, f) - rounding2_, R{});
        y.q = corrected<M, R>(y.q, f);
        // Theta^2; a first correction below the noise is no cause for concern, and its quotient may be rounding
        const R theta2 = second / (first + noise2_);
        const R most = options_.largest_contraction * options_.largest_contraction + R{};
        const R largest_first = R{} + 1e-2;
        y.accepted = both(both(short_enough, theta2 < most), first < largest_first);
        // h (target / Theta)^(1/4), between a quarter and four times h
        const R growth =
            square_root(square_root(square_root((options_.contraction * options_.contraction) / (theta2 + 1e-30))));
        R proposed = h * lane_min(lane_max(growth, R{} + 0.25), R{} + 4.0);
        const R turn_limit = h * (0.8 * options_.largest_turn) / square_root(turn + 1e-30);
        proposed = lane_min(proposed, lane_max(turn_limit, 0.25 * h));
        y.next_step = select(y.accepted, proposed, select(proposed < 0.5 * h, proposed, 0.5 * h));
        // a NaN proposal: shrink
        y.next_step = select(y.next_step > R{} + 0.0, y.next_step, 0.25 * h_asked);
        return y;
    }

    /// q_k of unknown u, k = 1, 2, 3.
    const Z& coefficient(int k, int u) const { return taylor_[k - 1][u]; }

private:
    static Mask both(const Mask& a, const Mask& b) {
        if constexpr (is_pack<R>)
            return a & b;
        else
            return a && b;
    }

    Time time(const R& tau) const {
        if constexpr (std::is_same_v<Time, R>)
            return tau;
        else
            return origin_ + tau * direction_;
    }
    /// Derivatives by t to derivatives by tau.
    Z scaled(const Z& d) const {
        if constexpr (std::is_same_v<Time, R>)
            return d;
        else
            return direction_ * d;
    }
    void complete(Z (&j)[n][n]) const {
        if constexpr (Pivoted && H::symmetric)
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
    }
    void solve_order(int k) {
        lu_.solve(taylor_[k - 1]);
        if constexpr (std::is_same_v<Time, R>) {
            evaluation_.set_coefficient(k, taylor_[k - 1]);
        } else {  // the evaluation works in t
            Z d[n];
            const Z by = inverse(direction_);
            for (int u = 0; u < n; ++u) {
                d[u] = taylor_[k - 1][u];
                for (int m = 0; m < k; ++m) d[u] *= by;
            }
            evaluation_.set_coefficient(k, d);
        }
    }

    /// The distance to the nearest pole: an unknown's series behaves like a geometric one, with quotient q_3 / q_2, and
    /// sqrt(q_3 / q_1) where q_2 happens to vanish. An unknown that rests (a symmetric path) has none.
    void find_pole(const Point<M, R>&) {
        R nearest2 = broadcast<R>(1e20);
        for (int u = 0; u < n; ++u) {
            const R a1 = norm2(taylor_[0][u]), a2 = norm2(taylor_[1][u]), a3 = norm2(taylor_[2][u]);
            const R by_ratio = (a2 + 1e-20) / (a3 + 1e-24);
            const R by_root = square_root((a1 + 1e-20) / (a3 + 1e-24));
            nearest2 = lane_min(nearest2, lane_max(by_ratio, 0.25 * by_root));
        }
        pole_ = square_root(nearest2);
    }

    /// Pade(2,1): q_1 h + q_2 h^2 / (1 - h q_3 / q_2), and the cubic where that is ill-conditioned.
    Z predicted(int u, const R& h) const {
        const Z &q1 = taylor_[0][u], &q2 = taylor_[1][u], &q3 = taylor_[2][u];
        const Z step3 = h * q3;
        const Z den = q2 - step3;
        const Mask pade = norm2(step3) < 0.5 * norm2(q2);
        const Z tail = select(pade, q2 * q2 / den, q2 + step3);
        return h * (q1 + h * tail);
    }

    TrackerOptions options_;
    typename H::template Evaluation<R, Time> evaluation_;
    Factorization lu_;
    Time origin_, direction_;
    Z taylor_[3][n];
    R pole_;
    R noise2_ = R{} + 1e-14, rounding2_ = R{};
};

}  // namespace detail
}  // namespace equilibria
