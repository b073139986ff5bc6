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
template <Model M, StartKind Kind, class C>
void rescue_path(const Homotopy<M, Kind, C>& homotopy, const Polisher<M, Kind, C>& polisher,
                 const TrackerOptions& options, const Point<M, double>& start, Endpoint<M>& end) {
    const auto track = [&]<class R>(R) {
        if (end.status != PathStatus::failed) return;
        const std::int32_t steps = end.steps;
        end = Endgame<M, Kind, C, R>(homotopy, polisher, options).from_start(start);
        end.steps += steps;
    };
    track(Multiprecision<32>());
    track(Multiprecision<64>());
}

}  // namespace detail

/// For solve_multihomogeneous, solve_from and trace_locus.
template <Model M>
inline constexpr RootRescue<M> careful_roots = &detail::rescue_path<LinearProduct<M>, StartKind::parameter, double>;

/// `enumerate`, but paths that fail in double, tightened steps included, are tracked with more digits before they count
/// as failed; paths.more_digits says how many were. A path costs up to a second then.
template <Model M, StartKind Kind = natural_start<M>()>
RootSet<M> enumerate_carefully(const Parameters<M>& p, const EnumerateOptions& options = {}) {
    detail::check_arguments<M, Kind>(p, options);
    return detail::enumerate_total_degree<M, Kind>(p, options, &detail::rescue_path<M, Kind, double>);
}

/// The same for the equilibria at p from those of a solved instance.
template <Model M>
RootSet<M> enumerate_carefully(const RootSet<M>& solved, const Parameters<M>& p, const EnumerateOptions& options = {}) {
    detail::check_arguments<M>(solved, p, options);
    return detail::enumerate_from<M>(solved.roots, solved.parameters, p, options,
                                     &detail::rescue_path<M, StartKind::parameter, double>);
}

}  // namespace equilibria
