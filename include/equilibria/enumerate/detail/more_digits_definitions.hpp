/// \file
/// See enumerate/more_digits.hpp.
#pragma once

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/endgame.hpp>

namespace equilibria::detail {

/// Whether Newton's method in R converges from the endpoint, quadratically and next to it: then it is a regular
/// solution, whatever its condition, and the endpoint becomes it. (At a multiple one it converges linearly.)
template <class R, class H>
bool is_regular_in_digits(const H& homotopy, Endpoint& end) {
    constexpr int most_corrections = 8;
    const int n = homotopy.sizes().unknowns;
    typename H::template Evaluation<R, Complex<R>> evaluation(homotopy);
    PivotedFactorization<R> lu(n);
    RuntimeArray<Complex<R>> f(n);
    RuntimeMatrix<Complex<R>> j(n);
    RuntimePoint<R> q;
    copy_lane(end.q, 0, q, 0);
    for (int k = 0; k < most_corrections; ++k) {
        evaluation.target_jacobian(q, f, j);
        if (homotopy.symmetric())
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
        lu.factor(j);
        for (int i = 0; i < n; ++i) f[i] = -f[i];
        lu.solve(f);
        const auto size2 = static_cast<double>(correction_size(q, f));
        if (!(size2 < 1e-6)) return false;
        correct(q, f);
        if (size2 > 1e-48) continue;
        RuntimePoint<double> root;
        copy_lane(q, 0, root, 0);
        if (!(distance(root, end.q) < 1e-3)) return false;
        end.q = root;
        return true;
    }
    return false;
}

template <class H>
void track_again_with_more_digits(const H& homotopy, const Polisher<H>& polisher, const TrackerOptions& options,
                                  const RuntimePoint<double>& start, Endpoint& end) {
    // far out, or where equations are badly scaled, regular solutions have conditions that doubles take for singular
    // ones, or that no step in double comes close to
    if (end.status == PathStatus::singular || end.status == PathStatus::failed) {
        if (is_regular_in_digits<Multiprecision<32>>(homotopy, end)) {
            typename Polisher<H>::template Workspace<double> with(homotopy);
            polisher.assess(end.q, &end.evidence, with);
            end.status = PathStatus::finite;
            end.reason = FailureReason::none;
        }
        if (end.status == PathStatus::singular) return;
    }
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
