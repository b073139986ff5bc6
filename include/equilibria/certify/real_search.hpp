/// \file
/// Branch and prune over the torus of real angles: a proof that systems have no real root beside those that
/// are known, for any parameters in their intervals. It needs no bound on the number of complex roots, and none of
/// them.
///
/// The torus is cut into boxes m + d, |d_u| <= r_u. With J and F_k, the derivatives by the unknowns and the parameters,
/// over the whole box and all parameters, any matrix Y and the parameters' distances |t_k| <= w_k from their middle,
///     |F(m)| > |J| r + sum |F_k| w_k,  or  |Y F(m)| > r + |1 - Y J| r + sum |Y F_k| w_k
/// in one component excludes a root (mean value theorem; the second one with Y the inverse of the midpoint of J). And
/// |1 - Y J| r < r makes F injective over the box, so that a known root in it is the only one. What is neither is cut
/// in two. Sources: Hansen, Walster, Global Optimization Using Interval Analysis, chapter 11; Neumaier, Interval
/// Methods for Systems of Equations, chapter 5.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <equilibria/certify/krawczyk_systems.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria {

/// All real angles with |theta_u - center_u| <= radius_u, in radians and up to whole turns.
struct AngleBox {
    RuntimeArray<double> center;  ///< of each angle
    RuntimeArray<double> radius;  ///< of each angle, not negative

    AngleBox() = default;
    explicit AngleBox(int n) : center(n), radius(n) {}  ///< room for n angles, all 0

    /// That of the root which lane k of a test with real = true proves, for all parameters of the test.
    template <class M, class R>
    static AngleBox of(const KrawczykResult<R>& proof, const Point<M, R>& q, int k) {
        AngleBox y(proof.radius.size());
        for (int u = 0; u < y.center.size(); ++u) {
            y.center[u] = std::atan2(lane(q.s[u].re, k), lane(q.c[u].re, k));
            y.radius[u] = rounded_up(lane(proof.radius[u], k) + angle_rounding);
        }
        return y;
    }
    /// Covers the rounding of angles up to a few turns, and of their sines and cosines.
    static constexpr double angle_rounding = 64 * std::numeric_limits<double>::epsilon();
};

/// What a search found: nothing but the known roots, or a box that it could not decide.
struct RealSearchResult {
    bool complete = false;  ///< there is no real root outside the boxes given
    std::size_t boxes = 0;  ///< that were examined
};

/// Whether systems in angles alone have no real roots but one in each of the given boxes, for all their parameters. The
/// boxes hold proved roots and are disjoint; at most `most` boxes are examined.
RealSearchResult search_real_roots(const BallSystems<double>& systems, const std::vector<AngleBox>& roots,
                                   std::size_t most);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/real_search_definitions.hpp>
#endif
