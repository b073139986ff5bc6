/// \file
/// See paths/merge.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <equilibria/evaluation/angles.hpp>
#include <equilibria/paths/detail/coincidence_finder.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/paths/path_set.hpp>

namespace equilibria {

namespace detail {

constexpr bool is_root(PathStatus status) { return status == PathStatus::finite || status == PathStatus::singular; }

/// Roots that wait for their angles, which are computed in lanes.
class AngleLanes {
public:
    explicit AngleLanes(const RuntimeSizes& sizes) : c_(sizes.angles), s_(sizes.angles) {
        for (auto* part : {&c_, &s_})
            for (Complex<Pack>& z : *part) z = Complex<Pack>(1.0);
    }
    bool full() const { return waiting_.size() == native_lanes; }
    /// A root without angles, at this point; weight: as of PathSet.
    void add(Root<RuntimeUnknowns> root, const PointView& point, std::uint64_t weight) {
        const int l = static_cast<int>(waiting_.size());
        for (int i = 0; i < c_.size(); ++i) {
            const auto from = static_cast<std::size_t>(i);
            set_lane(c_[i].re, l, point.c[from].re), set_lane(c_[i].im, l, point.c[from].im);
            set_lane(s_[i].re, l, point.s[from].re), set_lane(s_[i].im, l, point.s[from].im);
        }
        waiting_.push_back({std::move(root), weight});
    }
    /// Calls take(root, weight) for each, with its angles; none waits any more.
    void flush(const auto& take) {
        for (int i = 0; i < c_.size(); ++i) {
            const Complex<Pack> angle = angle_of(c_[i], s_[i]);
            int l = 0;
            for (auto& [root, weight] : waiting_) root.q[i] = {lane(angle.re, l), lane(angle.im, l)}, ++l;
        }
        for (auto& [root, weight] : waiting_) take(std::move(root), weight);
        waiting_.clear();
    }

private:
    using Pack = Lanes<native_lanes>;
    struct Waiting {
        Root<RuntimeUnknowns> root;
        std::uint64_t weight;
    };
    RuntimeArray<Complex<Pack>> c_, s_;
    std::vector<Waiting> waiting_;
};

/// Which records are the same root. A bit a record, and more for those that others are merged with.
class MergedPaths {
public:
    explicit MergedPaths(PathSet& paths) : paths_(&paths), merged_(paths.size()) {
        if (!paths.apart) merge(PathStatus::finite, 1e-9);
        for (std::size_t k = 0; k < paths.size(); ++k)
            if (paths.finished(k) && paths.status(k) == PathStatus::singular) {
                merge(PathStatus::singular, 1e-5);
                break;
            }
    }

    /// Calls take(root) for each root, in the order of the tracked paths, a mirror image after its original; those that
    /// rest come last.
    void for_each(const auto& take) {
        PathSet& paths = *paths_;
        AngleLanes lanes(paths.sizes());
        const auto with_image = [&](Root<RuntimeUnknowns> root, std::uint64_t weight) {
            if (weight == 2) {
                auto image = reflected(root, paths.mirror(root.path));
                take(std::move(root));
                take(std::move(image));
            } else {
                take(std::move(root));
            }
        };
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (merged_[k] || !paths.finished(k)) continue;
            const EndpointRecord end = paths.record(k);
            if (!is_root(end.status)) continue;
            const PointView point = paths.point(k);
            Root<RuntimeUnknowns> root = root_without_angles(point, end, paths.path(k));
            if (const auto at = leaders_.find(k); at != leaders_.end()) {
                root.paths += at->second.others;
                root.winding_number = std::max(root.winding_number, at->second.winding_number);
            }
            lanes.add(std::move(root), point, paths.weight(k));
            if (lanes.full()) lanes.flush(with_image);
        }
        lanes.flush(with_image);
    }

private:
    void merge(PathStatus status, double tolerance) {
        PathSet& paths = *paths_;
        const auto point = [&](std::size_t k) {
            return paths.finished(k) && paths.status(k) == status ? paths.point(k) : PointView();
        };
        for (const auto& group : CoincidenceFinder(paths.symmetric(), paths.sizes(), paths.key_limits)
                                     .groups(paths.size(), point, tolerance)) {
            // a root that rests, its own mirror image, stands for the group; else the first path
            const std::size_t leader = paths.rests(group.back()) ? group.back() : group.front();
            Others& others = leaders_[leader];
            for (const std::size_t k : group) {
                if (k == leader) continue;
                merged_[k] = true;
                others.others += paths.rests(leader) ? static_cast<std::int32_t>(paths.weight(k)) : 1;
                others.winding_number = std::max<std::int32_t>(others.winding_number, paths.record(k).winding_number);
            }
        }
    }

    struct Others {
        std::int32_t others = 0, winding_number = 1;  ///< how many, and the largest of theirs
    };

    PathSet* paths_;
    std::vector<bool> merged_;
    std::unordered_map<std::size_t, Others> leaders_;
};

}  // namespace detail

EQUILIBRIA_INLINE std::uint64_t most_roots(PathSet& paths) {
    std::uint64_t y = 0;
    for (std::size_t k = 0; k < paths.size(); ++k)
        if (paths.finished(k) && detail::is_root(paths.status(k))) y += paths.weight(k);
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
