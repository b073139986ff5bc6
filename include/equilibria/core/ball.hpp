/// \file
/// Complex balls with a priori rounding bounds (midpoint-radius arithmetic, Rump): {z : |z - mid| <= rad}. The exact
/// result of an operation on members of the operands is a member of the ball returned. No rounding mode is switched, so
/// the same code runs over doubles, packs of lanes and multiprecision floats, and lanes stay full.
///
/// What is assumed: IEEE arithmetic rounded to nearest (of multiprecision floats: each operation within one unit in the
/// last place), subnormals kept or flushed, contraction into fused operations allowed. Options that let the compiler
/// reorder sums or drop NaNs break the proofs, and are refused.
#pragma once

#include <limits>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "equilibria: proofs need IEEE arithmetic: compile without -ffast-math, -Ofast and their parts"
#endif

namespace equilibria {

/// One unit in the last place of 1, as a share: above the relative error of any single operation.
template <class R>
inline const typename LaneTraits<R>::Scalar rounding_unit =
    std::numeric_limits<typename LaneTraits<R>::Scalar>::epsilon();
/// More than the absolute error of any operation that underflows.
template <class R>
inline const typename LaneTraits<R>::Scalar underflow_unit =
    16 * std::numeric_limits<typename LaneTraits<R>::Scalar>::min();

/// An upper bound of a sum or product of non-negative numbers that was computed with at most 12 roundings.
template <class R>
R rounded_up(const R& x) {
    return x * (R{} + (1 + 16 * rounding_unit<R>)) + underflow_unit<R>;
}

/// max + min / 2 of |re| and |im|: not below |z|, and above it by 12 % at the most. One rounding.
template <class R>
R magnitude_bound(const Complex<R>& z) {
    const R re = lane_max(z.re, R(-z.re)), im = lane_max(z.im, R(-z.im));
    // lane_max would drop a NaN in its first operand
    return select(re > im, R(re + 0.5 * im), R(im + 0.5 * re)) + (z.re - z.re) + (z.im - z.im);
}

template <class R>
struct BallFactor;

/// All z with |z - mid| <= rad, a ball in each lane.
template <class R>
struct Ball {
    Complex<R> mid;  ///< midpoint
    R rad;           ///< radius, not negative; infinite where nothing is known

    constexpr Ball() = default;
    Ball(const Complex<R>& z) : mid(z), rad(R{} + 0.0) {}                ///< the point z alone
    Ball(const Complex<R>& z, const R& radius) : mid(z), rad(radius) {}  ///< both parts as given

    /// Not below |z| for any member z.
    friend R magnitude_bound(const Ball& a) { return rounded_up<R>(magnitude_bound(a.mid) + a.rad); }

    /// Contains the exact result for any members of the operands.
    /// \{
    friend Ball operator-(const Ball& a) { return {-a.mid, a.rad}; }
    friend Ball operator+(const Ball& a, const Ball& b) {
        const Complex<R> sum = a.mid + b.mid;
        return {sum, rounded_up<R>(a.rad + b.rad + rounding_unit<R> * magnitude_bound(sum))};
    }
    friend Ball operator-(const Ball& a, const Ball& b) { return a + (-b); }
    /// The error of a complex product is below sqrt(5) / 2 units (Brent, Percival, Zimmermann).
    friend Ball operator*(const Ball& a, const Ball& b) { return a * BallFactor<R>(b); }
    /// By a small integer.
    friend Ball operator*(int k, const Ball& a) {
        if (k == 1 || k == -1) return k == 1 ? a : -a;
        const R by = R{} + static_cast<double>(k), size = R{} + static_cast<double>(k < 0 ? -k : k);
        const Complex<R> product = by * a.mid;
        return {product, rounded_up<R>(size * a.rad + rounding_unit<R> * magnitude_bound(product))};
    }
    Ball& operator+=(const Ball& b) { return *this = *this + b; }
    /// \}

    /// 1 / z; an infinite radius where 0 may be a member.
    friend Ball inverse(const Ball& a) {
        const R square = norm2(a.mid);
        const R size = lane_max(lane_max(a.mid.re, R(-a.mid.re)), lane_max(a.mid.im, R(-a.mid.im)));  // at most |z|
        const R gap = size - a.rad - 4 * rounding_unit<R> * size;
        const Complex<R> y = inverse(a.mid);
        // |1/z - 1/mid| <= rad / (|mid| (|mid| - rad)), and 8 units for the rounding of 1/mid
        const R radius = rounded_up<R>(a.rad / (size * gap) + 8 * rounding_unit<R> * magnitude_bound(y));
        const R infinite = R{} + std::numeric_limits<typename LaneTraits<R>::Scalar>::infinity();
        const auto& least = std::numeric_limits<typename LaneTraits<R>::Scalar>::min();
        const auto safe = square > R{} + least / rounding_unit<R>;  // no underflow in re^2 + im^2 that matters
        return {y, select(gap > R{} + 0.0, select(safe, rounded_up<R>(radius), infinite), infinite)};
    }
};

/// A ball that many others are multiplied by, with what each product takes of it.
template <class R>
struct BallFactor {
    Complex<R> mid;  ///< that of the ball
    R error;         ///< rad and the rounding of a product, as a share of the other's size
    R reach;         ///< bound of |mid| + rad

    BallFactor() = default;
    /// Of the ball b.
    BallFactor(const Ball<R>& b) : mid(b.mid) {
        const R size = magnitude_bound(b.mid);
        error = b.rad + 2 * rounding_unit<R> * size;
        reach = size + b.rad;
    }
    /// As of two balls.
    friend Ball<R> operator*(const Ball<R>& a, const BallFactor& b) {
        return {a.mid * b.mid, rounded_up<R>(magnitude_bound(a.mid) * b.error + a.rad * b.reach)};
    }
};

/// The same ball in every lane.
template <class R>
Ball<R> broadcast_ball(const Ball<typename LaneTraits<R>::Scalar>& a) {
    return {Complex<R>(broadcast<R>(a.mid.re), broadcast<R>(a.mid.im)), broadcast<R>(a.rad)};
}

}  // namespace equilibria
