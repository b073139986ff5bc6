/// \file
/// A square system of trigonometric polynomials as data: made at run time from a model, from other systems, or from
/// terms. Nothing of it is in its type, so that all systems share one tracker.
#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/monomial.hpp>
#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/system/sparse_term.hpp>

namespace equilibria {

/// As many equations as unknowns. Terms are sorted by equation, then by the code of the equation's own unknown.
class SparseSystem {
public:
    using Term = SparseTerm;  ///< product of factors with its coefficient

    /// From terms, in any order, each product of factors once in an equation. Throws InvalidArgument where a term's
    /// equation or number of codes is none of the system's, where an equation has no terms, or a coefficient is not
    /// finite.
    SparseSystem(const RuntimeSizes& sizes, std::vector<Term> terms);
    /// From n polynomials in n unknowns. Throws InvalidArgument where there are not n of them, where one is 0, or a
    /// coefficient is not finite.
    template <int Angles, int Coordinates>
    explicit SparseSystem(const std::vector<TrigonometricPolynomial<Angles, Coordinates>>& equations)
        : SparseSystem(RuntimeSizes(Angles, Coordinates), terms_of(equations)) {}

    const RuntimeSizes& sizes() const { return sizes_; }          ///< numbers of angles and coordinates
    const std::vector<Term>& terms() const { return terms_; }     ///< of all equations, sorted
    const std::vector<double>& scale() const { return scale_; }   ///< the largest coefficient of each equation
    const std::vector<int>& degrees() const { return degrees_; }  ///< total degree of each in (cos, sin), coordinates

    /// With a constant added to each equation.
    SparseSystem with_constants(std::span<const double> constants) const;

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    template <int Angles, int Coordinates>
    static std::vector<Term> terms_of(const std::vector<TrigonometricPolynomial<Angles, Coordinates>>& equations) {
        constexpr int n = Angles + Coordinates;
        require(static_cast<int>(equations.size()) == n, "equations", equations.size(),
                "must be as many as there are unknowns");
        std::vector<Term> terms;
        for (int i = 0; i < n; ++i)
            for (const auto& t : equations[at(i)].terms())
                terms.push_back({i, sparse_monomial(t.monomial), t.coefficient});
        return terms;
    }

    RuntimeSizes sizes_;
    std::vector<Term> terms_;
    std::vector<double> scale_;
    std::vector<int> degrees_;
};

/// A model's equations at the parameters p. Terms that the model lacks there, though it has them at other parameters,
/// are left out. Throws InvalidArgument as `coefficients` does.
template <Model M>
SparseSystem sparse_system(const Parameters<M>& p) {
    const auto own = coefficients<M, double>(p);
    std::vector<SparseTerm> terms;
    for (int k = 0; k < Formulation<M>::terms; ++k)
        if (const auto& term = Formulation<M>::support[k]; own[k] != 0)
            terms.push_back({term.equation, sparse_monomial(term.monomial), own[k]});
    return {RuntimeSizes(n_angles<M>, n_coordinates<M>), std::move(terms)};
}

/// Polynomials in plain coordinates, the variables of `system` in their order, for systems that come from a file or
/// from terms. Errors count equations from 1. Throws InvalidArgument unless there are as many equations as variables,
/// with real, finite coefficients and, in each term, an exponent of each variable from 0 to Monomial's highest.
template <class C>
requires std::same_as<C, double> || std::same_as<C, std::complex<double>>
SparseSystem sparse_system(const PolynomialSystem<C>& system) {
    const std::size_t n = system.variables.size();
    const auto number = std::to_string(n);
    require(n > 0, "variables", n, "must not be none");
    require(system.equations.size() == n, "equations", system.equations.size(), "must be " + number);
    std::vector<SparseTerm> terms;
    for (std::size_t i = 0; i < n; ++i) {
        std::map<SparseMonomial, double> sums;  // a file may have a product of factors twice
        for (const auto& t : system.equations[i]) {
            const std::string in = " in equation " + std::to_string(i + 1);
            require(t.exponents.size() == n, "exponents" + in, t.exponents.size(), "must be " + number);
            double coefficient{};
            if constexpr (std::same_as<C, double>) {
                coefficient = t.coefficient;
            } else {
                require(t.coefficient.imag() == 0, "coefficient" + in, t.coefficient, "must be real");
                coefficient = t.coefficient.real();
            }
            constexpr int highest = Monomial<0, 1>::highest;
            for (std::size_t v = 0; v < n; ++v)
                require(t.exponents[v] >= 0 && t.exponents[v] <= highest, "exponent of " + system.variables[v] + in,
                        t.exponents[v], "must be from 0 to " + std::to_string(highest));
            sums[SparseMonomial(t.exponents)] += coefficient;
        }
        for (const auto& [monomial, coefficient] : sums)
            if (coefficient != 0) terms.push_back({static_cast<int>(i), monomial, coefficient});
    }
    return {RuntimeSizes(0, static_cast<int>(n)), std::move(terms)};
}

/// The same system in the (c, s) of its angles and its coordinates, as polynomial_system of a model.
PolynomialSystem<double> polynomial_system(const SparseSystem& system);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/sparse_system_definitions.hpp>
#endif
