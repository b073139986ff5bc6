/// \file
/// Krawczyk's test for all parameters in intervals at once: one root for each of them.
///
/// Displacements are written as d = B (X t + e): t are the parameters' distances from the middle of their intervals, X
/// the root's approximate derivative by them, and e a remainder of second order, |e_u| <= s_u. B is an orthonormal
/// basis that starts with the directions in which the Jacobian is weak, so that a wide range along those does not stand
/// for a wide range along the others. With Y close to (J B)^-1 the test is |Y F(x + B X t, p + t)| + E s <= s, E s < s,
/// for all t. Both terms are bounded by the mean value theorem with the second derivatives over the whole range, what
/// cancels between terms being summed first. The intervals may be several times as wide as with J over them, and near a
/// fold the widest possible ones are only a constant factor wider.
#pragma once

#include <vector>

#include <array>

#include <equilibria/certify/krawczyk.hpp>

namespace equilibria {

/// A family of systems over S, see ExactFamily.
template <class M, class S, int N>
struct BallFamily {
    BallSystem<M, S> center, all;
    std::vector<BallSystem<M, S>> derivative;
    Array<S, N> half_width;

    explicit BallFamily(const ExactFamily<M, N>& exact) : center(exact.center), all(exact.all) {
        // one table of factors serves them all
        for (int u = 0; u < n_unknowns<M>; ++u) center.highest[u] = std::max(all.highest[u], center.highest[u]);
        for (int k = 0; k < N; ++k) {
            derivative.emplace_back(exact.derivative[k]);
            half_width[k] = static_cast<S>(exact.half_width[k]);
        }
    }
};

namespace detail {

/// Columns that span those of y, orthonormal to rounding: the directions that y makes longest come first.
template <class R, int N>
void weak_directions(const Complex<R> (&y)[N][N], Complex<R> (&b)[N][N]) {
    for (int c = 0; c < N; ++c) {
        for (int r = 0; r < N; ++r) b[r][c] = y[r][c];
        for (int round = 0; round < 2; ++round)
            for (int k = 0; k < c; ++k) {
                Complex<R> dot(0.0);
                for (int r = 0; r < N; ++r) dot += conj(b[r][k]) * b[r][c];
                for (int r = 0; r < N; ++r) b[r][c] -= dot * b[r][k];
            }
        R size = R{} + 0.0;
        for (int r = 0; r < N; ++r) size = size + norm2(b[r][c]);
        const R by = 1.0 / square_root(size);
        for (int r = 0; r < N; ++r) b[r][c] = by * b[r][c];
    }
}

template <class R, int N>
using BallMatrix = std::array<std::array<Ball<R>, N>, N>;

template <class R, int N>
BallMatrix<R, N> times(const Ball<R> (&a)[N][N], const Complex<R> (&b)[N][N]) {
    BallMatrix<R, N> y;
    for (int r = 0; r < N; ++r)
        for (int c = 0; c < N; ++c) {
            Ball<R> sum(Complex<R>(0.0));
            for (int k = 0; k < N; ++k) sum += a[r][k] * Ball<R>(b[k][c]);
            y[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = sum;
        }
    return y;
}

}  // namespace detail

/// The test at the points q, one a lane; see krawczyk for one system. The radii and the enclosures hold the roots of
/// all parameters of the family, and E the Jacobians at all of them.
template <class M, class R, class S, int N>
KrawczykResult<M, R> krawczyk(const BallFamily<M, S, N>& family, const Point<M, R>& q, bool real) {
    using Mask = typename LaneTraits<R>::Mask;
    using Matrix = detail::BallMatrix<R, n_unknowns<M>>;
    constexpr int n = n_unknowns<M>;
    const auto derivative = [&](int k) -> const BallSystem<M, S>& {
        return family.derivative[static_cast<std::size_t>(k)];
    };
    const auto entry = [](Matrix& m, int r, int c) -> Ball<R>& {
        return m[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    };
    const R unit = R{} + (n + 4) * rounding_unit<R>, zero = R{} + 0.0;
    R width[N];
    for (int m = 0; m < N; ++m) width[m] = broadcast<R>(family.half_width[m]);

    KrawczykResult<M, R> out;
    const FactorBalls<M, R> at(family.center, q, real);
    Ball<R> f[n], j[n][n], g[n][n];
    ball_values(family.center, at, f);
    ball_jacobian(family.center, at, j);
    Complex<R> y[n][n];
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) out.jacobian[r][c] = j[r][c].mid;
    detail::approximate_inverse(out.jacobian, y);
    detail::weak_directions(y, out.basis);
    const auto& b = out.basis;
    Matrix jb = detail::times(j, b);
    Complex<R> middle[n][n];
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) middle[r][c] = entry(jb, r, c).mid;
    detail::approximate_inverse(middle, out.inverse);
    R size_y[n][n], size_b[n][n];
    for (int u = 0; u < n; ++u)
        for (int k = 0; k < n; ++k) {
            size_y[u][k] = rounded_up<R>(magnitude_bound(out.inverse[u][k]));
            size_b[u][k] = rounded_up<R>(magnitude_bound(b[u][k]));
        }
    const auto bound = [&](const Ball<R>(&v)[n], R(&z)[n]) { detail::product_bound(out.inverse, size_y, v, z); };

