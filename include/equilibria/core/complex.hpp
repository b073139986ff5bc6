/// \file
/// Complex numbers over any real type, packs of lanes included (std::complex is specified for float, double and
/// long double alone, and its product tests for NaN in every call).
#pragma once

#include <cmath>
#include <complex>
#include <type_traits>

#include <equilibria/core/lanes.hpp>

namespace equilibria {

/// re + i im over the real type R; uninitialised by default where R is.
template <class R>
struct Complex {
    using Real = R;  ///< of the parts: a floating-point type or a pack of lanes
    R re;            ///< real part
    R im;            ///< imaginary part

    constexpr Complex() = default;
    constexpr Complex(const R& real, const R& imaginary) : re(real), im(imaginary) {}  ///< from both parts
    /// A real constant, in every lane.
    constexpr Complex(double real) : re(broadcast<R>(real)), im(broadcast<R>(0.0)) {}
    /// A real number, which is not converted unasked.
    template <class A>
    requires(std::is_same_v<A, R> && !std::is_same_v<A, double>)
    constexpr explicit Complex(const A& real) : re(real), im(broadcast<R>(0.0)) {}

    /// Arithmetic of the field, and with real numbers; no guards against overflow.
    /// \{
    friend constexpr Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
    friend constexpr Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
    friend constexpr Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
    friend constexpr Complex operator*(const Complex& a, const Complex& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend constexpr Complex operator*(const R& a, const Complex& b) { return {a * b.re, a * b.im}; }
    friend constexpr Complex operator*(const Complex& b, const R& a) { return {a * b.re, a * b.im}; }
    friend constexpr Complex operator+(const Complex& a, const R& b) { return {a.re + b, a.im}; }
    friend constexpr Complex operator+(const R& b, const Complex& a) { return {a.re + b, a.im}; }
    friend constexpr Complex operator-(const Complex& a, const R& b) { return {a.re - b, a.im}; }
    friend constexpr Complex operator-(const R& b, const Complex& a) { return {b - a.re, -a.im}; }
    friend constexpr Complex operator/(const Complex& a, const Complex& b) { return a * inverse(b); }
    friend constexpr Complex operator/(const Complex& a, const R& b) { return {a.re / b, a.im / b}; }
    friend constexpr Complex operator/(const R& a, const Complex& b) { return a * inverse(b); }
    constexpr Complex& operator+=(const Complex& b) { return *this = *this + b; }
    constexpr Complex& operator-=(const Complex& b) { return *this = *this - b; }
    constexpr Complex& operator*=(const Complex& b) { return *this = *this * b; }
    constexpr Complex& operator*=(const R& b) { return *this = b * *this; }
    /// \}

    /// 1 / a, without guards against overflow: the values of a path are scaled, and a bad quotient is a failed step.
    friend constexpr Complex inverse(const Complex& a) {
        const R d = 1.0 / (a.re * a.re + a.im * a.im);
        return {a.re * d, -(a.im * d)};
    }
    /// The root with a real part that is not negative.
    friend Complex sqrt(const Complex& a) {
        const R size = square_root(a.re * a.re + a.im * a.im), one = broadcast<R>(1.0);
        const auto right = a.re >= broadcast<R>(0.0);
        const R larger = square_root(0.5 * (size + select(right, a.re, -a.re)));
        const R smaller = 0.5 * a.im / select(larger > broadcast<R>(0.0), larger, one);
        const auto below = smaller < broadcast<R>(0.0);
        return {select(right, larger, select(below, -smaller, smaller)),
                select(right, smaller, select(below, -larger, larger))};
    }
    /// |a|^2
    friend constexpr R norm2(const Complex& a) { return a.re * a.re + a.im * a.im; }
    friend constexpr Complex conj(const Complex& a) { return {a.re, -a.im}; }  ///< conjugate
    /// a^k, for an integer k of any arithmetic type: what a trigonometric polynomial needs.
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Complex pow(const Complex& a, A power) {
        const int k = static_cast<int>(power);
        if (k < 0) return inverse(pow(a, -k));
        Complex y(1.0);
        for (int j = 0; j < k; ++j) y *= a;
        return y;
    }
};

/// double factors and summands for packs of lanes and for multiprecision: 2.0 * z.
/// \{
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator*(double a, const Complex<R>& b) {
    return {a * b.re, a * b.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator*(const Complex<R>& b, double a) {
    return {a * b.re, a * b.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator+(const Complex<R>& a, double b) {
    return {a.re + b, a.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator+(double b, const Complex<R>& a) {
    return {a.re + b, a.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator-(const Complex<R>& a, double b) {
    return {a.re - b, a.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator-(double b, const Complex<R>& a) {
    return {b - a.re, -a.im};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator/(const Complex<R>& a, double b) {
    return {a.re / b, a.im / b};
}
template <class R>
requires(!std::is_same_v<R, double>)
constexpr Complex<R> operator/(double a, const Complex<R>& b) {
    return a * inverse(b);
}
/// \}

/// The same complex number in every lane.
template <class R, class A = double>
Complex<R> broadcast_complex(const std::complex<A>& z) {
    return {broadcast<R>(static_cast<typename LaneTraits<R>::Scalar>(z.real())),
            broadcast<R>(static_cast<typename LaneTraits<R>::Scalar>(z.imag()))};
}

/// Lane k as a std::complex<double>.
template <class R>
std::complex<double> lane(const Complex<R>& z, int k) {
    return {static_cast<double>(lane(z.re, k)), static_cast<double>(lane(z.im, k))};
}
/// Writes lane k, rounded to the lane's type.
template <class R>
void set_lane(Complex<R>& z, int k, const std::complex<double>& value) {
    set_lane(z.re, k, static_cast<typename LaneTraits<R>::Scalar>(value.real()));
    set_lane(z.im, k, static_cast<typename LaneTraits<R>::Scalar>(value.imag()));
}
/// Lane by lane, a where the mask is set and b elsewhere.
template <class M, class R>
Complex<R> select(const M& mask, const Complex<R>& a, const Complex<R>& b) {
    return {select(mask, a.re, b.re), select(mask, a.im, b.im)};
}

}  // namespace equilibria
