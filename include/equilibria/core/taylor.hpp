/// \file
/// Truncated power series in one variable: the Taylor coefficients of a function along a curve, exact to rounding, by
/// the recurrences of univariate Taylor arithmetic. One series of order K costs O(K^2) operations where K nested duals
/// cost 2^K, and it nests with Dual (core/dual.hpp) both ways: Taylor<Dual<double, N>, K> has the derivatives of all
/// coefficients, Dual<Taylor<double, K>, n> the gradient of a potential along a curve.
/// Where it fails: log, sqrt, division and floating powers need a first coefficient that is not 0.
/// Source: Griewank and Walther, Evaluating Derivatives, 13.2.
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>

namespace equilibria {

/// sum_k coefficient[k] t^k for k = 0..Order, higher powers dropped.
template <class T, int Order>
struct Taylor {
    static_assert(Order >= 0, "equilibria: the order of a power series must not be negative");

    Array<T, Order + 1> coefficient{};  ///< of t^k, k = 0..Order

    constexpr Taylor() = default;
    /// A constant.
    /// \{
    constexpr Taylor(const T& constant) { coefficient[0] = constant; }
    template <class A>
    requires(std::is_arithmetic_v<A> && !std::is_same_v<A, T>)
    constexpr Taylor(A constant) {
        coefficient[0] = static_cast<T>(detail::plain(constant));
    }
    /// \}

    /// value + slope t.
    static constexpr Taylor variable(const T& value, const T& slope = T(1.0)) {
        Taylor y(value);
        if constexpr (Order > 0) y.coefficient[1] = slope;
        return y;
    }

    /// All coefficients equal.
    friend constexpr bool operator==(const Taylor& a, const Taylor& b) { return a.coefficient == b.coefficient; }

