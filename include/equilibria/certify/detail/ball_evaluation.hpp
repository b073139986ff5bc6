/// \file
/// Values and Jacobians of the equations over balls: at a point, to rounding, and over a polydisc of displacements.
#pragma once

#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/ball.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria {

/// The terms with coefficients enclosed over the scalar type S, ready to be evaluated over S or packs of it.
template <class M, class S>
struct BallSystem {
    struct Factor {
        int unknown, code;  ///< see Monomial: cos k, sin k (code -k), or x^k
    };
    struct Term {
        int equation, first, last;  ///< its factors
        Ball<S> coefficient;
    };
    std::vector<Term> terms;
    std::vector<Factor> factors;
    Array<int, n_unknowns<M>> highest;  ///< multiple or power of each unknown, at least 1

    explicit BallSystem(const ExactSystem<M>& exact) {
        for (int& h : highest) h = 1;
        for (const auto& t : exact.terms) {
            const int first = static_cast<int>(factors.size());
            for (int u = 0; u < n_unknowns<M>; ++u)
                if (const int code = t.monomial.code(u); code != 0) {
                    factors.push_back({u, code});
                    highest[u] = std::max(highest[u], t.monomial.degree(u));
                }
            const int last = static_cast<int>(factors.size());
            terms.push_back({t.equation, first, last, t.coefficient.template enclosure<S>()});
        }
    }
};

/// The factors of the terms at a point, R being a scalar or a pack.
///
/// A point is exact: an angle by exp(i theta) or its inverse, whichever is larger, for which any nonzero number serves
/// (`complex`); or by the real point of the circle nearest to (c, s) (`real`). Its cosine and sine are enclosed.
template <class M, class R>
class FactorBalls {
public:
    using S = typename LaneTraits<R>::Scalar;

    /// Encloses the factors at the point q. real: at the real point next to q, whose imaginary parts are ignored.
    FactorBalls(const BallSystem<M, S>& system, const Point<M, R>& q, bool real) {
        int size = 0;
        for (int u = 0; u < n_unknowns<M>; ++u) {
            offset_[u] = size;
            size += (u < n_angles<M> ? 2 : 1) * system.highest[u];
            highest_[u] = system.highest[u];
        }
        balls_.resize(static_cast<std::size_t>(size));
        for (int i = 0; i < n_angles<M>; ++i) {
            Ball<R>&c = at(i, 1), &s = at(i, -1);
            real ? real_angle(q.c[i], q.s[i], c, s) : complex_angle(q.c[i], q.s[i], c, s);
            for (int k = 2; k <= highest_[i]; ++k) {
                at(i, k) = at(i, k - 1) * c - at(i, 1 - k) * s;
                at(i, -k) = at(i, 1 - k) * c + at(i, k - 1) * s;
            }
        }
        for (int u = n_angles<M>; u < n_unknowns<M>; ++u) {
            const Complex<R>& x = q.x[u - n_angles<M>];
            at(u, 1) = real ? Ball<R>(Complex<R>(x.re, R{} + 0.0)) : Ball<R>(x);
            for (int k = 2; k <= highest_[u]; ++k) at(u, k) = at(u, k - 1) * at(u, 1);
        }
    }

    Ball<R>& at(int u, int code) { return balls_[index(u, code)]; }
    const Ball<R>& at(int u, int code) const { return balls_[index(u, code)]; }

    /// The factors over all displacements |d_u| <= r_u from the point: of angles in (complex) radians.
    FactorBalls widened(const R (&r)[n_unknowns<M>]) const {
        FactorBalls y = *this;
        for (int i = 0; i < n_angles<M>; ++i)
            for (int k = 1; k <= highest_[i]; ++k) {
                // |cos(a + d) - cos a| <= |cos a| (cosh|d| - 1) + |sin a| sinh|d|, and cosh x - 1 < 0.52 x^2,
                // sinh x < 1.05 x for x < 0.5
                const R x = static_cast<double>(k) * r[i];
                const auto small = x < R{} + 0.5;
                const R infinite = R{} + std::numeric_limits<S>::infinity();
                const R cosh1 = select(small, R(0.52 * x * x), infinite), sinh = select(small, R(1.05 * x), infinite);
                const R c = magnitude_bound(at(i, k)), s = magnitude_bound(at(i, -k));
                y.at(i, k).rad = rounded_up<R>(at(i, k).rad + c * cosh1 + s * sinh);
                y.at(i, -k).rad = rounded_up<R>(at(i, -k).rad + s * cosh1 + c * sinh);
            }
        for (int u = n_angles<M>; u < n_unknowns<M>; ++u) {
            y.at(u, 1).rad = rounded_up<R>(at(u, 1).rad + r[u]);
            for (int k = 2; k <= highest_[u]; ++k) y.at(u, k) = y.at(u, k - 1) * y.at(u, 1);
        }
        return y;
    }

private:
    std::size_t index(int u, int code) const {
        if (n_coordinates<M> != 0 && u >= n_angles<M>) return static_cast<std::size_t>(offset_[u] + code - 1);
        return static_cast<std::size_t>(offset_[u] + (code > 0 ? 2 * (code - 1) : 2 * (-code - 1) + 1));
    }
    static void complex_angle(const Complex<R>& c, const Complex<R>& s, Ball<R>& cosine, Ball<R>& sine) {
        const Complex<R> is(-s.im, s.re), plus = c + is, minus = c - is;  // exp(i theta), exp(-i theta)
        const auto upper = norm2(plus) >= norm2(minus);
        const Ball<R> larger(select(upper, plus, minus)), smaller = inverse(larger);
        const R half = R{} + 0.5, sign = select(upper, half, R(-half));
        const Ball<R> sum = larger + smaller, difference = larger - smaller;
        cosine = {half * sum.mid, rounded_up<R>(half * sum.rad)};
        // (larger - smaller) / 2i, with the sign of theta
        sine = {Complex<R>(sign * difference.mid.im, -(sign * difference.mid.re)),
                rounded_up<R>(half * difference.rad)};
    }
    static void real_angle(const Complex<R>& c, const Complex<R>& s, Ball<R>& cosine, Ball<R>& sine) {
        const R zero = R{} + 0.0;
        const Ball<R> x(Complex<R>(c.re, zero)), y(Complex<R>(s.re, zero));
        const R off = magnitude_bound(x * x + y * y - Ball<R>(Complex<R>(R{} + 1.0, zero)));
        // the point of the circle is (c, s) / sqrt(1 + e), |e| <= off, and |1 / sqrt(1 + e) - 1| < 0.6 |e| if |e| < 0.1
        const R share = select(off < R{} + 0.1, R(0.6 * off), R(R{} + std::numeric_limits<S>::infinity()));
        cosine = {x.mid, rounded_up<R>(share * magnitude_bound(x.mid))};
        sine = {y.mid, rounded_up<R>(share * magnitude_bound(y.mid))};
    }

