/// \file
/// Polynomials in variables that become known while they are read, multiplied out.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

namespace equilibria::detail::polynomial_text {

using Coefficient = std::complex<double>;

/// Exponents up to the last that is not 0: more variables may be still to come.
using Exponents = std::vector<int>;

/// A coefficient, and the sum of the absolute values of its summands, which tells it from the rounding error of
/// cancelled ones.
struct ExpandedCoefficient {
    Coefficient value;
    double summands;

    bool is_rounding() const { return std::abs(value) < 8 * std::numeric_limits<double>::epsilon() * summands; }
};

/// A polynomial expanded, the coefficient of each product of powers.
class Expansion {
    using Terms = std::map<Exponents, ExpandedCoefficient>;

public:
    Expansion() = default;
    explicit Expansion(Coefficient constant) { add({}, {constant, std::abs(constant)}); }
    static Expansion variable(std::size_t v) {
        Expansion y;
        Exponents e(v + 1);
        e[v] = 1;
        y.add(e, {1.0, 1.0});
        return y;
    }

    const Terms& terms() const { return terms_; }
    bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first.empty()); }
    Coefficient constant() const { return terms_.empty() ? 0.0 : terms_.begin()->second.value; }

    void add(const Expansion& other, double factor) {
        for (const auto& [exponents, c] : other.terms_)
            add(exponents, {factor * c.value, std::abs(factor) * c.summands});
    }
    /// Takes out what is rounding of a complete sum.
    void prune() {
        std::erase_if(terms_, [](const auto& term) { return term.second.is_rounding(); });
    }

    /// Whether the product or quotient that made it has a coefficient below the normal numbers, which would lose
    /// digits.
    bool underflows() const { return underflows_; }

    /// The largest absolute value of an exponent.
    int largest_exponent() const {
        int largest = 0;
        for (const auto& [exponents, c] : terms_)
            for (int k : exponents) largest = std::max(largest, std::abs(k));
        return largest;
    }

    Expansion times(const Expansion& other) const {
        Expansion y;
        for (const auto& [a, ca] : terms_)
            for (const auto& [b, cb] : other.terms_) {
                Exponents e = a;
                e.resize(std::max(a.size(), b.size()));
                for (std::size_t v = 0; v < b.size(); ++v) e[v] += b[v];
                while (!e.empty() && e.back() == 0) e.pop_back();
                const Coefficient c = ca.value * cb.value;
                y.underflows_ = y.underflows_ || std::abs(c) < std::numeric_limits<double>::min();
                y.add(e, {c, ca.summands * cb.summands});
            }
        return y;
    }

    void divide_by(Coefficient divisor) {
        for (auto& [exponents, c] : terms_) {
            c.value = divisor.imag() == 0 ? c.value / divisor.real() : c.value / divisor;
            c.summands /= std::abs(divisor);
            underflows_ = underflows_ || std::abs(c.value) < std::numeric_limits<double>::min();
        }
    }

    /// Of a single term.
    Expansion inverse() const {
        Expansion y;
        Exponents e = terms_.begin()->first;
        for (int& k : e) k = -k;
        y.add(e, {1.0, 1.0});
        y.divide_by(terms_.begin()->second.value);
        return y;
    }

private:
    void add(const Exponents& exponents, const ExpandedCoefficient& c) {
        if (c.value == 0.0) return;
        const auto [at, is_new] = terms_.try_emplace(exponents, c);
        if (is_new) return;
        at->second.value += c.value;
        at->second.summands += c.summands;
    }

    Terms terms_;
    bool underflows_ = false;
};

}  // namespace equilibria::detail::polynomial_text
