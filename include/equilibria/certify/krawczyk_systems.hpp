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

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria {

/// Systems at all parameters in intervals, over S; see ExactSystems.
template <class S>
struct BallSystems {
    BallSystem<S> center;                   ///< the system at the middle of the intervals
    BallSystem<S> all;                      ///< the system for all values at once
    std::vector<BallSystem<S>> derivative;  ///< by each varied parameter, for all values at once
    std::vector<S> half_width;              ///< of each interval, from the middle

    /// The same systems with coefficients over S, enclosed.
    explicit BallSystems(const ExactTermFamily& exact) : center(exact.center), all(exact.all) {
        // one table of factors serves them all
        auto multiples = all.multiples();
        const auto add = [&multiples](const typename BallSystem<S>::Multiples& others) {
            for (std::size_t u = 0; u < others.size(); ++u) {
                multiples[u].resize(std::max(multiples[u].size(), others[u].size()));
                for (std::size_t k = 0; k < others[u].size(); ++k) multiples[u][k] |= others[u][k];
            }
        };
        add(center.multiples());
        for (const auto& by : exact.derivative) add(derivative.emplace_back(by).multiples());
        center.use_table(multiples);
        all.use_table(multiples);
        for (std::size_t k = 0; k < exact.derivative.size(); ++k) {
            derivative[k].use_table(multiples);
            half_width.push_back(static_cast<S>(exact.half_width[k]));
        }
    }
    /// How many parameters vary.
    int varied() const { return static_cast<int>(derivative.size()); }
};

namespace detail {

/// Columns that span those of y, orthonormal to rounding: the directions that y makes longest come first.
template <class R>
void weak_directions(int n, const auto& y, auto& b) {
    for (int c = 0; c < n; ++c) {
        for (int r = 0; r < n; ++r) b[r][c] = y[r][c];
        for (int round = 0; round < 2; ++round)
            for (int k = 0; k < c; ++k) {
                Complex<R> dot(0.0);
                for (int r = 0; r < n; ++r) dot += conj(b[r][k]) * b[r][c];
                for (int r = 0; r < n; ++r) b[r][c] -= dot * b[r][k];
            }
        R size = R{} + 0.0;
        for (int r = 0; r < n; ++r) size = size + norm2(b[r][c]);
        const R by = 1.0 / square_root(size);
        for (int r = 0; r < n; ++r) b[r][c] = by * b[r][c];
    }
}

/// y = a b, of n by n matrices.
template <class R>
void multiply(int n, const auto& a, const auto& b, auto& y) {
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            Ball<R> sum(Complex<R>(0.0));
            for (int k = 0; k < n; ++k) sum += a[r][k] * Ball<R>(b[k][c]);
            y[r][c] = sum;
        }
}

}  // namespace detail

/// The test for systems, which are referred to: made once, for any number of points, whose numbers take its room.
template <class R>
class KrawczykSystemsTest {
public:
    using S = typename LaneTraits<R>::Scalar;  ///< the type of one lane

    /// The systems are not copied.
    explicit KrawczykSystemsTest(const BallSystems<S>& systems)
        : systems_(systems), n_(systems.all.sizes.unknowns), varied_(systems.varied()), at_(systems.center),
          wide_(systems.center), out_(systems.center.sizes), lu_(n_), y_(n_), middle_(n_), j_(n_), jb_(n_), f_(n_),
          ball_column_(n_), size_y_(n_), size_b_(n_), fixed_e_(n_), e_(n_), fixed_(n_), along_(n_), s_(n_), best_(n_),
          second_(n_), reach_(n_), d_(n_), part_(n_), x_(static_cast<std::size_t>(varied_), Column(n_)),
          by_unknown_(static_cast<std::size_t>(n_), BallMatrix(n_)), along_basis_(by_unknown_), g_(n_),
          along_center_(static_cast<std::size_t>(varied_), BallMatrix(n_)), own_(along_center_) {
        for (const S& width : systems.half_width) width_.push_back(broadcast<R>(width));
    }

