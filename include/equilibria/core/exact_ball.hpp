/// \file
/// The numbers in which a model's polynomials are known exactly. A double is an integer times a power of two, and so
/// are sums and products of doubles: the coefficients of most models are computed without any rounding, and one that
/// cancels is exactly 0. Quotients, sqrt, sin, exp, ... of parameters are enclosed to 100 digits; so is a parameter
/// that stands for an interval. Used for a model's few coefficients, never in a loop over roots.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include <equilibria/core/ball.hpp>
#include <equilibria/core/big_integer.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// mantissa 2^exponent, with no limit to the digits of the mantissa.
class Dyadic {
public:
    Dyadic() = default;
    /// The value of a finite number of any binary floating-point type, or of an integer; of a type of more digits than
    /// a double's where core/multiprecision.hpp is included.
    template <class A>
    explicit Dyadic(const A& value) {
        if constexpr (std::is_integral_v<A>) {
            using Wide = std::conditional_t<std::is_unsigned_v<A>, std::uint64_t, std::int64_t>;
            mantissa_ = BigInteger(static_cast<Wide>(value));
        } else if constexpr (std::is_same_v<A, double>) {
            auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent_), 53));
            exponent_ -= 53;
            for (; m != 0 && m % 2 == 0; m /= 2) ++exponent_;
            mantissa_ = BigInteger(m);
        } else {
            using std::frexp, std::ldexp;
            int e = 0;
            A m = frexp(value, &e);
            constexpr int bits = std::numeric_limits<A>::digits;
            m = ldexp(m, bits);
            mantissa_ = BigInteger(m);
            exponent_ = e - bits;
            if (is_zero()) return;
            const int zeros = mantissa_.trailing_zeros();
            mantissa_ = mantissa_ >> zeros;
            exponent_ += zeros;
        }
    }

    bool is_zero() const { return mantissa_.is_zero(); }  ///< whether the value is 0
    /// Whether the values are the same, however they are written.
    friend bool operator==(const Dyadic& a, const Dyadic& b) {
        if (a.is_zero() || b.is_zero()) return a.is_zero() && b.is_zero();
        return (a - b).is_zero();
    }
    /// Exact.
    /// \{
    friend Dyadic operator-(Dyadic a) {
        a.mantissa_ = -a.mantissa_;
        return a;
    }
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        Dyadic y;
        y.exponent_ = std::min(a.exponent_, b.exponent_);
        y.mantissa_ = (a.mantissa_ << (a.exponent_ - y.exponent_)) + (b.mantissa_ << (b.exponent_ - y.exponent_));
        return y;
    }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + (-b); }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        Dyadic y;
        y.mantissa_ = a.mantissa_ * b.mantissa_;
        y.exponent_ = y.is_zero() ? 0 : a.exponent_ + b.exponent_;
        return y;
    }
    /// \}

    /// The value in the floating-point type S, wrong by a few units in the last place at the most.
    template <class S>
    S to() const {
        using std::ldexp;
        if (is_zero()) return S(0);
        // the leading digits, so that the conversion cannot overflow
        const int drop = std::max(0, mantissa_.top_bit() - (std::numeric_limits<S>::digits + 8));
        return ldexp((mantissa_ >> drop).template to<S>(), exponent_ + drop);
    }

private:
    BigInteger mantissa_;
    int exponent_ = 0;
};

/// All real numbers within `rad` of an exactly known midpoint.
class ExactBall {
public:
    ExactBall() = default;
    /// Exactly this number.
    template <class A>
    requires std::is_arithmetic_v<A>
    ExactBall(A value) : mid_(value) {}
    ExactBall(const Dyadic& mid, double rad) : mid_(mid), rad_(rad) {}  ///< all within rad >= 0 of mid
    /// All numbers from low to high.
    static ExactBall between(double low, double high) {
        const Dyadic a(low), b(high), half(0.5);
        return {half * (a + b), rounded_up((half * (b - a)).to<double>())};
    }