    /// Arithmetic, truncated after t^Order; division needs b.coefficient[0] != 0.
    /// \{
    friend constexpr Taylor operator+(const Taylor& a) { return a; }
    friend constexpr Taylor operator-(const Taylor& a) {
        Taylor y;
        for (int k = 0; k <= Order; ++k) y.coefficient[k] = -a.coefficient[k];
        return y;
    }
    friend constexpr Taylor operator+(const Taylor& a, const Taylor& b) {
        Taylor y;
        for (int k = 0; k <= Order; ++k) y.coefficient[k] = a.coefficient[k] + b.coefficient[k];
        return y;
    }
    friend constexpr Taylor operator-(const Taylor& a, const Taylor& b) {
        Taylor y;
        for (int k = 0; k <= Order; ++k) y.coefficient[k] = a.coefficient[k] - b.coefficient[k];
        return y;
    }
    friend constexpr Taylor operator*(const Taylor& a, const Taylor& b) {
        Taylor y;
        for (int k = 0; k <= Order; ++k) {
            T sum = a.coefficient[0] * b.coefficient[k];
            for (int j = 1; j <= k; ++j) sum = sum + a.coefficient[j] * b.coefficient[k - j];
            y.coefficient[k] = sum;
        }
        return y;
    }
    friend constexpr Taylor operator/(const Taylor& a, const Taylor& b) {
        Taylor y;
        const T inverse = 1.0 / b.coefficient[0];
        for (int k = 0; k <= Order; ++k) {
            T sum = a.coefficient[k];
            for (int j = 1; j <= k; ++j) sum = sum - b.coefficient[j] * y.coefficient[k - j];
            y.coefficient[k] = sum * inverse;
        }
        return y;
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Taylor operator*(A a, const Taylor& b) {
        Taylor y;
        for (int k = 0; k <= Order; ++k) y.coefficient[k] = detail::plain(a) * b.coefficient[k];
        return y;
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Taylor operator*(const Taylor& b, A a) {
        return a * b;
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend constexpr Taylor operator/(const Taylor& b, A a) {
        Taylor y;
        const T divisor(detail::plain(a));
        for (int k = 0; k <= Order; ++k) y.coefficient[k] = b.coefficient[k] / divisor;
        return y;
    }
    constexpr Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
    constexpr Taylor& operator-=(const Taylor& b) { return *this = *this - b; }
    constexpr Taylor& operator*=(const Taylor& b) { return *this = *this * b; }
    constexpr Taylor& operator/=(const Taylor& b) { return *this = *this / b; }
    /// \}

    /// Elementary functions of the series; log, sqrt and powers that are no integers need a.coefficient[0] != 0,
    /// integer powers are repeated products.
    /// \{
    friend constexpr Taylor sin(const Taylor& a) { return sine_and_cosine(a).sine; }
    friend constexpr Taylor cos(const Taylor& a) { return sine_and_cosine(a).cosine; }
    friend constexpr Taylor exp(const Taylor& a) {
        using std::exp;
        Taylor y(T(exp(a.coefficient[0])));
        for (int k = 1; k <= Order; ++k) y.coefficient[k] = a.slope_product(y, k);
        return y;
    }
    friend constexpr Taylor log(const Taylor& a) {
        using std::log;
        Taylor y(T(log(a.coefficient[0])));
        const T inverse = 1.0 / a.coefficient[0];
        for (int k = 1; k <= Order; ++k) {
            T sum = static_cast<double>(k) * a.coefficient[k];
            for (int j = 1; j < k; ++j) sum = sum - static_cast<double>(j) * (y.coefficient[j] * a.coefficient[k - j]);
            y.coefficient[k] = sum * inverse / T(static_cast<double>(k));
        }
        return y;
    }
    friend constexpr Taylor sqrt(const Taylor& a) {
        using std::sqrt;
        Taylor y(T(sqrt(a.coefficient[0])));
        const T inverse = 0.5 / y.coefficient[0];
        for (int k = 1; k <= Order; ++k) {
            T sum = a.coefficient[k];
            for (int j = 1; j < k; ++j) sum = sum - y.coefficient[j] * y.coefficient[k - j];
            y.coefficient[k] = sum * inverse;
        }
        return y;
    }
    template <std::integral I>
    friend constexpr Taylor pow(const Taylor& a, I power) {
        const int k = static_cast<int>(power);
        if (k < 0) return Taylor(1.0) / pow(a, -k);
        Taylor y(1.0);
        for (int j = 0; j < k; ++j) y *= a;
        return y;
    }
    template <std::floating_point F>
    friend constexpr Taylor pow(const Taylor& a, F power) {
        using std::pow;
        Taylor y(T(pow(a.coefficient[0], power)));
        const T inverse = 1.0 / a.coefficient[0];
        for (int k = 1; k <= Order; ++k) {
            T sum{};
            for (int j = 1; j <= k; ++j)
                sum = sum + detail::plain(power * F(j) - F(k - j)) * (a.coefficient[j] * y.coefficient[k - j]);
            y.coefficient[k] = sum * inverse / T(static_cast<double>(k));
        }
        return y;
    }
    /// \}

private:
    struct SineAndCosine {
        Taylor sine, cosine;
    };

    static constexpr SineAndCosine sine_and_cosine(const Taylor& a) {
        using std::cos, std::sin;
        SineAndCosine y{Taylor(T(sin(a.coefficient[0]))), Taylor(T(cos(a.coefficient[0])))};
        for (int k = 1; k <= Order; ++k) {
            y.sine.coefficient[k] = a.slope_product(y.cosine, k);
            y.cosine.coefficient[k] = -a.slope_product(y.sine, k);
        }
        return y;
    }

    /// The coefficient k of the integral of this' y, k > 0; it needs those of y below k alone. (Divided by k as a T: a
    /// dual over a wide float would multiply by the rounded double 1 / k.)
    constexpr T slope_product(const Taylor& y, int k) const {
        T sum{};
        for (int j = 1; j <= k; ++j) sum = sum + static_cast<double>(j) * (coefficient[j] * y.coefficient[k - j]);
        return sum / T(static_cast<double>(k));
    }
};

}  // namespace equilibria
