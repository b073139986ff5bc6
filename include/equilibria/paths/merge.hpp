/// \file
/// From records of paths to distinct roots: endpoints that are one point are one root.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
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

/// The same in the unknowns of a model, which are as many.
template <class M, std::invocable<const Root<M>&> Take>
void merge(PathSet& paths, Take&& take) {
    merge(paths, std::function<void(Root<RuntimeUnknowns>)>(
                     [&](Root<RuntimeUnknowns> root) { take(typed<M>(std::move(root))); }));
}
template <class M>
[[gnu::cold]] std::vector<Root<M>> merge(PathSet& paths) {
    std::vector<Root<M>> roots;
    roots.reserve(static_cast<std::size_t>(most_roots(paths)));
    merge<M>(paths, [&](Root<M> root) { roots.push_back(std::move(root)); });
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return roots;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/merge_definitions.hpp>
#endif
