/// \file
/// Points that coincide.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria::detail {

/// Groups of two or more numbers of points that are within `tolerance` of each other, relative to their size. Each
/// group is sorted, and so are the groups.
std::vector<std::vector<std::size_t>> coincident(std::span<const RuntimePoint<double>> points, double tolerance);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/coincidence_definitions.hpp>
#endif
