/// \file
/// Points of (C*)^n x C^m: each angle by its point (c, s) of the complex circle, the coordinates by their values.
#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <utility>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// A point over the real type R, possibly a pack of lanes (a point a lane).
template <class M, class R>
struct Point {
    Array<Complex<R>, n_angles<M>> c;       ///< cosine of each angle
    Array<Complex<R>, n_angles<M>> s;       ///< sine of each angle
    Array<Complex<R>, n_coordinates<M>> x;  ///< the plain coordinates
};
/// Of as many unknowns as are asked for.
template <class R>
struct Point<RuntimeUnknowns, R> {
    SizedArray<Complex<R>, at_run_time> c;  ///< cosine of each angle
    SizedArray<Complex<R>, at_run_time> s;  ///< sine of each angle
    SizedArray<Complex<R>, at_run_time> x;  ///< the plain coordinates
};
/// A point whose numbers of unknowns are known at run time.
template <class R>
using RuntimePoint = Point<RuntimeUnknowns, R>;

/// The numbers of a point, wherever they lie. Empty: no point.
struct PointView {
    std::span<const Complex<double>> c;  ///< cosine of each angle
    std::span<const Complex<double>> s;  ///< sine of each angle
    std::span<const Complex<double>> x;  ///< the plain coordinates

    PointView() = default;
    /// Of these numbers, which have to outlive it.
    PointView(std::span<const Complex<double>> cosines, std::span<const Complex<double>> sines,
              std::span<const Complex<double>> coordinates)
        : c(cosines), s(sines), x(coordinates) {}
    /// Of a point, which has to outlive it.
    PointView(const RuntimePoint<double>& q)
        : c(q.c.begin(), q.c.end()), s(q.s.begin(), q.s.end()), x(q.x.begin(), q.x.end()) {}
    bool empty() const { return c.empty() && x.empty(); }  ///< whether there is no point
};

/// A point with the numbers 0.
template <class M, class R>
Point<M, R> point_of_zeros(const Sizes<M>& sizes) {
    if constexpr (Sizes<M>::extent == at_run_time) {
        using Numbers = SizedArray<Complex<R>, at_run_time>;
        return {Numbers(sizes.angles), Numbers(sizes.angles), Numbers(sizes.coordinates)};
    } else {
        return Point<M, R>();
    }
}

/// Copies lane `from` of a to lane `to` of b, which has as many unknowns, or none yet.
template <class M, class R, class N, class Q>
void copy_lane(const Point<M, R>& a, int from, Point<N, Q>& b, int to) {
    const auto copy = [&](const auto& source, auto& target) {
        if constexpr (std::is_same_v<N, RuntimeUnknowns>)
            if (target.size() != source.size()) target.resize(source.size());
        for (int i = 0; i < source.size(); ++i) {
            set_lane(target[i].re, to, static_cast<typename LaneTraits<Q>::Scalar>(lane(source[i].re, from)));
            set_lane(target[i].im, to, static_cast<typename LaneTraits<Q>::Scalar>(lane(source[i].im, from)));
        }
    };
    copy(a.c, b.c);
    copy(a.s, b.s);
    copy(a.x, b.x);
}

/// The same point, with its numbers of unknowns at run time.
template <class R>
RuntimePoint<R> runtime_point(RuntimePoint<R> q) {
    return q;
}
/// A copy.
template <class M, class R>
RuntimePoint<R> runtime_point(const Point<M, R>& q) {
    const auto entries = [](const auto& a) {
        return SizedArray<Complex<R>, at_run_time>(AlignedVector<Complex<R>>(a.begin(), a.end()));
    };
    return {entries(q.c), entries(q.s), entries(q.x)};
}

/// b becomes a where the mask is set.
template <class M, class R, class Mask>
void take_where(const Mask& mask, const Point<M, R>& a, Point<M, R>& b) {
    for (int i = 0; i < a.c.size(); ++i) b.c[i] = select(mask, a.c[i], b.c[i]), b.s[i] = select(mask, a.s[i], b.s[i]);
    for (int j = 0; j < a.x.size(); ++j) b.x[j] = select(mask, a.x[j], b.x[j]);
}
/// a where the mask is set, b elsewhere.
template <class M, class R, class Mask>
Point<M, R> select(const Mask& mask, const Point<M, R>& a, const Point<M, R>& b) {
    Point<M, R> y = b;
    take_where(mask, a, y);
    return y;
}

/// How many unknowns a point has.
template <class M, class R>
int unknowns(const Point<M, R>& q) {
    return q.c.size() + q.x.size();
}
/// |c|^2 + |s|^2 of an angle, |x|^2 of a coordinate.
template <class M, class R>
R unknown_size2(const Point<M, R>& q, int u) {
    return u < q.c.size() ? norm2(q.c[u]) + norm2(q.s[u]) : norm2(q.x[u - q.c.size()]);
}
/// The square of the size of the unknown that is farthest out.
template <class M, class R>
R farthest2(const Point<M, R>& q) {
    R y = broadcast<R>(0.0);
    for (int u = 0; u < unknowns(q); ++u) y = lane_max(y, unknown_size2(q, u));
    return y;
}

