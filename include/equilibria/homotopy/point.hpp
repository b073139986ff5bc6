/// \file
/// Points of (C*)^n x C^m: each angle by its point (c, s) of the complex circle, the coordinates by their values.
#pragma once

#include <complex>

#include <equilibria/core/array.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// A point over the real type R, possibly a pack of lanes (a point a lane).
template <class M, class R>
struct Point {
    Array<Complex<R>, n_angles<M>> c, s;
    Array<Complex<R>, n_coordinates<M>> x;
};

/// Copies lane `from` of a to lane `to` of b.
template <class M, class R, class Q>
void copy_lane(const Point<M, R>& a, int from, Point<M, Q>& b, int to) {
    const auto copy = [&](const auto& source, auto& target) {
        for (int i = 0; i < source.size(); ++i) {
            set_lane(target[i].re, to, lane(source[i].re, from));
            set_lane(target[i].im, to, lane(source[i].im, from));
        }
    };
    copy(a.c, b.c);
    copy(a.s, b.s);
    copy(a.x, b.x);
}

/// a where the mask is set, b elsewhere.
template <class M, class R, class Mask>
Point<M, R> select(const Mask& mask, const Point<M, R>& a, const Point<M, R>& b) {
    Point<M, R> y;
    for (int i = 0; i < a.c.size(); ++i) y.c[i] = select(mask, a.c[i], b.c[i]), y.s[i] = select(mask, a.s[i], b.s[i]);
    for (int j = 0; j < a.x.size(); ++j) y.x[j] = select(mask, a.x[j], b.x[j]);
    return y;
}

/// The point moved by d: angles turned by the small complex angle d_i, coordinates shifted by d_j.
///
/// sin d and cos d by their series to d^8 and d^9 (|d| < 0.5: error below 1e-9, absorbed by the corrector), then one
/// Newton step back onto the circle: no transcendental function is called.
template <class M, class R>
Point<M, R> moved(const Point<M, R>& a, const Complex<R> (&d)[n_unknowns<M>]) {
    Point<M, R> y;
    for (int i = 0; i < n_angles<M>; ++i) {
        const Complex<R> d2 = d[i] * d[i];
        const Complex<R> co = 1.0 - 0.5 * (d2 * (1.0 - 1 / 12. * (d2 * (1.0 - 1 / 30. * (d2 * (1.0 - 1 / 56. * d2))))));
        const Complex<R> si =
            d[i] * (1.0 - 1 / 6. * (d2 * (1.0 - 1 / 20. * (d2 * (1.0 - 1 / 42. * (d2 * (1.0 - 1 / 72. * d2)))))));
        const Complex<R> c = a.c[i] * co - a.s[i] * si, s = a.s[i] * co + a.c[i] * si;
        const Complex<R> back = 1.5 - 0.5 * (c * c + s * s);
        y.c[i] = c * back;
        y.s[i] = s * back;
    }
    for (int j = 0; j < n_coordinates<M>; ++j) y.x[j] = a.x[j] + d[n_angles<M> + j];
    return y;
}

/// The same for the tiny steps of a corrector (|d| < 0.01: error below 1e-12).
template <class M, class R>
Point<M, R> corrected(const Point<M, R>& a, const Complex<R> (&d)[n_unknowns<M>]) {
    Point<M, R> y;
    for (int i = 0; i < n_angles<M>; ++i) {
        const Complex<R> d2 = d[i] * d[i];
        const Complex<R> co = 1.0 - 0.5 * (d2 * (1.0 - 1 / 12. * d2));
        const Complex<R> si = d[i] * (1.0 - 1 / 6. * d2);
        const Complex<R> c = a.c[i] * co - a.s[i] * si, s = a.s[i] * co + a.c[i] * si;
        const Complex<R> back = 1.5 - 0.5 * (c * c + s * s);
        y.c[i] = c * back;
        y.s[i] = s * back;
    }
    for (int j = 0; j < n_coordinates<M>; ++j) y.x[j] = a.x[j] + d[n_angles<M> + j];
    return y;
}

}  // namespace equilibria
