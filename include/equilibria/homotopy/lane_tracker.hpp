/// \file
/// Tracks many paths, one a lane; a lane takes the next path as soon as its own ends. Every operation on a lane is
/// independent of the others, so that a path's result does not depend on its neighbours, nor on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <equilibria/core/flush_denormals.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker.hpp>

namespace equilibria {

namespace detail {

/// Lanes, and the paths in them.
template <class R, bool Pivoted, class H, class StartPoint>
class LaneTracker {
public:
    LaneTracker(const H& homotopy, const TrackerOptions& options, std::span<const std::uint64_t> paths,
                const StartPoint& start, std::span<Endpoint> ends)
        : options_(&options),
          endgame_start_(is_single<R> ? std::max(options.endgame_start, 1e-3) : options.endgame_start),
          smallest_step_(is_single<R> ? std::max(options.smallest_step, 1e-4) : options.smallest_step),
          far_(is_single<R> ? std::min(far_limit2(homotopy), 1e36) : far_limit2(homotopy)), paths_(paths),
          start_(&start), ends_(ends), stepper_(homotopy, options),
          q_(point_of_zeros<RuntimeUnknowns, R>(homotopy.sizes())) {
        for (int k = 0; k < width; ++k) load(k);
        fill_idle();
    }

    void run() {
        while (running_ > 0) {
            stepper_.expand(q_, t_);
            if (any_fresh_) begin_fresh();
            const auto& outcome = stepper_.step(q_, t_, h_);
            take_where(outcome.accepted, outcome.q, q_);
            const R before = t_;
            t_ = select(outcome.accepted, t_ + outcome.step, t_);
            h_ = lane_min(outcome.next_step, 1.0 - t_);
            settle(before, outcome);
        }
    }

private:
    using Steps = Stepper<H, R, R, Pivoted>;
    using Scalar = typename LaneTraits<R>::Scalar;
    static constexpr int width = LaneTraits<R>::width;

    void load(int k) {
        const bool loaded = next_ < paths_.size();
        path_[k] = loaded ? static_cast<std::int64_t>(next_++) : -1;
        if (!loaded) return;
        ++running_;
        const Endpoint& end = ends_[static_cast<std::size_t>(path_[k])];
        set_lane(t_, k, static_cast<Scalar>(end.t));
        steps_[k] = end.steps;
        const std::uint64_t path = paths_[static_cast<std::size_t>(path_[k])];
        stepper_.enter(k, path);
        copy_lane(end.t > 0 ? end.q : (*start_)(path), 0, q_, k);
        fresh_[k] = any_fresh_ = true;
    }
    /// Idle lanes go with a lane that runs. On their own they would rest at a solution, where what Newton's method
    /// corrects dies away into denormal numbers, each of which costs a processor a hundred cycles.
    void fill_idle() {
        const auto running = std::find_if(path_, path_ + width, [](std::int64_t path) { return path >= 0; }) - path_;
        if (running == width) return;
        const int from = static_cast<int>(running);
        for (int k = 0; k < width; ++k) {
            if (path_[k] >= 0) continue;
            stepper_.repeat(k, from);
            copy_lane(q_, from, q_, k);
            set_lane(t_, k, lane(t_, from));
            set_lane(h_, k, lane(h_, from));
            fresh_[k] = fresh_[from];
            steps_[k] = 0;
        }
    }
    void finish(int k, Arrival arrival, FailureReason reason) {
        Endpoint& end = ends_[static_cast<std::size_t>(path_[k])];
        copy_lane(q_, k, end.q, 0);
        end.t = static_cast<double>(lane(t_, k));
        end.steps = steps_[k];
        end.arrival = arrival;
        end.reason = reason;
        --running_;
        load(k);
    }
    void begin_fresh() {
        const R first = lane_min(stepper_.first_step(), 1.0 - t_);
        for (int k = 0; k < width; ++k)
            if (fresh_[k]) set_lane(h_, k, lane(first, k)), fresh_[k] = false;
        any_fresh_ = false;
    }
    /// Counts the step that was tried from the time `before`, and finishes the paths that go no further.
    void settle(const R& before, const typename Steps::Outcome& outcome) {
        const R &step = outcome.step, &next_step = outcome.next_step;
        const R far = farthest2(q_), remaining = 1.0 - t_;
        const R reached = step - (1.0 - before);  // 0 where the step went to the end
        int most_steps = 0;
        for (int k = 0; k < width; ++k) most_steps = std::max(most_steps, ++steps_[k]);
        // what most steps are, for all lanes at once: inside, and nowhere near an end
        const auto inside = mask_and(remaining > R{} + endgame_start_, reached < R{});
        const auto fit = mask_and(mask_not(far > R{} + far_), next_step > R{} + smallest_step_);
        if (all_lanes(mask_and(inside, fit)) && most_steps < options_->most_steps) return;
        for (int k = 0; k < width; ++k) {
            if (path_[k] < 0) continue;
            const auto number = [k](const R& pack) { return static_cast<double>(lane(pack, k)); };
            const double left = number(remaining);
            const bool accepted = lane(t_, k) != lane(before, k) || lane(step, k) == 0;
            if (accepted && (left <= end_ || number(reached) >= 0)) {
                set_lane(t_, k, Scalar(1));
                finish(k, Arrival::end, FailureReason::none);
            } else if (number(far) > far_) {
                finish(k, Arrival::endgame, FailureReason::none);
            } else if (left < endgame_start_ &&  // the next step falls short of t = 1, or this one did
                       (number(h_) < 0.9 * left || number(reached) < -0.1 * (1 - number(before)))) {
                finish(k, Arrival::endgame, FailureReason::none);
            } else if (!(number(next_step) > smallest_step_)) {
                finish(k, Arrival::stuck, FailureReason::step_too_small);
            } else if (steps_[k] >= options_->most_steps) {
                finish(k, Arrival::stuck, FailureReason::too_many_steps);
            }
        }
        if (next_ == paths_.size()) fill_idle();
    }

