/// \file
/// A model's function of real numbers as an object, its numbers of unknowns and of parameters known at run time: what
/// follows branches, refines singularities and traces loci is written over it, and compiled once for all models.
#pragma once

#include <algorithm>
#include <utility>

#include <equilibria/core/jet.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The equations F(q, p) of a model over the scalar S, and their first and second derivatives. q: angles in radians,
/// then coordinates; p: all parameters.
template <class S = double>
class ModelDerivatives {
public:
    virtual ~ModelDerivatives() = default;

    const RuntimeSizes& sizes() const { return sizes_; }   ///< numbers of angles and coordinates
    int unknowns() const { return sizes_.unknowns; }       ///< number of equations, and of entries of q
    int parameters() const { return parameters_; }         ///< number of entries of p
    bool has_potential() const { return has_potential_; }  ///< whether the equations are the gradient of a potential

    /// f: F; j: J, row after row.
    virtual void linearize(const RuntimeArray<S>& q, const RuntimeArray<S>& p, RuntimeArray<S>& f,
                           RuntimeMatrix<S>& j) const = 0;
    /// f, j: d/de of F and of J at (q + e v, p + e w), e = 0.
    virtual void derivatives_along(const RuntimeArray<S>& q, const RuntimeArray<S>& v, const RuntimeArray<S>& p,
                                   const RuntimeArray<S>& w, RuntimeArray<S>& f, RuntimeMatrix<S>& j) const = 0;

protected:
    /// What the four functions above return.
    ModelDerivatives(const RuntimeSizes& sizes, int parameters, bool has_potential)
        : sizes_(sizes), parameters_(parameters), has_potential_(has_potential) {}

private:
    RuntimeSizes sizes_;
    int parameters_;
    bool has_potential_;
};

/// Those, and the equations over series.
template <class S = double>
class ModelFunctions : public ModelDerivatives<S> {
public:
    /// F over series; q and p are constants or of one order.
    virtual RuntimeArray<Jet<S>> equations(const RuntimeArray<Jet<S>>& q, const RuntimeArray<Jet<S>>& p) const = 0;

protected:
    using ModelDerivatives<S>::ModelDerivatives;
};

namespace detail {

/// Those of the model M, as a Base.
template <Model M, class S, class Base>
class DerivativesOf : public Base {
public:
    DerivativesOf() : Base(Sizes<M>(), n_parameters<M>, PotentialModel<M>) {}

    void linearize(const RuntimeArray<S>& q, const RuntimeArray<S>& p, RuntimeArray<S>& f,
                   RuntimeMatrix<S>& j) const override {
        const auto values = equations_and_slopes<M, S>(unknowns_from<M>(q), parameters_from<M>(p));
        assign(values, [](const S& z) { return z; }, f, j);
    }
    void derivatives_along(const RuntimeArray<S>& q, const RuntimeArray<S>& v, const RuntimeArray<S>& p,
                           const RuntimeArray<S>& w, RuntimeArray<S>& f, RuntimeMatrix<S>& j) const override {
        using D = Dual<S, 1>;
        Unknowns<M, D> along;
        Parameters<M, D> parameters;
        for (int i = 0; i < along.size(); ++i) along[i] = D(q[i]), along[i].derivative[0] = v[i];
        for (int k = 0; k < parameters.size(); ++k) parameters[k] = D(p[k]), parameters[k].derivative[0] = w[k];
        const auto values = equations_and_slopes<M, D>(along, parameters);
        assign(values, [](const D& z) { return z.derivative[0]; }, f, j);
    }

private:
    /// f, j: part(z) of the values, and of their derivatives.
    static void assign(const auto& values, const auto& part, RuntimeArray<S>& f, RuntimeMatrix<S>& j) {
        f.resize(n_unknowns<M>);
        j = RuntimeMatrix<S>(n_unknowns<M>);
        for (int r = 0; r < n_unknowns<M>; ++r) {
            f[r] = part(values[r].value);
            for (int c = 0; c < n_unknowns<M>; ++c) j[r][c] = part(values[r].derivative[c]);
        }
    }
};

template <Model M, class S>
class FunctionsOf final : public DerivativesOf<M, S, ModelFunctions<S>> {
public:
    RuntimeArray<Jet<S>> equations(const RuntimeArray<Jet<S>>& q, const RuntimeArray<Jet<S>>& p) const override {
        return runtime_array(equilibria::equations<M, Jet<S>>(unknowns_from<M>(q), parameters_from<M>(p)));
    }
};

}  // namespace detail

/// Those of the model M; what all calls for it share.
/// \{
template <Model M, class S = double>
const ModelDerivatives<S>& derivatives_of() {
    static const detail::DerivativesOf<M, S, ModelDerivatives<S>> derivatives;
    return derivatives;
}
template <Model M, class S = double>
const ModelFunctions<S>& functions_of() {
    static const detail::FunctionsOf<M, S> functions;
    return functions;
}
/// \}

/// F(q, p).
template <class S>
RuntimeArray<S> equations(const ModelDerivatives<S>& model, const RuntimeArray<S>& q, const RuntimeArray<S>& p) {
    RuntimeArray<S> f;
    RuntimeMatrix<S> j;
    model.linearize(q, p, f, j);
    return f;
}
/// J(q, p).
template <class S>
RuntimeMatrix<S> jacobian(const ModelDerivatives<S>& model, const RuntimeArray<S>& q, const RuntimeArray<S>& p) {
    RuntimeArray<S> f;
    RuntimeMatrix<S> j;
    model.linearize(q, p, f, j);
    return j;
}
/// d/de J(q + e v, p) at e = 0.
template <class S>
RuntimeMatrix<S> jacobian_derivative(const ModelDerivatives<S>& model, const RuntimeArray<S>& q,
                                     const RuntimeArray<S>& v, const RuntimeArray<S>& p) {
    RuntimeArray<S> f;
    RuntimeMatrix<S> j;
    model.derivatives_along(q, v, p, RuntimeArray<S>(p.size()), f, j);
    return j;
}
/// dF/dp_k and dJ/dp_k.
template <class S>
std::pair<RuntimeArray<S>, RuntimeMatrix<S>> parameter_derivatives(const ModelDerivatives<S>& model,
                                                                   const RuntimeArray<S>& q, const RuntimeArray<S>& p,
                                                                   int k) {
    RuntimeArray<S> f, unit(p.size());
    RuntimeMatrix<S> j;
    unit[k] = S(1.0);
    model.derivatives_along(q, RuntimeArray<S>(q.size()), p, unit, f, j);
    return {std::move(f), std::move(j)};
}
/// d^order / de^order F(q + e v, p) at e = 0.
template <class S>
RuntimeArray<S> directional_derivative(const ModelFunctions<S>& model, int order, const RuntimeArray<S>& q,
                                       const RuntimeArray<S>& v, const RuntimeArray<S>& p) {
    RuntimeArray<Jet<S>> along(q.size()), constant(p.size());
    for (int i = 0; i < q.size(); ++i) along[i] = Jet<S>::variable(q[i], v[i], order);
    for (int k = 0; k < p.size(); ++k) constant[k] = Jet<S>(p[k]);
    const auto f = model.equations(along, constant);
    double factorial = 1;
    for (int k = 2; k <= order; ++k) factorial *= k;
    RuntimeArray<S> y(f.size());
    for (int i = 0; i < f.size(); ++i) y[i] = factorial * f[i].value(order);
    return y;
}

}  // namespace equilibria
