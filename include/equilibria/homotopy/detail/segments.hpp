/// \file
/// Paths followed along segments of the complex plane of t, one path a lane; a lane takes the next path as soon as its
/// own is done. As in lane_tracker.hpp a path's result does not depend on its neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <equilibria/core/lanes.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker.hpp>

namespace equilibria::detail {

/// doubles go in lanes, floats of more digits alone.
template <class R>
using PackOf = std::conditional_t<std::is_same_v<R, double>, Lanes<native_lanes>, R>;

/// The largest difference of two points: of (c, s) relative to their size, of coordinates against 1 + |x|.
template <class R>
double distance(const RuntimePoint<R>& a, const RuntimePoint<R>& b) {
    double largest = 0;
    const auto take = [&](const R& difference2, const R& size2) {
        largest = std::max(largest, std::sqrt(static_cast<double>(difference2 / size2)));
        if (!(difference2 < 1e300)) largest = 1e300;
    };
    for (int i = 0; i < a.c.size(); ++i)
        take(norm2(a.c[i] - b.c[i]) + norm2(a.s[i] - b.s[i]), norm2(a.c[i]) + norm2(a.s[i]));
    for (int j = 0; j < a.x.size(); ++j) take(norm2(a.x[j] - b.x[j]), 1 + norm2(a.x[j]));
    return largest;
}

enum class Progress { arrived, far, stuck };

/// A path along a segment; a class that derives from it may add segments, by its own `advance` and `take`.
template <class R>
struct Segment {
    RuntimePoint<R> q;       ///< at `from`, then where it was left
    Complex<R> from, to;     ///< t
    std::int32_t steps = 0;  ///< of the whole path
    double noise = 1e-7;     ///< Newton corrections up to this size may be rounding
    bool may_leave = false;  ///< it is done as soon as q is far away
    double reached = 0;      ///< the part of the way that was gone
    Progress progress = Progress::stuck;

    /// At `to`: sets the next segment, or returns false.
    bool advance() { return false; }
    /// The point at `to`, corrected to all its digits; false: it is done.
    bool take(const RuntimePoint<R>& at) {
        q = at;
        return false;
    }
};

/// A point of a path at t = 1 - r.
template <class R>
struct Expansion {
    RuntimePoint<R> q;  ///< corrected
    double r;
    double noise = 0;                    ///< what further corrections still change: rounding
    SizedArray<double, at_run_time> nu;  ///< |(1-t) q'|
};

/// R: double, or a float of more digits.
template <class H, class R>
class SegmentLanes {
public:
    using M = typename H::System;
    using Pack = PackOf<R>;
    using Z = Complex<Pack>;
    using Tracker = Stepper<H, Pack, Z, true>;
    static constexpr int width = LaneTraits<Pack>::width;

    /// A path whose next step must be shorter than `shortest_step` of its segment is stuck.
    SegmentLanes(const H& h, const TrackerOptions& options, double shortest_step)
        : n_(h.sizes().unknowns), stepper_(h, options), most_steps_(options.most_steps), shortest_step_(shortest_step),
          far_(far_limit2(h)), q_(point_of_zeros<RuntimeUnknowns, Pack>(h.sizes())) {}

    /// Follows `paths`: Segments, or what derives from them.
    template <class Path>
    void follow(std::span<Path> paths) {
        std::array<Path*, width> path{};
        std::size_t next = 0;
        const auto load = [&](int k) {
            path[at(k)] = next < paths.size() ? &paths[next++] : nullptr;
            if (path[at(k)]) enter(k, *path[at(k)]);
        };
        for (int k = 0; k < width; ++k) load(k);
        while (std::any_of(path.begin(), path.end(), [](Path* p) { return p != nullptr; })) {
            stepper_.set_segment(from_, way_);
            stepper_.set_noise(noise_);
            stepper_.expand(q_, tau_);
            const Pack first = stepper_.first_step();
            for (int k = 0; k < width; ++k) {
                if (!path[at(k)]) continue;
                if (corrections_[k] > 0 && --corrections_[k] == 0) hand_over(k, *path[at(k)]);
                if (fresh_[k] && corrections_[k] == 0) set_lane(h_, k, lane(first, k)), fresh_[k] = false;
            }
            const auto& outcome = stepper_.step(q_, tau_, lane_min<Pack>(h_, 1.0 - tau_));
            for (int k = 0; k < width; ++k) {
                Path* const here = path[at(k)];
                if (!here) continue;
                if (!done_[k] && corrections_[k] == 0) move(k, *here, outcome);
                if (done_[k]) load(k);
            }
            const auto running = std::find_if(path.begin(), path.end(), [](Path* p) { return p != nullptr; });
            for (int k = 0; running != path.end() && k < width; ++k)
                if (!path[at(k)]) repeat(k, static_cast<int>(running - path.begin()));
        }
    }

