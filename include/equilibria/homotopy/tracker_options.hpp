/// \file
/// What a tracker of paths needs to know.
#pragma once

#include <algorithm>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// How exactly paths are followed, and when one is given up.
struct TrackerOptions {
    double contraction = 2e-3;          ///< target of Theta, in (0, 0.05]; smaller: shorter, safer steps
    double largest_contraction = 0.05;  ///< a step with a larger Theta is refused
    double largest_turn = 0.4;          ///< largest predicted change of an angle in a step, radians
    double pole_fraction = 0.4;         ///< largest step over the distance to the nearest pole of the path, in (0, 1)
    double smallest_step = 1e-12;       ///< a path that needs a smaller one fails
    double endgame_start = 1e-5;        ///< a path that can't reach t = 1 in one step from 1 - this goes to the endgame
    int most_steps = 3000;              ///< steps of one path, refused ones included
    bool single_precision = true;       ///< where it pays; false: doubles alone

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(contraction > 0 && contraction <= 0.05, "contraction", contraction, "must be in (0, 0.05]");
        require(largest_contraction >= contraction && largest_contraction <= 0.1, "largest_contraction",
                largest_contraction, "must be between contraction and 0.1");
        require(largest_turn > 0 && largest_turn <= 0.5, "largest_turn", largest_turn, "must be in (0, 0.5]");
        require(pole_fraction > 0 && pole_fraction < 1, "pole_fraction", pole_fraction, "must be in (0, 1)");
        require(smallest_step > 0 && smallest_step < 1e-3, "smallest_step", smallest_step, "must be in (0, 1e-3)");
        require(endgame_start > 0 && endgame_start < 0.1, "endgame_start", endgame_start, "must be in (0, 0.1)");
        require(most_steps > 0, "most_steps", most_steps, "must be positive");
    }
    /// Half the step, for paths that are tracked again.
    TrackerOptions tightened() const {
        TrackerOptions o = *this;
        o.contraction /= 100;
        o.largest_contraction = std::max(o.contraction, o.largest_contraction / 20);
        o.pole_fraction /= 2;
        o.largest_turn /= 2;
        return o;
    }
};

}  // namespace equilibria
