/// \file
/// Values and Jacobians of the equations over balls: at a point, to rounding, and over a polydisc of displacements.
///
/// Nothing here depends on a model: a system is a table of terms, its numbers of unknowns are known at run time.
/// Vectors and matrices of balls are of any type that is indexed by [u] and [row][column].
#pragma once

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/ball.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria {

/// The terms with coefficients enclosed over the scalar type S, ready to be evaluated over S or packs of it.
template <class S>
struct BallSystem {
    struct Factor {
        int unknown, code;  ///< see Monomial: cos k, sin k (code -k), or x^k
        int ball;           ///< its place in a table of factors
    };
    struct Term {
        int equation, first, last;  ///< its factors
        Ball<S> coefficient;
    };
    /// Which multiples or powers the table of factors has of each unknown, from 0 on.
    using Multiples = std::vector<std::vector<char>>;
    /// A multiple or power in the table, from those of half of it: none is far from 1, so that radii stay small.
    struct Step {
        int unknown, multiple;     ///< at least 2
        int place, first, second;  ///< in the table: of it, and of those whose multiples add up to it
    };

    RuntimeSizes sizes;
    bool symmetric;  ///< the equations are the gradient of a potential: the Jacobian is a Hessian
    std::vector<Term> terms;
    std::vector<Factor> factors;
    std::vector<Step> steps;  ///< all of the table but multiple 1 of each unknown, by unknown, then by multiple

    explicit BallSystem(const ExactTerms& exact) : sizes(exact.sizes), symmetric(exact.symmetric) {
        for (const auto& f : exact.factors) factors.push_back({f.unknown, f.code, 0});
        for (const auto& t : exact.terms)
            terms.push_back({t.equation, t.first, t.last, t.coefficient.template enclosure<S>()});
        use_table(multiples());
    }

    /// The highest multiple or power of an unknown, at least 1.
    int highest(int u) const {
        int y = 1;
        for (const auto& f : factors)
            if (f.unknown == u) y = std::max(y, std::abs(f.code));
        return y;
    }
    /// What the terms and their first and second derivatives need.
    Multiples multiples() const {
        Multiples y(static_cast<std::size_t>(sizes.unknowns));
        for (const auto& f : factors) {
            auto& of = y[static_cast<std::size_t>(f.unknown)];
            const auto k = static_cast<std::size_t>(std::abs(f.code));
            if (of.size() <= k) of.resize(k + 1);
            for (std::size_t lower = 0; lower < (f.unknown < sizes.angles ? 1U : 3U) && lower < k; ++lower)
                of[k - lower] = 1;
        }
        return y;
    }
    /// Makes the factors refer to a table with these multiples and powers, its own among them: systems with the same
    /// ones share a table.
    void use_table(Multiples with) {
        first_.resize(sizes.unknowns);
        steps.clear();
        size_ = 0;
        for (int u = 0; u < sizes.unknowns; ++u) {
            auto& has = with[static_cast<std::size_t>(u)];
            for (std::size_t k = has.size(); k-- > 2;)
                if (has[k]) has[k / 2] = has[k - k / 2] = 1;
            first_[u] = size_;
            size_ += (u < sizes.angles ? 2 : 1) * std::max(1, static_cast<int>(has.size()) - 1);
            for (int k = 2; k < static_cast<int>(has.size()); ++k)
                if (has[static_cast<std::size_t>(k)])
                    steps.push_back({u, k, place(u, k), place(u, k / 2), place(u, k - k / 2)});
        }
        for (auto& f : factors) f.ball = place(f.unknown, f.code);
    }
    /// Of a factor in the table of factors: of an angle cos, sin, cos 2, sin 2, ..; of a coordinate its powers.
    int place(int u, int code) const {
        if (u >= sizes.angles) return first_[u] + code - 1;
        return first_[u] + (code > 0 ? 2 * (code - 1) : 2 * (-code - 1) + 1);
    }
    int table_size() const { return size_; }

private:
    SizedArray<int, at_run_time> first_;
    int size_ = 0;
};

/// The factors of the terms of a system at a point, R being a scalar or a pack. The system is referred to.
///
/// A point is exact: an angle by exp(i theta) or its inverse, whichever is larger, for which any nonzero number serves
/// (`complex`); or by the real point of the circle nearest to (c, s) (`real`). Its cosine and sine are enclosed.
template <class R>
class FactorBalls {
public:
    using S = typename LaneTraits<R>::Scalar;

    /// Room for them.
    explicit FactorBalls(const BallSystem<S>& system)
        : system_(&system), balls_(static_cast<std::size_t>(system.table_size())), factors_(balls_.size()) {}
    template <class M>
    FactorBalls(const BallSystem<S>& system, const Point<M, R>& q, bool real) : FactorBalls(system) {
        enclose(q, real);
    }

    /// Encloses the factors at the point q. real: at the real point next to q, whose imaginary parts are ignored.
    template <class M>
    void enclose(const Point<M, R>& q, bool real) {
        const int angles = system_->sizes.angles, n = system_->sizes.unknowns;
        Ball<R>* const b = balls_.data();
        for (int i = 0; i < angles; ++i) {
            Ball<R>* const of = b + system_->place(i, 1);
            real ? real_angle(q.c[i], q.s[i], of[0], of[1]) : complex_angle(q.c[i], q.s[i], of[0], of[1]);
        }
        for (int u = angles; u < n; ++u) {
            const Complex<R>& x = q.x[u - angles];
            b[system_->place(u, 1)] = real ? Ball<R>(Complex<R>(x.re, R{} + 0.0)) : Ball<R>(x);
        }
        for (const auto& step : system_->steps) {
            const Ball<R>* const c = b + step.first;
            const Ball<R>* const d = b + step.second;
            Ball<R>* const y = b + step.place;
            if (step.unknown < angles) {
                y[0] = c[0] * d[0] - c[1] * d[1];
                y[1] = c[1] * d[0] + c[0] * d[1];
            } else {
                y[0] = c[0] * d[0];
            }
        }
        take_factors();
    }

    const Ball<R>& at(int u, int code) const { return balls_[static_cast<std::size_t>(system_->place(u, code))]; }
    /// The factors in their places of the table.
    const BallFactor<R>* table() const { return factors_.data(); }

    /// The factors over all displacements |d_u| <= r_u from the point: of angles in (complex) radians.
    FactorBalls widened(const auto& r) const {
        FactorBalls y(*system_);
        y.widen(*this, r);
        return y;
    }
    /// Becomes those of `point`, of the same system, over all displacements |d_u| <= r_u.
    void widen(const FactorBalls& point, const auto& r) {
        const int angles = system_->sizes.angles, n = system_->sizes.unknowns;
        const Ball<R>* const a = point.balls_.data();
        Ball<R>* const y = balls_.data();
        for (int i = 0; i < angles; ++i) widen_multiple(a + system_->place(i, 1), 1, r[i], y + system_->place(i, 1));
        for (int u = angles; u < n; ++u) {
            const Ball<R>& at = a[system_->place(u, 1)];
            y[system_->place(u, 1)] = {at.mid, rounded_up<R>(at.rad + r[u])};
        }
        for (const auto& step : system_->steps) {
            if (step.unknown < angles)
                widen_multiple(a + step.place, step.multiple, r[step.unknown], y + step.place);
            else
                y[step.place] = y[step.first] * y[step.second];
        }
        take_factors();
    }

private:
    /// Cosine and sine of k theta over all displacements |d| <= r of theta.
    static void widen_multiple(const Ball<R>* a, int k, const R& r, Ball<R>* y) {
        // |cos(a + d) - cos a| <= |cos a| (cosh|d| - 1) + |sin a| sinh|d|, and cosh x - 1 < 0.52 x^2,
        // sinh x < 1.05 x for x < 0.5
        const R x = static_cast<double>(k) * r;
        const auto small = x < R{} + 0.5;
        const R infinite = R{} + std::numeric_limits<S>::infinity();
        const R cosh1 = select(small, R(0.52 * x * x), infinite), sinh = select(small, R(1.05 * x), infinite);
        const R c = magnitude_bound(a[0]), s = magnitude_bound(a[1]);
        y[0] = {a[0].mid, rounded_up<R>(a[0].rad + c * cosh1 + s * sinh)};
        y[1] = {a[1].mid, rounded_up<R>(a[1].rad + s * cosh1 + c * sinh)};
    }
    void take_factors() {
        const auto take = [this](int place) {
            const auto k = static_cast<std::size_t>(place);
            factors_[k] = balls_[k];
        };
        for (int u = 0; u < system_->sizes.unknowns; ++u) {
            take(system_->place(u, 1));
            if (u < system_->sizes.angles) take(system_->place(u, -1));
        }
        for (const auto& step : system_->steps) {
            take(step.place);
            if (step.unknown < system_->sizes.angles) take(step.place + 1);
        }
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

    const BallSystem<S>* system_;
    std::vector<Ball<R>> balls_;
    std::vector<BallFactor<R>> factors_;
};

/// F over the balls of the factors.
template <class R, class S>
void ball_values(const BallSystem<S>& system, const FactorBalls<R>& at, auto&& f) {
    for (int u = 0; u < system.sizes.unknowns; ++u) f[u] = Ball<R>(Complex<R>(0.0));
    const auto* factors = system.factors.data();
    const BallFactor<R>* table = at.table();
    for (const auto& t : system.terms) {
        Ball<R> product = broadcast_ball<R>(t.coefficient);
        for (int k = t.first; k < t.last; ++k) product = product * table[factors[k].ball];
        f[t.equation] += product;
    }
}

namespace detail {

/// The term's product, differentiated by its factor number `d` and then by its factor number `d2`; -1 stands for none.
template <class R, class S>
Ball<R> term_derivative(const BallSystem<S>& system, const typename BallSystem<S>::Term& t, const FactorBalls<R>& at,
                        int d, int d2 = -1) {
    Ball<R> product = broadcast_ball<R>(t.coefficient);
    const auto* factors = system.factors.data();
    const BallFactor<R>* table = at.table();
    const int angles = system.sizes.angles;
    for (int k = t.first; k < t.last; ++k) {
        const auto& factor = factors[k];
        const int times = (k == d) + (k == d2);
        if (times == 0) {
            product = product * table[factor.ball];
        } else if (factor.unknown < angles) {
            // (cos k theta)' = -k sin k theta, (sin k theta)' = k cos k theta: with the code, -code and the other
            // factor
            const int other = factor.ball + (factor.code > 0 ? 1 : -1);
            product = product * table[times == 1 ? other : factor.ball];
            product = (times == 1 ? -factor.code : -(factor.code * factor.code)) * product;
        } else if (factor.code < times) {
            return Ball<R>(Complex<R>(0.0));
        } else {
            if (factor.code > times) product = product * table[factor.ball - times];
            product = (times == 1 ? factor.code : factor.code * (factor.code - 1)) * product;
        }
    }
    return product;
}

template <class R>
void clear(int n, auto&& j) {
    for (int r = 0; r < n; ++r) {
        auto* row = j[r];
        for (int c = 0; c < n; ++c) row[c] = Ball<R>(Complex<R>(0.0));
    }
}
/// Of a Hessian only the entries on and above the diagonal were filled in.
void complete(bool symmetric, int n, auto&& j) {
    if (!symmetric) return;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
}

}  // namespace detail

/// dF/dq over the balls of the factors; of a potential model the Hessian.
template <class R, class S>
void ball_jacobian(const BallSystem<S>& system, const FactorBalls<R>& at, auto&& j) {
    const int n = system.sizes.unknowns;
    detail::clear<R>(n, j);
    for (const auto& t : system.terms) {
        auto* row = j[t.equation];
        for (int d = t.first; d < t.last; ++d) {
            const int by = system.factors[static_cast<std::size_t>(d)].unknown;
            if (system.symmetric && by < t.equation) continue;
            row[by] += detail::term_derivative(system, t, at, d);
        }
    }
    detail::complete(system.symmetric, n, j);
}

/// The derivative of dF/dq by unknown number u.
template <class R, class S>
void ball_jacobian_derivative(const BallSystem<S>& system, const FactorBalls<R>& at, int u, auto&& j) {
    const int n = system.sizes.unknowns;
    detail::clear<R>(n, j);
    for (const auto& t : system.terms) {
        int d2 = t.first;
        while (d2 < t.last && system.factors[static_cast<std::size_t>(d2)].unknown != u) ++d2;
        if (d2 == t.last) continue;
        auto* row = j[t.equation];
        for (int d = t.first; d < t.last; ++d) {
            const int by = system.factors[static_cast<std::size_t>(d)].unknown;
            if (system.symmetric && by < t.equation) continue;
            row[by] += detail::term_derivative(system, t, at, d, d2);
        }
    }
    detail::complete(system.symmetric, n, j);
}

}  // namespace equilibria
