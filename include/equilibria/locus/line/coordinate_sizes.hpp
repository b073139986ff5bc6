/// \file
/// About how large the coordinates of a model's equilibria are.
#pragma once

#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// The largest absolute value of each coordinate at these equilibria of a model with coordinates, each angles first.
/// One that is below 1e-6 of the unit that the equations' coefficients at p suggest (unit_scaling) is 0 but for
/// rounding: that unit takes its place, or 1 where an equation loses its unknowns at p.
std::vector<double> coordinate_sizes(const SearchedModel& model, const RuntimeArray<double>& p,
                                     std::span<const RuntimeArray<double>> equilibria);

/// The sizes at the equilibria that the model counts at these points of the parameter space, one or more.
std::vector<double> coordinate_sizes(const SearchedModel& model, std::span<const RuntimeArray<double>> points,
                                     const RunOptions& run);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/line/detail/coordinate_sizes_definitions.hpp>
#endif
