/// \file
/// See enumerate/more_digits.hpp.
#pragma once

#include <array>
#include <cstdint>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/endgame.hpp>
#include <equilibria/homotopy/newton_in_digits.hpp>

namespace equilibria::detail {

/// undecided_ends: paths that came near their end and stay undecided there are tracked again as well.
template <class H>
void track_again_with_more_digits(const H& homotopy, const Polisher<H>& polisher, const TrackerOptions& options,
                                  const RuntimePoint<double>* start, Endpoint& end, bool undecided_ends = true) {
    if (start == nullptr) {
        Endpoint here = end;
        if (Endgame<H, DoubleDouble>(homotopy, polisher, options).end_straight(here)) end = here;
        return;
    }
    const Endpoint before = end;
    // far out, or where equations are badly scaled, regular solutions have conditions that doubles take for singular
    // ones, or that no step in double comes close to
    if (end.status == PathStatus::singular || end.status == PathStatus::failed) {
        RuntimePoint<DoubleDouble> q;
        copy_lane(end.q, 0, q, 0);
        if (!converges_in_digits(homotopy, q)) {
            if (end.status == PathStatus::singular) return;
        } else if (end.status == PathStatus::singular && end.winding_number > 1) {
            // rounding disturbed the loops in double, or another solution is too near for them
            end.status = PathStatus::failed;
        } else {
            copy_lane(q, 0, end.q, 0);
            typename Polisher<H>::template Workspace<double> with(homotopy);
            polisher.assess(end.q, &end.evidence, with);
            end.status = PathStatus::finite;
            end.reason = FailureReason::none;
            return;
        }
    }
    if (!undecided_ends && end.reason == FailureReason::endgame_undecided && end.t > 0.98) return;
    const auto track = [&]<class R>(R) {
        if (end.status != PathStatus::failed) return;
        Endgame<H, R> endgame(homotopy, polisher, options);
        const std::int32_t steps = end.steps;
        // from where it stands, if it had come close: a regular solution there is the path's
        if (end.t > 0.98) {
            Endpoint here = end;
            here.steps = 0;
            endgame.finish(std::array{&here});
            here.steps += steps;
            if (here.status == PathStatus::finite) {
                end = here;
                return;
            }
        }
        end = endgame.from_start(*start);
        end.steps += steps;
    };
    track(DoubleDouble());
    track(Multiprecision<64>());
    if (end.status == PathStatus::failed && before.status == PathStatus::singular) end = before;
}

EQUILIBRIA_INLINE void track_with_more_digits(const PolynomialHomotopy& homotopy,
                                              const Polisher<PolynomialHomotopy>& polisher,
                                              const TrackerOptions& options, const RuntimePoint<double>* start,
                                              Endpoint& end) {
    track_again_with_more_digits(homotopy, polisher, options, start, end);
}
EQUILIBRIA_INLINE void track_with_more_digits_but_ends(const PolynomialHomotopy& homotopy,
                                                       const Polisher<PolynomialHomotopy>& polisher,
                                                       const TrackerOptions& options, const RuntimePoint<double>* start,
                                                       Endpoint& end) {
    track_again_with_more_digits(homotopy, polisher, options, start, end, false);
}
EQUILIBRIA_INLINE void track_arc_with_more_digits(const ArcHomotopy& homotopy, const Polisher<ArcHomotopy>& polisher,
                                                  const TrackerOptions& options, const RuntimePoint<double>* start,
                                                  Endpoint& end) {
    track_again_with_more_digits(homotopy, polisher, options, start, end);
}

}  // namespace equilibria::detail
