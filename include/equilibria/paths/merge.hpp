/// \file
/// From records of paths to distinct roots: endpoints that are one point are one root.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <vector>

#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/path_set.hpp>

namespace equilibria {

namespace detail {

/// Which records are the same root. 9 bytes a record.
template <class M>
class MergedPaths {
public:
    explicit MergedPaths(PathSet<M>& paths)
        : paths_(&paths), merged_(paths.size()), others_(paths.size()), winding_(paths.size()) {
        for (std::size_t k = 0; k < paths.size(); ++k)
            if (paths.finished(k)) winding_[k] = paths[k].winding_number;
        merge(PathStatus::finite, 1e-9);
        merge(PathStatus::singular, 1e-5);
    }

    /// Calls take(root) for each root, in the order of the tracked paths, a mirror image after its original; those that
    /// rest come last.
    template <class Take>
    void for_each(Take&& take) {
        PathSet<M>& paths = *paths_;
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (merged_[k] || !paths.finished(k)) continue;
            const Endpoint<M>& end = paths[k];
            if (end.status != PathStatus::finite && end.status != PathStatus::singular) continue;
            Root<M> root = root_of(end, paths.path(k));
            root.paths += others_[k];
            root.winding_number = winding_[k];
            take(root);
            if (paths.weight(k) == 2) take(reflected(root, paths.mirror(root.path)));
        }
    }

private:
    void merge(PathStatus status, double tolerance) {
        PathSet<M>& paths = *paths_;
        const auto point = [&](std::size_t k) -> const Point<M, double>* {
            if (!paths.finished(k)) return nullptr;
            const Endpoint<M>& end = paths[k];
            return end.status == status ? &end.q : nullptr;
        };
        for (const auto& group : CoincidenceFinder<M>(paths.symmetric()).groups(paths.size(), point, tolerance)) {
            // a root that rests, its own mirror image, stands for the group; else the first path
            const std::size_t leader = paths.rests(group.back()) ? group.back() : group.front();
            for (const std::size_t k : group) {
                if (k == leader) continue;
                merged_[k] = 1;
                others_[leader] += paths.rests(leader) ? static_cast<std::int32_t>(paths.weight(k)) : 1;
                winding_[leader] = std::max(winding_[leader], winding_[k]);
            }
        }
    }

    PathSet<M>* paths_;
    std::vector<std::uint8_t> merged_;
    std::vector<std::int32_t> others_, winding_;
};

}  // namespace detail

/// The distinct roots, one after the other: take(root) is called in the order of the tracked paths, a mirror image
/// after its original; roots that are their own mirror images come last.
template <class M, std::invocable<const Root<M>&> Take>
void merge(PathSet<M>& paths, Take&& take) {
    detail::MergedPaths<M>(paths).for_each(take);
}

/// The distinct roots, by path number.
template <class M>
std::vector<Root<M>> merge(PathSet<M>& paths) {
    std::vector<Root<M>> roots;
    merge(paths, [&](const Root<M>& root) { roots.push_back(root); });
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return roots;
}

}  // namespace equilibria
