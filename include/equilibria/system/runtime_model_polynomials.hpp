/// \file
/// The polynomials of a model at run time as ModelPolynomials.
#pragma once

#include <span>

#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/system/model_polynomials.hpp>
#include <equilibria/system/runtime_formulation.hpp>

namespace equilibria {

/// The polynomials of a model of type T, which is copied.
template <RuntimeModel T>
class RuntimeModelPolynomials final : public ModelPolynomials {
public:
    /// Throws InvalidArgument as RuntimeFormulation does.
    explicit RuntimeModelPolynomials(const T& model) : RuntimeModelPolynomials(model, RuntimeFormulation(model)) {}

    RuntimePolynomials<> equations(const RuntimeArray<double>& p, std::span<const int> active,
                                   std::span<const double> scales, int first) const override {
        detail::require_coordinates_left(sizes().unknowns, active, first);
        const auto f = detail::symbolic_equations_of<double>(model_, [&](const RuntimePool<double>& pool) {
            RuntimeArray<RuntimeScalar<>> y(p.size());
            for (int k = 0; k < y.size(); ++k) y[k] = p[k];
            detail::set_active<double>(y, pool, active, scales, first);
            return y;
        });
        detail::require_polynomial(f, active);
        return f;
    }

private:
    RuntimeModelPolynomials(const T& model, const RuntimeFormulation& formulation)
        : ModelPolynomials(formulation.sizes(), formulation.has_potential(), formulation.reflection_symmetric(),
                           RuntimeFormulation::generic_parameters(model.parameters())),
          model_(model) {}

    T model_;
};

}  // namespace equilibria