    /// Newton corrections, and the speed of the path.
    void expand(std::span<Expansion<R>> points) {
        for (std::size_t first = 0; first < points.size(); first += at(width)) {
            const int filled = static_cast<int>(std::min(points.size() - first, at(width)));
            for (int k = 0; k < width; ++k) {  // lanes that are left over repeat the first point
                const Expansion<R>& point = points[first + at(k < filled ? k : 0)];
                copy_lane(point.q, 0, q_, k);
                set_time(k, {1.0 - R(point.r), R(0.0)}, {R(point.r), R(0.0)});
            }
            tau_ = broadcast<Pack>(0.0);
            stepper_.set_segment(from_, way_);
            stepper_.expand(q_, tau_);
            for (int round = 0; round < 2; ++round) {
                for (int k = 0; k < filled; ++k) copy_lane(q_, k, points[first + at(k)].q, 0);
                stepper_.expand(q_, tau_);
                for (int k = 0; k < filled; ++k) {
                    Expansion<R>& point = points[first + at(k)];
                    const RuntimePoint<R> before = point.q;
                    copy_lane(q_, k, point.q, 0);
                    point.noise = std::max(point.noise, distance(before, point.q));
                }
            }
            for (int u = 0; u < n_; ++u) {
                const Z speed = stepper_.coefficient(1, u);
                for (int k = 0; k < filled; ++k)
                    points[first + at(k)].nu[u] = std::sqrt(static_cast<double>(lane(norm2(speed), k)));
            }
        }
    }

private:
    using Scalar = typename LaneTraits<Pack>::Scalar;
    /// Of points that are compared and averaged: one more, or three for all the digits.
    static constexpr int last_corrections = std::is_same_v<R, double> ? 1 : 3;
    /// By which those may move it.
    static constexpr double largest_correction = 0.1;

    static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

    void set_time(int k, const Complex<R>& from, const Complex<R>& way) {
        set_lane(from_.re, k, from.re), set_lane(from_.im, k, from.im);
        set_lane(way_.re, k, way.re), set_lane(way_.im, k, way.im);
    }
    void begin_segment(int k, const Segment<R>& path) {
        set_time(k, path.from, path.to - path.from);
        set_lane(tau_, k, Scalar(0));
        fresh_[k] = true;
    }
    void enter(int k, const Segment<R>& path) {
        copy_lane(path.q, 0, q_, k);
        set_lane(noise_, k, Scalar(path.noise));
        begin_segment(k, path);
        corrections_[k] = 0;
        done_[k] = false;
        was_far_[k] = static_cast<double>(farthest2(path.q)) > far_;
    }
    /// Lane k, which is idle, goes with another, as in LaneTracker.
    void repeat(int k, int other) {
        copy_lane(q_, other, q_, k);
        for (Pack* const pack : {&from_.re, &from_.im, &way_.re, &way_.im, &tau_, &h_, &noise_})
            set_lane(*pack, k, lane(*pack, other));
    }
    void leave(int k, Segment<R>& path, Progress progress) {
        copy_lane(q_, k, path.q, 0);
        path.progress = progress;
        done_[k] = true;
    }
    template <class Path>
    void hand_over(int k, Path& path) {
        RuntimePoint<R> corrected;
        copy_lane(q_, k, corrected, 0);
        // at a singular point Newton's method may go anywhere
        if (!(distance(path.q, corrected) < largest_correction)) return leave(k, path, Progress::stuck);
        if (path.take(corrected)) return;
        path.progress = Progress::arrived;
        done_[k] = true;
    }
    /// Takes lane k's step.
    template <class Path>
    void move(int k, Path& path, const typename Tracker::Outcome& outcome) {
        if (++path.steps > most_steps_) return leave(k, path, Progress::stuck);
        set_lane(h_, k, lane(outcome.next_step, k));
        if (!mask_lane(outcome.accepted, k)) {
            if (!(lane(h_, k) > shortest_step_)) leave(k, path, Progress::stuck);
            return;
        }
        copy_lane(outcome.q, k, q_, k);
        const Scalar tau = lane(tau_, k), step = lane(outcome.step, k);
        const bool arrived = step >= 1 - tau;
        set_lane(tau_, k, arrived ? Scalar(1) : Scalar(tau + step));
        path.reached = static_cast<double>(lane(tau_, k));
        if (path.may_leave && !was_far_[k] && static_cast<double>(lane(farthest2(q_), k)) > far_)
            return leave(k, path, Progress::far);
        if (!arrived) return;
        copy_lane(q_, k, path.q, 0);
        if (path.advance()) begin_segment(k, path);
        corrections_[k] = last_corrections;
    }

    int n_;
    Tracker stepper_;
    int most_steps_;
    double shortest_step_;
    double far_;  // the square of the size where a path may leave
    RuntimePoint<Pack> q_;
    Z from_{}, way_{};
    Pack tau_{}, h_{}, noise_{};
    int corrections_[width]{};  // still to come at the end of a segment
    bool fresh_[width]{}, done_[width]{}, was_far_[width]{};
};

}  // namespace equilibria::detail
