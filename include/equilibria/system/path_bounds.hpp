/// \file
/// Numbers of Bezout of a system that is data: upper bounds of the number of its isolated complex solutions, and what
/// starts from degrees take in paths. Of a model as a type: algebra/multihomogeneous.hpp, which says what they are.
///
/// They know degrees alone: systems with few of the terms that their degrees allow have far fewer solutions.
#pragma once

#include <span>
#include <vector>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// The product of the equations' degrees, times 2 an angle.
PathCount total_degree_count(const SparseSystem& system);

/// The multihomogeneous number of one grouping: of each unknown its group, numbers from 0, none left out. Throws
/// InvalidArgument where there is no group for each unknown, for a number that is none of a group, and for more groups
/// than can be counted with (see multihomogeneous_number of a model).
PathCount multihomogeneous_number(const SparseSystem& system, std::span<const int> grouping);

/// The smallest number, and the first grouping that has it; fewer groups come first.
GroupingNumber<std::vector<int>> smallest_multihomogeneous_number(const SparseSystem& system);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/path_bounds_definitions.hpp>
#endif
