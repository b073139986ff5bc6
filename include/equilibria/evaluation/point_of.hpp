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

/// The point of these unknowns: cos and sin of the angles, and the coordinates as they are. Angles far off the real
/// axis overflow from |imaginary part| of about 700 in double.
template <class M, class S>
Point<M, S> point_of(const ComplexUnknowns<M, S>& q, const Sizes<M>& sizes = {}) {
    using std::cos, std::exp, std::sin;
    auto y = point_of_zeros<M, S>(sizes);
    for (int i = 0; i < sizes.angles; ++i) {
        const S c = cos(q[i].re), s = sin(q[i].re), e = exp(q[i].im);
        const S ch = (e + 1 / e) / 2, sh = (e - 1 / e) / 2;
        y.c[i] = Complex<S>(S(c * ch), S(-(s * sh)));
        y.s[i] = Complex<S>(S(s * ch), S(c * sh));
    }
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
