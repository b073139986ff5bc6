/// \file
/// Paths near t = 1: finite, at infinity or singular, told apart by two-sided tests; and single paths tracked
/// carefully.
///
/// Valuation: nu_u = |(1-t) q_u'(t)| of an angle, |(1-t) x'/x| of a coordinate. On a path to a finite point it tends to
/// 0 like (1-t)^(1/m); on one to infinity it settles at a positive rational (theta ~ -+ i nu log(1-t)).
/// Cauchy: on the circle |1-t| = r the path closes after m turns, m the winding number; the mean of its points is the
/// endpoint, to the accuracy of the tracking even where Newton's method would crawl. It is accepted when two radii
/// agree; on a path to infinity they agree on a pole instead, at radii where it is not far out yet. Sources: Morgan,
/// Sommese, Wampler, power-series and Cauchy endgames; Timme (valuation test).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include <equilibria/homotopy/detail/closed_loop.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/polish.hpp>

namespace equilibria {

/// The largest condition number (see PolishedEvidence) of an endpoint that counts as regular.
inline constexpr double regular_condition = 1e8;

namespace detail {

/// R: double, or a multiprecision float, which tracks and closes loops with more digits; what is polished, and what
/// counts as regular, is decided in double all the same.
template <class H, class R = double>
class Endgame {
public:
    using M = typename H::System;
    using Z = Complex<R>;
    using At = Point<M, R>;
    using Loop = ClosedLoop<M, R>;
    using Tracker = Stepper<H, R, Complex<R>, true>;
    static constexpr int n = n_unknowns<M>;

    Endgame(const H& h, const Polisher<H>& polisher, const TrackerOptions& options)
        : options_(options), stepper_(h, options), closing_(h, closing(options)), polisher_(&polisher) {}

    /// Tracks the path from its start, slowly, and ends it with the endgame wherever it leads.
    Endpoint<M> from_start(const Point<M, double>& start) {
        Endpoint<M> end;
        At q;
        copy_lane(start, 0, q, 0);
        double reached = 0;
        const Progress progress = track(stepper_, q, time(1), time(1e-3), end.steps, &reached);
        copy_lane(q, 0, end.q, 0);
        const double r = 1 - reached * (1 - 1e-3);
        // close to t = 1 rounding may be what stops it, and the endgame measures that
        if (progress == Progress::stuck && (end.steps >= options_.most_steps || r > 0.02)) {
            end.reason =
                end.steps >= options_.most_steps ? FailureReason::too_many_steps : FailureReason::step_too_small;
            return end;
        }
        finish(end, q, r);
        return end;
    }

    /// Ends a path that has come to t = 1 - r.
    void finish(Endpoint<M>& end, double r) {
        At q;
        copy_lane(end.q, 0, q, 0);
        finish(end, q, r);
    }

    enum class Progress { arrived, far, stuck };

private:
    static constexpr bool exact = !std::is_same_v<R, double>;
    /// What a difference, a radius and a step may be with the digits of R: rounding of 1e-16 in double.
    static constexpr double closed = exact ? 1e-22 : 1e-11;
    /// How well two means of loops must agree.
    static constexpr double settled = 1e-7;
    static constexpr double smallest_radius = exact ? 1e-24 : 1e-13;
    /// Where a path that seems to diverge is believed, once it is 1e5 out and before: a finite solution that is merely
    /// far away looks the same down to r = size^(-1 / nu), nu the valuation on the way there.
    static constexpr double diverging_radius = exact ? 1e-14 : 2e-9, slowly_diverging_radius = exact ? 1e-18 : 1e-12;
    /// Where a pole that closed loops show is believed of a path that rounding stops.
    static constexpr double pole_radius = 1e-9;
    static constexpr double shortest_step = exact ? 1e-18 : 1e-9;

    /// The point 1 - r of the time.
    static Z time(const std::complex<double>& r) { return {1.0 - R(r.real()), -R(r.imag())}; }
    /// Near a family the position along it is known only to 1e-16 / r: contractions below 1e-5 can't be told there.
    static TrackerOptions closing(TrackerOptions o) {
        o.contraction = std::max(o.contraction, 1e-5);
        o.largest_contraction = std::max(o.largest_contraction, 1e-3);
        return o;
    }
    static double size2(const At& q) { return static_cast<double>(farthest2(q)); }

    void finish(Endpoint<M>& end, At& q, double r) {
        decide(end, q, r);
        if (end.status == PathStatus::at_infinity || end.status == PathStatus::failed) copy_lane(q, 0, end.q, 0);
    }

