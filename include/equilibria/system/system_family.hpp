/// \file
/// A family of systems: one support, and coefficients that are analytic functions of parameters, real or complex. What
/// homotopies follow that stay in a model.
///
/// A system's parameters may enter its coefficients by any function that the scalars of the model know. What is asked
/// of them is that they can be complex: between two real members lie degenerate ones, and the way around them is
/// through complex parameters (Morgan, Sommese, Coefficient-parameter polynomial continuation, Appl. Math. Comput. 29
/// (1989)).
#pragma once

#include <algorithm>
#include <complex>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/system/runtime_formulation.hpp>
#include <equilibria/system/sparse_system.hpp>
#include <equilibria/system/sparse_term.hpp>

namespace equilibria {

/// The support, the number of parameters, and the function that gives the coefficients.
class SystemFamily {
public:
    using Number = std::complex<double>;         ///< type of parameters and coefficients
    using Parameters = std::span<const Number>;  ///< one after the other, real or not
    /// The coefficients of the support's terms, in its order, at parameters.
    using Coefficients = std::function<std::vector<Number>(Parameters)>;

    /// support: terms, each product of factors once in an equation; their coefficients are not read. coefficients: may
    /// be called from one thread at a time. Throws InvalidArgument where a term is none of the system's.
    SystemFamily(const RuntimeSizes& sizes, std::vector<SparseTerm> support, int parameters, Coefficients coefficients);

    const RuntimeSizes& sizes() const { return sizes_; }                 ///< numbers of angles and coordinates
    int parameters() const { return parameters_; }                       ///< number of parameters
    const std::vector<SparseTerm>& support() const { return support_; }  ///< terms in the order of the coefficients

    /// Throws InvalidArgument where there are other numbers of parameters or of coefficients than there should be. A
    /// coefficient that is not finite comes back as it is, or as an error of the model's.
    std::vector<Number> coefficients(Parameters p) const;
    /// The member at real parameters; terms with the coefficient 0 are left out. Throws InvalidArgument as SparseSystem
    /// does, and where a coefficient is not real.
    SparseSystem system(std::span<const double> p) const;

    /// Whether on the line between two members all coefficients are affine, to rounding: then the line in the space of
    /// coefficients between them is in the family. Told by four points of the line, drawn once.
    bool is_affine_between(Parameters from, Parameters to) const;

private:
    RuntimeSizes sizes_;
    std::vector<SparseTerm> support_;
    int parameters_;
    Coefficients coefficients_;
};

namespace detail {

/// Complex coefficients of a support's terms. Throws InvalidArgument where the equations have others.
std::vector<std::complex<double>> coefficients_on(const std::vector<SparseTerm>& support, const RuntimeSizes& sizes,
                                                  const RuntimePolynomials<std::complex<double>>& equations);

}  // namespace detail

/// The members of a model, at all its parameters.
template <Model M>
SystemFamily system_family() {
    std::vector<SparseTerm> support;
    for (const auto& term : Formulation<M>::support)
        support.push_back({term.equation, sparse_monomial(term.monomial), 0});
    return {Sizes<M>(), std::move(support), Parameters<M>().size(), [](SystemFamily::Parameters p) {
                Parameters<M, std::complex<double>> q;
                for (int k = 0; k < q.size(); ++k) q[k] = p[static_cast<std::size_t>(k)];
                const auto found = coefficients<M, std::complex<double>>(q);
                return std::vector<std::complex<double>>(found.begin(), found.end());
            }};
}
/// The same of a model at run time, which is copied. Throws InvalidArgument as RuntimeFormulation does.
template <RuntimeModel T>
SystemFamily system_family(const T& model) {
    const RuntimeFormulation formulation(model);
    return {formulation.sizes(), formulation.support(), model.parameters(),
            [model, support = formulation.support(), sizes = formulation.sizes()](SystemFamily::Parameters p) {
                RuntimeArray<std::complex<double>> q(static_cast<int>(p.size()));
                std::copy(p.begin(), p.end(), q.begin());
                return detail::coefficients_on(support, sizes,
                                               detail::symbolic_equations<std::complex<double>>(model, q));
            }};
}

/// The systems with any constants in place of this one's, n parameters: the constant term of each equation. All pairs
/// of a root and constants are one irreducible variety, since each point is the root for some constants.
SystemFamily constants_family(const SparseSystem& system);
/// The parameters of that family at which the system is its member.
std::vector<double> constants_of(const SparseSystem& system);

/// Real parameters as complex ones.
template <class Range>
std::vector<std::complex<double>> complex_parameters(const Range& p) {
    return {p.begin(), p.end()};
}

}  // namespace equilibria

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
extern template class RuntimePool<std::complex<double>>;
extern template class RuntimeScalar<std::complex<double>>;
extern template class RuntimeAngle<std::complex<double>>;
}  // namespace equilibria
#else
#include <equilibria/system/detail/system_family_definitions.hpp>
#endif
