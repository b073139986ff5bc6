/// \file
/// The equations of a model at run time as trigonometric polynomials, over any coefficients.
#pragma once

#include <equilibria/algebra/runtime_polynomial.hpp>
#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/runtime_model.hpp>

namespace equilibria {

namespace detail {

/// The equations as polynomials. parameters(pool): the model's parameters as symbolic scalars. Throws InvalidArgument
/// where the model has more unknowns than a RuntimePolynomial, or other numbers of equations than it says.
template <class C, RuntimeModel T>
RuntimePolynomials<C> symbolic_equations_of(const T& model, const auto& parameters) {
    using Scalar = SymbolicScalar<most_angles, most_coordinates, C>;
    const RuntimeSizes sizes = sizes_of(model);
    require(sizes.angles <= most_angles, "model.angles()", sizes.angles, "must be at most 16");
    require(sizes.coordinates <= most_coordinates, "model.coordinates()", sizes.coordinates, "must be at most 48");
    typename Scalar::Pool pool;
    RuntimeArray<SymbolicAngle<most_angles, most_coordinates, C>> theta(sizes.angles);
    RuntimeArray<Scalar> x(sizes.coordinates);
    for (int i = 0; i < theta.size(); ++i) theta[i] = {&pool, i};
    for (int j = 0; j < x.size(); ++j) x[j] = Scalar(&pool, coordinate_polynomial<C>(j));
    const RuntimeArray<Scalar> p = parameters(&pool);
    RuntimePolynomials<C> f;
    if constexpr (RuntimePotentialModel<T>) {
        const RuntimePolynomial<C> v = Scalar(call_runtime_potential(model, theta, x, p)).polynomial();
        for (int i = 0; i < sizes.angles; ++i) f.push_back(derivative(v, i));
        for (int j = 0; j < sizes.coordinates; ++j) f.push_back(derivative(v, most_angles + j));
    } else {
        for (const auto& value : call_runtime_equations(model, theta, x, p)) f.push_back(Scalar(value).polynomial());
    }
    return f;
}

/// Their coefficients for the parameters p. Throws InvalidArgument also where these are not as many as the model's.
template <class C, RuntimeModel T>
RuntimePolynomials<C> symbolic_equations(const T& model, const RuntimeArray<C>& p) {
    using Scalar = SymbolicScalar<most_angles, most_coordinates, C>;
    require(p.size() == model.parameters(), "parameters", p.size(), "must be as many as model.parameters()");
    return symbolic_equations_of<C>(model, [&](typename Scalar::Pool*) {
        RuntimeArray<Scalar> y(p.size());
        for (int k = 0; k < y.size(); ++k) y[k] = Scalar(p[k]);
        return y;
    });
}

}  // namespace detail

}  // namespace equilibria
