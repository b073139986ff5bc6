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

#include <utility>

#include <equilibria/certify/detail/ball_evaluation.hpp>
#include <equilibria/core/linear_solve.hpp>

namespace equilibria {

/// The outcome for one lane of points.
template <class R>
struct KrawczykResult {
    using Mask = typename LaneTraits<R>::Mask;   ///< a truth value a lane
    using Numbers = SizedArray<R, at_run_time>;  ///< one an unknown
    using Matrix = RuntimeMatrix<Complex<R>>;    ///< n x n

    Mask proved{};           ///< whether exactly one root lies in the polydisc
    Numbers radius;          ///< |root - point| of each unknown, angles in radians; meaningful where proved
    Numbers weight;          ///< radii of the polydisc of e in which the root is alone: E weight < weight
    RuntimePoint<R> center;  ///< of the enclosure of (c, s, x)
    Numbers off;             ///< radius of the enclosures of c_u and s_u, or of x_u, around `center`
    // for proofs about the Jacobians over the polydisc
    Matrix jacobian;               ///< J at the point
    Matrix inverse;                ///< Y, close to (J B)^-1
    Matrix basis;                  ///< B, n x n: displacements are B e; 1 but for krawczyk_systems.hpp
    RuntimeMatrix<R> contraction;  ///< E >= |1 - Y J B| over the polydisc of e

    KrawczykResult() = default;
    /// Room for these sizes; nothing is proved.
    explicit KrawczykResult(const RuntimeSizes& sizes)
        : radius(sizes.unknowns), weight(sizes.unknowns), center(point_of_zeros<RuntimeUnknowns, R>(sizes)),
          off(sizes.unknowns), jacobian(sizes.unknowns), inverse(sizes.unknowns), basis(sizes.unknowns),
          contraction(sizes.unknowns) {}
};

// What follows is for matrices and vectors of any type that is indexed by [row][column] and [u], of n unknowns.
namespace detail {

/// E >= |1 - Y J| for all J in the balls: a midpoint product with its a priori bound, and |Y| times the radii.
/// The radii of j become their spread, with the rounding of the midpoints' products.
template <class R>
void contraction(int n, const auto& y, const auto& size_y, auto& j, auto& e) {
    const R unit = R{} + (n + 4) * rounding_unit<R>;
    for (int r = 0; r < n; ++r) {
        auto* row = j[r];
        for (int c = 0; c < n; ++c) row[c].rad = rounded_up<R>(row[c].rad + unit * magnitude_bound(row[c].mid));
    }
    for (int r = 0; r < n; ++r) {
        const auto* y_row = y[r];
        const auto* size_row = size_y[r];
        for (int c = 0; c < n; ++c) {
            Complex<R> product(r == c ? 1.0 : 0.0);
            R sum = R{} + (r == c ? static_cast<double>(n) * rounding_unit<R> : 0 * rounding_unit<R>);
            for (int k = 0; k < n; ++k) {
                const Ball<R>& entry = j[k][c];
                product -= y_row[k] * entry.mid;
                sum = sum + size_row[k] * entry.rad;
            }
            e[r][c] = rounded_up<R>(magnitude_bound(product) + sum * (1 + unit));
        }
    }
}

/// The bound of |Y v| for the balls v.
template <class R>
void product_bound(int n, const auto& y, const auto& size_y, const auto& v, auto& bound) {
    const R unit = R{} + (n + 4) * rounding_unit<R>;
    for (int u = 0; u < n; ++u) {
        const auto* y_row = y[u];
        const auto* size_row = size_y[u];
        Complex<R> sum(0.0);
        R error = R{} + 0.0;
        for (int k = 0; k < n; ++k) {
            sum += y_row[k] * v[k].mid;
            error = error + size_row[k] * (v[k].rad + unit * magnitude_bound(v[k].mid));
        }
        bound[u] = rounded_up<R>(magnitude_bound(sum) + error * (1 + unit));
    }
}

/// Fills in what a proof says of the enclosure of (c, s, x), given the factors over the radii.
template <class R>
void enclose(const RuntimeSizes& sizes, const FactorBalls<R>& wide, KrawczykResult<R>& out) {
    for (int u = 0; u < sizes.unknowns; ++u) {
        const Ball<R>& first = wide.at(u, 1);
        out.off[u] = first.rad;
        if (u < sizes.angles) {
            const Ball<R>& sine = wide.at(u, -1);
            out.center.c[u] = first.mid;
            out.center.s[u] = sine.mid;
            out.off[u] = lane_max(first.rad, sine.rad);
        } else {
            out.center.x[u - sizes.angles] = first.mid;
        }
    }
}

}  // namespace detail

/// The test for a system, which is referred to: made once, for any number of points, whose numbers take its room.
template <class R>
class KrawczykTest {
public:
    using S = typename LaneTraits<R>::Scalar;  ///< the type of one lane

