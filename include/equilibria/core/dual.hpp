/// \file
/// Forward-mode automatic differentiation: a value and its derivatives along N directions. Nested duals give higher
/// derivatives, exact to rounding: Dual<Dual<double, 1>, N> holds a Hessian-vector product.
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

#include <equilibria/core/array.hpp>

namespace equilibria {

namespace detail {
/// Plain numbers meet any scalar as doubles, but for long doubles, which would lose digits.
template <class A>
constexpr auto plain(A a) {
    if constexpr (std::is_same_v<A, long double>)
        return a;
    else
        return static_cast<double>(a);
}
}  // namespace detail

/// A value and its derivatives along N directions, over the scalar T.
template <class T, int N>
struct Dual {
    T value{};                 ///< of the function at the point
    Array<T, N> derivative{};  ///< along each direction; of a variable number k, entry k is 1

    constexpr Dual() = default;
    /// A constant: all derivatives are 0.
    /// \{
    constexpr Dual(const T& v) : value(v) {}
    template <class A>
    requires(std::is_arithmetic_v<A> && !std::is_same_v<A, T>)
    constexpr Dual(A v) : value(static_cast<T>(detail::plain(v))) {}
    /// \}

    /// The independent variable number k.
    static constexpr Dual variable(const T& v, int k) {
        Dual x(v);
        x.derivative[k] = T(1.0);
        return x;
    }

    /// f(x) given the values of f and of f' there.
    template <class F, class D>
    constexpr Dual chain(const F& f, const D& slope) const {
        Dual y(f);
        for (int k = 0; k < derivative.size(); ++k) y.derivative[k] = slope * derivative[k];
        return y;
    }

    /// Whether the values and all derivatives agree.
    friend constexpr bool operator==(const Dual& a, const Dual& b) {
        for (int k = 0; k < N; ++k)
            if (!(a.derivative[k] == b.derivative[k])) return false;
        return a.value == b.value;
    }
    /// Arithmetic, exact to first order.
    /// \{
    friend constexpr Dual operator-(const Dual& a) { return a.chain(-a.value, -1.0); }
    friend constexpr Dual operator+(const Dual& a, const Dual& b) {
        Dual y(a.value + b.value);
        for (int k = 0; k < y.derivative.size(); ++k) y.derivative[k] = a.derivative[k] + b.derivative[k];
        return y;
    }
    friend constexpr Dual operator-(const Dual& a, const Dual& b) {
        Dual y(a.value - b.value);
        for (int k = 0; k < y.derivative.size(); ++k) y.derivative[k] = a.derivative[k] - b.derivative[k];
        return y;
    }
    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        Dual y(a.value * b.value);
        for (int k = 0; k < y.derivative.size(); ++k)
            y.derivative[k] = a.derivative[k] * b.value + a.value * b.derivative[k];
        return y;
    }
    friend constexpr Dual operator/(const Dual& a, const Dual& b) {
        const T inverse = 1.0 / b.value, quotient = a.value * inverse;
        Dual y(quotient);
        for (int k = 0; k < y.derivative.size(); ++k)
            y.derivative[k] = (a.derivative[k] - quotient * b.derivative[k]) * inverse;
        return y;
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Dual operator*(A a, const Dual& b) {
        return b.chain(detail::plain(a) * b.value, detail::plain(a));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Dual operator*(const Dual& b, A a) {
        return a * b;
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Dual operator/(const Dual& b, A a) {
        Dual y(b.value / detail::plain(a));
        for (int k = 0; k < N; ++k) y.derivative[k] = b.derivative[k] / detail::plain(a);
        return y;
    }
    constexpr Dual& operator+=(const Dual& b) {
        value = value + b.value;
        for (int k = 0; k < derivative.size(); ++k) derivative[k] = derivative[k] + b.derivative[k];
        return *this;
    }
    constexpr Dual& operator-=(const Dual& b) {
        value = value - b.value;
        for (int k = 0; k < derivative.size(); ++k) derivative[k] = derivative[k] - b.derivative[k];
        return *this;
    }
    constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
    constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }
    /// \}

    /// Elementary functions by the chain rule, from those of T; the integer powers by repeated products.
    /// \{
    friend constexpr Dual sin(const Dual& a) {
        using std::cos, std::sin;
        return a.chain(sin(a.value), cos(a.value));
    }
    friend constexpr Dual cos(const Dual& a) {
        using std::cos, std::sin;
        return a.chain(cos(a.value), -sin(a.value));
    }
    friend constexpr Dual exp(const Dual& a) {
        using std::exp;
        const T e = exp(a.value);
        return a.chain(e, e);
    }
    friend constexpr Dual log(const Dual& a) {
        using std::log;
        return a.chain(log(a.value), 1.0 / a.value);
    }
    friend constexpr Dual sqrt(const Dual& a) {
        using std::sqrt;
        const T root = sqrt(a.value);
        return a.chain(root, 0.5 / root);
    }
    friend constexpr Dual atan2(const Dual& y, const Dual& x) {
        using std::atan2;
        const T inverse = 1.0 / (x.value * x.value + y.value * y.value);
        Dual angle(atan2(y.value, x.value));
        for (int k = 0; k < angle.derivative.size(); ++k)
            angle.derivative[k] = (x.value * y.derivative[k] - y.value * x.derivative[k]) * inverse;
        return angle;
    }
    template <std::integral I>
    friend constexpr Dual pow(const Dual& a, I power) {
        const int k = static_cast<int>(power);
        if (k < 0) return Dual(1.0) / pow(a, -k);
        Dual y(1.0);
        for (int j = 0; j < k; ++j) y *= a;
        return y;
    }
    template <std::floating_point F>
    friend constexpr Dual pow(const Dual& a, F power) {
        using std::pow;
        return a.chain(pow(a.value, power), detail::plain(power) * pow(a.value, power - 1));
    }
    /// \}
};

}  // namespace equilibria
