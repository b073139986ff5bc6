/// \file
/// The last resort for paths that fail in double: tracked from their start, and ended, with 32 digits, then with 64.
///
/// More digits help where rounding is what stops a path: close passes to a singular point, endpoints far out, loops at
/// small radii around an ill-conditioned endpoint. They do not make the coefficients more exact, which are doubles, nor
/// the endpoints, which are polished in double. Opt-in, since it costs as much compile time as everything else.
#pragma once

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/paths/complex_roots.hpp>

namespace equilibria {

namespace detail {

/// Tracks a path again with 32 digits, and if it fails once more with 64.
template <class H>
void track_with_more_digits(const H& homotopy, const Polisher<H>& polisher, const TrackerOptions& options,
                            const Point<typename H::System, double>& start, Endpoint<typename H::System>& end) {
    const auto track = [&]<class R>(R) {
        if (end.status != PathStatus::failed) return;
        const std::int32_t steps = end.steps;
        end = Endgame<H, R>(homotopy, polisher, options).from_start(start);
        end.steps += steps;
    };
    track(Multiprecision<32>());
    track(Multiprecision<64>());
}

}  // namespace detail

/// For solve_multihomogeneous and trace_locus; System: anything with as many angles and coordinates.
template <class System>
inline constexpr MoreDigitsOf<System> more_digits =
    &detail::track_with_more_digits<MultihomogeneousHomotopy<System::n_angles, System::n_coordinates>>;

/// `enumerate`, but paths that fail in double, tightened steps included, are tracked with more digits before they count
/// as failed; paths.more_digits says how many were. A path costs up to a second then.
template <Model M, class StartSystem = NaturalStart<M>>
RootSet<M> enumerate_with_more_digits(const Parameters<M>& p, const RunOptions& run = {},
                                      const TrackerOptions& options = {}) {
    return detail::enumerate_all<M, StartSystem>(p, run, options,
                                                 &detail::track_with_more_digits<ModelHomotopy<M, StartSystem>>);
}

/// The same for the equilibria at p from those of a solved instance.
template <Model M>
RootSet<M> enumerate_with_more_digits(const RootSet<M>& solved, const Parameters<M>& p, const RunOptions& run = {},
                                      const TrackerOptions& options = {}) {
    return detail::enumerate_by_parameters<M>(solved, p, run, options,
                                              &detail::track_with_more_digits<ModelHomotopy<M, Moving<M>>>);
}

}  // namespace equilibria
