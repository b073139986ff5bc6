/// \file
/// The homotopies: what H(q, t) is. How it is evaluated: evaluation.hpp.
///
/// From a total-degree start: H = (1-t) G + t F, gamma being a factor of G. From a solved instance: H = F with the
/// coefficients (1-t) gamma a_start + t a_target, a straight line in the space of coefficients. The second kind contains
/// the first (a_start = 0, plus G): a model that needs both is compiled once, for some loss of speed.
#pragma once

#include <complex>

#include <equilibria/homotopy/detail/evaluation_plan.hpp>
#include <equilibria/homotopy/total_degree_start.hpp>

namespace equilibria {

/// The numbers of a homotopy. C: double for real parameters, std::complex<double> for complex ones.
template <Model M, StartKind Kind, class C = double>
struct Homotopy {
    using Plan = detail::EvaluationPlan<M, Kind>;
    static constexpr StartKind kind = Kind;
    using Coefficient = std::conditional_t<Kind == StartKind::parameter, std::complex<double>, C>;

    Array<Coefficient, Formulation<M>::terms> target;                ///< a_target
    Array<std::complex<double>, Formulation<M>::terms> difference;   ///< parameter: a_target - gamma a_start
    Array<std::complex<double>, Plan::n_groups> start;               ///< coefficients of G, a group each; else 0

    /// H = (1-t) G + t F(., target).
    static Homotopy total_degree(const Array<C, Formulation<M>::terms>& target, const TotalDegreeStart<M>& start) {
        Homotopy h;
        for (int k = 0; k < Formulation<M>::terms; ++k) h.target[k] = target[k], h.difference[k] = target[k];
        for (int g = 0; g < Plan::n_groups; ++g)
            if (Plan::groups[g].in_start) h.start[g] = start.coefficient(Plan::groups[g].equation, Plan::groups[g].own_code);
        return h;
    }
    /// H = F with coefficients (1-t) gamma a_start + t a_target.
    template <class A, class B>
    static Homotopy parameter(const Array<A, Formulation<M>::terms>& from, const Array<B, Formulation<M>::terms>& to,
                              std::complex<double> gamma)
        requires(Kind == StartKind::parameter)
    {
        Homotopy h;
        for (int k = 0; k < Formulation<M>::terms; ++k) h.target[k] = to[k], h.difference[k] = to[k] - gamma * from[k];
        return h;
    }
};

}  // namespace equilibria
