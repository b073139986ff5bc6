/// \file
/// Whether a system has a solution next to a point, on a curve of solutions or alone.
#pragma once

#include <complex>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/laurent_column.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// True if the target (`to` of the columns) has a solution next to z, by steps of least length with 31 digits that move
/// no unknown by more than `most` of its size: on a curve of solutions, to its rounding; a near miss is none.
bool has_solution_near(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns,
                       const std::vector<std::complex<double>>& z, double most);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/homotopy/detail/nearby_solution_definitions.hpp>
#endif