namespace detail {

/// exp(i theta) = c + i s and exp(-i theta) = c - i s: the larger one, and its reciprocal, so that both have all their
/// digits however far out the angle is.
template <class R>
std::pair<Complex<R>, Complex<R>> exponentials(const Complex<R>& c, const Complex<R>& s) {
    const Complex<R> plus(c.re - s.im, c.im + s.re), minus(c.re + s.im, c.im - s.re);
    const auto outside = norm2(plus) > norm2(minus);
    const Complex<R> larger = select(outside, plus, minus), smaller = inverse(larger);
    return {select(outside, larger, smaller), select(outside, smaller, larger)};
}

/// (c, s) on the circle.
template <class R>
void onto_circle(Complex<R>& c, Complex<R>& s) {
    const auto [z, reciprocal] = exponentials(c, s);
    const Complex<R> half = 0.5 * (z - reciprocal);
    c = 0.5 * (z + reciprocal);
    s = Complex<R>(half.im, -half.re);
}

/// Turns (c, s) by the angle whose cosine and sine are nearly (co, si), and goes back onto the circle: by one Newton
/// step, or, where |c| is large and 1 - c^2 - s^2 all rounding, by its exponentials.
template <class R>
void turn(Complex<R>& c, Complex<R>& s, const Complex<R>& co, const Complex<R>& si) {
    const Complex<R> cosine = c * co - s * si, sine = s * co + c * si;
    const Complex<R> back = 1.5 - 0.5 * (cosine * cosine + sine * sine);
    const auto near = norm2(cosine) < R{} + 1e4;
    Complex<R> far_cosine = cosine, far_sine = sine;
    if (!all_lanes(near)) onto_circle(far_cosine, far_sine);
    c = select(near, cosine * back, far_cosine);
    s = select(near, sine * back, far_sine);
}

/// cos d and sin d by their series to d^8 and d^9 (|d| < 0.5: error below 1e-9, absorbed by the corrector): no
/// transcendental function is called.
template <class R>
std::pair<Complex<R>, Complex<R>> series_of_circle(const Complex<R>& d) {
    const Complex<R> d2 = d * d;
    return {
        Complex<R>(1.0 - 0.5 * (d2 * (1.0 - 1 / 12. * (d2 * (1.0 - 1 / 30. * (d2 * (1.0 - 1 / 56. * d2))))))),
        Complex<R>(d * (1.0 - 1 / 6. * (d2 * (1.0 - 1 / 20. * (d2 * (1.0 - 1 / 42. * (d2 * (1.0 - 1 / 72. * d2))))))))};
}

}  // namespace detail

/// Moves the point by d: angles turned by the small complex angle d_i, coordinates shifted by d_j.
template <class M, class R>
void move(Point<M, R>& q, const auto& d) {
    for (int i = 0; i < q.c.size(); ++i) {
        const auto [co, si] = detail::series_of_circle(d[i]);
        detail::turn(q.c[i], q.s[i], co, si);
    }
    for (int j = 0; j < q.x.size(); ++j) q.x[j] += d[q.c.size() + j];
}
/// The same, off the circle by the error of the series: for a prediction, whose corrector goes back onto it.
template <class M, class R>
void move_roughly(Point<M, R>& q, const auto& d) {
    for (int i = 0; i < q.c.size(); ++i) {
        const auto [co, si] = detail::series_of_circle(d[i]);
        const Complex<R> cosine = q.c[i] * co - q.s[i] * si;
        q.s[i] = q.s[i] * co + q.c[i] * si;
        q.c[i] = cosine;
    }
    for (int j = 0; j < q.x.size(); ++j) q.x[j] += d[q.c.size() + j];
}
/// q after `move`.
template <class M, class R>
Point<M, R> moved(Point<M, R> q, const auto& d) {
    move(q, d);
    return q;
}

/// The square of the largest change in d: of angles in radians, of coordinates against 1 + |x|.
template <class M, class R>
R correction_size(const Point<M, R>& q, const auto& d) {
    R largest = broadcast<R>(0.0);
    for (int u = 0; u < q.c.size(); ++u) largest = lane_max(largest, norm2(d[u]));
    for (int j = 0; j < q.x.size(); ++j) largest = lane_max(largest, norm2(d[q.c.size() + j]) / (1.0 + norm2(q.x[j])));
    return largest;
}

/// `move` for the tiny steps of a corrector (|d| < 0.01: error below 1e-12).
template <class M, class R>
void correct(Point<M, R>& q, const auto& d) {
    for (int i = 0; i < q.c.size(); ++i) {
        const Complex<R> d2 = d[i] * d[i];
        const Complex<R> co = 1.0 - 0.5 * (d2 * (1.0 - 1 / 12. * d2));
        const Complex<R> si = d[i] * (1.0 - 1 / 6. * d2);
        detail::turn(q.c[i], q.s[i], co, si);
    }
    for (int j = 0; j < q.x.size(); ++j) q.x[j] += d[q.c.size() + j];
}
/// q after `correct`.
template <class M, class R>
Point<M, R> corrected(Point<M, R> q, const auto& d) {
    correct(q, d);
    return q;
}

/// `correct` to the order of Newton's method, whose steps are wrong by their squares: the angle by |d|^3 / 6.
template <class R>
void correct_roughly(RuntimePoint<R>& q, const auto& d) {
    for (int i = 0; i < q.c.size(); ++i) detail::turn(q.c[i], q.s[i], Complex<R>(1.0 - 0.5 * (d[i] * d[i])), d[i]);
    for (int j = 0; j < q.x.size(); ++j) q.x[j] += d[q.c.size() + j];
}

}  // namespace equilibria