    static constexpr double end_ = is_single<R> ? 2e-7 : 1e-15;  // what is left of t at most at its end

    const TrackerOptions* options_;
    double endgame_start_,
        smallest_step_;  // of floats, 1 - t has three digits at 1e-3, and steps no meaning below 1e-4
    double far_;         // the square of the size where a path is left to the endgame
    std::span<const std::uint64_t> paths_;
    const StartPoint* start_;
    std::span<Endpoint> ends_;
    Steps stepper_;
    RuntimePoint<R> q_;
    R t_ = broadcast<R>(1.0), h_ = broadcast<R>(0.0);
    std::int64_t path_[width];  // -1: idle
    std::int32_t steps_[width];
    bool fresh_[width], any_fresh_ = false;
    std::size_t next_ = 0;
    int running_ = 0;
};

}  // namespace detail

/// Tracks from t = 0 the paths that start at `start(path)`, a RuntimePoint<double>, for each of `paths`, or from
/// (ends[k].q, ends[k].t) where that has a t > 0; where paths[k] was left goes to ends[k] (q, t, steps, arrival,
/// reason). R: the pack of lanes, or a scalar type.
template <class R, bool Pivoted, class H, class StartPoint>
void track_lanes(const H& homotopy, const TrackerOptions& options, std::span<const std::uint64_t> paths,
                 const StartPoint& start, std::span<Endpoint> ends) {
    std::optional<FlushDenormals> flush;
    if constexpr (is_single<R>) flush.emplace();
    detail::LaneTracker<R, Pivoted, H, StartPoint>(homotopy, options, paths, start, ends).run();
}

/// The same in single precision, and in double from where single precision left them, of those that it did not bring to
/// t = 1. scaled: the homotopy, in numbers that single precision can work with.
template <class H, class StartPoint>
void track_single_first(const H& scaled, const H& homotopy, const TrackerOptions& options,
                        std::span<const std::uint64_t> paths, const StartPoint& start, std::span<Endpoint> ends) {
    track_lanes<FloatLanes<2 * native_lanes>, false>(scaled, options, paths, start, ends);
    std::vector<std::uint64_t> left;
    std::vector<Endpoint> on;
    for (std::size_t k = 0; k < ends.size(); ++k)
        if (ends[k].arrival != Arrival::end) left.push_back(paths[k]), on.push_back(ends[k]);
    if (left.empty()) return;
    track_lanes<Lanes<native_lanes>, false>(homotopy, options, left, start, std::span(on));
    auto next = on.begin();
    for (Endpoint& end : ends) {
        if (end.arrival == Arrival::end) continue;
        end = *next++;
        end.precision = Precision::in_double;
    }
}

}  // namespace equilibria
