/// \file
/// Krawczyk's test on the torus, one point a lane: a proof that exactly one root lies in a polydisc around a point, for
/// every value of the parameters in their intervals.
///
/// With Y close to J^-1 let T(d) = d - Y F(x + d), d in the polydisc |d_u| <= r_u (angles displaced in radians). If
/// E >= |1 - Y J(x + d)| for all those d, then |T(d)| <= |Y F(x)| + E r, and |T(d) - T(d')| <= E |d - d'|. So
/// |Y F(x)| + E r <= r and E r < r make T a contraction of the polydisc into itself, in the norm weighted by r: one
/// zero of F is in it, no other, and every matrix in the hull of the Jacobians is regular. Found by eps-inflation of r.
/// Sources: Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4 (1969); Rump,
/// Verification methods, Acta Numerica 19 (2010); Breiding, Rose, Timme, Certifying zeros of polynomial systems using
/// interval arithmetic, ACM Trans. Math. Software 49 (2023).
#pragma once

#include <array>

#include <equilibria/certify/detail/ball_evaluation.hpp>
#include <equilibria/core/linear_solve.hpp>

namespace equilibria {

/// The outcome for one lane of points.
template <class M, class R>
struct KrawczykResult {
    using Mask = typename LaneTraits<R>::Mask;
    static constexpr int n = n_unknowns<M>;

