/// \file
/// Truncated power series whose order is known at run time, each coefficient with its derivatives along some
/// directions: one scalar for all derivatives that the theory of singularities asks for, so that a model's function is
/// compiled for it once. Sums and products take the coefficients that there are; the rest is the series of
/// core/taylor.hpp.
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/taylor.hpp>

namespace equilibria {

/// sum_k value(k) t^k for k = 0..order, with the derivatives slope(k, d) of the coefficients. Numbers of different
/// orders that meet are a constant (order 0) and a series.
template <class S>
class Jet {
public:
    static constexpr int highest = 7;                     ///< order
    static constexpr int directions = 4;                  ///< of the derivatives
    using Series = Taylor<Dual<S, directions>, highest>;  ///< the same, with every order and direction there

    Jet() : Jet(S(0.0)) {}
    /// A constant, of order 0.
    /// \{
    Jet(const S& constant) { value_[0] = constant; }
    template <class A>
    requires(std::is_arithmetic_v<A> && !std::is_same_v<A, S>)
    Jet(A constant) : Jet(static_cast<S>(detail::plain(constant))) {}
    /// \}
    /// value + slope t, to this order.
    static Jet variable(const S& value, const S& slope, int order) {
        Jet y(order, false);
        y.value_[0] = value;
        for (int k = 1; k <= order; ++k) y.value_[k] = S(0.0);
        if (order > 0) y.value_[1] = slope;
        return y;
    }
    /// Copies what there is up to the order.
    /// \{
    Jet(const Jet& a) { *this = a; }
    Jet& operator=(const Jet& a) {
        order_ = a.order_;
        moves_ = a.moves_;
        std::copy(a.value_, a.value_ + order_ + 1, value_);
        if (moves_) std::copy(&a.slope_[0][0], &a.slope_[0][0] + (order_ + 1) * directions, &slope_[0][0]);
        return *this;
    }

    /// \}
    int order() const { return order_; }  ///< highest power that is kept
    /// The coefficient k; 0 above the order.
    S value(int k) const { return k <= order_ ? value_[k] : S(0.0); }
    void set(int k, const S& value) { value_[k] = value; }  ///< the coefficient k <= order(), without its derivatives
    /// Its derivative along the direction d.
    S slope(int k, int d) const { return moves_ && k <= order_ ? slope_[k][d] : S(0.0); }
    /// The coefficient k with all its derivatives.
    Dual<S, directions> coefficient(int k) const {
        Dual<S, directions> y(value(k));
        for (int d = 0; d < directions; ++d) y.derivative[d] = slope(k, d);
        return y;
    }
    /// The same series, its coefficient k with these derivatives, and no others.
    Jet& move(int k, const Array<S, directions>& slope) {
        if (!moves_)
            for (int j = 0; j <= order_; ++j)
                for (S& s : slope_[j]) s = S(0.0);
        moves_ = true;
        std::copy(slope.begin(), slope.end(), slope_[k]);
        return *this;
    }

    /// Arithmetic, to the higher of the two orders.
    /// \{
    friend Jet operator+(const Jet& a) { return a; }
    friend Jet operator-(const Jet& a) { return a.scaled(-1.0); }
    friend Jet operator+(const Jet& a, const Jet& b) { return sum(a, b); }
    friend Jet operator-(const Jet& a, const Jet& b) { return difference(a, b); }
    friend Jet operator*(const Jet& a, const Jet& b) { return product(a, b); }
    friend Jet operator/(const Jet& a, const Jet& b) { return quotient(a, b); }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Jet operator*(A a, const Jet& b) {
        return b.scaled(detail::plain(a));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Jet operator*(const Jet& b, A a) {
        return b.scaled(detail::plain(a));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Jet operator/(const Jet& b, A a) {
        return quotient(b, Jet(a));
    }
    Jet& operator+=(const Jet& b) { return *this = *this + b; }
    Jet& operator-=(const Jet& b) { return *this = *this - b; }
    Jet& operator*=(const Jet& b) { return *this = *this * b; }
    Jet& operator/=(const Jet& b) { return *this = *this / b; }
    /// \}

    /// Elementary functions, to the same order; log, sqrt and powers that are no integers need value(0) != 0.
    /// \{
    friend Jet sin(const Jet& a) { return a.of(Function::sine); }
    friend Jet cos(const Jet& a) { return a.of(Function::cosine); }
    friend Jet exp(const Jet& a) { return a.of(Function::exponential); }
    friend Jet log(const Jet& a) { return a.of(Function::logarithm); }
    friend Jet sqrt(const Jet& a) { return a.of(Function::square_root); }
    template <std::integral I>
    friend Jet pow(const Jet& a, I power) {
        return a.to_the(static_cast<int>(power));
    }
    template <std::floating_point F>
    friend Jet pow(const Jet& a, F power) {
        return a.to_the(static_cast<double>(power));
    }
    /// \}

private:
    enum class Function { sine, cosine, exponential, logarithm, square_root };

    /// Coefficients are not set.
    Jet(int order, bool moves) : order_(order), moves_(moves) {}
    Jet(const Series& series, int order, bool moves);

    static Jet sum(const Jet& a, const Jet& b);
    static Jet difference(const Jet& a, const Jet& b);
    static Jet product(const Jet& a, const Jet& b);
    static Jet quotient(const Jet& a, const Jet& b);
    Jet scaled(double by) const;
    Jet of(Function function) const;
    Jet to_the(int power) const;
    Jet to_the(double power) const;
    template <class Operation>
    static Jet entry_by_entry(const Jet& a, const Jet& b, const Operation& operation);
    Series series() const;

    int order_ = 0;
    bool moves_ = false;
    S value_[highest + 1];
    S slope_[highest + 1][directions];
};

}  // namespace equilibria

#include <equilibria/core/detail/jet_definitions.hpp>
#ifdef EQUILIBRIA_COMPILED
extern template class equilibria::Jet<double>;
#endif
