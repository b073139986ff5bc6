/// \file
/// Points of a parameter space, by number: grids, random ones, lists.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria {

/// Any generator of points: `at(k)` for k < size gives all parameters of the model, and the same ones each time.
struct ParameterPoints {
    std::uint64_t size = 0;                                   ///< how many points
    std::function<RuntimeArray<double>(std::uint64_t k)> at;  ///< the parameters of point k, from 0
};

/// A parameter that is varied, by its number in the model, from `low` to `high`.
struct VariedParameter {
    int parameter = 0;        ///< its number in the model
    double low = 0;           ///< first value, or the box's edge
    double high = 1;          ///< last value, or the box's other edge
    std::uint64_t count = 2;  ///< of a grid: values, both ends among them; 1: low alone
};

/// A grid, the last axis fastest; the other parameters are those of `fixed`. Throws InvalidArgument for an axis without
/// values, or of a parameter that is not there.
ParameterPoints parameter_grid(const RuntimeArray<double>& fixed, const std::vector<VariedParameter>& axes);

/// So many points, uniform in the box of the axes, each from the seed and its own number.
ParameterPoints random_parameters(const RuntimeArray<double>& fixed, const std::vector<VariedParameter>& axes,
                                  std::uint64_t size, std::uint64_t seed);

/// Points from the text of a CSV file: the first line names the columns, `parameter_of` says which parameter a name is
/// (-1: of none, which is refused). Spaces around values do not count; lines that are empty are no points. Throws
/// InvalidArgument with line and column for what is no finite number, for lines of another length and for names twice.
ParameterPoints listed_parameters(const std::string& csv, const RuntimeArray<double>& fixed,
                                  const std::function<int(const std::string& name)>& parameter_of);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/parameter_points_definitions.hpp>
#endif
