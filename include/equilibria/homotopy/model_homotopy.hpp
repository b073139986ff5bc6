/// \file
/// The homotopy from a start to a model at given parameters: the numbers that its evaluation needs.
#pragma once

#include <complex>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>

#include <equilibria/evaluation/evaluation_plan.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/unrolled_evaluation.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/model_system.hpp>

namespace equilibria {

namespace detail {

/// The model's equations at a point of M, or of as many unknowns at run time.
template <Model M, class N, class R>
void own_equations(const Point<N, R>& q, const Parameters<M>& p, auto& f) {
    AnglesOf<M, Complex<R>> theta;
    CoordinatesOf<M, Complex<R>> x;
    for (int i = 0; i < n_angles<M>; ++i) theta[i] = {q.c[i], q.s[i]};
    for (int j = 0; j < n_coordinates<M>; ++j) x[j] = q.x[j];
    const auto own = equations_at<M, Complex<R>>(theta, x, p);
    for (int i = 0; i < n_unknowns<M>; ++i) f[i] = own[i];
}

template <Model M>
class ModelEquations : public OwnEquations {
public:
    explicit ModelEquations(const Parameters<M>& p) : p_(p) {}

    void at(int width, const double* c, const double* s, const double* x, double* f) const override {
        using Pack = Lanes<native_lanes>;
        int k = 0;
        for (; k + native_lanes <= width; k += native_lanes) evaluate<Pack>(width, k, c, s, x, f);
        for (; k < width; ++k) evaluate<double>(width, k, c, s, x, f);
    }

private:
    /// At points number k to k + (lanes of R).
    template <class R>
    void evaluate(int width, int k, const double* c, const double* s, const double* x, double* f) const {
        const auto number = [&](const double* from, int i) {
            Complex<R> z;
            std::memcpy(&z.re, from + 2 * i * width + k, sizeof(R));
            std::memcpy(&z.im, from + (2 * i + 1) * width + k, sizeof(R));
            return z;
        };
        Point<M, R> q;
        for (int i = 0; i < n_angles<M>; ++i) q.c[i] = number(c, i), q.s[i] = number(s, i);
        for (int j = 0; j < n_coordinates<M>; ++j) q.x[j] = number(x, j);
        Array<Complex<R>, n_unknowns<M>> values;
        own_equations<M>(q, p_, values);
        for (int i = 0; i < n_unknowns<M>; ++i) {
            std::memcpy(f + 2 * i * width + k, &values[i].re, sizeof(R));
            std::memcpy(f + (2 * i + 1) * width + k, &values[i].im, sizeof(R));
        }
    }
    Parameters<M> p_;
};

}  // namespace detail

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
    template <class R, class Time>
    using Evaluation = detail::UnrolledEvaluation<ModelHomotopy, R, Time>;
    /// Unrolled, every term is code of its own: fastest, but hundreds of terms compile for minutes. Those are tracked
    /// as `polynomials`.
    static constexpr bool unrolls = !moving || Formulation<M>::terms <= 128;

    ModelHomotopy(const ModelSystem<M>& system, const Start& start) : system_(system) {
        for (int k = 0; k < Formulation<M>::terms; ++k) {
            target_[k] = system.coefficients[k];
            if constexpr (moving) difference_[k] = target_[k] - start.from(k);
        }
        for (int g = 0; g < Plan::n_groups; ++g)
            if (Plan::groups[g].in_start)
                start_[g] = start.coefficient(Plan::groups[g].equation, Plan::groups[g].own_code);
        polynomials_ = std::make_shared<PolynomialHomotopy>(parts());
    }

    /// The coefficients at t = 1, and how much less they are at t = 0 where they move.
    const Coefficient& target(int term) const { return target_[term]; }
    const std::complex<double>& difference(int term) const { return difference_[term]; }
    /// The start's coefficient of the own factor of a group (see EvaluationPlan); 0 where it has none.
    const std::complex<double>& start(int group) const { return start_[group]; }
    /// The largest coefficient of each equation.
    const Array<double, n>& scale() const { return system_.scale; }

    static constexpr Sizes<M> sizes() { return {}; }

    /// The model's own function at q, not its polynomial form: what is polished is a solution of the equations that the
    /// user wrote.
    template <class R>
    void residual(const Point<M, R>& q, auto& f) const {
        detail::own_equations<M>(q, system_.parameters, f);
    }
    /// The same homotopy as data.
    const PolynomialHomotopy& polynomials() const { return *polynomials_; }

    const Parameters<M>& parameters() const { return system_.parameters; }

private:
    PolynomialHomotopy::Parts parts() const {
        PolynomialHomotopy::Parts y{.sizes = sizes(), .terms = {}, .from = {}, .forms = {}, .scale = {}};
        for (int k = 0; k < Formulation<M>::terms; ++k) {
            const auto& term = Formulation<M>::support[k];
            y.terms.push_back({term.equation, sparse_monomial(term.monomial), system_.coefficients[k]});
            if constexpr (moving) y.from.push_back(system_.coefficients[k] - difference_[k]);
        }
        for (int g = 0; g < Plan::n_groups; ++g)
            if (Plan::groups[g].in_start && start_[g] != std::complex<double>())
                y.forms.terms.push_back({Plan::groups[g].equation, Plan::groups[g].own_code, start_[g]});
        y.scale.assign(scale().begin(), scale().end());
        y.symmetric = symmetric;
        y.own = std::make_shared<detail::ModelEquations<M>>(system_.parameters);
        y.degrees.assign(Formulation<M>::degrees.begin(), Formulation<M>::degrees.end());
        return y;
    }

    ModelSystem<M> system_;
    Array<Coefficient, Formulation<M>::terms> target_{};
    Array<std::complex<double>, Formulation<M>::terms> difference_{};
    Array<std::complex<double>, Plan::n_groups> start_{};
    std::shared_ptr<const PolynomialHomotopy> polynomials_;
};

}  // namespace equilibria
