/// \file
/// The homotopy from a start to a model at given parameters: the numbers that its evaluation needs.
#pragma once

#include <complex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/evaluation/evaluation_plan.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/evaluation/term_tables.hpp>
#include <equilibria/evaluation/unrolled_evaluation.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/model_system.hpp>

namespace equilibria {

/// H(q, t), with H(q, 1) = F(q) at the parameters of the target. Start: see start.hpp.
template <Model M, class Start>
class ModelHomotopy {
public:
    using System = M;
    using Plan = detail::EvaluationPlan<M, Start>;
    static constexpr int n = n_unknowns<M>;
    static constexpr bool moving = Start::moving;
    static constexpr int law_order = 1;  ///< the highest order in t of a term's coefficient
    /// With a potential the Jacobian is complex symmetric.
    static constexpr bool symmetric = Formulation<M>::has_potential;
    using Coefficient = std::conditional_t<moving, std::complex<double>, double>;
    /// Unrolled, every term is code of its own: fastest, but hundreds of terms compile for minutes.
    template <class R, class Time>
    using Evaluation =
        std::conditional_t<!moving || Formulation<M>::terms <= 128, detail::UnrolledEvaluation<ModelHomotopy, R, Time>,
                           detail::TableEvaluation<ModelHomotopy, R, Time>>;
    /// What the start adds, for an evaluation by loops.
    template <class R>
    using Form = detail::SeparableForm<ModelHomotopy, R>;

    ModelHomotopy(const ModelSystem<M>& system, const Start& start) : system_(system) {
        for (int k = 0; k < Formulation<M>::terms; ++k) {
            target_[k] = system.coefficients[k];
            if constexpr (moving) difference_[k] = target_[k] - start.from(k);
        }
        for (int g = 0; g < Plan::n_groups; ++g)
            if (Plan::groups[g].in_start)
                start_[g] = start.coefficient(Plan::groups[g].equation, Plan::groups[g].own_code);
    }

    /// The coefficients at t = 1, and how much less they are at t = 0 where they move.
    const Coefficient& target(int term) const { return target_[term]; }
    const std::complex<double>& difference(int term) const { return difference_[term]; }
    /// The Taylor coefficient in t, at the time t, of a term's coefficient where it moves: difference of order 1.
    template <int Order, class R, class Time>
    auto law(int term, const Time& t) const {
        if constexpr (Order == 0)
            return Complex<R>(broadcast_complex<R>(target_[term]) -
                              broadcast_complex<R>(difference_[term]) * (1.0 - t));
        else
            return difference_[term];
    }
    /// The start's coefficient of the own factor of a group (see EvaluationPlan); 0 where it has none.
    const std::complex<double>& start(int group) const { return start_[group]; }
    /// For an evaluation by loops.
    static const detail::TermTables<M>& tables() {
        static const detail::TermTables<M> tables = [] {
            std::vector<SupportTerm<M>> terms(Formulation<M>::support.begin(), Formulation<M>::support.end());
            return detail::TermTables<M>(terms, Formulation<M>::degrees);
        }();
        return tables;
    }

    /// The largest coefficient of each equation.
    const Array<double, n>& scale() const { return system_.scale; }

    /// The model's own function at q, not its polynomial form: what is polished is a solution of the equations that the
    /// user wrote. `polynomials` has their values as polynomials, and is left as it is by systems that have no other
    /// form.
    template <class R>
    void residual(const Point<M, R>& q, Complex<R> (&polynomials)[n]) const {
        detail::AnglesOf<M, Complex<R>> theta;
        detail::CoordinatesOf<M, Complex<R>> x;
        for (int i = 0; i < n_angles<M>; ++i) theta[i] = {q.c[i], q.s[i]};
        for (int j = 0; j < n_coordinates<M>; ++j) x[j] = q.x[j];
        const auto own = detail::equations_at<M, Complex<R>>(theta, x, system_.parameters);
        for (int i = 0; i < n; ++i) polynomials[i] = own[i];
    }

    const Parameters<M>& parameters() const { return system_.parameters; }
    /// Calls take(number) for each number that a path depends on beside its start point.
    void for_each_number(const auto& take) const {
        for (const auto& a : target_) take(a);
        for (const auto& a : difference_) take(a);
        for (const auto& a : start_) take(a);
    }

private:
    ModelSystem<M> system_;
    Array<Coefficient, Formulation<M>::terms> target_{};
    Array<std::complex<double>, Formulation<M>::terms> difference_{};
    Array<std::complex<double>, Plan::n_groups> start_{};
};

}  // namespace equilibria
