/// \file
/// See paths/merge.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <equilibria/paths/detail/coincidence_finder.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/paths/path_set.hpp>

namespace equilibria {

namespace detail {

constexpr bool is_root(PathStatus status) { return status == PathStatus::finite || status == PathStatus::singular; }

/// Which records are the same root. 9 bytes a record.
class MergedPaths {
public:
    explicit MergedPaths(PathSet& paths)
        : paths_(&paths), merged_(paths.size()), others_(paths.size()), winding_(paths.size()) {
        bool singular = false;
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (!paths.finished(k)) continue;
            const Endpoint& end = paths[k];
            winding_[k] = end.winding_number;
            singular |= end.status == PathStatus::singular;
        }
        merge(PathStatus::finite, 1e-9);
        if (singular) merge(PathStatus::singular, 1e-5);
    }

    /// Calls take(root) for each root, in the order of the tracked paths, a mirror image after its original; those that
    /// rest come last.
    void for_each(const auto& take) {
        PathSet& paths = *paths_;
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (merged_[k] || !paths.finished(k)) continue;
            const Endpoint& end = paths[k];
            if (!is_root(end.status)) continue;
            Root<RuntimeUnknowns> root = root_of(end, paths.path(k));
            root.paths += others_[k];
            root.winding_number = winding_[k];
            if (paths.weight(k) == 2) {
                auto image = reflected(root, paths.mirror(root.path));
                take(std::move(root));
                take(std::move(image));
            } else {
                take(std::move(root));
            }
        }
    }

private:
    void merge(PathStatus status, double tolerance) {
        PathSet& paths = *paths_;
        const auto point = [&](std::size_t k) -> const RuntimePoint<double>* {
            if (!paths.finished(k)) return nullptr;
            const Endpoint& end = paths[k];
            return end.status == status ? &end.q : nullptr;
        };
        for (const auto& group :
             CoincidenceFinder(paths.symmetric(), paths.sizes()).groups(paths.size(), point, tolerance)) {
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

    PathSet* paths_;
    std::vector<std::uint8_t> merged_;
    std::vector<std::int32_t> others_, winding_;
};

}  // namespace detail

EQUILIBRIA_INLINE std::uint64_t most_roots(PathSet& paths) {
    std::uint64_t y = 0;
    for (std::size_t k = 0; k < paths.size(); ++k)
        if (paths.finished(k) && detail::is_root(paths[k].status)) y += paths.weight(k);
    return y;
}

EQUILIBRIA_INLINE void merge(PathSet& paths, const std::function<void(Root<RuntimeUnknowns>)>& take) {
    detail::MergedPaths(paths).for_each(take);
}

EQUILIBRIA_INLINE std::vector<Root<RuntimeUnknowns>> merge(PathSet& paths) {
    std::vector<Root<RuntimeUnknowns>> roots;
    roots.reserve(static_cast<std::size_t>(most_roots(paths)));
    detail::MergedPaths(paths).for_each([&](Root<RuntimeUnknowns> root) { roots.push_back(std::move(root)); });
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return roots;
}

}  // namespace equilibria
