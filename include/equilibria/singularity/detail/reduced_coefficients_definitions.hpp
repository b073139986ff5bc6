/// \file
/// See singularity/reduced_coefficients.hpp.
#pragma once

#include <limits>

#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

EQUILIBRIA_INLINE ReducedCoefficients reduced_coefficients(const ModelFunctions<>& functions,
                                                           const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                                           const RuntimeArray<double>& p) {
    const auto u = functions.has_potential() ? v : left_null_vector(jacobian(functions, q, p), v, false);
    const auto series = reduced_series<double, double>(functions, 3, q, v, u, p);
    if (series.regular) return {series.derivative(3), series.derivative(4)};
    const auto second = directional_derivative(functions, 2, q, v, p);
    return {detail::dot(u, second), std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace equilibria
