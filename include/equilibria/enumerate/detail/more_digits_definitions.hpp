/// \file
/// See enumerate/more_digits.hpp.
#pragma once

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/endgame.hpp>

namespace equilibria::detail {

template <class H>
void track_again_with_more_digits(const H& homotopy, const Polisher<H>& polisher, const TrackerOptions& options,
                                  const RuntimePoint<double>& start, Endpoint& end) {
    const auto track = [&]<class R>(R) {
        if (end.status != PathStatus::failed) return;
        const std::int32_t steps = end.steps;
        end = Endgame<H, R>(homotopy, polisher, options).from_start(start);
        end.steps += steps;
    };
    track(Multiprecision<32>());
    track(Multiprecision<64>());
}

EQUILIBRIA_INLINE void track_with_more_digits(const PolynomialHomotopy& homotopy,
                                              const Polisher<PolynomialHomotopy>& polisher,
                                              const TrackerOptions& options, const RuntimePoint<double>& start,
                                              Endpoint& end) {
    track_again_with_more_digits(homotopy, polisher, options, start, end);
}
EQUILIBRIA_INLINE void track_arc_with_more_digits(const ArcHomotopy& homotopy, const Polisher<ArcHomotopy>& polisher,
                                                  const TrackerOptions& options, const RuntimePoint<double>& start,
                                                  Endpoint& end) {
    track_again_with_more_digits(homotopy, polisher, options, start, end);
}

}  // namespace equilibria::detail