    void decide(Endpoint<M>& end, At& at, double r) {
        Array<double, n> before;
        bool diverging = false;
        double excluded = 1;
        Loop last;
        for (double& nu : before) nu = -1;
        while (r > smallest_radius) {
            const Array<double, n> nu = valuations(at, r);
            diverging = diverges(at, nu, before);
            if (diverging &&
                (size2(at) > far_away2 || r < (size2(at) > 1e10 ? diverging_radius : slowly_diverging_radius)))
                break;
            before = nu;
            const Loop now = recedes(at, nu) || size2(at) > far_away2 ? Loop{} : loop(at, r, end.steps);
            if (now.winding > 0 && last.winding > 0) {
                excluded = std::min(excluded, excluded_radius(now, r, last));
                if (excluded < slowly_diverging_radius) break;
                if (now.has_mean && last.has_mean && distance(now.mean, last.mean) < settled &&
                    settle(end, now.mean, now.winding))
                    return;
            }
            last = now;
            // the next scale: where the fastest unknown has grown e^3 times, a tenth at the most
            double fastest = 0;
            for (const double v : nu) fastest = std::max(fastest, v);
            const double smaller = r * std::max(0.1, std::exp(-3 / (fastest + 1e-3)));
            double reached = 0;
            At next = at;
            if (track(closing_, next, time(r), time(smaller), end.steps, &reached) == Progress::stuck) break;
            at = next;
            r -= reached * (r - smaller);
        }
        if (diverging || excluded < slowly_diverging_radius ||
            (r > smallest_radius && (excluded < pole_radius || recedes_from_afar(at, r, end.steps)))) {
            end.status = PathStatus::at_infinity;
            return;
        }
        // no singularity on any scale: the path is regular there, only badly conditioned
        if (r <= 10 * smallest_radius) {
            if (track(closing_, at, time(r), time(0), end.steps) == Progress::arrived) {
                Point<M, double> q;
                copy_lane(at, 0, q, 0);
                polisher_->run(q, &end.evidence);
                if (end.evidence.condition < regular_condition && end.evidence.correction < 1e-8) {
                    end.q = q;
                    end.status = PathStatus::finite;
                    return;
                }
            }
        }
        end.status = PathStatus::failed;
        end.reason = FailureReason::endgame_undecided;
    }

    /// Moves q along the segment from t = a to t = b; stops where q is far away. `reached`: the part of the way.
    Progress track(Tracker& stepper, At& q, const Z& a, const Z& b, std::int32_t& steps, double* reached = nullptr) {
        stepper.set_segment(a, b - a);
        R tau = 0, h = 0;
        const bool was_far = size2(q) > far_away2;
        while (tau < 1) {
            if (++steps > options_.most_steps) return Progress::stuck;
            stepper.expand(q, tau);
            if (h == 0) h = stepper.first_step();
            const auto outcome = stepper.step(q, tau, lane_min<R>(h, 1 - tau));
            h = outcome.next_step;
            if (outcome.accepted) {
                q = outcome.q;
                tau = outcome.step >= 1 - tau ? R(1) : R(tau + outcome.step);
                if (reached) *reached = static_cast<double>(tau);
                if (!was_far && reached && size2(q) > far_away2) return Progress::far;
            } else if (!(h > shortest_step)) {
                return Progress::stuck;
            }
        }
        // one more correction, or three for all the digits: the loops average these points
        for (int k = 0; k < (exact ? 3 : 1); ++k) stepper.expand(q, R(1.0));
        return Progress::arrived;
    }

    /// The largest difference of two points: of (c, s) relative to their size, of coordinates against 1 + |x|.
    template <class Q>
    static double distance(const Point<M, Q>& a, const Point<M, Q>& b) {
        double largest = 0;
        const auto take = [&](const Q& difference2, const Q& size2) {
            largest = std::max(largest, std::sqrt(static_cast<double>(difference2 / size2)));
            if (!(difference2 < 1e300)) largest = 1e300;
        };
        for (int i = 0; i < n_angles<M>; ++i)
            take(norm2(a.c[i] - b.c[i]) + norm2(a.s[i] - b.s[i]), norm2(a.c[i]) + norm2(a.s[i]));
        for (int j = 0; j < n_coordinates<M>; ++j) take(norm2(a.x[j] - b.x[j]), 1 + norm2(a.x[j]));
        return largest;
    }

