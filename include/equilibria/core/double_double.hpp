/// \file
/// Floating-point numbers of twice a double's digits: unevaluated sums of two doubles, 106 bits, some 31 decimal
/// digits, with the range of doubles. Ten times as fast as binary floats of as many digits in software.
///
/// Sources: T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18
/// (1971) 224-242; Y. Hida, X. S. Li, D. H. Bailey, "Algorithms for quad-double precision floating point arithmetic",
/// 15th IEEE Symposium on Computer Arithmetic (2001) 155-162; bounds of the errors: M. Joldes, J.-M. Muller, V.
/// Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM Transactions on
/// Mathematical Software 44 (2017) 15res.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "equilibria: sums of two doubles need IEEE arithmetic: compile without -ffast-math, -Ofast and their parts"
#endif

namespace equilibria {

/// high + low, |low| at most half a unit in the last place of high. Relative errors: sums and differences 3 u^2,
/// products 5 u^2, quotients and roots 10 u^2, u = 2^-53, where nothing overflows or underflows. Infinities become
/// NaNs.
class DoubleDouble {
public:
    DoubleDouble() = default;
    /// Any double, float, or integer of at most 53 bits.
    template <class A>
    requires std::is_arithmetic_v<A>
    constexpr DoubleDouble(A value) : high_(static_cast<double>(value)) {}
    /// Of two doubles whose sum rounds to the first.
    constexpr DoubleDouble(double high, double low) : high_(high), low_(low) {}

    constexpr double high() const { return high_; }  ///< the sum rounded to a double
    constexpr double low() const { return low_; }    ///< what the rounding to high() leaves
    /// Rounded to nearest.
    template <class A>
    requires std::is_arithmetic_v<A>
    constexpr explicit operator A() const {
        return static_cast<A>(high_);
    }

    using Self = DoubleDouble;  ///< short for the operators below
    /// Arithmetic, with the errors given above.
    /// \{
    friend Self operator+(const Self& a, const Self& b) {
        const Self s = sum(a.high_, b.high_), t = sum(a.low_, b.low_);
        const Self v = ordered_sum(s.high_, s.low_ + t.high_);
        return ordered_sum(v.high_, t.low_ + v.low_);
    }
    friend Self operator-(const Self& a) { return {-a.high_, -a.low_}; }
    friend Self operator-(const Self& a, const Self& b) { return a + -b; }
    friend Self operator*(const Self& a, const Self& b) {
        const Self p = product(a.high_, b.high_);
        return ordered_sum(p.high_, p.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
    }
    friend Self operator/(const Self& a, const Self& b) {
        const double first = a.high_ / b.high_;
        const Self rest = a - b * Self(first);
        const double second = rest.high_ / b.high_;
        const double third = (rest - b * Self(second)).high_ / b.high_;
        return ordered_sum(first, second) + Self(third);
    }
    Self& operator+=(const Self& b) { return *this = *this + b; }
    Self& operator-=(const Self& b) { return *this = *this - b; }
    Self& operator*=(const Self& b) { return *this = *this * b; }
    Self& operator/=(const Self& b) { return *this = *this / b; }
    /// \}

    /// Order of the values; all false of a NaN.
    /// \{
    friend bool operator<(const Self& a, const Self& b) {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    friend bool operator==(const Self& a, const Self& b) { return a.high_ == b.high_ && a.low_ == b.low_; }
    friend bool operator>(const Self& a, const Self& b) { return b < a; }
    friend bool operator<=(const Self& a, const Self& b) { return a < b || a == b; }
    friend bool operator>=(const Self& a, const Self& b) { return b <= a; }
    /// \}

    friend Self abs(const Self& a) { return a.high_ < 0 ? -a : a; }  ///< |a|, exactly
    /// Of a number that is not positive what std::sqrt gives: 0, or a NaN.
    friend Self sqrt(const Self& a) {
        if (!(a.high_ > 0)) return std::sqrt(a.high_);
        const double root = std::sqrt(a.high_);
        return ordered_sum(root, (a - product(root, root)).high_ / (2 * root));
    }
    /// Whether neither part is infinite or a NaN.
    friend bool isfinite(const Self& a) { return std::isfinite(a.high_) && std::isfinite(a.low_); }

private:
    /// a + b, exactly.
    static Self sum(double a, double b) {
        const double s = a + b, of_b = s - a;
        return {s, (a - (s - of_b)) + (b - of_b)};
    }
    /// The same where |a| >= |b|, or a = 0.
    static Self ordered_sum(double a, double b) {
        const double s = a + b;
        return {s, b - (s - a)};
    }
    /// a b, exactly.
    static Self product(double a, double b) {
        const double p = a * b;
#ifdef __FMA__
        return {p, std::fma(a, b, -p)};
#else
        const Self x = halves(a), y = halves(b);
        return {p, ((x.high_ * y.high_ - p) + x.high_ * y.low_ + x.low_ * y.high_) + x.low_ * y.low_};
#endif
    }
    /// Two numbers of 26 bits whose sum is a (Dekker). Products of them are exact.
    static Self halves(double a) {
        const double shifted = 134217729.0 * a;  // 2^27 + 1
        const double high = shifted - (shifted - a);
        return {high, a - high};
    }

    double high_ = 0, low_ = 0;
};

}  // namespace equilibria

/// \cond
/// As of a floating-point type; epsilon is a bound of the relative error of any of the operations above.
template <>
class std::numeric_limits<equilibria::DoubleDouble> : public std::numeric_limits<double> {
    using Self = equilibria::DoubleDouble;
    using Base = std::numeric_limits<double>;

public:
    static constexpr int digits = 103, digits10 = 31, max_digits10 = 33;
    static constexpr bool is_iec559 = false;
    static constexpr Self epsilon() { return 0x1p-102; }
    /// Below, the low part is no longer exact.
    static constexpr Self min() { return 0x1p-916; }
    static constexpr Self max() { return Base::max(); }
    static constexpr Self lowest() { return Base::lowest(); }
    static constexpr Self infinity() { return Base::infinity(); }
    static constexpr Self quiet_NaN() { return Base::quiet_NaN(); }
};
/// \endcond
