/// \file
/// All paths of a run, one record each, and the account of them. Nothing here is changed once it is written: counts,
/// failures and roots (merge.hpp) are read off the records.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/storage/endpoint_store.hpp>

namespace equilibria {

/// The records: endpoints of the paths that were tracked, then those of the paths that rest.
template <class M>
class PathSet {
public:
    PathSet(PathNumbering numbering, detail::EndpointStore<M> ends, std::vector<Endpoint<M>> resting)
        : ends_(std::move(ends)), resting_(std::move(resting)), numbering_(std::move(numbering)) {}

    std::size_t size() const { return tracked() + resting_.size(); }
    std::size_t tracked() const { return static_cast<std::size_t>(ends_.size()); }
    /// Record k, valid until the next call but one.
    const Endpoint<M>& operator[](std::size_t k) { return k < tracked() ? ends_[k] : resting_[k - tracked()]; }
    /// False of a path that a cancelled run left.
    bool finished(std::size_t k) const { return k >= tracked() || ends_.finished(k); }
    /// Whether mirror images under theta -> -theta count as the same endpoint.
    bool symmetric() const { return numbering_.symmetric(); }
    bool rests(std::size_t k) const { return k >= tracked(); }
    /// How many paths the record stands for: 2 where a mirror image was not tracked.
    std::uint64_t weight(std::size_t k) const { return rests(k) ? 1 : numbering_.weight(); }
    /// The number of its path, and that of a path's mirror image.
    std::uint64_t path(std::size_t k) const {
        return rests(k) ? numbering_.resting_path(k - tracked()) : numbering_.tracked_path(k);
    }
    std::uint64_t mirror(std::uint64_t path) const { return numbering_.mirror(path); }

    /// What the run did beside tracking each path once.
    struct Effort {
        std::uint64_t retracked = 0, crossed = 0, more_digits = 0;  ///< see PathCounts
        double tracking_seconds = 0;  ///< of the trackers proper, as a share of the time that went by
    };
    Effort effort;

    detail::EndpointStore<M>& ends() { return ends_; }
    const std::vector<Endpoint<M>>& resting() const { return resting_; }

private:
    detail::EndpointStore<M> ends_;
    std::vector<Endpoint<M>> resting_;
    PathNumbering numbering_;
};

namespace detail {

template <class M>
Root<M> root_of(const Endpoint<M>& end, std::uint64_t path) {
    Root<M> root;
    for (int i = 0; i < n_angles<M>; ++i) root.q[i] = angle_of(end.q.c[i], end.q.s[i]);
    for (int j = 0; j < n_coordinates<M>; ++j) root.q[n_angles<M> + j] = {end.q.x[j].re, end.q.x[j].im};
    root.residual = end.evidence.residual;
    root.condition = end.evidence.condition;
    root.path = path;
    root.winding_number = end.winding_number;
    root.status = end.status;
    return root;
}

/// theta -> -theta.
template <class M>
Root<M> reflected(Root<M> root, std::uint64_t path) {
    for (int i = 0; i < n_angles<M>; ++i) {
        const double angle = -root.q[i].real();
        root.q[i] = {angle <= -std::numbers::pi ? std::numbers::pi : angle, -root.q[i].imag()};
    }
    root.path = path;
    return root;
}

}  // namespace detail

/// The account of a set of paths.
template <class M>
struct PathAccount {
    PathCounts counts;
    std::vector<FailedPath<M>> failures;  ///< by path number
};

/// How every path ended. Of a cancelled run the paths that it left are counted as such.
template <class M>
PathAccount<M> account_for(PathSet<M>& paths) {
    PathAccount<M> y;
    PathCounts& counts = y.counts;
    counts.retracked = paths.effort.retracked;
    counts.crossed = paths.effort.crossed;
    counts.more_digits = paths.effort.more_digits;
    counts.tracked = paths.ends().finished();
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const std::uint64_t weight = paths.weight(k);
        counts.total += weight;
        if (!paths.finished(k)) {
            counts.cancelled += weight;
            continue;
        }
        const Endpoint<M>& end = paths[k];
        counts.steps += static_cast<std::uint64_t>(end.steps);
        switch (end.status) {
            case PathStatus::finite: counts.finite += weight; break;
            case PathStatus::at_infinity: counts.at_infinity += weight; break;
            case PathStatus::singular: counts.singular += weight; break;
            case PathStatus::failed: {
                counts.failed += weight;
                const Root<M> at = detail::root_of(end, paths.path(k));
                y.failures.push_back({at.path, end.reason, at.q});
                if (weight == 2) {
                    const Root<M> image = detail::reflected(at, paths.mirror(at.path));
                    y.failures.push_back({image.path, end.reason, image.q});
                }
            }
        }
    }
    std::sort(y.failures.begin(), y.failures.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return y;
}

}  // namespace equilibria
