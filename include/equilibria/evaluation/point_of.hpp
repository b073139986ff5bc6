/// \file
/// From unknowns to points of (C*)^n x C^m (point.hpp): the cosines and sines of complex angles, in any real type.
#pragma once

#include <cmath>
#include <complex>

#include <equilibria/core/array.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// Angles in complex radians, then coordinates.
template <class M, class S>
using ComplexUnknowns = UnknownArray<M, Complex<S>>;

/// c and s: the cosine and sine of a complex angle.
template <class S>
void set_circle_point(const S& re, const S& im, Complex<S>& c, Complex<S>& s) {
    using std::cos, std::exp, std::sin;
    const S co = cos(re), si = sin(re), e = exp(im);
    const S ch = (e + 1 / e) / 2, sh = (e - 1 / e) / 2;
    c = Complex<S>(S(co * ch), S(-(si * sh)));
    s = Complex<S>(S(si * ch), S(co * sh));
}

/// The point of these unknowns: cos and sin of the angles, and the coordinates as they are. Angles far off the real
/// axis overflow from |imaginary part| of about 700 in double.
template <class M, class S>
Point<M, S> point_of(const ComplexUnknowns<M, S>& q, const Sizes<M>& sizes = {}) {
    auto y = point_of_zeros<M, S>(sizes);
    for (int i = 0; i < sizes.angles; ++i) set_circle_point(q[i].re, q[i].im, y.c[i], y.s[i]);
    for (int j = 0; j < sizes.coordinates; ++j) y.x[j] = q[sizes.angles + j];
    return y;
}

/// The same of std::complex, by its own cos and sin: a root's unknowns. For a lane of a pack see copy_lane.
template <class M>
Point<M, double> point_of(const UnknownArray<M, std::complex<double>>& q, const Sizes<M>& sizes = {}) {
    const auto entry = [](const std::complex<double>& z) { return Complex<double>(z.real(), z.imag()); };
    auto y = point_of_zeros<M, double>(sizes);
    for (int i = 0; i < sizes.angles; ++i) y.c[i] = entry(std::cos(q[i])), y.s[i] = entry(std::sin(q[i]));
    for (int j = 0; j < sizes.coordinates; ++j) y.x[j] = entry(q[sizes.angles + j]);
    return y;
}

}  // namespace equilibria