    /// Also tells the stepper of the loops how large rounding is there.
    Array<double, n> valuations(At& q, double r) {
        closing_.set_segment(time(r), {R(r), R(0.0)});
        closing_.expand(q, R(0.0));
        // what further corrections still change is rounding
        double noise = 0;
        for (int k = 0; k < 2; ++k) {
            const At before = q;
            closing_.expand(q, R(0.0));
            noise = std::max(noise, distance(before, q));
        }
        closing_.set_noise(std::clamp(16 * noise / closing(options_).contraction, 1e-7, 1e-5));
        Array<double, n> nu;
        for (int u = 0; u < n; ++u) {
            nu[u] = std::sqrt(static_cast<double>(norm2(closing_.coefficient(1, u))));
            if (u >= n_angles<M>) nu[u] /= 1e-30 + std::sqrt(static_cast<double>(norm2(q.x[u - n_angles<M>])));
        }
        return nu;
    }
    /// The unknown that is farthest out.
    static int farthest(const At& q) {
        int u = 0;
        for (int k = 1; k < n; ++k)
            if (unknown_size2(q, k) > unknown_size2(q, u)) u = k;
        return u;
    }
    /// The unknown that is farthest out is far, and on its way.
    static bool recedes(const At& q, const Array<double, n>& nu) {
        const int u = farthest(q);
        return unknown_size2(q, u) > 100 && nu[u] > 0.1;
    }
    /// Some unknown is far out, and its valuation is positive and the same on two scales; and that of the farthest one
    /// does not fall, as it does near a finite solution that is merely far away.
    static bool diverges(const At& q, const Array<double, n>& nu, const Array<double, n>& before) {
        const int last = farthest(q);
        if (!(nu[last] > 0.05 && nu[last] > 0.9 * before[last])) return false;
        for (int u = 0; u < n; ++u)
            if (unknown_size2(q, u) > 100 && nu[u] > 0.05 && before[u] > 0 &&
                std::abs(nu[u] - before[u]) < 0.05 * nu[u])
                return true;
        return false;
    }

    /// Where rounding stops a path: whether it is on its way to infinity, as far as r and 10 r tell. Loops there show a
    /// pole; or it is so far out that its valuations are enough.
    bool recedes_from_afar(At& at, double r, std::int32_t& steps) {
        if (!(unknown_size2(at, farthest(at)) > 100) || 10 * r > 0.05) return false;
        const Array<double, n> nu = valuations(at, r);
        const Loop here = loop(at, r, steps);
        At back = at;
        if (track(closing_, back, time(r), time(10 * r), steps) != Progress::arrived) return false;
        if (grows(at, nu, back, valuations(back, 10 * r))) return true;
        return here.pole > 0 && excluded_radius(here, r, loop(back, 10 * r, steps)) < pole_radius;
    }
    /// Whether some unknown is very far out, and has grown since ten times the radius by a power of it between its
    /// valuations on both scales, which do not fall.
    static bool grows(const At& q, const Array<double, n>& nu, const At& back, const Array<double, n>& before) {
        for (int u = 0; u < n; ++u) {
            const double size2 = static_cast<double>(unknown_size2(q, u));
            if (!(size2 > 1e8 && nu[u] > 0.05 && nu[u] > 0.9 * before[u])) continue;
            const double growth = 0.5 * std::log10(size2 / static_cast<double>(unknown_size2(back, u)));
            if (growth > 0.9 * std::min(nu[u], before[u]) && growth < 1.1 * nu[u]) return true;
        }
        return false;
    }
    /// Where loops at r and at a larger radius show the same pole: the radius down to which they exclude a finite
    /// solution, whose branch point so close to t = 1 would add terms of lower orders. 1 where they do not.
    static double excluded_radius(const Loop& at_r, double r, const Loop& wider) {
        const bool same = at_r.winding == wider.winding && at_r.pole == wider.pole;
        return same && at_r.pole > 0 ? at_r.beyond * r : 1;
    }

    /// Follows the path around t = 1 until it closes.
    Loop loop(const At& first, double r, std::int32_t& steps) {
        constexpr int samples = Loop::samples;
        std::vector<At> points;
        double excursion = 0;
        At at = first;
        for (int turn = 1; turn <= Loop::most_turns; ++turn) {
            for (int k = 0; k < samples; ++k) {
                points.push_back(at);
                const auto point = [&](int m) {
                    return time(m % samples == 0 ? std::complex<double>(r)
                                                 : std::polar(r, 2 * std::numbers::pi * m / samples));
                };
                if (track(closing_, at, point(k), point(k + 1), steps) != Progress::arrived) return {};
                excursion = std::max(excursion, distance(first, at));
            }
            if (distance(first, at) < 1e-3 * excursion + closed) return Loop(points, turn);
        }
        return {};
    }

    /// Decides at a settled estimate of the endpoint; false if the radius is still too large to tell.
    bool settle(Endpoint<M>& end, const At& mean, int winding) {
        Point<M, double> estimate;
        copy_lane(mean, 0, estimate, 0);
        Point<M, double> q = estimate;
        polisher_->run(q, &end.evidence);
        if (end.evidence.condition < regular_condition && end.evidence.correction < 1e-8) {
            if (winding > 1 || distance(q, estimate) > 1e-6) return false;  // a branch point near t = 1, not at it
            end.q = q;
            end.status = PathStatus::finite;
            return true;
        }
        // loops around what looks like an endpoint at these radii, but is none, close as well: it fulfils no equations
        q = estimate;
        if (!(polisher_->correct_determined(q) < 1e-10)) return false;
        polisher_->assess(q, &end.evidence);
        end.q = q;
        end.status = PathStatus::singular;
        end.winding_number = static_cast<std::int16_t>(winding);
        return true;
    }

    TrackerOptions options_;
    Tracker stepper_, closing_;  // from the start, and near t = 1
    const Polisher<H>* polisher_;
};

}  // namespace detail
}  // namespace equilibria
