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

#include <array>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>

namespace equilibria {

/// Systems at all parameters in intervals, over S; see ExactSystems.
template <class M, class S, int N>
struct BallSystems {
    BallSystem<S> center, all;
    std::vector<BallSystem<S>> derivative;
    Array<S, N> half_width;

    explicit BallSystems(const ExactSystems<M, N>& exact) : center(exact.center), all(exact.all) {
        // one table of factors serves them all
        auto highest = all.highest;
        for (int u = 0; u < n_unknowns<M>; ++u) highest[u] = std::max(highest[u], center.highest[u]);
        center.use_table(highest);
        all.use_table(highest);
        for (int k = 0; k < N; ++k) {
            derivative.emplace_back(exact.derivative[k]);
            derivative.back().use_table(highest);
            half_width[k] = static_cast<S>(exact.half_width[k]);
        }
    }
};

namespace detail {

/// Columns that span those of y, orthonormal to rounding: the directions that y makes longest come first.
template <class R, int N>
void weak_directions(const Complex<R> (&y)[N][N], auto& b) {
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
BallMatrix<R, N> times(const Ball<R> (&a)[N][N], const auto& b) {
    BallMatrix<R, N> y;
    for (int r = 0; r < N; ++r)
        for (int c = 0; c < N; ++c) {
            Ball<R> sum(Complex<R>(0.0));
            for (int k = 0; k < N; ++k) sum += a[r][k] * Ball<R>(b[k][c]);
            y[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = sum;
        }
    return y;
}

/// The test, step by step; see `krawczyk`.
template <class M, class R, class S, int N>
class SystemsTest {
public:
    SystemsTest(const BallSystems<M, S, N>& systems, const Point<M, R>& q, bool real)
        : systems_(systems), at_(systems.center, q, real), out_(Sizes<M>()) {
        for (int m = 0; m < N; ++m) width_[m] = broadcast<R>(systems.half_width[m]);
    }

    KrawczykResult<R> run() {
        precondition();
        bound_middle();
        follow_center();
        R s[n], best[n]{};
        for (int u = 0; u < n; ++u)
            s[u] = rounded_up<R>(2.0 * fixed_[u] + 0.3 * along_[u] + rounding_unit<R> * (zero() + 1e-3));
        out_.proved = R{} > zero() + 1.0;
        for (int round = 0; round < 5; ++round) {
            R second[n], e[n][n], reach[n];
            bound_over(s, second, e);
            const Mask holds = contracts(s, second, e, reach);
            const Mask fresh = mask_and<Mask>(holds, mask_not(out_.proved));
            out_.proved = mask_not(mask_and<Mask>(mask_not(out_.proved), mask_not(holds)));
            for (int u = 0; u < n; ++u) {
                best[u] = select(fresh, reach[u], best[u]);
                out_.weight[u] = select(fresh, s[u], out_.weight[u]);
                for (int k = 0; k < n; ++k) out_.contraction[u][k] = select(fresh, e[u][k], out_.contraction[u][k]);
            }
            if (all_lanes(out_.proved)) break;
            for (int u = 0; u < n; ++u) s[u] = select(out_.proved, s[u], R(1.2 * reach[u]));
        }
        range(best, out_.radius);
        enclose(RuntimeSizes(Sizes<M>()), at_.widened(out_.radius), out_);
        return out_;
    }

private:
    using Mask = typename LaneTraits<R>::Mask;
    static constexpr int n = n_unknowns<M>;
    using Matrix = BallMatrix<R, n>;

    static R zero() { return R{} + 0.0; }
    static R unit() { return R{} + (n + 4) * rounding_unit<R>; }
    static Ball<R>& entry(Matrix& m, int r, int c) {
        return m[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
    const BallSystem<S>& derivative(int m) const { return systems_.derivative[static_cast<std::size_t>(m)]; }
    /// |Y v|
    void bound(const Ball<R> (&v)[n], R (&z)[n]) const { product_bound<R>(n, out_.inverse, size_y_, v, z); }

    /// The basis B, J B and the inverse Y of its middle.
    void precondition() {
        Ball<R> j[n][n];
        ball_jacobian(systems_.center, at_, j);
        Complex<R> y[n][n], middle[n][n];
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) out_.jacobian[r][c] = j[r][c].mid;
        PivotedFactorization<R, n> lu;
        Complex<R> column[n];
        approximate_inverse(n, lu, out_.jacobian, column, y);
        weak_directions(y, out_.basis);
        jb_ = times(j, out_.basis);
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) middle[r][c] = entry(jb_, r, c).mid;
        approximate_inverse(n, lu, middle, column, out_.inverse);
        for (int u = 0; u < n; ++u)
            for (int k = 0; k < n; ++k) {
                size_y_[u][k] = rounded_up<R>(magnitude_bound(out_.inverse[u][k]));
                size_b_[u][k] = rounded_up<R>(magnitude_bound(out_.basis[u][k]));
            }
    }
    /// What does not depend on the radii: the values at the middle and |1 - Y J B| there.
    void bound_middle() {
        Ball<R> f[n];
        ball_values(systems_.center, at_, f);
        bound(f, fixed_);
        for (int c = 0; c < n; ++c) {
            Ball<R> column[n];
            for (int r = 0; r < n; ++r) column[r] = entry(jb_, r, c);
            // 1 - Y (J B), the 1 taken into the sum
            for (int r = 0; r < n; ++r) {
                Complex<R> sum(r == c ? 1.0 : 0.0);
                R error = zero() + (r == c ? static_cast<double>(n) : 0.0) * rounding_unit<R>;
                for (int k = 0; k < n; ++k) {
                    sum -= out_.inverse[r][k] * column[k].mid;
                    error = error + size_y_[r][k] * (column[k].rad + unit() * magnitude_bound(column[k].mid));
                }
                fixed_e_[r][c] = rounded_up<R>(magnitude_bound(sum) + error * (1 + unit()));
            }
        }
    }
    /// X, and the part of F that it does not cancel.
    void follow_center() {
        Ball<R> f[n];
        R part[n];
        for (R& value : along_) value = zero();
        for (int m = 0; m < N; ++m) {
            ball_values(derivative(m), at_, f);
            for (int u = 0; u < n; ++u) {
                x_[u][m] = Complex<R>(0.0);
                for (int k = 0; k < n; ++k) x_[u][m] -= out_.inverse[u][k] * f[k].mid;
                along_[u] = rounded_up<R>(along_[u] + magnitude_bound(x_[u][m]) * width_[m]);
            }
            for (int r = 0; r < n; ++r)
                for (int k = 0; k < n; ++k) f[r] += entry(jb_, r, k) * Ball<R>(x_[k][m]);
            bound(f, part);
            for (int u = 0; u < n; ++u) fixed_[u] = rounded_up<R>(fixed_[u] + width_[m] * part[u]);
        }
    }
    /// How far the unknowns move by `rest` in the basis, and with the centre.
    void range(const R (&rest)[n], auto& d) const {
        for (int u = 0; u < n; ++u) {
            R sum = zero();
            for (int k = 0; k < n; ++k) sum = sum + size_b_[u][k] * (along_[k] + rest[k]);
            d[u] = rounded_up<R>(sum * (1 + unit()));
        }
    }
    /// e += |Y slope| by
    void widen(Matrix& slope, const R& by, R (&e)[n][n]) const {
        R part[n];
        for (int c = 0; c < n; ++c) {
            Ball<R> column[n];
            for (int u = 0; u < n; ++u) column[u] = entry(slope, u, c);
            bound(column, part);
            for (int u = 0; u < n; ++u) e[u][c] = rounded_up<R>(e[u][c] + by * part[u]);
        }
    }
    /// Over the radii s: |1 - Y J B|, and the second derivative of F along the moving centre, half of which counts.
    void bound_over(const R (&s)[n], R (&second)[n], R (&e)[n][n]) {
        R d[n], part[n];
        range(s, d);
        const FactorBalls<R> wide = at_.widened(d);
        for (int u = 0; u < n; ++u) {
            second[u] = zero();
            for (int k = 0; k < n; ++k) e[u][k] = fixed_e_[u][k];
        }
        // the derivatives of J B along the basis, and along the moving centre
        Ball<R> by_unknown[n][n][n], f[n], g[n][n];
        for (int u = 0; u < n; ++u) ball_jacobian_derivative(systems_.all, wide, u, by_unknown[u]);
        Matrix along_basis[n], along_center[N], own[N];
        for (int k = 0; k < n; ++k) {
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < n; ++c) {
                    g[r][c] = Ball<R>(Complex<R>(0.0));
                    for (int u = 0; u < n; ++u) g[r][c] += by_unknown[u][r][c] * Ball<R>(out_.basis[u][k]);
                }
            along_basis[k] = times(g, out_.basis);
            widen(along_basis[k], s[k], e);
        }
        for (int m = 0; m < N; ++m) {
            ball_jacobian(derivative(m), wide, g);
            own[m] = along_center[m] = times(g, out_.basis);
            for (int k = 0; k < n; ++k)
                for (int r = 0; r < n; ++r)
                    for (int c = 0; c < n; ++c)
                        entry(along_center[m], r, c) += entry(along_basis[k], r, c) * Ball<R>(x_[k][m]);
            widen(along_center[m], width_[m], e);
        }
        for (int m = 0; m < N; ++m)
            for (int l = 0; l < N; ++l) {
                for (int r = 0; r < n; ++r) {
                    f[r] = Ball<R>(Complex<R>(0.0));
                    for (int k = 0; k < n; ++k)
                        f[r] +=
                            entry(own[m], r, k) * Ball<R>(x_[k][l]) + entry(along_center[l], r, k) * Ball<R>(x_[k][m]);
                }
                bound(f, part);
                for (int u = 0; u < n; ++u)
                    second[u] = rounded_up<R>(second[u] + 0.5 * (width_[m] * width_[l]) * part[u]);
            }
    }
    /// Whether the polydisc of the radii s goes into itself, and how far it reaches.
    Mask contracts(const R (&s)[n], const R (&second)[n], const R (&e)[n][n], R (&reach)[n]) const {
        Mask holds = R{} < zero() + 1.0;
        for (int u = 0; u < n; ++u) {
            R sum = zero();
            for (int k = 0; k < n; ++k) sum = sum + e[u][k] * s[k];
            sum = rounded_up<R>(sum * (1 + unit()));
            reach[u] = rounded_up<R>(fixed_[u] + second[u] + sum);
            holds = mask_and<Mask>(holds, mask_and<Mask>(reach[u] <= s[u], sum < s[u]));
        }
        return holds;
    }

    const BallSystems<M, S, N>& systems_;
    FactorBalls<R> at_;
    R width_[N];
    KrawczykResult<R> out_;
    Matrix jb_;
    R size_y_[n][n], size_b_[n][n];  // |Y|, |B|
    R fixed_[n], fixed_e_[n][n];     // what the values at the middle, and 1 - Y J B there, contribute
    Complex<R> x_[n][N];             // X, how the centre moves with the parameters
    R along_[n];                     // how far it does
};

}  // namespace detail

/// The test at the points q, one a lane; see krawczyk for one system. The radii and the enclosures hold the roots of
/// all parameters, and E the Jacobians at all of them.
template <class M, class R, class S, int N>
KrawczykResult<R> krawczyk(const BallSystems<M, S, N>& systems, const Point<M, R>& q, bool real) {
    return detail::SystemsTest<M, R, S, N>(systems, q, real).run();
}

}  // namespace equilibria
