/// \file
/// The equilibrium equations as polynomials with exactly known coefficients: what every proof is about. They come from
/// the model's own function, called with exact numbers, so that no rounding stands between the model and its proof.
#pragma once

#include <algorithm>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/exact_ball.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// One term of an equation over exact numbers.
template <class M>
struct ExactTerm {
    int equation;
    Monomial<n_angles<M>, n_coordinates<M>> monomial;
    ExactBall coefficient;
};

/// All terms of all equations, by equation; those that cancel are absent.
template <class M>
struct ExactSystem {
    std::vector<ExactTerm<M>> terms;

    /// The system at the parameters p, each a number or an interval. Throws InvalidArgument where a coefficient is not
    /// finite or divides by 0 there.
    static ExactSystem at(const Parameters<M, ExactBall>& p) {
        ExactSystem y;
        int equation = 0;
        for (const auto& f : detail::symbolic_equations<M, ExactBall>(p)) {
            for (const auto& t : f.terms()) y.terms.push_back({equation, t.monomial, t.coefficient});
            ++equation;
        }
        return y;
    }
    static ExactSystem at(const Parameters<M>& p) {
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

}  // namespace equilibria
