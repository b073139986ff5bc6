/// \file
/// Trigonometric polynomials in some angles, polynomial in some plain coordinates. A model's own function, called with
/// them for scalars, returns its algebra: in a constant expression the support, at run time the coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/algebra/monomial.hpp>
#include <equilibria/core/constant_math.hpp>

namespace equilibria {

/// Why an expression is not a trigonometric polynomial. It travels with the value, to become one sentence in the end.
enum class NotPolynomial {
    no,                    ///< it is one
    function_of_angle,     ///< sqrt, exp, ... or sin of something that depends on the angles or coordinates
    divisor_not_constant,  ///< a quotient whose divisor depends on the angles or coordinates
    degree_too_high        ///< a multiple of an angle or a power of a coordinate that Monomial cannot hold
};

/// Numbers whose sums, where they cancel, are exactly 0: nothing is taken for a rounding error.
template <class C>
inline constexpr bool exact_cancellation = false;

namespace detail {
template <class C>
struct RealPart {
    using type = C;
};
template <class R>
struct RealPart<std::complex<R>> {
    using type = R;
};
}  // namespace detail

/// A sum of terms, sorted by monomial, each monomial once. Sums that cancel to rounding are dropped.
template <int Angles, int Coordinates, class C = double>
class TrigonometricPolynomial {
public:
    using Coefficient = C;                        ///< type of the coefficients: real or complex, exact or not
    using Basis = Monomial<Angles, Coordinates>;  ///< products of cosines, sines and powers
    /// coefficient * monomial.
    struct Term {
        Basis monomial;  ///< product of factors, one an unknown
        C coefficient;   ///< not 0, unless it was given so
    };

    constexpr TrigonometricPolynomial() = default;
    /// A constant; 0 has no terms.
    template <class A>
    requires(std::is_arithmetic_v<A> || std::is_same_v<A, C>)
    constexpr TrigonometricPolynomial(const A& constant) {
        if (C value = static_cast<C>(constant); value != C(0)) terms_.push_back({{}, value});
    }
    /// A single term.
    constexpr TrigonometricPolynomial(const Basis& monomial, const C& coefficient) : terms_{{monomial, coefficient}} {}

    constexpr const std::vector<Term>& terms() const { return terms_; }  ///< by ascending monomial
    constexpr NotPolynomial fault() const { return fault_; }             ///< the gravest fault of all that went into it

