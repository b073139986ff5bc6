/// \file
/// Whether a problem's derivatives are what they promise: against central differences.
#pragma once

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// How far a problem's functions are from what they promise, along one direction; see check_derivatives.
struct DerivativeErrors {
    double tangent = 0;               ///< |K v - difference of g| over their size
    double symmetry = 0;              ///< |K v - K^T v| over |K v|; 0 where no symmetry is promised
    double parameter_derivative = 0;  ///< of dg/dp
    // 0 where the problem gives none
    double tangent_derivative = 0;           ///< of dK along v
    double parameter_derivative_along = 0;   ///< of d(dg/dp) along v
    double second_parameter_derivative = 0;  ///< of d2g/dp2
};

/// Of a problem of any type, see below.
template <class Matrix>
DerivativeErrors check_derivatives(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p,
                                   double tolerance);

/// Compares the derivatives of a problem with central differences along a fixed direction without zeros. Throws
/// InvalidArgument that names the function where a value is not finite, a size does not fit, an error is above
/// `tolerance` or constraints are redundant: their gradients, the rows of K of the multipliers, dependent at q.
template <ContinuationProblem P>
DerivativeErrors check_derivatives(const P& problem, const Configuration<P>& q, double p, double tolerance = 1e-4) {
    return check_derivatives(AnyProblemOf<P>(problem), AnyConfiguration::of(q), p, tolerance);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/check_derivatives_definitions.hpp>
#endif
