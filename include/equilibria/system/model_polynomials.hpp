/// \file
/// A model's equations in its unknowns and in some of its parameters, as polynomials made at run time, of one type for
/// all models: what critical systems are made of.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/algebra/runtime_polynomial.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// n polynomials in n unknowns as a system. Throws InvalidArgument as SparseSystem does.
inline SparseSystem sparse_system(const RuntimePolynomials<>& equations, const RuntimeSizes& sizes) {
    std::vector<SparseTerm> terms;
    int i = 0;
    for (const auto& f : equations) {
        for (const auto& t : f.terms())
            terms.push_back({i, SparseMonomial(codes_of(t.monomial, sizes)), t.coefficient});
        ++i;
    }
    return {sizes, std::move(terms)};
}

namespace detail {

/// Makes a model's parameters, as symbolic scalars, those that are coordinates: number active[k] is scales[k] times the
/// coordinate first + k.
template <class C>
void set_active(auto& parameters, const RuntimePool<C>& pool, std::span<const int> active,
                std::span<const double> scales, int first) {
    for (std::size_t k = 0; k < active.size(); ++k)
        parameters[active[k]] = RuntimeScalar<C>::coordinate(pool, first + static_cast<int>(k), C(scales[k]));
}
/// Throws InvalidArgument where a model of so many unknowns has no coordinates left for its active parameters.
inline void require_coordinates_left(int unknowns, std::span<const int> active, int first) {
    require(first + static_cast<int>(active.size()) < most_coordinates, "unknowns of the model", unknowns,
            "must be fewer: a critical system has at most 48 coordinates");
}
/// Throws InvalidArgument where the active parameters do not enter as polynomials.
template <class C>
void require_polynomial(const RuntimePolynomials<C>& equations, std::span<const int> active) {
    for (const auto& equation : equations)
        require(equation.fault() == NotPolynomial::no, "active parameters", active.size(),
                "must enter the model's equations as polynomials");
}

}  // namespace detail

/// The equations of a model at p, but for the parameters number `active`, of which number k is `scales[k]` times the
/// coordinate first + k. Throws InvalidArgument where there are more unknowns than a RuntimePolynomial has, or the
/// active parameters do not enter as polynomials.
template <Model M, class C>
RuntimePolynomials<C> model_polynomials(const RuntimeArray<double>& p, std::span<const int> active,
                                        std::span<const double> scales, int first) {
    require(n_angles<M> <= most_angles, "angles of the model", n_angles<M>, "must be at most 16");
    detail::require_coordinates_left(n_unknowns<M>, active, first);
    const auto f = detail::symbolic_equations_of<M, C>([&](const RuntimePool<C>& pool) {
        Parameters<M, RuntimeScalar<C>> q;
        for (int k = 0; k < q.size(); ++k) q[k] = C(p[k]);
        detail::set_active<C>(q, pool, active, scales, first);
        return q;
    });
    detail::require_polynomial(f, active);
    return f;
}

/// The polynomials of a model as an object, whatever the model.
class ModelPolynomials {
public:
    virtual ~ModelPolynomials() = default;

    const RuntimeSizes& sizes() const { return sizes_; }   ///< numbers of angles and coordinates
    bool has_potential() const { return has_potential_; }  ///< whether the equations are the gradient of a potential
    /// Whether F(-theta) = -F(theta), of angles alone.
    bool reflection_symmetric() const { return reflection_symmetric_; }
    /// Those at which the support was found.
    const RuntimeArray<double>& generic_parameters() const { return generic_parameters_; }

    /// See model_polynomials.
    virtual RuntimePolynomials<> equations(const RuntimeArray<double>& p, std::span<const int> active,
                                           std::span<const double> scales, int first) const = 0;

protected:
    /// What the four functions above return.
    ModelPolynomials(const RuntimeSizes& sizes, bool has_potential, bool reflection_symmetric,
                     RuntimeArray<double> generic)
        : sizes_(sizes), has_potential_(has_potential), reflection_symmetric_(reflection_symmetric),
          generic_parameters_(std::move(generic)) {}

private:
    RuntimeSizes sizes_;
    bool has_potential_, reflection_symmetric_;
    RuntimeArray<double> generic_parameters_;
};

/// The polynomials of a Model, known from its type alone.
template <Model M>
class PolynomialsOf final : public ModelPolynomials {
public:
    PolynomialsOf()
        : ModelPolynomials(Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric,
                           runtime_array(detail::generic_parameters<M>())) {}

    RuntimePolynomials<> equations(const RuntimeArray<double>& p, std::span<const int> active,
                                   std::span<const double> scales, int first) const override {
        return model_polynomials<M, double>(p, active, scales, first);
    }
};

/// What all calls for the model M share.
template <Model M>
const ModelPolynomials& polynomials_of() {
    static const PolynomialsOf<M> polynomials;
    return polynomials;
}

}  // namespace equilibria
