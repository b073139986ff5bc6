/// \file
/// The equilibrium equations as polynomials with exactly known coefficients: what every proof is about. They come from
/// the model's own function, called with exact numbers, so that no rounding stands between the model and its proof.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <equilibria/algebra/exact_scalars.hpp>
#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/exact_ball.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// One term of an equation over exact numbers.
template <class M>
struct ExactTerm {
    int equation;                                      ///< from 0
    Monomial<n_angles<M>, n_coordinates<M>> monomial;  ///< product of factors, one an unknown
    ExactBall coefficient;                             ///< with its radius, 0 at parameters that are numbers
};

/// All terms of all equations, by equation; those that cancel are absent.
template <class M>
struct ExactSystem {
    std::vector<ExactTerm<M>> terms;  ///< by equation

    ExactSystem() = default;
    /// From an equation each, polynomials over exact numbers.
    template <class Polynomials>
    explicit ExactSystem(const Polynomials& equations) {
        int equation = 0;
        for (const auto& f : equations) {
            for (const auto& t : f.terms())
                terms.push_back({equation, detail::own_monomial<M>(t.monomial), t.coefficient});
            ++equation;
        }
    }

    /// The system at the parameters p, each a number or an interval. Throws InvalidArgument where a coefficient is not
    /// finite or divides by 0 there.
    static ExactSystem at(const Parameters<M, ExactBall>& p) {
        return ExactSystem(detail::equations_at_run_time<M, ExactBall>(p));
    }
    /// At numbers; throws InvalidArgument for those that are not finite as well.
    static ExactSystem at(const Parameters<M>& p) {
        require_finite(p, "parameters");
        Parameters<M, ExactBall> exact;
        for (int k = 0; k < p.size(); ++k) exact[k] = p[k];
        return at(exact);
    }

    /// Total degree of each equation in (cos, sin) and the coordinates; 0 of one that vanishes.
    Array<int, n_unknowns<M>> degrees() const {
        Array<int, n_unknowns<M>> y;
        for (const auto& t : terms) y[t.equation] = std::max(y[t.equation], t.monomial.degree());
        return y;
    }
    /// Whether each term belongs to the support that the library finds at generic parameters.
    bool within_support() const {
        using F = Formulation<M>;
        return std::all_of(terms.begin(), terms.end(), [](const auto& t) {
            const SupportTerm<M> key{t.equation, t.monomial};
            const auto at = std::lower_bound(F::support.begin(), F::support.end(), key);
            return at != F::support.end() && *at == key;
        });
    }
};

/// The terms of an exact system as data, whatever the model: what the proofs compute with.
struct ExactTerms {
    /// A factor of a term.
    struct Factor {
        int unknown;  ///< number of the unknown
        int code;     ///< see Monomial: cos k, sin k (code -k), or x^k
    };
    /// One term of an equation.
    struct Term {
        int equation;           ///< from 0
        int first;              ///< its first factor in `factors`
        int last;               ///< past its last factor
        ExactBall coefficient;  ///< with its radius
    };
    RuntimeSizes sizes;           ///< numbers of angles and coordinates
    bool symmetric = false;       ///< the equations are the gradient of a potential
    std::vector<Term> terms;      ///< of all equations, by equation
    std::vector<Factor> factors;  ///< of all terms, one term's after the other's

    /// Total degree of each equation in (cos, sin) and the coordinates; 0 of one that vanishes.
    std::vector<int> degrees() const {
        std::vector<int> y(static_cast<std::size_t>(sizes.unknowns));
        for (const auto& t : terms) {
            int degree = 0;
            for (int k = t.first; k < t.last; ++k) degree += std::abs(factors[static_cast<std::size_t>(k)].code);
            int& largest = y[static_cast<std::size_t>(t.equation)];
            largest = std::max(largest, degree);
        }
        return y;
    }

    /// Whether F(-theta) = -F(theta) exactly: the unknowns are angles, and each term has an odd number of sines.
    bool odd() const {
        return sizes.coordinates == 0 && std::all_of(terms.begin(), terms.end(), [this](const Term& t) {
                   int sines = 0;
                   for (int k = t.first; k < t.last; ++k) sines += factors[static_cast<std::size_t>(k)].code < 0;
                   return sines % 2 == 1;
               });
    }

