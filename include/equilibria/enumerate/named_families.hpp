/// \file
/// Curves and surfaces of solutions of a system, named by dimension, degree and a point of each.
///
/// Every curve is met by paths of the total degree. Its degree is the number of points in which a generic hyperplane
/// meets it: the solutions of generic combinations of the equations and of that hyperplane, among which those count
/// that fulfil all equations. Source: A. J. Sommese, C. W. Wampler, The Numerical Solution of Systems of Polynomials
/// Arising in Engineering and Science, World Scientific (2005), chapters 13 and 15.
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria::detail {

/// Families of which a second point is a solution to 31 digits, as a near miss is not; the others are dropped, and
/// on_one says so. roots: those that `found` is of.
void keep_families(const SparseSystem& system, const std::vector<Root<RuntimeUnknowns>>& roots, FoundFamilies& found);

/// The families that these suspects, and singular ends of paths from the total degree, lie on; on_one: of the suspects.
/// most_paths: above so many paths the total degree is not tracked. Degrees are counted of systems without angles.
FoundFamilies name_families(const SparseSystem& system, const std::vector<Root<RuntimeUnknowns>>& suspects,
                            const RunOptions& run, const TrackerOptions& options, std::uint64_t most_paths);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/named_families_definitions.hpp>
#endif
