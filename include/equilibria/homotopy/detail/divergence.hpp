/// \file
/// What tells a path to infinity from one to a finite point: valuations on two scales of 1-t, growth between them, and
/// poles that closed loops show. Sources: Morgan, Sommese, Wampler, A power series method for computing singular
/// solutions to nonlinear analytic systems, Numer. Math. 63 (1992); Timme, Mixed precision path tracking for polynomial
/// homotopy continuation, Adv. Comput. Math. 47 (2021) (valuation test).
#pragma once

#include <algorithm>
#include <cmath>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/detail/closed_loop.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria::detail {

/// |(1-t) q_u'(t)| of each angle, |(1-t) x'/x| of each coordinate; -1 without one.
using Valuations = SizedArray<double, at_run_time>;

inline bool are_below(const Valuations& nu, double most) {
    return std::all_of(nu.begin(), nu.end(), [&](double v) { return v < most; });
}

/// The unknown that is farthest out.
template <class R>
int farthest(const RuntimePoint<R>& q) {
    int u = 0;
    for (int k = 1; k < unknowns(q); ++k)
        if (unknown_size2(q, k) > unknown_size2(q, u)) u = k;
    return u;
}
/// Whether that one is more than 10 out.
template <class R>
bool is_far(const RuntimePoint<R>& q) {
    return unknown_size2(q, farthest(q)) > 100;
}

/// Some unknown is far out, and its valuation is positive and the same on two scales; and that of the farthest one
/// does not fall, as it does near a finite solution that is merely far away. all: each unknown that is far out has such
/// a valuation, or none; near a badly conditioned solution some may look so by chance. One that is a million times
/// nearer than the farthest has too few digits to say so.
template <class R>
bool diverges(const RuntimePoint<R>& q, const Valuations& nu, const Valuations& before, bool all = false) {
    const int last = farthest(q);
    if (!(nu[last] > 0.05 && nu[last] > 0.9 * before[last])) return false;
    const auto with_digits2 = 1e-12 * unknown_size2(q, last);
    bool some = false;
    for (int u = 0; u < unknowns(q); ++u) {
        const auto size2 = unknown_size2(q, u);
        if (!(size2 > 100 && nu[u] > 0.05)) continue;
        const bool settled = before[u] > 0 && std::abs(nu[u] - before[u]) < 0.05 * nu[u];
        if (all && !settled && size2 > with_digits2) return false;
        some = some || settled;
    }
    return some;
}

/// Whether some unknown is very far out, and has grown since ten times the radius by a power of it between its
/// valuations on both scales, which do not fall. all: each unknown that is far out has grown so, the
/// farthest among them, and they agree.
template <class R>
bool grows(const RuntimePoint<R>& q, const Valuations& nu, const RuntimePoint<R>& back, const Valuations& before,
           bool all = false) {
    if (all && !(nu[farthest(q)] > 0.05)) return false;
    bool some = false;
    for (int u = 0; u < unknowns(q); ++u) {
        const double size2 = static_cast<double>(unknown_size2(q, u));
        if (!(size2 > 100 && nu[u] > 0.05)) continue;
        const double growth = 0.5 * std::log10(size2 / static_cast<double>(unknown_size2(back, u)));
        const bool steady =
            nu[u] > 0.9 * before[u] && growth > 0.9 * std::min(nu[u], before[u]) && growth < 1.1 * nu[u];
        if (all && !(steady && nu[u] < 1.1 * before[u])) return false;
        some = some || (steady && size2 > 1e8);
    }
    return some;
}

/// Where loops at r and at a larger radius show the same pole: the radius down to which they exclude a finite
/// solution, whose branch point so close to t = 1 would add terms of lower orders. 1 where they do not.
template <class R>
double excluded_radius(const ClosedLoop<R>& at_r, double r, const ClosedLoop<R>& wider) {
    const bool same = at_r.winding == wider.winding && at_r.pole == wider.pole;
    return same && at_r.pole > 0 ? at_r.beyond * r : 1;
}

}  // namespace equilibria::detail
