/// \file
/// A square system of trigonometric polynomials as data: made at run time from a model, from other systems, or from
/// terms. Its type says how many angles and coordinates it has, and no more, so that all systems of a size share one
/// tracker.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/monomial.hpp>
#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// The unknowns of a system: angles first, plain coordinates after them. It stands for the system's type where points
/// and roots are concerned.
template <int Angles, int Coordinates>
struct UnknownsOf {
    static constexpr int n_angles = Angles, n_coordinates = Coordinates;
};

/// One term of one equation. Terms are sorted by equation, then by the code of the equation's own unknown.
template <int Angles, int Coordinates>
struct SparseTerm {
    int equation;
    Monomial<Angles, Coordinates> monomial;
    double coefficient;

    /// The factor in unknown number `equation`: terms of an equation that share it are summed before it is multiplied.
    int own_code() const { return monomial.code(equation); }
};

template <int Angles, int Coordinates>
class SparseSystem {
public:
    using Unknowns = UnknownsOf<Angles, Coordinates>;
    using Term = SparseTerm<Angles, Coordinates>;
    using Polynomial = TrigonometricPolynomial<Angles, Coordinates>;
    static constexpr int n_angles = Angles, n_coordinates = Coordinates, n = Angles + Coordinates;

    /// From n polynomials. Throws InvalidArgument where there are not n of them, where one is 0, or a coefficient is
    /// not finite.
    explicit SparseSystem(const std::vector<Polynomial>& equations) {
        require(static_cast<int>(equations.size()) == n, "equations", equations.size(),
                "must be as many as there are unknowns");
        for (int i = 0; i < n; ++i) {
            const Polynomial& f = equations[static_cast<std::size_t>(i)];
            require(!f.terms().empty(), "equations", "equation " + std::to_string(i), "must not be 0");
            for (const auto& t : f.terms()) {
                require(std::isfinite(t.coefficient), "equations", "equation " + std::to_string(i),
                        "has a coefficient that is not finite");
                terms_.push_back({i, t.monomial, t.coefficient});
                scale_[i] = std::max(scale_[i], std::abs(t.coefficient));
                degrees_[i] = std::max(degrees_[i], t.monomial.degree());
            }
        }
        std::sort(terms_.begin(), terms_.end(), before);
    }

    const std::vector<Term>& terms() const { return terms_; }
    /// The equations as polynomials.
    std::vector<Polynomial> equations() const {
        std::vector<Polynomial> y(static_cast<std::size_t>(n));
        for (const Term& t : terms_) y[static_cast<std::size_t>(t.equation)] += Polynomial(t.monomial, t.coefficient);
        return y;
    }
    const Array<double, n>& scale() const { return scale_; }   ///< the largest coefficient of each equation
    const Array<int, n>& degrees() const { return degrees_; }  ///< total degree of each in (cos, sin) and coordinates

    /// The order of terms.
    static bool before(const Term& a, const Term& b) {
        if (a.equation != b.equation) return a.equation < b.equation;
        if (a.own_code() != b.own_code()) return a.own_code() < b.own_code();
        return a.monomial < b.monomial;
    }

private:
    std::vector<Term> terms_;
    Array<double, n> scale_{};
    Array<int, n> degrees_{};
};

/// A model's equations at the parameters p. Terms that the model lacks there, though it has them at other parameters,
/// are left out. Throws InvalidArgument as `coefficients` does.
template <Model M>
auto sparse_system(const Parameters<M>& p) {
    using System = SparseSystem<n_angles<M>, n_coordinates<M>>;
    const auto own = coefficients<M, double>(p);
    std::vector<typename System::Polynomial> equations(static_cast<std::size_t>(n_unknowns<M>));
    for (int k = 0; k < Formulation<M>::terms; ++k) {
        const auto& term = Formulation<M>::support[k];
        if (own[k] != 0)
            equations[static_cast<std::size_t>(term.equation)] += typename System::Polynomial(term.monomial, own[k]);
    }
    return System(equations);
}

/// Polynomials in n plain coordinates, the variables of `system` in their order, for systems that come from a file or
/// from terms. Throws InvalidArgument unless there are n equations in n variables with real, finite coefficients and,
/// in each term, n exponents from 0 to Monomial's highest.
template <int n, class C>
requires std::same_as<C, double> || std::same_as<C, std::complex<double>>
SparseSystem<0, n> sparse_system(const PolynomialSystem<C>& system) {
    using Polynomial = typename SparseSystem<0, n>::Polynomial;
    const auto number = std::to_string(n);
    require(system.variables.size() == n, "variables", system.variables.size(), "must be " + number);
    require(system.equations.size() == n, "equations", system.equations.size(), "must be " + number);
    std::vector<Polynomial> equations(n);
    for (std::size_t i = 0; i < n; ++i)
        for (const auto& t : system.equations[i]) {
            const std::string in = " in equation " + std::to_string(i);
            require(t.exponents.size() == n, "exponents" + in, t.exponents.size(), "must be " + number);
            double coefficient{};
            if constexpr (std::same_as<C, double>) {
                coefficient = t.coefficient;
            } else {
                require(t.coefficient.imag() == 0, "coefficient" + in, t.coefficient, "must be real");
                coefficient = t.coefficient.real();
            }
            Monomial<0, n> monomial;
            for (int v = 0; v < n; ++v) {
                const auto at = static_cast<std::size_t>(v);
                require(t.exponents[at] >= 0 && t.exponents[at] <= Monomial<0, n>::highest,
                        "exponent of " + system.variables[at] + in, t.exponents[at],
                        "must be from 0 to " + std::to_string(Monomial<0, n>::highest));
                monomial.set_code(v, t.exponents[at]);
            }
            equations[i] += Polynomial(monomial, coefficient);
        }
    return SparseSystem<0, n>(equations);
}

}  // namespace equilibria
