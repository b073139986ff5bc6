/// \file
/// The equations of a model, at run time, as trigonometric polynomials, over any coefficients.
#pragma once

#include <equilibria/algebra/runtime_polynomial.hpp>
#include <equilibria/algebra/runtime_scalar.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/runtime_model.hpp>

namespace equilibria {

namespace detail {

/// The equations as polynomials. parameters(pool): the model's parameters as symbolic scalars. Throws InvalidArgument
/// where the model has more unknowns than a RuntimePolynomial, or other numbers of equations than it says.
template <class C, RuntimeModel T>
RuntimePolynomials<C> symbolic_equations_of(const T& model, const auto& parameters) {
    const RuntimeSizes sizes = sizes_of(model);
    require(sizes.angles <= most_angles, "model.angles()", sizes.angles, "must be at most 16");
    require(sizes.coordinates <= most_coordinates, "model.coordinates()", sizes.coordinates, "must be at most 48");
    const RuntimePool<C> pool;
    RuntimeArray<RuntimeAngle<C>> theta(sizes.angles);
    RuntimeArray<RuntimeScalar<C>> x(sizes.coordinates);
    for (int i = 0; i < theta.size(); ++i) theta[i] = RuntimeAngle<C>(pool, i);
    for (int j = 0; j < x.size(); ++j) x[j] = RuntimeScalar<C>::coordinate(pool, j, C(1));
    const RuntimeArray<RuntimeScalar<C>> p = parameters(pool);
    if constexpr (RuntimePotentialModel<T>) {
        return RuntimeScalar<C>(call_runtime_potential(model, theta, x, p)).gradient(sizes);
    } else {
        RuntimePolynomials<C> f;
        for (const auto& value : call_runtime_equations(model, theta, x, p))
            f.push_back(RuntimeScalar<C>(value).polynomial());
        return f;
    }
}

/// Their coefficients for the parameters p. Throws InvalidArgument also where these are not as many as the model's.
template <class C, RuntimeModel T>
RuntimePolynomials<C> symbolic_equations(const T& model, const RuntimeArray<C>& p) {
    require(p.size() == model.parameters(), "parameters", p.size(), "must be as many as model.parameters()");
    return symbolic_equations_of<C>(model, [&](const RuntimePool<C>&) {
        RuntimeArray<RuntimeScalar<C>> y(p.size());
        for (int k = 0; k < y.size(); ++k) y[k] = RuntimeScalar<C>(p[k]);
        return y;
    });
}

/// The same of a Model. parameters(pool): as above, of type Parameters<M, RuntimeScalar<C>>.
template <class M, class C>
RuntimePolynomials<C> symbolic_equations_of(const auto& parameters) {
    const RuntimePool<C> pool;
    Array<RuntimeAngle<C>, n_angles<M>> theta;
    Array<RuntimeScalar<C>, n_coordinates<M>> x;
    for (int i = 0; i < theta.size(); ++i) theta[i] = RuntimeAngle<C>(pool, i);
    for (int j = 0; j < x.size(); ++j) x[j] = RuntimeScalar<C>::coordinate(pool, j, C(1));
    const Parameters<M, RuntimeScalar<C>> p = parameters(pool);
    if constexpr (PotentialModel<M>) {
        return RuntimeScalar<C>(call_potential(M{}, theta, x, p)).gradient(Sizes<M>());
    } else {
        RuntimePolynomials<C> f;
        for (const auto& value : call_equations(M{}, theta, x, p)) f.push_back(RuntimeScalar<C>(value).polynomial());
        return f;
    }
}

}  // namespace detail

}  // namespace equilibria
