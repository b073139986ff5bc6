/// \file
/// From records of paths to distinct roots: endpoints that are one point are one root.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/paths/path_set.hpp>

namespace equilibria {

/// How many roots the paths have found if no two of them found the same.
std::uint64_t most_roots(PathSet& paths);

/// The distinct roots, one after the other: take(root) is called in the order of the tracked paths, a mirror image
/// after its original; roots that are their own mirror images come last.
void merge(PathSet& paths, const std::function<void(Root<RuntimeUnknowns>)>& take);
/// The distinct roots, by path number.
std::vector<Root<RuntimeUnknowns>> merge(PathSet& paths);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/merge_definitions.hpp>
#endif
