/// \file
/// The polynomials of a model at run time as ModelPolynomials.
#pragma once

#include <cstddef>
#include <span>

#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/system/model_polynomials.hpp>
#include <equilibria/system/runtime_formulation.hpp>

namespace equilibria {

template <RuntimeModel T>
class RuntimeModelPolynomials final : public ModelPolynomials {
public:
    explicit RuntimeModelPolynomials(const T& model) : RuntimeModelPolynomials(model, RuntimeFormulation(model)) {}

    RuntimePolynomials<> equations(const RuntimeArray<double>& p, std::span<const int> active,
                                   std::span<const double> scales, int first) const override {
        require(first + static_cast<int>(active.size()) < most_coordinates, "unknowns of the model", sizes().unknowns,
                "must be fewer: a critical system has at most 48 coordinates");
        using Scalar = SymbolicScalar<most_angles, most_coordinates, double>;
        const auto f = detail::symbolic_equations_of<double>(model_, [&](typename Scalar::Pool* pool) {
            RuntimeArray<Scalar> y(p.size());
            for (int k = 0; k < y.size(); ++k) y[k] = Scalar(p[k]);
            for (std::size_t k = 0; k < active.size(); ++k)
                y[active[k]] =
                    Scalar(pool, coordinate_polynomial(first + static_cast<int>(k)) * RuntimePolynomial<>(scales[k]));
            return y;
        });
        for (const auto& equation : f)
            require(equation.fault() == NotPolynomial::no, "active parameters", active.size(),
                    "must enter the model's equations as polynomials");
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
