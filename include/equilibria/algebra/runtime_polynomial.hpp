/// \file
/// Trigonometric polynomials of one type for all numbers of unknowns: what is made at run time.
#pragma once

#include <cstddef>
#include <vector>

#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The sizes of the polynomials made at run time: models may have so many angles and coordinates, and most have fewer.
inline constexpr int most_angles = 16;       ///< highest number of angles
inline constexpr int most_coordinates = 48;  ///< highest number of coordinates
/// A polynomial in at most so many angles and coordinates, with coefficients of type C.
template <class C = double>
using RuntimePolynomial = TrigonometricPolynomial<most_angles, most_coordinates, C>;
/// A polynomial for each equation.
template <class C = double>
using RuntimePolynomials = std::vector<RuntimePolynomial<C>>;

/// The coordinate number j.
template <class C = double>
RuntimePolynomial<C> coordinate_polynomial(int j) {
    return {RuntimePolynomial<C>::Basis::single(most_angles + j, 1), C(1)};
}

/// The code of each unknown of a system of these sizes.
inline std::vector<int> codes_of(const Monomial<most_angles, most_coordinates>& monomial, const RuntimeSizes& sizes) {
    std::vector<int> codes;
    codes.reserve(static_cast<std::size_t>(sizes.unknowns));
    for (int i = 0; i < sizes.angles; ++i) codes.push_back(monomial.code(i));
    for (int j = 0; j < sizes.coordinates; ++j) codes.push_back(monomial.code(most_angles + j));
    return codes;
}

}  // namespace equilibria