    Array<int, n_unknowns<M>> offset_, highest_;
    std::vector<Ball<R>> balls_;
};

/// F over the balls of the factors.
template <class M, class R, class S>
void ball_values(const BallSystem<M, S>& system, const FactorBalls<M, R>& at, Ball<R> (&f)[n_unknowns<M>]) {
    for (auto& value : f) value = Ball<R>(Complex<R>(0.0));
    for (const auto& t : system.terms) {
        Ball<R> product = broadcast_ball<R>(t.coefficient);
        for (int k = t.first; k < t.last; ++k) {
            const auto& factor = system.factors[static_cast<std::size_t>(k)];
            product = product * at.at(factor.unknown, factor.code);
        }
        f[t.equation] += product;
    }
}

namespace detail {

/// The term's product, differentiated by its factor number `d` and then by its factor number `d2`; -1 stands for none.
template <class M, class R, class S>
Ball<R> term_derivative(const BallSystem<M, S>& system, const typename BallSystem<M, S>::Term& t,
                        const FactorBalls<M, R>& at, int d, int d2 = -1) {
    Ball<R> product = broadcast_ball<R>(t.coefficient);
    for (int k = t.first; k < t.last; ++k) {
        const auto& factor = system.factors[static_cast<std::size_t>(k)];
        const int times = (k == d) + (k == d2);
        if (n_coordinates<M> == 0 || factor.unknown < n_angles<M>) {
            // (cos k theta)' = -k sin k theta, (sin k theta)' = k cos k theta: with the code, -code and the other
            // factor
            product = product * at.at(factor.unknown, times == 1 ? -factor.code : factor.code);
            if (times == 1) product = -factor.code * product;
            if (times == 2) product = -(factor.code * factor.code) * product;
        } else if (factor.code < times) {
            return Ball<R>(Complex<R>(0.0));
        } else {
            if (factor.code > times) product = product * at.at(factor.unknown, factor.code - times);
            if (times == 1) product = factor.code * product;
            if (times == 2) product = factor.code * (factor.code - 1) * product;
        }
    }
    return product;
}

template <class M, class R>
void clear(Ball<R> (&j)[n_unknowns<M>][n_unknowns<M>]) {
    for (auto& row : j)
        for (auto& entry : row) entry = Ball<R>(Complex<R>(0.0));
}
/// Of a potential model only the entries on and above the diagonal were filled in.
template <class M, class R>
void complete(Ball<R> (&j)[n_unknowns<M>][n_unknowns<M>]) {
    if constexpr (PotentialModel<M>)
        for (int r = 0; r < n_unknowns<M>; ++r)
            for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
}

}  // namespace detail

/// dF/dq over the balls of the factors; of a potential model the Hessian.
template <class M, class R, class S>
void ball_jacobian(const BallSystem<M, S>& system, const FactorBalls<M, R>& at,
                   Ball<R> (&j)[n_unknowns<M>][n_unknowns<M>]) {
    detail::clear<M>(j);
    for (const auto& t : system.terms)
        for (int d = t.first; d < t.last; ++d) {
            const int by = system.factors[static_cast<std::size_t>(d)].unknown;
            if (PotentialModel<M> && by < t.equation) continue;
            j[t.equation][by] += detail::term_derivative(system, t, at, d);
        }
    detail::complete<M>(j);
}

/// The derivative of dF/dq by unknown number u.
template <class M, class R, class S>
void ball_jacobian_derivative(const BallSystem<M, S>& system, const FactorBalls<M, R>& at, int u,
                              Ball<R> (&j)[n_unknowns<M>][n_unknowns<M>]) {
    detail::clear<M>(j);
    for (const auto& t : system.terms) {
        int d2 = t.first;
        while (d2 < t.last && system.factors[static_cast<std::size_t>(d2)].unknown != u) ++d2;
        if (d2 == t.last) continue;
        for (int d = t.first; d < t.last; ++d) {
            const int by = system.factors[static_cast<std::size_t>(d)].unknown;
            if (PotentialModel<M> && by < t.equation) continue;
            j[t.equation][by] += detail::term_derivative(system, t, at, d, d2);
        }
    }
    detail::complete<M>(j);
}

}  // namespace equilibria