    /// Whether it has no term but the constant one.
    constexpr bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_[0].monomial.is_one()); }
    /// The constant term; 0 where there is none.
    constexpr C constant() const {
        return !terms_.empty() && terms_[0].monomial.is_one() ? terms_[0].coefficient : C(0);
    }

    /// The largest absolute value of a coefficient.
    constexpr double scale() const {
        double s = 0;
        for (const Term& t : terms_) s = std::max(s, magnitude(t.coefficient));
        return s;
    }
    /// Without the terms that are rounding errors of cancelled ones.
    constexpr TrigonometricPolynomial pruned() const {
        TrigonometricPolynomial y;
        y.fault_ = fault_;
        const double smallest = 1e-13 * scale();
        for (const Term& t : terms_)
            if (!(magnitude(t.coefficient) < smallest)) y.terms_.push_back(t);  // a NaN stays, to be seen
        return y;
    }

    /// Arithmetic; a divisor that is not constant gives what is faulty. Faults of operands travel along.
    /// \{
    friend constexpr TrigonometricPolynomial operator-(TrigonometricPolynomial a) {
        for (Term& t : a.terms_) t.coefficient = -t.coefficient;
        return a;
    }
    friend constexpr TrigonometricPolynomial operator+(const TrigonometricPolynomial& a,
                                                       const TrigonometricPolynomial& b) {
        return merged(a, b, C(1));
    }
    friend constexpr TrigonometricPolynomial operator-(const TrigonometricPolynomial& a,
                                                       const TrigonometricPolynomial& b) {
        return merged(a, b, C(-1));
    }
    friend constexpr TrigonometricPolynomial operator*(TrigonometricPolynomial a, const C& b) {
        a.scale_by(b);
        return a;
    }
    friend constexpr TrigonometricPolynomial operator*(const C& a, TrigonometricPolynomial b) {
        b.scale_by(a);
        return b;
    }
    friend constexpr TrigonometricPolynomial operator*(const TrigonometricPolynomial& a,
                                                       const TrigonometricPolynomial& b) {
        TrigonometricPolynomial y;
        if (a.is_constant() || b.is_constant()) {
            y = a.is_constant() ? b : a;
            y.scale_by(a.is_constant() ? a.constant() : b.constant());
            y.fault_ = std::max(a.fault_, b.fault_);
            return y;
        }
        y.fault_ = std::max(a.fault_, b.fault_);
        y.terms_.reserve(a.terms_.size() * b.terms_.size());
        for (const Term& s : a.terms_)
            for (const Term& t : b.terms_) {
                if (overlap(s.monomial, t.monomial))
                    y.append_product(s.monomial, t.monomial, s.coefficient * t.coefficient);
                else
                    y.terms_.push_back({join(s.monomial, t.monomial), s.coefficient * t.coefficient});
            }
        y.combine();
        return y;
    }
    friend constexpr TrigonometricPolynomial operator/(const TrigonometricPolynomial& a,
                                                       const TrigonometricPolynomial& b) {
        if (!b.is_constant()) return faulty(NotPolynomial::divisor_not_constant);
        TrigonometricPolynomial y = a;
        y.fault_ = std::max(a.fault_, b.fault_);
        for (Term& t : y.terms_) t.coefficient = t.coefficient / b.constant();
        return y;
    }
    constexpr TrigonometricPolynomial& operator+=(const TrigonometricPolynomial& b) { return *this = *this + b; }
    constexpr TrigonometricPolynomial& operator-=(const TrigonometricPolynomial& b) { return *this = *this - b; }
    constexpr TrigonometricPolynomial& operator*=(const TrigonometricPolynomial& b) { return *this = *this * b; }
    constexpr TrigonometricPolynomial& operator/=(const TrigonometricPolynomial& b) { return *this = *this / b; }
    /// \}

    /// Integer powers; negative ones of constants only.
    template <std::integral I>
    friend constexpr TrigonometricPolynomial pow(const TrigonometricPolynomial& a, I power) {
        const int k = static_cast<int>(power);
        if (k < 0) return TrigonometricPolynomial(1) / pow(a, -k);
        TrigonometricPolynomial y(1);
        for (int j = 0; j < k; ++j) y *= a;
        return y;
    }
    /// Other powers, of constants only.
    template <std::floating_point F>
    friend constexpr TrigonometricPolynomial pow(const TrigonometricPolynomial& a, F power) {
        const double y = static_cast<double>(power);
        if (y > -1000 && y < 1000 && y == static_cast<int>(y)) return pow(a, static_cast<int>(y));
        return a.of_constant([y](const C& x) { return C(constant_math::pow(x, y)); });
    }
    /// Of constants only; of anything else the result is faulty.
    /// \{
    friend constexpr TrigonometricPolynomial sqrt(const TrigonometricPolynomial& a) {
        return a.of_constant([](const C& x) { return C(constant_math::sqrt(x)); });
    }
    friend constexpr TrigonometricPolynomial exp(const TrigonometricPolynomial& a) {
        return a.of_constant([](const C& x) { return C(constant_math::exp(x)); });
    }
    friend constexpr TrigonometricPolynomial log(const TrigonometricPolynomial& a) {
        return a.of_constant([](const C& x) { return C(constant_math::log(x)); });
    }
    friend constexpr TrigonometricPolynomial sin(const TrigonometricPolynomial& a) {
        return a.of_constant([](const C& x) { return C(constant_math::sin(x)); });
    }
    friend constexpr TrigonometricPolynomial cos(const TrigonometricPolynomial& a) {
        return a.of_constant([](const C& x) { return C(constant_math::cos(x)); });
    }
    /// \}

    /// The partial derivative by one unknown.
    friend constexpr TrigonometricPolynomial derivative(const TrigonometricPolynomial& a, int unknown) {
        TrigonometricPolynomial y;
        y.fault_ = a.fault_;
        y.terms_.reserve(a.terms_.size());
        for (const Term& t : a.terms_) {
            const int k = t.monomial.code(unknown);
            if (k == 0) continue;
            Basis m = t.monomial;
            m.set_code(unknown, Basis::is_angle(unknown) ? -k : k - 1);
            // (cos k theta)' = -k sin k theta, (sin k theta)' = k cos k theta: with the code, -code in both cases
            y.terms_.push_back({m, t.coefficient * static_cast<double>(Basis::is_angle(unknown) ? -k : k)});
        }
        y.combine();
        return y;
    }

    /// What stands for an expression that is no polynomial: without terms, and with this fault.
    static constexpr TrigonometricPolynomial faulty(NotPolynomial why) {
        TrigonometricPolynomial y;
        y.fault_ = why;
        return y;
    }

