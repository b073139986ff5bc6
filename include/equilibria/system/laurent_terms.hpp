/// \file
/// A system that is data as a Laurent system in z_u = exp(i theta_u), with its coordinates as they are.
#pragma once

#include <complex>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {
/// What a product of factors is a sum of: exponents, and with which coefficient.
std::vector<PolynomialTerm<std::complex<double>>> laurent_products(const SparseMonomial& monomial,
                                                                   const RuntimeSizes& sizes);
}  // namespace detail

/// The terms of each equation: exponents of z_1 .. z_n, then of the coordinates. Terms whose coefficient is rounding,
/// beside what cancels in it, are left out: cos(theta_1 - theta_2), a sum of two products, has two exponents, not four.
std::vector<std::vector<PolynomialTerm<std::complex<double>>>> laurent_terms(const SparseSystem& system);

/// The exponents alone. Their mixed volume bounds the isolated solutions with no coordinate 0 (Bernstein, The number of
/// roots of a system of equations, Funct. Anal. Appl. 9 (1975)).
Supports laurent_supports(const SparseSystem& system);

/// The same, with the exponent 0 added to each equation where solutions with a coordinate 0 cannot be ruled out: their
/// mixed volume bounds all isolated solutions (Li, Wang, The BKK root count in C^n, Math. Comp. 65 (1996)). They are
/// ruled out where, whichever coordinates are 0, an equation has a single term left.
Supports affine_supports(const SparseSystem& system);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/laurent_terms_definitions.hpp>
#endif
