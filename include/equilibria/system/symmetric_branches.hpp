/// \file
/// The symmetric branches of a model, theta in {0, pi}^n where it has the symmetry theta -> -theta, and the pitchforks
/// on them: det J restricted to a branch is a polynomial of known degree in a parameter; interpolated at Chebyshev
/// points, its roots are eigenvalues of the colleague matrix. Source: Good, The colleague matrix, 1961; Trefethen,
/// Approximation Theory and Approximation Practice, chapter 18.
#pragma once

#include <functional>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/system/model_polynomials.hpp>

namespace equilibria {

/// The symmetric branches of a model; none where it lacks the symmetry.
std::vector<RuntimeArray<double>> symmetric_branches(const ModelPolynomials& model);

/// Whether q lies on a symmetric branch, to within `tolerance` in the sines.
bool on_symmetric_branch(const ModelPolynomials& model, const RuntimeArray<double>& q, double tolerance = 1e-6);

/// The real roots in [low, high] of a polynomial of degree at most `degree`, from its values. None where the values are
/// rounding of zero throughout.
std::vector<double> polynomial_roots(const std::function<double(double)>& f, int degree, double low, double high);

/// Where J is singular on a symmetric branch, with the parameter number `active` in a range, the others those of p.
/// degree: of the equations in that parameter.
std::vector<double> singular_points_of_branch(const ModelDerivatives<>& functions, const RuntimeArray<double>& branch,
                                              RuntimeArray<double> p, int active, int degree, const Interval& range);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/symmetric_branches_definitions.hpp>
#endif