    ExactTerms() = default;
    /// Of a model's system; it is symmetric where the model has a potential.
    template <class M>
    ExactTerms(const ExactSystem<M>& system) : sizes(Sizes<M>()), symmetric(PotentialModel<M>) {
        for (const auto& t : system.terms) {
            const auto first = static_cast<int>(factors.size());
            for (int u = 0; u < n_unknowns<M>; ++u)
                if (const int code = t.monomial.code(u); code != 0) factors.push_back({u, code});
            terms.push_back({t.equation, first, static_cast<int>(factors.size()), t.coefficient});
        }
    }
    /// From an equation each, polynomials in as many unknowns.
    ExactTerms(const RuntimePolynomials<ExactBall>& equations, const RuntimeSizes& numbers) : sizes(numbers) {
        int equation = 0;
        for (const auto& f : equations) {
            for (const auto& t : f.terms()) {
                const auto first = static_cast<int>(factors.size());
                const auto codes = codes_of(t.monomial, sizes);
                for (int u = 0; u < sizes.unknowns; ++u)
                    if (const int code = codes[static_cast<std::size_t>(u)]; code != 0) factors.push_back({u, code});
                terms.push_back({equation, first, static_cast<int>(factors.size()), t.coefficient});
            }
            ++equation;
        }
    }
};

/// The equations of a model at run time at the parameters p, exactly. Throws InvalidArgument where the model is no
/// trigonometric polynomial there, or a parameter is not finite.
template <RuntimeModel T>
ExactTerms exact_terms(const T& model, const RuntimeArray<double>& p) {
    require_finite(p, "parameters");
    RuntimeArray<ExactBall> exact(p.size());
    for (int k = 0; k < p.size(); ++k) exact[k] = p[k];
    ExactTerms y(detail::symbolic_equations<ExactBall>(model, exact), sizes_of(model));
    y.symmetric = RuntimePotentialModel<T>;
    return y;
}

/// The system for all values of some parameters in intervals, and its derivatives by those parameters.
template <class M, int N>
struct ExactSystems {
    ExactSystem<M> center;         ///< at the middle of the intervals, which are doubles
    ExactSystem<M> all;            ///< for all values at once
    ExactSystem<M> derivative[N];  ///< by the k-th varied parameter, for all values at once
    Array<double, N> half_width;   ///< of the intervals, from the middle

    /// Parameter varied[k] takes all values from low[k] to high[k], the others are those of p.
    ExactSystems(const Parameters<M>& p, const Array<int, N>& varied, const Array<double, N>& low,
                 const Array<double, N>& high) {
        Parameters<M> middle = p;
        Parameters<M, ExactBall> wide;
        Parameters<M, Dual<ExactBall, N>> dual;
        for (int k = 0; k < p.size(); ++k) wide[k] = p[k];
        for (int k = 0; k < N; ++k) {
            middle[varied[k]] = low[k] + (high[k] - low[k]) / 2;
            const double m = middle[varied[k]];
            half_width[k] = rounded_up(std::max(high[k] - m, m - low[k]));
            wide[varied[k]] = ExactBall(Dyadic(m), half_width[k]);
        }
        for (int k = 0; k < p.size(); ++k) dual[k] = wide[k];
        for (int k = 0; k < N; ++k) dual[varied[k]].derivative[k] = 1;
        center = ExactSystem<M>::at(middle);
        int equation = 0;
        for (const auto& f : detail::equations_at_run_time<M, Dual<ExactBall, N>>(dual)) {
            for (const auto& t : f.terms()) {
                const auto monomial = detail::own_monomial<M>(t.monomial);
                all.terms.push_back({equation, monomial, t.coefficient.value});
                for (int k = 0; k < N; ++k)
                    if (!(t.coefficient.derivative[k] == 0))
                        derivative[k].terms.push_back({equation, monomial, t.coefficient.derivative[k]});
            }
            ++equation;
        }
    }
};

/// The members of ExactSystems as data, whatever the model.
struct ExactTermFamily {
    ExactTerms center;                   ///< the system at the middle of the intervals
    ExactTerms all;                      ///< the system for all values at once
    std::vector<ExactTerms> derivative;  ///< by each varied parameter
    std::vector<double> half_width;      ///< of each interval, from the middle

    /// A copy as data.
    template <class M, int N>
    ExactTermFamily(const ExactSystems<M, N>& systems)
        : center(systems.center), all(systems.all), half_width(systems.half_width.begin(), systems.half_width.end()) {
        for (const auto& by : systems.derivative) derivative.emplace_back(by);
    }
};

}  // namespace equilibria