    const Dyadic& mid() const { return mid_; }  ///< exact midpoint
    double rad() const { return rad_; }         ///< radius, not negative; rounded up
    bool exact() const { return rad_ == 0; }    ///< whether there is one member alone

    /// Whether midpoint and radius agree.
    friend bool operator==(const ExactBall& a, const ExactBall& b) { return a.mid_ == b.mid_ && a.rad_ == b.rad_; }
    /// Contains the result for any members of the operands; exact where they are.
    /// \{
    friend ExactBall operator-(const ExactBall& a) { return {-a.mid_, a.rad_}; }
    friend ExactBall operator+(const ExactBall& a, const ExactBall& b) {
        return {a.mid_ + b.mid_, a.exact() && b.exact() ? 0 : rounded_up(a.rad_ + b.rad_)};
    }
    friend ExactBall operator-(const ExactBall& a, const ExactBall& b) { return a + (-b); }
    friend ExactBall operator*(const ExactBall& a, const ExactBall& b) {
        if (a.exact() && b.exact()) return {a.mid_ * b.mid_, 0};
        return {a.mid_ * b.mid_, rounded_up(a.size() * b.rad_ + a.rad_ * (b.size() + b.rad_))};
    }

    /// \}
    // Templates, so that a program without the compiled library pays only for the functions that its models call.

    /// Throws InvalidArgument where the divisor may be 0.
    template <class A, class B>
    requires(std::same_as<A, ExactBall> || std::same_as<B, ExactBall>)
    friend ExactBall operator/(const A& a, const B& b) {
        return ExactBall(a) * inverse(ExactBall(b));
    }
    /// Enclosed to 100 digits. Throws InvalidArgument where the result is not finite, and where the argument of a root
    /// or logarithm may not be positive (but for sqrt(0) = 0).
    /// \{
    template <std::same_as<ExactBall> B>
    friend ExactBall sqrt(const B& a);
    template <std::same_as<ExactBall> B>
    friend ExactBall exp(const B& a);
    template <std::same_as<ExactBall> B>
    friend ExactBall log(const B& a);
    template <std::same_as<ExactBall> B>
    friend ExactBall sin(const B& a);
    template <std::same_as<ExactBall> B>
    friend ExactBall cos(const B& a);
    /// \}
    /// a^y for a > 0.
    template <std::same_as<ExactBall> B>
    friend ExactBall pow(const B& a, double y) {
        return exp(ExactBall(y) * log(a));
    }

    /// A ball over the real type S that contains this one.
    template <class S>
    Ball<S> enclosure() const {
        const S mid = mid_.to<S>();
        const Dyadic off = mid_ - Dyadic(mid);
        S rad(0);
        if (!off.is_zero() || rad_ != 0) {
            const S distance = off.to<S>();
            rad = equilibria::rounded_up<S>((distance < 0 ? S(-distance) : distance) + S(rad_));
        }
        require(rad < std::numeric_limits<S>::infinity(), "model", text(), "a coefficient is too large");
        return {Complex<S>(mid, S(0)), rad};
    }

private:
    static double rounded_up(double x) { return equilibria::rounded_up<double>(x); }
    double size() const { return rounded_up(std::abs(mid_.to<double>())); }
    /// Not above any member; at most 1e-14 below the least, as a share.
    double low() const {
        const double m = mid_.to<double>();
        return m - rad_ - 1e-14 * (std::abs(m) + rad_);
    }
    std::string text() const { return to_text(mid_.to<double>()) + (exact() ? "" : " +- " + to_text(rad_)); }

    template <std::same_as<ExactBall> B>
    friend ExactBall inverse(const B& a);
    template <class F>
    ExactBall through(F f, double slope) const;

    Dyadic mid_;
    double rad_ = 0;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/exact_ball_definitions.hpp>
#endif
