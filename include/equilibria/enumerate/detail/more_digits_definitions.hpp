/// \file
/// See enumerate/more_digits.hpp.
#pragma once

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/endgame.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE void track_with_more_digits(const PolynomialHomotopy& homotopy,
                                              const Polisher<PolynomialHomotopy>& polisher,
                                              const TrackerOptions& options, const RuntimePoint<double>& start,
                                              Endpoint& end) {
    const auto track = [&]<class R>(R) {
        if (end.status != PathStatus::failed) return;
        const std::int32_t steps = end.steps;
        end = Endgame<PolynomialHomotopy, R>(homotopy, polisher, options).from_start(start);
        end.steps += steps;
    };
    track(Multiprecision<32>());
    track(Multiprecision<64>());
}

}  // namespace equilibria::detail
