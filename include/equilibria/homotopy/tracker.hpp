/// \file
/// Prediction, correction and step control, on all lanes of a pack at once; one lane (a scalar type) is the same code.
///
/// Predictor: Taylor coefficients of the path from one factorisation of the Jacobian, and what the homotopy's predictor
/// makes of them. Corrector: one Newton step and one simplified step with the same factorisation; the step control
/// judges by their quotient whether the prediction is an approximate zero of this path, which keeps a path from jumping
/// to its neighbour. Which predictor and which step control: tracking.hpp.
///
/// Where it fails: at singular points of the path; t = 1 is left to the endgame.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/path_status.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/homotopy/tracking.hpp>

namespace equilibria {

namespace detail {

/// One predictor-corrector step for all lanes. The driver owns t, the refilling of lanes and the end of paths.
///
/// H: a homotopy. Pivoted: LU also where the Jacobian is symmetric. Time: R, and the path runs along the reals; or
/// Complex<R>, and it runs along the segment t = origin + tau direction.
template <class H, class R, class Time = R, bool Pivoted = false>
class Stepper {
public:
    using Z = Complex<R>;
    using Mask = typename LaneTraits<R>::Mask;

    using Predictor = typename TrackingOf<H>::type::template Predictor<R>;
    using StepControl = typename TrackingOf<H>::type::template StepControl<R, Predictor::local_order>;

    Stepper(const H& h, const TrackerOptions& options)
        : n_(h.sizes().unknowns), angles_(h.sizes().angles), control_(options), evaluation_(h),
          lu_(n_, !Pivoted && evaluation_.symmetric()), mirrors_(Pivoted && evaluation_.symmetric()), origin_(Time{}),
          direction_(Time{} + 1.0), f_(n_), d_(n_), j_(n_) {
        outcome_.q = point_of_zeros<RuntimeUnknowns, R>(h.sizes());
        for (auto& coefficient : taylor_) coefficient.resize(n_);
    }

    /// The segment that tau in [0, 1] runs along.
    void set_segment(const Time& origin, const Time& direction) {
        origin_ = origin;
        direction_ = direction;
    }

    /// Lane k goes along this path from now on, or with another lane: of concern where paths have equations of their
    /// own.
    void enter(int k, std::uint64_t path) {
        if constexpr (requires { evaluation_.enter(k, path); }) evaluation_.enter(k, path);
    }
    void repeat(int k, int other) {
        if constexpr (requires { evaluation_.repeat(k, other); }) evaluation_.repeat(k, other);
    }

    /// Newton corrections up to this size are no cause for concern: they may be rounding.
    void set_noise(const R& size) { noise2_ = size * size; }

    struct Outcome {
        RuntimePoint<R> q;  ///< the corrected point at tau + h
        Mask accepted;
        R next_step;  ///< what the step control proposes, from this point if accepted, else again from the old one
        R step;       ///< the step that was tried: at most the one asked for
    };

    /// Taylor coefficients at (q, tau), which is first corrected by one Newton step for free.
    void expand(RuntimePoint<R>& q, const R& tau) {
        solve_newton(q, tau);
        rounding2_ = lane_min(16.0 * correction_size(q, f_), noise2_);
        correct_roughly(q, f_);
        [&]<int... k>(std::integer_sequence<int, k...>) {
            (find_coefficient<k + 1>(), ...);
        }(std::make_integer_sequence<int, Predictor::order>());
        pole_ = Predictor::pole(taylor_, n_);
    }

    /// A first step for a new path, from its Taylor coefficients.
    R first_step() const { return control_.first(pole_); }

    /// Predicts and corrects from (q, tau), after `expand`, with a step of at most h. Valid until the next call.
    const Outcome& step(const RuntimePoint<R>& q, const R& tau, const R& h_asked) {
        Outcome& y = outcome_;
        // a NaN pole must not pass: the comparison is false for it and leaves a NaN step, which is refused below
        const R limit = control_.longest(pole_);
        const R h = y.step = select(h_asked < limit, h_asked, limit);
        Trial<R> trial{.step = h, .asked = h_asked, .turn2 = {}, .first2 = {}, .second2 = {}, .noise2 = noise2_};
        const int n = n_;
        for (int u = 0; u < n; ++u) {
            d_[u] = Predictor::change(taylor_, u, h);
            if (u < angles_) trial.turn2 = lane_max(trial.turn2, norm2(d_[u]));
        }
        y.q = q;
        move_roughly(y.q, d_);
        solve_newton(y.q, tau + h);
        trial.first2 = correction_size(y.q, f_);
        correct_roughly(y.q, f_);
        evaluation_.value(y.q, time(tau + h), f_);
        for (int i = 0; i < n; ++i) f_[i] = -f_[i];
        lu_.solve(f_);
        // what the third correction at the last point still changed is rounding: far out it would look like a bad step
        trial.second2 = lane_max(correction_size(y.q, f_) - rounding2_, R{});
        correct_roughly(y.q, f_);
        const Verdict<R> verdict = control_.judge(trial);
        y.accepted = verdict.accepted;
        y.next_step = verdict.next_step;
        return y;
    }

    /// q_k of unknown u, k from 1 to the order of the predictor.
    const Z& coefficient(int k, int u) const { return taylor_[k - 1][u]; }

private:
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
    /// f_: Newton's correction at (q, tau).
    void solve_newton(const RuntimePoint<R>& q, const R& tau) {
        const int n = n_;
        evaluation_.jacobian(q, time(tau), f_, j_);
        if (mirrors_)
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < r; ++c) j_[r][c] = j_[c][r];
        lu_.factor(j_);
        for (int i = 0; i < n; ++i) f_[i] = -f_[i];
        lu_.solve(f_);
    }
    /// q_k, from those below; angles in radians, by tau.
    template <int k>
    void find_coefficient() {
        auto& q = taylor_[k - 1];
        const int n = n_;
        evaluation_.taylor_right_side(k, q);
        for (int u = 0; u < n; ++u)
            for (int m = 0; m < k; ++m) q[u] = scaled(q[u]);
        lu_.solve(q);
        if constexpr (k == Predictor::order) return;
        if constexpr (std::is_same_v<Time, R>) {
            evaluation_.set_coefficient(k, q);
        } else {  // the evaluation works in t
            const Z by = inverse(direction_);
            for (int u = 0; u < n; ++u) {
                d_[u] = q[u];
                for (int m = 0; m < k; ++m) d_[u] *= by;
            }
            evaluation_.set_coefficient(k, d_);
        }
    }

    int n_, angles_;
    StepControl control_;
    typename H::template Evaluation<R, Time> evaluation_;
    RuntimeFactorization<R> lu_;
    bool mirrors_;  // the Jacobian has only the entries on and above its diagonal, and the factorisation reads all
    Time origin_, direction_;
    RuntimeArray<Z> f_, d_;
    RuntimeMatrix<Z> j_;
    RuntimeArray<Z> taylor_[Predictor::order];
    Outcome outcome_;
    R pole_;
    R noise2_ = R{} + (is_single<R> ? 1e-9 : 1e-14);  // with 1e-8 in single precision paths met
    R rounding2_ = R{};
};

}  // namespace detail
}  // namespace equilibria
