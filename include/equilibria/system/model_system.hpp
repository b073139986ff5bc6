/// \file
/// A model at given parameters as a system of trigonometric polynomials: its support is known at compile time, its
/// coefficients are those of the parameters.
#pragma once

#include <algorithm>
#include <cmath>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/model/equations.hpp>

namespace equilibria {

/// The largest coefficient of each equation; 1 of an equation that vanishes identically, whose every solution is
/// singular.
template <Model M, class C>
Array<double, n_unknowns<M>> equation_scales(const Array<C, Formulation<M>::terms>& coefficients) {
    Array<double, n_unknowns<M>> scale;
    for (int i = 0; i < n_unknowns<M>; ++i) {
        for (int k = Formulation<M>::first[i]; k < Formulation<M>::first[i + 1]; ++k)
            scale[i] = std::max(scale[i], std::abs(coefficients[k]));
        if (!(scale[i] > 0)) scale[i] = 1;
    }
    return scale;
}

/// The coefficients of a model's terms, which are those of Formulation<M>, at given parameters.
template <Model M>
struct ModelSystem {
    Parameters<M> parameters;                           ///< as given
    Array<double, Formulation<M>::terms> coefficients;  ///< of the support's terms
    Array<double, n_unknowns<M>> scale;                 ///< the largest coefficient of each equation

    /// Throws InvalidArgument as `coefficients` does.
    explicit ModelSystem(const Parameters<M>& p)
        : parameters(p), coefficients(equilibria::coefficients<M, double>(p)), scale(equation_scales<M>(coefficients)) {
    }
};

}  // namespace equilibria
