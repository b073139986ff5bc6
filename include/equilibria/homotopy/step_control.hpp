/// \file
/// Step control: how far a predictor may go, and whether what the corrector made of a prediction is still on its path.
///
/// A step control is made from TrackerOptions; it has `first(pole)` and `longest(pole)`, the steps to begin with and at
/// most at that distance from the nearest pole of the path, and `judge(trial)`, on all lanes at once.
#pragma once

#include <cmath>

#include <equilibria/core/lanes.hpp>
#include <equilibria/homotopy/tracker_options.hpp>

namespace equilibria {

/// A step that was predicted and corrected, and what is known of it. Squares of sizes, in radians of angles and against
/// 1 + |x| of coordinates.
template <class R>
struct Trial {
    R step;     ///< that was made
    R asked;    ///< for: `step` may be shorter
    R turn2;    ///< the largest predicted change of an angle
    R first2;   ///< of Newton's step from the prediction
    R second2;  ///< of the simplified one after it, rounding taken off
    R noise2;   ///< corrections up to this size may be rounding
};

/// What the step control makes of a trial, in each lane.
template <class R>
struct Verdict {
    typename LaneTraits<R>::Mask accepted;  ///< the new point is on the path
    R next_step;                            ///< from the new point if accepted, else again from the old one
};

/// Theta = |second| / |first| correction, half of Newton's Lipschitz figure times the error of the prediction, is far
/// below 1 where the prediction is an approximate zero of this path and not of its neighbour's. The next step makes
/// Theta its target; it grows with the power local_order of the step. Source: Timme, Mixed precision path tracking for
/// polynomial homotopy continuation, Adv. Comput. Math. 47 (2021).
template <class R, int local_order>
class ContractionControl {
public:
    using Mask = typename LaneTraits<R>::Mask;  ///< a truth value for each lane

    /// Of the contraction, the turn and the share of the pole's distance that the options allow.
    explicit ContractionControl(const TrackerOptions& options) : options_(options) {}

    /// The longest step at this distance from the nearest pole.
    R longest(const R& pole) const { return options_.pole_fraction * pole; }
    R first(const R& pole) const { return lane_min(R{} + 0.4, longest(pole)); }  ///< the step to begin with

    /// Whether the new point is accepted, and the next step.
    Verdict<R> judge(const Trial<R>& trial) const {
        const R &h = trial.step, &turn2 = trial.turn2;
        // a first correction below the noise is no cause for concern, and its quotient may be rounding
        const R first2 = trial.first2 + trial.noise2;
        const R largest_turn2 = options_.largest_turn * options_.largest_turn + R{};
        const R largest_theta2 = options_.largest_contraction * options_.largest_contraction + R{};
        const R largest_first2 = R{} + 1e-2;
        Verdict<R> y;
        y.accepted = mask_and(mask_and(turn2 < largest_turn2, trial.second2 < largest_theta2 * first2),
                              trial.first2 < largest_first2);
        // h (target / Theta)^(1 / local_order), between a quarter and four times h
        const R growth =
            root((options_.contraction * options_.contraction) * first2 / (trial.second2 + 1e-28 * first2));
        R proposed = h * lane_min(lane_max(growth, R{} + 0.25), R{} + 4.0);
        const R turn_limit = h * (0.8 * options_.largest_turn) / square_root(turn2 + 1e-30);
        proposed = lane_min(proposed, lane_max(turn_limit, 0.25 * h));
        y.next_step = select(y.accepted, proposed, select(proposed < 0.5 * h, proposed, 0.5 * h));
        // a NaN proposal: shrink
        y.next_step = select(y.next_step > R{} + 0.0, y.next_step, 0.25 * trial.asked);
        return y;
    }

private:
    /// a^(1 / (2 local_order))
    static R root(const R& a) {
        static_assert(local_order >= 1);
        if constexpr (local_order == 1) {
            return square_root(a);
        } else if constexpr (local_order % 2 == 0) {
            return square_root(ContractionControl<R, local_order / 2>::root(a));
        } else {
            R y = a;
            for (int k = 0; k < LaneTraits<R>::width; ++k) {
                using std::pow;
                using Scalar = typename LaneTraits<R>::Scalar;
                set_lane(y, k, Scalar(pow(lane(a, k), Scalar(0.5 / local_order))));
            }
            return y;
        }
    }
    template <class, int>
    friend class ContractionControl;

    TrackerOptions options_;
};

}  // namespace equilibria
