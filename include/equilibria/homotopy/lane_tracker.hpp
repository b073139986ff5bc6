/// \file
/// Tracks many paths, one a lane; a lane takes the next path as soon as its own ends. Every operation on a lane is
/// independent of the others, so that a path's result does not depend on its neighbours, nor on the number of threads.
#pragma once

#include <cstdint>
#include <span>

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker.hpp>

namespace equilibria {

/// Tracks from t = 0 the paths that start at `start(path)`, a Point<M, double>, for each of `paths`; where
/// paths[k] was left goes to ends[k] (q, t, steps, arrival, reason). R: the pack of lanes, or a scalar type.
template <class R, bool Pivoted, class H, class StartPoint>
void track_lanes(const H& homotopy, const TrackerOptions& options, std::span<const std::uint64_t> paths,
                 StartPoint&& start, std::span<Endpoint> ends) {
    using M = typename H::System;
    constexpr int width = LaneTraits<R>::width;
    detail::Stepper<H, R, R, Pivoted> stepper(homotopy, options);
    auto q = point_of_zeros<M, R>(homotopy.sizes());
    R t = broadcast<R>(1.0), h = broadcast<R>(0.0);
    std::int64_t path[width];
    std::int32_t steps[width];
    bool fresh[width];
    std::size_t next = 0;
    int running = 0;

    const auto load = [&](int k) {
        fresh[k] = next < paths.size();
        path[k] = fresh[k] ? static_cast<std::int64_t>(next++) : -1;
        set_lane(t, k, fresh[k] ? 0.0 : 1.0);
        set_lane(h, k, 0.0);
        steps[k] = 0;
        if (fresh[k]) {
            ++running;
            copy_lane(start(paths[static_cast<std::size_t>(path[k])]), 0, q, k);
        }
    };
    const auto finish = [&](int k, Arrival arrival, FailureReason reason) {
        Endpoint& end = ends[static_cast<std::size_t>(path[k])];
        copy_lane(q, k, end.q, 0);
        end.t = static_cast<double>(lane(t, k));
        end.steps = steps[k];
        end.arrival = arrival;
        end.reason = reason;
        --running;
        load(k);
    };

    for (int k = 0; k < width; ++k) load(k);
    for (int k = 1; k < width; ++k)  // idle lanes repeat the first path's start: any finite numbers will do
        if (path[k] < 0 && path[0] >= 0) copy_lane(q, 0, q, k);
    while (running > 0) {
        stepper.expand(q, t);
        const R first = stepper.first_step();
        for (int k = 0; k < width; ++k)
            if (fresh[k]) set_lane(h, k, lane(first, k)), fresh[k] = false;
        const auto& outcome = stepper.step(q, t, h);
        take_where(outcome.accepted, outcome.q, q);
        const R before = t;
        t = select(outcome.accepted, t + outcome.step, t);
        h = lane_min(outcome.next_step, 1.0 - t);
        const R far = farthest2(q);
        const R reached = outcome.step - (1.0 - before);  // 0 where the step went to the end
        for (int k = 0; k < width; ++k) {
            if (path[k] < 0) continue;
            ++steps[k];
            const double left = 1.0 - static_cast<double>(lane(t, k));
            const bool accepted = lane(t, k) != lane(before, k) || lane(outcome.step, k) == 0;
            if (accepted && (left <= 1e-15 || static_cast<double>(lane(reached, k)) >= 0)) {
                set_lane(t, k, 1.0);
                finish(k, Arrival::end, FailureReason::none);
            } else if (static_cast<double>(lane(far, k)) > far_away2) {
                finish(k, Arrival::endgame, FailureReason::none);
            } else if (left < options.endgame_start &&  // the next step falls short of t = 1, or this one did
                       (static_cast<double>(lane(h, k)) < 0.9 * left ||
                        static_cast<double>(lane(reached, k)) < -0.1 * static_cast<double>(1 - lane(before, k)))) {
                finish(k, Arrival::endgame, FailureReason::none);
            } else if (!(static_cast<double>(lane(outcome.next_step, k)) > options.smallest_step)) {
                finish(k, Arrival::stuck, FailureReason::step_too_small);
            } else if (steps[k] >= options.most_steps) {
                finish(k, Arrival::stuck, FailureReason::too_many_steps);
            }
        }
    }
}

}  // namespace equilibria
