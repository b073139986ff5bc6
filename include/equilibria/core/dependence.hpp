/// \file
/// A number that is nothing but what it depends on: the set of the independent variables that went into it. A function
/// that is generic over the scalar, run once with it, tells which entries its Jacobian can have, whatever the values.
///
/// It knows the operations of Dual (core/dual.hpp). What depends on a variable in form alone counts as well, such as
/// x - x and 0 * x: the pattern is one of all values, and never lacks an entry. Source: Griewank and Walther,
/// Evaluating Derivatives, 2nd ed., section 7.1, propagation of index domains.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace equilibria {

/// The set of independent variables that went into a number; it is computed with as a number is.
class Dependence {
public:
    /// A constant.
    Dependence() = default;
    /// Any number: a constant.
    template <class A>
    requires std::is_arithmetic_v<A>
    Dependence(A) {}

    /// The independent variable number k.
    static Dependence variable(int k) {
        Dependence x;
        x.on_.push_back(k);
        return x;
    }

    /// The numbers of the variables, in ascending order.
    const std::vector<int>& on() const { return on_; }

    /// The union of the operands' sets, whatever the operation.
    /// \{
    Dependence& operator+=(const Dependence& b) {
        if (std::includes(on_.begin(), on_.end(), b.on_.begin(), b.on_.end())) return *this;
        std::vector<int> both(on_.size() + b.on_.size());
        both.erase(std::set_union(on_.begin(), on_.end(), b.on_.begin(), b.on_.end(), both.begin()), both.end());
        on_ = std::move(both);
        return *this;
    }
    Dependence& operator-=(const Dependence& b) { return *this += b; }
    Dependence& operator*=(const Dependence& b) { return *this += b; }
    Dependence& operator/=(const Dependence& b) { return *this += b; }

    friend Dependence operator-(Dependence a) { return a; }
    friend Dependence operator+(Dependence a, const Dependence& b) { return std::move(a += b); }
    friend Dependence operator-(Dependence a, const Dependence& b) { return std::move(a += b); }
    friend Dependence operator*(Dependence a, const Dependence& b) { return std::move(a += b); }
    friend Dependence operator/(Dependence a, const Dependence& b) { return std::move(a += b); }

    friend Dependence sin(Dependence a) { return a; }
    friend Dependence cos(Dependence a) { return a; }
    friend Dependence exp(Dependence a) { return a; }
    friend Dependence log(Dependence a) { return a; }
    friend Dependence sqrt(Dependence a) { return a; }
    friend Dependence atan2(Dependence y, const Dependence& x) { return std::move(y += x); }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Dependence pow(Dependence a, A) {
        return a;
    }
    /// \}

private:
    std::vector<int> on_;
};

}  // namespace equilibria