    /// At the points q, one a lane; the result holds until the next call. See KrawczykTest.
    template <class M>
    const KrawczykResult<R>& operator()(const Point<M, R>& q, bool real) {
        at_.enclose(q, real);
        precondition();
        bound_middle();
        follow_center();
        for (int u = 0; u < n_; ++u) {
            s_[u] = rounded_up<R>(2.0 * fixed_[u] + 0.3 * along_[u] + rounding_unit<R> * (zero() + 1e-3));
            best_[u] = out_.weight[u] = zero();
            for (int k = 0; k < n_; ++k) out_.contraction[u][k] = zero();
        }
        out_.proved = R{} > zero() + 1.0;
        for (int round = 0; round < 5; ++round) {
            bound_over();
            const Mask holds = contracts();
            const Mask fresh = mask_and<Mask>(holds, mask_not(out_.proved));
            out_.proved = mask_not(mask_and<Mask>(mask_not(out_.proved), mask_not(holds)));
            for (int u = 0; u < n_; ++u) {
                best_[u] = select(fresh, reach_[u], best_[u]);
                out_.weight[u] = select(fresh, s_[u], out_.weight[u]);
                for (int k = 0; k < n_; ++k) out_.contraction[u][k] = select(fresh, e_[u][k], out_.contraction[u][k]);
            }
            if (all_lanes(out_.proved)) break;
            for (int u = 0; u < n_; ++u) s_[u] = select(out_.proved, s_[u], R(1.2 * reach_[u]));
        }
        range(best_, out_.radius);
        wide_.widen(at_, out_.radius);
        detail::enclose(systems_.center.sizes, wide_, out_);
        return out_;
    }
    KrawczykResult<R> result() && { return std::move(out_); }  ///< that of the last call, moved out

private:
    using Mask = typename LaneTraits<R>::Mask;
    using Reals = RuntimeArray<R>;
    using Column = RuntimeArray<Complex<R>>;
    using BallMatrix = RuntimeMatrix<Ball<R>>;

    static R zero() { return R{} + 0.0; }
    R unit() const { return R{} + (n_ + 4) * rounding_unit<R>; }
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    const BallSystem<S>& derivative(int m) const { return systems_.derivative[at(m)]; }
    /// |Y v|
    void bound(const auto& v, Reals& z) const { detail::product_bound<R>(n_, out_.inverse, size_y_, v, z); }

