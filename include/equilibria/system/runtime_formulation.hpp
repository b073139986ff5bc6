/// \file
/// The equations of a model at run time as trigonometric polynomials: what Formulation<M> is for a Model, found out
/// when it is called.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <equilibria/algebra/exact_scalars.hpp>
#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/system/sparse_term.hpp>

namespace equilibria {

/// Support, degrees and symmetry at generic parameters, and the coefficients for given ones.
class RuntimeFormulation {
public:
    /// Throws InvalidArgument where the model is no trigonometric polynomial in its unknowns, or one of its equations
    /// does not depend on them.
    template <RuntimeModel T>
    explicit RuntimeFormulation(const T& model)
        : RuntimeFormulation(sizes_of(model), RuntimePotentialModel<T>,
                             detail::symbolic_equations<double>(model, generic_parameters(model.parameters())), [&] {
                                 const auto p = generic_parameters(model.parameters());
                                 RuntimeArray<ExactBall> exact(p.size());
                                 for (int k = 0; k < p.size(); ++k) exact[k] = p[k];
                                 return detail::symbolic_equations<ExactBall>(model, exact);
                             }) {}

    /// So many generic parameters.
    static RuntimeArray<double> generic_parameters(int number) {
        RuntimeArray<double> p(number);
        detail::set_generic({p.begin(), p.end()});
        return p;
    }

    const RuntimeSizes& sizes() const { return sizes_; }   ///< numbers of angles and coordinates
    bool has_potential() const { return has_potential_; }  ///< whether the equations are the gradient of a potential
    /// Whether F(-theta) = -F(theta), of angles alone.
    bool reflection_symmetric() const { return reflection_symmetric_; }
    /// Total degree of each equation in the (cos, sin) of the angles and the coordinates.
    const std::vector<int>& degrees() const { return degrees_; }
    /// Terms by equation, then by the code of the equation's own unknown; coefficients 0.
    const std::vector<SparseTerm>& support() const { return support_; }

    /// The support with the coefficients for the parameters p, 0 where the model lacks a term there. Throws
    /// InvalidArgument as `coefficients` does.
    template <RuntimeModel T>
    std::vector<SparseTerm> terms(const T& model, const RuntimeArray<double>& p) const {
        return with_coefficients(detail::symbolic_equations<double>(model, p));
    }

private:
    /// exactly: the same polynomials over exact numbers, asked for where a term may be rounding.
    RuntimeFormulation(const RuntimeSizes& sizes, bool has_potential, RuntimePolynomials<> generic,
                       const std::function<RuntimePolynomials<ExactBall>()>& exactly);
    std::vector<SparseTerm> with_coefficients(const RuntimePolynomials<>& equations) const;
    RuntimeSizes sizes_;
    bool has_potential_, reflection_symmetric_;
    std::vector<int> degrees_;
    std::vector<SparseTerm> support_;
};

/// A model at run time at given parameters.
struct RuntimeModelSystem {
    const RuntimeFormulation* formulation;  ///< not owned
    RuntimeArray<double> parameters;        ///< as given
    std::vector<SparseTerm> terms;          ///< the support with the coefficients there, 0 of terms that are absent
    std::vector<double> scale;  ///< the largest coefficient of each equation; 1 of one that vanishes identically

    /// The formulation has to outlive it. Throws InvalidArgument as `terms` does.
    template <RuntimeModel T>
    RuntimeModelSystem(const RuntimeFormulation& of, const T& model, const RuntimeArray<double>& p)
        : formulation(&of), parameters(p), terms(of.terms(model, p)),
          scale(static_cast<std::size_t>(of.sizes().unknowns)) {
        for (const auto& t : terms) {
            double& largest = scale[static_cast<std::size_t>(t.equation)];
            largest = std::max(largest, std::abs(t.coefficient));
        }
        for (double& largest : scale)
            if (!(largest > 0)) largest = 1;
    }
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/runtime_formulation_definitions.hpp>
#endif
