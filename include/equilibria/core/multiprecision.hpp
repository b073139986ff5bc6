/// \file
/// Multiprecision floats for the scalars of the library: Boost's binary floats behind functions that are not inlined.
/// Generic code does hundreds of operations on its scalars; inlined, a proof takes minutes to compile, and a call costs
/// nothing beside a product of many digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <concepts>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>

#include <equilibria/core/big_integer.hpp>

namespace equilibria {

/// Binary floating point with at least this many decimal digits, rounded to nearest.
template <int Digits>
class Multiprecision {
public:
    /// Boost's number behind it, without expression templates.
    using Value =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

    Multiprecision() = default;
    /// Any number of the machine's, exactly where the digits suffice.
    template <class A>
    requires std::is_arithmetic_v<A>
    [[gnu::noinline]] Multiprecision(A value) : value_(value) {}
    /// Of other digits, rounded where these are fewer.
    template <int Other>
    requires(Other != Digits)
    [[gnu::noinline]] explicit Multiprecision(const Multiprecision<Other>& a) : value_(a.value()) {}
    explicit Multiprecision(const Value& value) : value_(value) {}  ///< of Boost's number
    /// From decimal digits; throws std::runtime_error for text that is no number.
    explicit Multiprecision(const std::string& text) : value_(text) {}

    const Value& value() const { return value_; }  ///< Boost's number
    /// To a number of the machine's, rounded; to an integer, towards 0.
    template <class A>
    requires std::is_arithmetic_v<A>
    [[gnu::noinline]] explicit operator A() const {
        return static_cast<A>(value_);
    }
    /// Towards 0.
    [[gnu::noinline]] explicit operator boost::multiprecision::cpp_int() const {
        return static_cast<boost::multiprecision::cpp_int>(value_);
    }
    /// An integer, rounded where it has more digits.
    explicit Multiprecision(const boost::multiprecision::cpp_int& a) : value_(a) {}

    using Self = Multiprecision;  ///< short for the operators below
    /// Arithmetic, each operation within a unit in the last place.
    /// \{
    [[gnu::noinline]] friend Self operator+(const Self& a, const Self& b) { return Self(Value(a.value_ + b.value_)); }
    [[gnu::noinline]] friend Self operator-(const Self& a, const Self& b) { return Self(Value(a.value_ - b.value_)); }
    [[gnu::noinline]] friend Self operator*(const Self& a, const Self& b) { return Self(Value(a.value_ * b.value_)); }
    [[gnu::noinline]] friend Self operator/(const Self& a, const Self& b) { return Self(Value(a.value_ / b.value_)); }
    [[gnu::noinline]] friend Self operator-(const Self& a) { return Self(Value(-a.value_)); }
    friend Self operator+(const Self& a) { return a; }
    Self& operator+=(const Self& b) { return *this = *this + b; }
    Self& operator-=(const Self& b) { return *this = *this - b; }
    Self& operator*=(const Self& b) { return *this = *this * b; }
    Self& operator/=(const Self& b) { return *this = *this / b; }
    /// \}

    /// Order of the values; all false of a NaN.
    /// \{
    [[gnu::noinline]] friend bool operator<(const Self& a, const Self& b) { return a.value_ < b.value_; }
    [[gnu::noinline]] friend bool operator==(const Self& a, const Self& b) { return a.value_ == b.value_; }
    friend bool operator>(const Self& a, const Self& b) { return b < a; }
    [[gnu::noinline]] friend bool operator<=(const Self& a, const Self& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const Self& a, const Self& b) { return b <= a; }
    /// \}

    /// As of a double, to all digits; hypot by the bare sum of squares, whose exponent has room.
    /// \{
    [[gnu::noinline]] friend Self abs(const Self& a) { return Self(Value(abs(a.value_))); }
    [[gnu::noinline]] friend Self sqrt(const Self& a) { return Self(Value(sqrt(a.value_))); }
    [[gnu::noinline]] friend Self hypot(const Self& a, const Self& b) {
        return Self(Value(sqrt(Value(a.value_ * a.value_ + b.value_ * b.value_))));
    }
    [[gnu::noinline]] friend Self frexp(const Self& a, int* e) { return Self(Value(frexp(a.value_, e))); }
    [[gnu::noinline]] friend Self ldexp(const Self& a, int e) { return Self(Value(ldexp(a.value_, e))); }
    [[gnu::noinline]] friend bool isfinite(const Self& a) { return (boost::multiprecision::isfinite)(a.value_); }
    /// \}
    // Templates, so that a program pays only for those that it calls.

    /// Boost's, of angles in radians, to all digits but for a few units in the last place.
    /// \{
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self sin(const B& a) {
        return Self(Value(sin(a.value_)));
    }
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self cos(const B& a) {
        return Self(Value(cos(a.value_)));
    }
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self exp(const B& a) {
        return Self(Value(exp(a.value_)));
    }
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self log(const B& a) {
        return Self(Value(log(a.value_)));
    }
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self atan(const B& a) {
        return Self(Value(atan(a.value_)));
    }
    template <std::same_as<Self> B>
    [[gnu::noinline]] friend Self atan2(const B& y, const B& x) {
        return Self(Value(atan2(y.value_, x.value_)));
    }
    /// \}

    /// `digits` significant decimal digits (0: all there are).
    std::string text(int digits = 0, std::ios_base::fmtflags flags = {}) const { return value_.str(digits, flags); }
    /// With the stream's precision and format.
    friend std::ostream& operator<<(std::ostream& out, const Self& a) { return out << a.value_; }

private:
    Value value_;
};

template <class A>
BigInteger::BigInteger(const A& value) {
    ::new (storage_) boost::multiprecision::cpp_int(static_cast<boost::multiprecision::cpp_int>(value));
}
template <class S>
S BigInteger::to() const {
    return static_cast<S>(as<boost::multiprecision::cpp_int>());
}

}  // namespace equilibria

/// \cond
template <int Digits>
class std::numeric_limits<equilibria::Multiprecision<Digits>>
    : public std::numeric_limits<typename equilibria::Multiprecision<Digits>::Value> {
    using Base = std::numeric_limits<typename equilibria::Multiprecision<Digits>::Value>;
    using Self = equilibria::Multiprecision<Digits>;

public:
    static Self epsilon() { return Self(Base::epsilon()); }
    static Self min() { return Self((Base::min)()); }
    static Self max() { return Self((Base::max)()); }
    static Self lowest() { return Self(Base::lowest()); }
    static Self infinity() { return Self(Base::infinity()); }
    static Self quiet_NaN() { return Self(Base::quiet_NaN()); }
};
/// \endcond
