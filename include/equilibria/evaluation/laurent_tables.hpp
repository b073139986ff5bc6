/// \file
/// The terms c z^a of a square Laurent system in z = exp(i theta), as tables that are gone through by loops.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace equilibria {

/// As many equations as angles; terms by equation. Exponents that several terms have are one monomial.
class LaurentTables {
public:
    /// z_u^power; power is not 0.
    struct Factor {
        int unknown;  ///< number of the unknown
        int power;    ///< exponent, of either sign
    };
    /// coefficient * monomial.
    struct Term {
        int monomial;                      ///< its number
        std::complex<double> coefficient;  ///< complex factor
    };

    /// Without equations yet.
    explicit LaurentTables(int unknowns) : first_term{0}, lowest(at(unknowns)), highest(at(unknowns)) {}

    /// The next equation: the exponents and the coefficient of each of its terms.
    void add(std::span<const std::vector<int>> exponents, std::span<const std::complex<double>> coefficients) {
        for (std::size_t k = 0; k < exponents.size(); ++k) terms.push_back({monomial(exponents[k]), coefficients[k]});
        first_term.push_back(static_cast<int>(terms.size()));
    }

    int unknowns() const { return static_cast<int>(lowest.size()); }  ///< number of unknowns, all angles
    /// Number of different monomials of all equations.
    int monomials() const { return static_cast<int>(first_factor_.size()) - 1; }
    /// Of a monomial.
    std::span<const Factor> factors_of(int monomial) const {
        return {factors_.data() + first_factor_[at(monomial)], factors_.data() + first_factor_[at(monomial + 1)]};
    }

    std::vector<Term> terms;      ///< of all equations, one after the other
    std::vector<int> first_term;  ///< of each equation, and one past the last
    std::vector<int> lowest;      ///< lowest power of each unknown, at most 0
    std::vector<int> highest;     ///< highest one, at least 0

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    int monomial(const std::vector<int>& exponents) {
        const auto [place, fresh] = known_.try_emplace(exponents, monomials());
        if (fresh) {
            for (int u = 0; u < unknowns(); ++u) {
                const int power = exponents[at(u)];
                if (power == 0) continue;
                factors_.push_back({u, power});
                lowest[at(u)] = std::min(lowest[at(u)], power);
                highest[at(u)] = std::max(highest[at(u)], power);
            }
            first_factor_.push_back(factors_.size());
        }
        return place->second;
    }

    std::vector<Factor> factors_;
    std::vector<std::size_t> first_factor_{0};
    std::map<std::vector<int>, int> known_;
};

}  // namespace equilibria