    Mask proved{};
    R radius[n]{};       ///< |root - point| of each unknown, angles in radians; meaningful where proved
    R weight[n]{};       ///< radii of the polydisc of e in which the root is alone: E weight < weight
    Point<M, R> center;  ///< of the enclosure of (c, s, x)
    R off[n]{};          ///< radius of the enclosures of c_u and s_u, or of x_u, around `center`
    // for proofs about the Jacobians over the polydisc
    Complex<R> jacobian[n][n], inverse[n][n], basis[n][n];  ///< J at the point, Y, and B: displacements are B e
    R contraction[n][n]{};                                  ///< E >= |1 - Y J B| over the polydisc of e
};

namespace detail {

template <class R, int N>
void approximate_inverse(const Complex<R> (&j)[N][N], Complex<R> (&y)[N][N]) {
    PivotedFactorization<R, N> lu;
    lu.factor(j);
    for (int c = 0; c < N; ++c) {
        Complex<R> e[N];
        for (int r = 0; r < N; ++r) e[r] = Complex<R>(r == c ? 1.0 : 0.0);
        lu.solve(e);
        for (int r = 0; r < N; ++r) y[r][c] = e[r];
    }
}

/// E >= |1 - Y J| for all J in the balls: a midpoint product with its a priori bound, and |Y| times the radii.
template <class R, int N>
void contraction(const Complex<R> (&y)[N][N], const R (&size_y)[N][N], const Ball<R> (&j)[N][N], R (&e)[N][N]) {
    const R unit = R{} + (N + 4) * rounding_unit<R>;
    R spread[N][N];
    for (int r = 0; r < N; ++r)
        for (int c = 0; c < N; ++c) spread[r][c] = rounded_up<R>(j[r][c].rad + unit * magnitude_bound(j[r][c].mid));
    for (int r = 0; r < N; ++r)
        for (int c = 0; c < N; ++c) {
            Complex<R> product(r == c ? 1.0 : 0.0);
            R sum = R{} + (r == c ? static_cast<double>(N) * rounding_unit<R> : 0 * rounding_unit<R>);
            for (int k = 0; k < N; ++k) {
                product -= y[r][k] * j[k][c].mid;
                sum = sum + size_y[r][k] * spread[k][c];
            }
            e[r][c] = rounded_up<R>(magnitude_bound(product) + sum * (1 + unit));
        }
}

}  // namespace detail

namespace detail {

/// The bound of |Y v| for the balls v.
template <class R, int N>
void product_bound(const Complex<R> (&y)[N][N], const R (&size_y)[N][N], const Ball<R> (&v)[N], R (&bound)[N]) {
    const R unit = R{} + (N + 4) * rounding_unit<R>;
    for (int u = 0; u < N; ++u) {
        Complex<R> sum(0.0);
        R error = R{} + 0.0;
        for (int k = 0; k < N; ++k) {
            sum += y[u][k] * v[k].mid;
            error = error + size_y[u][k] * (v[k].rad + unit * magnitude_bound(v[k].mid));
        }
        bound[u] = rounded_up<R>(magnitude_bound(sum) + error * (1 + unit));
    }
}

/// Fills in what a proof says of the enclosure of (c, s, x), given the factors over the radii.
template <class M, class R>
void enclose(const FactorBalls<M, R>& wide, KrawczykResult<M, R>& out) {
    for (int u = 0; u < n_unknowns<M>; ++u) {
        const Ball<R>& first = wide.at(u, 1);
        out.off[u] = first.rad;
        if (u < n_angles<M>) {
            out.center.c[u] = first.mid;
            out.center.s[u] = wide.at(u, -1).mid;
            out.off[u] = lane_max(first.rad, wide.at(u, -1).rad);
        } else {
            out.center.x[u - n_angles<M>] = first.mid;
        }
    }
}

}  // namespace detail

/// The test at the points q, one a lane. real: the polydisc is centred at the real point next to q, so that the root
/// it holds is real: its conjugate is a root in it as well.
template <class M, class R, class S>
KrawczykResult<M, R> krawczyk(const BallSystem<M, S>& system, const Point<M, R>& q, bool real) {
    using Mask = typename LaneTraits<R>::Mask;
    constexpr int n = n_unknowns<M>;
    KrawczykResult<M, R> out;
    const FactorBalls<M, R> at(system, q, real);
    Ball<R> f[n], j[n][n];
    ball_values(system, at, f);
    ball_jacobian(system, at, j);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) out.jacobian[r][c] = j[r][c].mid, out.basis[r][c] = Complex<R>(r == c ? 1.0 : 0.0);
    detail::approximate_inverse(out.jacobian, out.inverse);
    R size_y[n][n], newton[n], r[n];
    const R unit = R{} + (n + 4) * rounding_unit<R>;
    for (int u = 0; u < n; ++u)
        for (int k = 0; k < n; ++k) size_y[u][k] = rounded_up<R>(magnitude_bound(out.inverse[u][k]));
    detail::product_bound(out.inverse, size_y, f, newton);
    for (int u = 0; u < n; ++u) r[u] = rounded_up<R>(2.0 * newton[u] + rounding_unit<R> * (R{} + 1e-3));
    out.proved = R{} > R{} + 1.0;
    for (int round = 0; round < 6; ++round) {
        ball_jacobian(system, at.widened(r), j);
        R e[n][n], reach[n];
        detail::contraction(out.inverse, size_y, j, e);
        Mask holds = R{} < R{} + 1.0;
        for (int u = 0; u < n; ++u) {
            R sum = R{} + 0.0;
            for (int k = 0; k < n; ++k) sum = sum + e[u][k] * r[k];
            sum = rounded_up<R>(sum * (1 + unit));
            reach[u] = rounded_up<R>(newton[u] + sum);
            holds = mask_and<Mask>(holds, mask_and<Mask>(reach[u] <= r[u], sum < r[u]));
        }
        const Mask fresh = mask_and<Mask>(holds, mask_not(out.proved));
        out.proved = mask_not(mask_and<Mask>(mask_not(out.proved), mask_not(holds)));
        for (int u = 0; u < n; ++u) {
            out.radius[u] = select(fresh, reach[u], out.radius[u]);
            out.weight[u] = select(fresh, r[u], out.weight[u]);
            for (int k = 0; k < n; ++k) out.contraction[u][k] = select(fresh, e[u][k], out.contraction[u][k]);
        }
        if (all_lanes(out.proved)) break;
        for (int u = 0; u < n; ++u) r[u] = select(out.proved, r[u], R(1.3 * reach[u]));
    }
    detail::enclose(at.widened(out.radius), out);
    return out;
}

}  // namespace equilibria