    /// The basis B, J B and the inverse Y of its middle.
    void precondition() {
        ball_jacobian(systems_.center, at_, j_);
        for (int r = 0; r < n_; ++r)
            for (int c = 0; c < n_; ++c) out_.jacobian[r][c] = j_[r][c].mid;
        lu_.factor(out_.jacobian);
        lu_.inverse_into(y_);
        detail::weak_directions<R>(n_, y_, out_.basis);
        detail::multiply<R>(n_, j_, out_.basis, jb_);
        for (int r = 0; r < n_; ++r)
            for (int c = 0; c < n_; ++c) middle_[r][c] = jb_[r][c].mid;
        lu_.factor(middle_);
        lu_.inverse_into(out_.inverse);
        for (int u = 0; u < n_; ++u)
            for (int k = 0; k < n_; ++k) {
                size_y_[u][k] = rounded_up<R>(magnitude_bound(out_.inverse[u][k]));
                size_b_[u][k] = rounded_up<R>(magnitude_bound(out_.basis[u][k]));
            }
    }
    /// What does not depend on the radii: the values at the middle and |1 - Y J B| there.
    void bound_middle() {
        ball_values(systems_.center, at_, f_);
        bound(f_, fixed_);
        for (int c = 0; c < n_; ++c)
            // 1 - Y (J B), the 1 taken into the sum
            for (int r = 0; r < n_; ++r) {
                Complex<R> sum(r == c ? 1.0 : 0.0);
                R error = zero() + (r == c ? static_cast<double>(n_) : 0.0) * rounding_unit<R>;
                for (int k = 0; k < n_; ++k) {
                    sum -= out_.inverse[r][k] * jb_[k][c].mid;
                    error = error + size_y_[r][k] * (jb_[k][c].rad + unit() * magnitude_bound(jb_[k][c].mid));
                }
                fixed_e_[r][c] = rounded_up<R>(magnitude_bound(sum) + error * (1 + unit()));
            }
    }
    /// X, and the part of F that it does not cancel.
    void follow_center() {
        for (R& value : along_) value = zero();
        for (int m = 0; m < varied_; ++m) {
            Column& x = x_[at(m)];
            ball_values(derivative(m), at_, f_);
            for (int u = 0; u < n_; ++u) {
                x[u] = Complex<R>(0.0);
                for (int k = 0; k < n_; ++k) x[u] -= out_.inverse[u][k] * f_[k].mid;
                along_[u] = rounded_up<R>(along_[u] + magnitude_bound(x[u]) * width_[at(m)]);
            }
            for (int r = 0; r < n_; ++r)
                for (int k = 0; k < n_; ++k) f_[r] += jb_[r][k] * Ball<R>(x[k]);
            bound(f_, part_);
            for (int u = 0; u < n_; ++u) fixed_[u] = rounded_up<R>(fixed_[u] + width_[at(m)] * part_[u]);
        }
    }
    /// How far the unknowns move by `rest` in the basis, and with the centre.
    void range(const Reals& rest, auto& d) const {
        for (int u = 0; u < n_; ++u) {
            R sum = zero();
            for (int k = 0; k < n_; ++k) sum = sum + size_b_[u][k] * (along_[k] + rest[k]);
            d[u] = rounded_up<R>(sum * (1 + unit()));
        }
    }
    /// E += |Y slope| by
    void widen(const BallMatrix& slope, const R& by) {
        for (int c = 0; c < n_; ++c) {
            for (int u = 0; u < n_; ++u) ball_column_[u] = slope[u][c];
            bound(ball_column_, part_);
            for (int u = 0; u < n_; ++u) e_[u][c] = rounded_up<R>(e_[u][c] + by * part_[u]);
        }
    }
    /// Over the radii s: |1 - Y J B|, and the second derivative of F along the moving centre, half of which counts.
    void bound_over() {
        range(s_, d_);
        wide_.widen(at_, d_);
        for (int u = 0; u < n_; ++u) {
            second_[u] = zero();
            for (int k = 0; k < n_; ++k) e_[u][k] = fixed_e_[u][k];
        }
        slopes_along_basis();
        for (int m = 0; m < varied_; ++m) {
            BallMatrix& along = along_center_[at(m)];
            ball_jacobian(derivative(m), wide_, g_);
            detail::multiply<R>(n_, g_, out_.basis, along);
            own_[at(m)] = along;
            for (int k = 0; k < n_; ++k)
                for (int r = 0; r < n_; ++r)
                    for (int c = 0; c < n_; ++c) along[r][c] += along_basis_[at(k)][r][c] * Ball<R>(x_[at(m)][k]);
            widen(along, width_[at(m)]);
        }
        for (int m = 0; m < varied_; ++m)
            for (int l = 0; l < varied_; ++l) {
                for (int r = 0; r < n_; ++r) {
                    f_[r] = Ball<R>(Complex<R>(0.0));
                    for (int k = 0; k < n_; ++k)
                        f_[r] += own_[at(m)][r][k] * Ball<R>(x_[at(l)][k]) +
                                 along_center_[at(l)][r][k] * Ball<R>(x_[at(m)][k]);
                }
                bound(f_, part_);
                for (int u = 0; u < n_; ++u)
                    second_[u] = rounded_up<R>(second_[u] + 0.5 * (width_[at(m)] * width_[at(l)]) * part_[u]);
            }
    }
    /// The derivatives of J B along the basis.
    void slopes_along_basis() {
        for (int u = 0; u < n_; ++u) ball_jacobian_derivative(systems_.all, wide_, u, by_unknown_[at(u)]);
        for (int k = 0; k < n_; ++k) {
            for (int r = 0; r < n_; ++r)
                for (int c = 0; c < n_; ++c) {
                    g_[r][c] = Ball<R>(Complex<R>(0.0));
                    for (int u = 0; u < n_; ++u) g_[r][c] += by_unknown_[at(u)][r][c] * Ball<R>(out_.basis[u][k]);
                }
            detail::multiply<R>(n_, g_, out_.basis, along_basis_[at(k)]);
            widen(along_basis_[at(k)], s_[k]);
        }
    }
    /// Whether the polydisc of the radii s goes into itself; how far it reaches.
    Mask contracts() {
        Mask holds = R{} < zero() + 1.0;
        for (int u = 0; u < n_; ++u) {
            R sum = zero();
            for (int k = 0; k < n_; ++k) sum = sum + e_[u][k] * s_[k];
            sum = rounded_up<R>(sum * (1 + unit()));
            reach_[u] = rounded_up<R>(fixed_[u] + second_[u] + sum);
            holds = mask_and<Mask>(holds, mask_and<Mask>(reach_[u] <= s_[u], sum < s_[u]));
        }
        return holds;
    }

    const BallSystems<S>& systems_;
    int n_, varied_;
    FactorBalls<R> at_, wide_;
    std::vector<R> width_;
    KrawczykResult<R> out_;
    PivotedFactorization<R> lu_;
    RuntimeMatrix<Complex<R>> y_, middle_;
    BallMatrix j_, jb_;
    RuntimeArray<Ball<R>> f_, ball_column_;
    RuntimeMatrix<R> size_y_, size_b_;  // |Y|, |B|
    RuntimeMatrix<R> fixed_e_, e_;      // |1 - Y J B|: what its value at the middle contributes, and E
    Reals fixed_;                       // what the values at the middle contribute
    Reals along_;                       // how far the centre moves with the parameters
    Reals s_, best_, second_, reach_, d_, part_;
    std::vector<Column> x_;  // X, how the centre moves with each parameter
    std::vector<BallMatrix> by_unknown_, along_basis_;
    BallMatrix g_;
    std::vector<BallMatrix> along_center_, own_;
};

/// The test at the points q, one a lane; see krawczyk for one system. The radii and the enclosures hold the roots of
/// all parameters, and E the Jacobians at all of them.
template <class M, class R>
KrawczykResult<R> krawczyk(const BallSystems<typename LaneTraits<R>::Scalar>& systems, const Point<M, R>& q,
                           bool real) {
    KrawczykSystemsTest<R> test(systems);
    test(q, real);
    return std::move(test).result();
}

}  // namespace equilibria
