/// \file
/// A solution of a system next to a point, on a curve of solutions or alone.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/laurent_column.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The solution of the target (`to` of the columns) that steps of least length with 31 digits lead to from z, rounded
/// to doubles; angles as exp(i t). On a curve of solutions it is one of them, to its rounding. Coordinates below
/// `small` begin at 0. Nothing where the steps do not converge, or move the unknowns by more than `most` of their sizes
/// in sum.
std::optional<std::vector<std::complex<double>>> nearby_solution(const RuntimeSizes& sizes,
                                                                 const std::vector<LaurentColumn>& columns,
                                                                 const std::vector<std::complex<double>>& z,
                                                                 double most, double small = 1e-6);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/homotopy/detail/nearby_solution_definitions.hpp>
#endif