    /// The system is not copied.
    explicit KrawczykTest(const BallSystem<S>& system)
        : system_(&system), n_(system.sizes.unknowns), at_(system), wide_(system), out_(system.sizes), lu_(n_), f_(n_),
          j_(n_), size_y_(n_), e_(n_), newton_(n_), r_(n_), reach_(n_) {
        for (int u = 0; u < n_; ++u)
            for (int k = 0; k < n_; ++k) out_.basis[u][k] = Complex<R>(u == k ? 1.0 : 0.0);
    }

    /// At the points q, one a lane; the result holds until the next call. real: the polydisc is centred at the real
    /// point next to q, so that the root it holds is real: its conjugate is a root in it as well.
    template <class M>
    const KrawczykResult<R>& operator()(const Point<M, R>& q, bool real) {
        const int n = n_;
        const R unit = R{} + (n + 4) * rounding_unit<R>;
        precondition(q, real);
        out_.proved = R{} > R{} + 1.0;
        for (int round = 0; round < 7; ++round) {
            if (round > 0) {
                wide_.widen(at_, r_);
                ball_jacobian(*system_, wide_, j_);
            }
            detail::contraction<R>(n, out_.inverse, size_y_, j_, e_);
            Mask holds = R{} < R{} + 1.0;
            for (int u = 0; u < n; ++u) {
                const R* row = e_[u];
                R sum = R{} + 0.0;
                for (int k = 0; k < n; ++k) sum = sum + row[k] * r_[k];
                sum = rounded_up<R>(sum * (1 + unit));
                reach_[u] = rounded_up<R>(newton_[u] + sum);
                holds = mask_and<Mask>(holds, mask_and<Mask>(reach_[u] <= r_[u], sum < r_[u]));
            }
            const Mask fresh = mask_and<Mask>(holds, mask_not(out_.proved));
            out_.proved = mask_not(mask_and<Mask>(mask_not(out_.proved), mask_not(holds)));
            for (int u = 0; u < n; ++u) {
                out_.radius[u] = select(fresh, reach_[u], out_.radius[u]);
                out_.weight[u] = select(fresh, r_[u], out_.weight[u]);
                const R* row = e_[u];
                R* best = out_.contraction[u];
                for (int k = 0; k < n; ++k) best[k] = select(fresh, row[k], best[k]);
            }
            if (all_lanes(out_.proved)) break;
            for (int u = 0; u < n; ++u) {
                const R smallest = rounded_up<R>(2.0 * newton_[u] + rounding_unit<R> * (R{} + 1e-3));
                r_[u] = select(out_.proved, r_[u], round == 0 ? smallest : R(1.3 * reach_[u]));
            }
        }
        wide_.widen(at_, out_.radius);
        detail::enclose(system_->sizes, wide_, out_);
        return out_;
    }
    KrawczykResult<R> result() && { return std::move(out_); }  ///< that of the last call, moved out

private:
    using Mask = typename LaneTraits<R>::Mask;
    template <class T>
    using Numbers = SizedArray<T, at_run_time>;
    template <class T>
    using Matrix = RuntimeMatrix<T>;

    /// J and Y at the points, |Y F|; nothing is proved yet. J is evaluated over the first polydisc at once, whose balls
    /// have the same midpoints: a radius far above |Y F| of most roots, and far below their distances.
    template <class M>
    void precondition(const Point<M, R>& q, bool real) {
        const int n = n_;
        at_.enclose(q, real);
        ball_values(*system_, at_, f_);
        using std::sqrt;
        for (int u = 0; u < n; ++u) r_[u] = R{} + sqrt(rounding_unit<R>) / 64;
        wide_.widen(at_, r_);
        ball_jacobian(*system_, wide_, j_);
        for (int r = 0; r < n; ++r) {
            out_.radius[r] = out_.weight[r] = R{} + 0.0;
            for (int c = 0; c < n; ++c) out_.jacobian[r][c] = j_[r][c].mid, out_.contraction[r][c] = R{} + 0.0;
        }
        lu_.factor(out_.jacobian);
        lu_.inverse_into(out_.inverse);
        for (int u = 0; u < n; ++u)
            for (int k = 0; k < n; ++k) size_y_[u][k] = rounded_up<R>(magnitude_bound(out_.inverse[u][k]));
        detail::product_bound<R>(n, out_.inverse, size_y_, f_, newton_);
    }

    const BallSystem<S>* system_;
    int n_;
    FactorBalls<R> at_, wide_;
    KrawczykResult<R> out_;
    PivotedFactorization<R> lu_;
    Numbers<Ball<R>> f_;
    Matrix<Ball<R>> j_;
    Matrix<R> size_y_, e_;  // |Y|, E
    Numbers<R> newton_, r_, reach_;
};

/// The test at one pack of points, see KrawczykTest.
template <class M, class R>
KrawczykResult<R> krawczyk(const BallSystem<typename LaneTraits<R>::Scalar>& system, const Point<M, R>& q, bool real) {
    KrawczykTest<R> test(system);
    test(q, real);
    return std::move(test).result();
}

}  // namespace equilibria
