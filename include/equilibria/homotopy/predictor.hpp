/// \file
/// Predictors: where a path goes, as its Taylor coefficients tell.
///
/// A predictor has `order`, the number of Taylor coefficients that it needs (1 to 3); `local_order`, the power of the
/// step that its error grows with; and, of the coefficients q_1 .. q_order of the unknowns (angles in radians),
/// `change(taylor, u, h)`, of unknown u after the step h, and `pole(taylor, n)`, the distance to the nearest pole of
/// the path as far as they can tell, n being the number of unknowns. taylor[k - 1][u] is the coefficient q_k of unknown
/// u.
#pragma once

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>

namespace equilibria {

/// A Pade(2,1) approximant an unknown. Source: Telen, Van Barel, Verschelde, A robust numerical path tracking algorithm
/// for polynomial homotopy continuation, SIAM J. Sci. Comput. 42 (2020).
template <class R>
struct PadePredictor {
    using Z = Complex<R>;                  ///< numbers of the path
    static constexpr int order = 3;        ///< Taylor coefficients that are needed
    static constexpr int local_order = 4;  ///< power of the step that the error grows with

    /// q_1 h + q_2 h^2 / (1 - h q_3 / q_2), and the cubic where that is ill-conditioned.
    static Z change(const auto& taylor, int u, const R& h) {
        const Z &q1 = taylor[0][u], &q2 = taylor[1][u], &q3 = taylor[2][u];
        const Z step3 = h * q3;
        const Z den = q2 - step3;
        // of an unknown that all but rests the squares underflow
        constexpr double rest = is_single<R> ? 1e-30 : 1e-60;
        const auto pade = norm2(step3) + rest < 0.5 * norm2(q2);
        const Z tail = select(pade, q2 * q2 / den, q2 + step3);
        return h * (q1 + h * tail);
    }
    /// An unknown's series behaves like a geometric one, with quotient q_3 / q_2, and sqrt(q_3 / q_1) where q_2 happens
    /// to vanish. An unknown that rests (a symmetric path) has none.
    static R pole(const auto& taylor, int n) {
        // coefficients below these (squared) are rounding
        constexpr double rest = is_single<R> ? 1e-10 : 1e-20, rest3 = is_single<R> ? 1e-12 : 1e-24;
        R nearest4 = broadcast<R>(is_single<R> ? 1e36 : 1e40);
        for (int u = 0; u < n; ++u) {
            const R a1 = norm2(taylor[0][u]) + rest, a2 = norm2(taylor[1][u]) + rest, a3 = norm2(taylor[2][u]) + rest3;
            const R by = 1.0 / a3;
            nearest4 = lane_min(nearest4, lane_max(a2 * a2 * by, 0.0625 * a1) * by);
        }
        return square_root(square_root(nearest4));
    }
};

}  // namespace equilibria
