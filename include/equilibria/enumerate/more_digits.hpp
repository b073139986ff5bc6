/// \file
/// For paths that rounding stops in double: from where they stand near their end, else from their start, with 31 digits
/// (sums of two doubles), then with 64.
///
/// More digits help where rounding is what stops a path: close passes to a singular point, endpoints far out, loops at
/// small radii around an ill-conditioned endpoint. They do not make the coefficients more exact, which are doubles, nor
/// the endpoints, which are polished in double. Opt-in, since it costs as much compile time as everything else.
#pragma once

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/homotopy/arc_homotopy.hpp>
#include <equilibria/paths/complex_roots.hpp>

namespace equilibria {

namespace detail {

/// Ends a path with 31 digits, and if that fails, and a start is given, with 64.
void track_with_more_digits(const PolynomialHomotopy& homotopy, const Polisher<PolynomialHomotopy>& polisher,
                            const TrackerOptions& options, const RuntimePoint<double>* start, Endpoint& end);
/// What track_with_more_digits does, but a path that came near its end and stays undecided there is left as it is: for
/// those who follow its limit (path_limit.hpp), which takes a hundredth of the time at a root of high multiplicity.
void track_with_more_digits_but_ends(const PolynomialHomotopy& homotopy, const Polisher<PolynomialHomotopy>& polisher,
                                     const TrackerOptions& options, const RuntimePoint<double>* start, Endpoint& end);
/// The same along an arc of parameters.
void track_arc_with_more_digits(const ArcHomotopy& homotopy, const Polisher<ArcHomotopy>& polisher,
                                const TrackerOptions& options, const RuntimePoint<double>* start, Endpoint& end);

}  // namespace detail

/// For solve_multihomogeneous and trace_locus.
inline constexpr MoreDigits<> more_digits = &detail::track_with_more_digits;
/// For solve_along.
inline constexpr MoreDigits<ArcHomotopy> more_digits_along_arcs = &detail::track_arc_with_more_digits;

/// `enumerate`, but paths that fail in double are tracked with more digits before they count as failed: after tighter
/// steps in double, or at once where only the endpoint was left. paths.more_digits says how many were.
template <Model M, class StartSystem = LeastCost>
RootSet<M> enumerate_with_more_digits(const Parameters<M>& p, const RunOptions& run = {},
                                      const TrackerOptions& options = {}) {
    return detail::enumerate_all<M, StartSystem>(p, run, options, more_digits);
}

/// The same for the equilibria at p from those of a solved instance.
template <Model M>
RootSet<M> enumerate_with_more_digits(const RootSet<M>& solved, const Parameters<M>& p, const RunOptions& run = {},
                                      const TrackerOptions& options = {}) {
    return detail::enumerate_by_parameters<M>(solved, p, run, options, more_digits, more_digits_along_arcs);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/more_digits_definitions.hpp>
#endif
