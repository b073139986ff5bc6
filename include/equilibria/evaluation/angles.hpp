/// \file
/// The complex angles of points (c, s) of the complex circle, in lanes: c + i s = exp(i theta).
///
/// Logarithm and arc tangent by their series after a reduction of the argument, to 2 units in the last place; libm's
/// functions take one number at a time, and a million roots have ten million angles.
#pragma once

#include <cstdint>
#include <cstring>
#include <numbers>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>

namespace equilibria {

namespace detail {

/// log x of positive normal numbers.
template <class R>
R logarithm(const R& x) {
    // x = 2^e m with m in [sqrt(1/2), sqrt(2)), and log m = 2 artanh((m - 1) / (m + 1))
    R e, m;
    for (int k = 0; k < LaneTraits<R>::width; ++k) {
        constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd;
        std::int64_t bits;
        const double number = lane(x, k);
        std::memcpy(&bits, &number, sizeof bits);
        const std::int64_t exponent = (bits - root_half) >> 52;
        bits -= exponent << 52;
        double mantissa;
        std::memcpy(&mantissa, &bits, sizeof bits);
        set_lane(e, k, static_cast<double>(exponent));
        set_lane(m, k, mantissa);
    }
    const R s = (m - 1.0) / (m + 1.0), s2 = s * s;
    R sum = broadcast<R>(1 / 23.0);
    for (int k = 21; k > 1; k -= 2) sum = 1.0 / k + s2 * sum;
    return e * std::numbers::ln2 + (2.0 * s + 2.0 * s * (s2 * sum));
}

/// The angle of the vector (x, y) in (-pi, pi], in radians; not of (0, 0).
template <class R>
R angle_of_vector(const R& x, const R& y) {
    const R zero = R{}, ax = lane_max(x, R(-x)), ay = lane_max(y, R(-y));
    const auto steep = ay > ax;
    const R t = select(steep, ax, ay) / select(steep, ay, ax);
    // atan t = b + atan((t - tan b) / (1 + t tan b)), b = 0, pi/8, pi/4; what is left is at most pi/16
    const auto middle = t > R{} + 0.19891236737965801, upper = t > R{} + 0.66817863791929888;
    const R tangent = select(upper, R{} + 1.0, select(middle, R{} + 0.41421356237309503, zero));
    const R base = select(upper, R{} + std::numbers::pi / 4, select(middle, R{} + std::numbers::pi / 8, zero));
    const R u = (t - tangent) / (1.0 + t * tangent), u2 = u * u;
    R sum = broadcast<R>(1 / 25.0);
    for (int k = 23; k > 1; k -= 2) sum = 1.0 / k - u2 * sum;
    R angle = base + (u - u * (u2 * sum));
    angle = select(steep, R(std::numbers::pi / 2 - angle), angle);
    angle = select(x < zero, R(std::numbers::pi - angle), angle);
    return select(y < zero, R(-angle), angle);
}

}  // namespace detail

/// The complex angle of (c, s), in radians, real part in (-pi, pi].
template <class R>
Complex<R> angle_of(const Complex<R>& c, const Complex<R>& s) {
    const Complex<R> z(c.re - s.im, c.im + s.re), w(c.re + s.im, c.im - s.re);  // exp(i theta), exp(-i theta)
    const R z2 = norm2(z), w2 = norm2(w);
    const auto upper = z2 >= w2;  // the larger of the two has the digits
    const R angle = detail::angle_of_vector(select(upper, z.re, w.re), select(upper, z.im, w.im));
    const R size = 0.5 * detail::logarithm(select(upper, z2, w2));
    return {select(upper, angle, R(-angle)), select(upper, R(-size), size)};
}

}  // namespace equilibria