    // what does not depend on the radii: the values at the middle and |1 - Y J B| there
    R part[n], fixed[n], fixed_e[n][n], along[n];
    bound(f, fixed);
    for (int c = 0; c < n; ++c) {
        Ball<R> column[n];
        for (int r = 0; r < n; ++r) column[r] = entry(jb, r, c);
        // 1 - Y (J B), the 1 taken into the sum
        for (int r = 0; r < n; ++r) {
            Complex<R> sum(r == c ? 1.0 : 0.0);
            R error = zero + (r == c ? static_cast<double>(n) : 0.0) * rounding_unit<R>;
            for (int k = 0; k < n; ++k) {
                sum -= out.inverse[r][k] * column[k].mid;
                error = error + size_y[r][k] * (column[k].rad + unit * magnitude_bound(column[k].mid));
            }
            fixed_e[r][c] = rounded_up<R>(magnitude_bound(sum) + error * (1 + unit));
        }
    }
    // X, and the part of F that it does not cancel
    Complex<R> x[n][N];
    for (R& value : along) value = zero;
    for (int m = 0; m < N; ++m) {
        ball_values(derivative(m), at, f);
        for (int u = 0; u < n; ++u) {
            x[u][m] = Complex<R>(0.0);
            for (int k = 0; k < n; ++k) x[u][m] -= out.inverse[u][k] * f[k].mid;
            along[u] = rounded_up<R>(along[u] + magnitude_bound(x[u][m]) * width[m]);
        }
        for (int r = 0; r < n; ++r)
            for (int k = 0; k < n; ++k) f[r] += entry(jb, r, k) * Ball<R>(x[k][m]);
        bound(f, part);
        for (int u = 0; u < n; ++u) fixed[u] = rounded_up<R>(fixed[u] + width[m] * part[u]);
    }

    R s[n];
    for (int u = 0; u < n; ++u)
        s[u] = rounded_up<R>(2.0 * fixed[u] + 0.3 * along[u] + rounding_unit<R> * (zero + 1e-3));
    const auto range = [&](const R(&rest)[n], R(&d)[n]) {
        for (int u = 0; u < n; ++u) {
            R sum = zero;
            for (int k = 0; k < n; ++k) sum = sum + size_b[u][k] * (along[k] + rest[k]);
            d[u] = rounded_up<R>(sum * (1 + unit));
        }
    };
    out.proved = R{} > zero + 1.0;
    R best[n]{};
    for (int round = 0; round < 5; ++round) {
        R d[n], e[n][n], second[n];
        range(s, d);
        const FactorBalls<M, R> wide = at.widened(d);
        for (int u = 0; u < n; ++u) {
            second[u] = zero;
            for (int k = 0; k < n; ++k) e[u][k] = fixed_e[u][k];
        }
        const auto widen = [&](Matrix& slope, const R& by) {  // e += |Y slope| by
            for (int c = 0; c < n; ++c) {
                Ball<R> column[n];
                for (int u = 0; u < n; ++u) column[u] = entry(slope, u, c);
                bound(column, part);
                for (int u = 0; u < n; ++u) e[u][c] = rounded_up<R>(e[u][c] + by * part[u]);
            }
        };
        // the derivatives of J B along the basis, and along the moving centre
        Ball<R> by_unknown[n][n][n];
        for (int u = 0; u < n; ++u) ball_jacobian_derivative(family.all, wide, u, by_unknown[u]);
        Matrix along_basis[n], along_center[N], own[N];
        for (int k = 0; k < n; ++k) {
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < n; ++c) {
                    g[r][c] = Ball<R>(Complex<R>(0.0));
                    for (int u = 0; u < n; ++u) g[r][c] += by_unknown[u][r][c] * Ball<R>(b[u][k]);
                }
            along_basis[k] = detail::times(g, b);
            widen(along_basis[k], s[k]);
        }
        for (int m = 0; m < N; ++m) {
            ball_jacobian(derivative(m), wide, g);
            own[m] = along_center[m] = detail::times(g, b);
            for (int k = 0; k < n; ++k)
                for (int r = 0; r < n; ++r)
                    for (int c = 0; c < n; ++c)
                        entry(along_center[m], r, c) += entry(along_basis[k], r, c) * Ball<R>(x[k][m]);
            widen(along_center[m], width[m]);
        }
        // the second derivative of F along the moving centre, half of which counts
        for (int m = 0; m < N; ++m)
            for (int l = 0; l < N; ++l) {
                for (int r = 0; r < n; ++r) {
                    f[r] = Ball<R>(Complex<R>(0.0));
                    for (int k = 0; k < n; ++k)
                        f[r] +=
                            entry(own[m], r, k) * Ball<R>(x[k][l]) + entry(along_center[l], r, k) * Ball<R>(x[k][m]);
                }
                bound(f, part);
                for (int u = 0; u < n; ++u)
                    second[u] = rounded_up<R>(second[u] + 0.5 * (width[m] * width[l]) * part[u]);
            }
        Mask holds = R{} < zero + 1.0;
        R reach[n];
        for (int u = 0; u < n; ++u) {
            R sum = zero;
            for (int k = 0; k < n; ++k) sum = sum + e[u][k] * s[k];
            sum = rounded_up<R>(sum * (1 + unit));
            reach[u] = rounded_up<R>(fixed[u] + second[u] + sum);
            holds = mask_and<Mask>(holds, mask_and<Mask>(reach[u] <= s[u], sum < s[u]));
        }
        const Mask fresh = mask_and<Mask>(holds, mask_not(out.proved));
        out.proved = mask_not(mask_and<Mask>(mask_not(out.proved), mask_not(holds)));
        for (int u = 0; u < n; ++u) {
            best[u] = select(fresh, reach[u], best[u]);
            out.weight[u] = select(fresh, s[u], out.weight[u]);
            for (int k = 0; k < n; ++k) out.contraction[u][k] = select(fresh, e[u][k], out.contraction[u][k]);
        }
        if (all_lanes(out.proved)) break;
        for (int u = 0; u < n; ++u) s[u] = select(out.proved, s[u], R(1.2 * reach[u]));
    }
    range(best, out.radius);
    detail::enclose(at.widened(out.radius), out);
    return out;
}

}  // namespace equilibria