private:
    /// Whether a sum is but the rounding error of cancelled summands. Neither NaN nor infinity is.
    static constexpr bool negligible(const C& sum, double summands) {
        if constexpr (exact_cancellation<C>) {
            return sum == C(0);
        } else {
            using Real = typename detail::RealPart<C>::type;
            return sum == C(0) ||
                   magnitude(sum) < 2 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * summands;
        }
    }

    static constexpr double magnitude(const C& c) {
        if constexpr (exact_cancellation<C>)
            return 0;
        else if constexpr (std::is_floating_point_v<C>)
            return c < 0 ? static_cast<double>(-c) : static_cast<double>(c);
        else {
            using std::abs;
            return static_cast<double>(abs(c));
        }
    }

    constexpr void scale_by(const C& factor) {
        if (factor == C(0)) terms_.clear();
        for (Term& t : terms_) t.coefficient = t.coefficient * factor;
    }

    template <class F>
    constexpr TrigonometricPolynomial of_constant(F function) const {
        if (!is_constant()) return faulty(NotPolynomial::function_of_angle);
        TrigonometricPolynomial y(function(constant()));
        y.fault_ = fault_;
        return y;
    }

    static constexpr TrigonometricPolynomial merged(const TrigonometricPolynomial& a, const TrigonometricPolynomial& b,
                                                    const C& sign) {
        TrigonometricPolynomial y;
        y.fault_ = std::max(a.fault_, b.fault_);
        y.terms_.reserve(a.terms_.size() + b.terms_.size());
        auto i = a.terms_.begin();
        auto j = b.terms_.begin();
        while (i != a.terms_.end() || j != b.terms_.end()) {
            if (j == b.terms_.end() || (i != a.terms_.end() && i->monomial < j->monomial))
                y.terms_.push_back(*i++);
            else if (i == a.terms_.end() || j->monomial < i->monomial)
                y.terms_.push_back({j->monomial, sign * j->coefficient}), ++j;
            else {
                const C sum = i->coefficient + sign * j->coefficient;
                if (!negligible(sum, magnitude(i->coefficient))) y.terms_.push_back({i->monomial, sum});
                ++i, ++j;
            }
        }
        return y;
    }

    /// Appends the product of overlapping monomials: powers add, and cos, sin by the product-to-sum formulas.
    constexpr void append_product(const Basis& a, const Basis& b, const C& coefficient) {
        const std::size_t first = terms_.size();  // of the products
        terms_.push_back({join(a, b), coefficient});
        for (int u = next_overlap(a, b, 0); u < Basis::unknowns; u = next_overlap(a, b, u + 1)) {
            const int p = a.code(u), q = b.code(u);
            if (a.degree(u) + b.degree(u) > Basis::highest) fault_ = std::max(fault_, NotPolynomial::degree_too_high);
            if (!Basis::is_angle(u)) {
                for (std::size_t i = first; i < terms_.size(); ++i) terms_[i].monomial.set_code(u, p + q);
                continue;
            }
            const int k = p < 0 ? -p : p, l = q < 0 ? -q : q;
            const bool odd = (p < 0) != (q < 0);  // sin times cos: sines come out, else cosines
            // harmonics k + l and |k - l|
            const double sum_sign = p < 0 && q < 0 ? -0.5 : 0.5;
            double difference_sign = 0.5;
            if (odd) difference_sign = (p < 0) == (k > l) ? 0.5 : -0.5;
            const int difference = k > l ? k - l : l - k;
            const std::size_t last = terms_.size();
            for (std::size_t i = first; i < last; ++i) {
                if (!(odd && difference == 0)) {
                    Term t = terms_[i];
                    t.coefficient = t.coefficient * difference_sign;
                    t.monomial.set_code(u, odd ? -difference : difference);
                    terms_.push_back(t);
                }
                terms_[i].coefficient = terms_[i].coefficient * sum_sign;
                terms_[i].monomial.set_code(u, odd ? -(k + l) : k + l);
            }
        }
    }

    /// Sorts and adds up equal monomials; sums that cancel to rounding are dropped.
    constexpr void combine() {
        std::sort(terms_.begin(), terms_.end(), [](const Term& s, const Term& t) { return s.monomial < t.monomial; });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < terms_.size();) {
            C sum = terms_[i].coefficient;
            double size = magnitude(sum);
            std::size_t j = i + 1;
            for (; j < terms_.size() && terms_[j].monomial == terms_[i].monomial; ++j) {
                sum = sum + terms_[j].coefficient;
                size += magnitude(terms_[j].coefficient);
            }
            if (!negligible(sum, size)) terms_[kept++] = {terms_[i].monomial, sum};
            i = j;
        }
        terms_.resize(kept);
    }

    std::vector<Term> terms_;
    NotPolynomial fault_ = NotPolynomial::no;
};

}  // namespace equilibria
