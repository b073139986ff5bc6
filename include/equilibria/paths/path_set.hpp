/// \file
/// All paths of a run, one record each, and the account of them. Nothing here is changed once it is written: counts,
/// failures and roots (merge.hpp) are read off the records.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/storage/key_files.hpp>

namespace equilibria {

namespace detail {
class EndpointStore;
}

/// The records: endpoints of the paths that were tracked, then those of the paths that rest.
class PathSet {
public:
    /// The endpoints of the tracked paths in the order of the numbering, and of those that rest.
    PathSet(PathNumbering numbering, detail::EndpointStore ends, std::vector<Endpoint> resting);
    /// Moves alone: the records may be gigabytes.
    /// \{
    PathSet(PathSet&&) noexcept;
    PathSet& operator=(PathSet&&) noexcept;
    /// \}
    ~PathSet();

    const RuntimeSizes& sizes() const;  ///< numbers of angles and coordinates

    std::size_t size() const { return tracked() + resting_.size(); }  ///< number of records
    std::size_t tracked() const;                                      ///< how many of them are of tracked paths
    /// Record k, valid until the next call but one.
    const Endpoint& operator[](std::size_t k);
    /// The same, without its point.
    EndpointRecord record(std::size_t k);
    PathStatus status(std::size_t k) { return record(k).status; }  ///< how the path of record k ended
    /// The point of record k, valid as long as the record.
    PointView point(std::size_t k);
    /// False of a path that a cancelled run left.
    bool finished(std::size_t k) const;
    /// Whether mirror images under theta -> -theta count as the same endpoint.
    bool symmetric() const { return numbering_.symmetric(); }
    bool rests(std::size_t k) const { return k >= tracked(); }  ///< whether the path of record k rests at every t
    /// How many paths the record stands for: 2 where a mirror image was not tracked.
    std::uint64_t weight(std::size_t k) const { return rests(k) ? 1 : numbering_.weight(); }
    /// The number of the path of record k.
    std::uint64_t path(std::size_t k) const {
        return rests(k) ? numbering_.resting_path(k - tracked()) : numbering_.tracked_path(k);
    }
    /// The number of that path's mirror image.
    std::uint64_t mirror(std::uint64_t path) const { return numbering_.mirror(path); }

    /// What the run did beside tracking each path once.
    struct Effort {
        std::uint64_t retracked = 0;    ///< see PathCounts
        std::uint64_t crossed = 0;      ///< see PathCounts
        std::uint64_t more_digits = 0;  ///< see PathCounts
        double tracking_seconds = 0;    ///< of the trackers proper, as a share of the time that went by
    };
    Effort effort;  ///< of this run
    /// How much memory is for keys, and beside which file they go beyond that.
    detail::KeyLimits key_limits;
    /// Whether the finite endpoints are known to be different from one another.
    bool apart = false;

    detail::EndpointStore& ends() { return *ends_; }                   ///< the store of the tracked paths' endpoints
    const std::vector<Endpoint>& resting() const { return resting_; }  ///< endpoints of the paths that rest

private:
    std::unique_ptr<detail::EndpointStore> ends_;
    std::vector<Endpoint> resting_;
    PathNumbering numbering_;
};

/// Where a path ended, as a root: whatever its status is.
Root<RuntimeUnknowns> root_of(const PointView& at, const EndpointRecord& end, std::uint64_t path);

namespace detail {
/// The same but for its angles, which are left 0.
Root<RuntimeUnknowns> root_without_angles(const PointView& at, const EndpointRecord& end, std::uint64_t path);
/// theta -> -theta, of roots whose unknowns are angles alone.
Root<RuntimeUnknowns> reflected(Root<RuntimeUnknowns> root, std::uint64_t path);
}  // namespace detail

/// The account of a set of paths.
struct PathAccount {
    PathCounts counts;                                  ///< how many ended how
    std::vector<FailedPath<RuntimeUnknowns>> failures;  ///< by path number
};

/// How every path ended. Of a cancelled run the paths that it left are counted as such.
PathAccount account_for(PathSet& paths);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/path_set_definitions.hpp>
#endif
