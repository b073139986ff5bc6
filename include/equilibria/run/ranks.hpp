/// \file
/// Processes that do one run together, on one machine or on many. Each makes the same calls with the same arguments;
/// what they share is the blocks of the loops that take long, whose results are bytes. By default there is one process;
/// over MPI: enumerate/mpi.hpp.
///
/// No result depends on how many there are, nor on which of them did a block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria {

/// What another rank threw, or that the ranks do not do the same run.
class RankError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Ranks are copied freely, and are numbered from 0. By default there is one.
class Ranks {
public:
    using Bytes = std::vector<std::uint8_t>;          ///< what a block gave
    using BytesView = std::span<const std::uint8_t>;  ///< bytes that are read, not owned

    /// A loop over the blocks 0 .. size - 1.
    struct Loop {
        std::size_t size = 0;  ///< how many blocks
        /// Asked at rank 0, of all blocks before any begins: whether it has the block already.
        std::function<bool(std::size_t block)> done;
        std::function<Bytes(std::size_t block)> work;                  ///< at any rank, from any thread
        std::function<void(std::size_t block, BytesView bytes)> take;  ///< at rank 0, one call at a time
        std::function<bool()> cancelled;                               ///< at any rank: no more blocks are begun then
    };

    /// What ranks of one's own derive from. All functions are collective: each rank calls them, in the same order.
    class Backend {
    public:
        virtual ~Backend() = default;
        virtual int rank() const = 0;  ///< this one, from 0
        virtual int size() const = 0;  ///< how many there are
        /// Does the blocks that are not done, each once. `executor` does those of this rank. The first exception is
        /// thrown by the rank where it arose, and as a RankError by the others.
        virtual void for_blocks(const Loop& loop, const Executor& executor) const = 0;
        /// What rank 0 has, for all.
        virtual void broadcast(Bytes& bytes) const = 0;
        /// What each rank has, in the order of the ranks, for all.
        virtual std::vector<Bytes> gather(const Bytes& own) const = 0;
    };

    Ranks() = default;
    /// With a backend of one's own; null: one rank.
    explicit Ranks(std::shared_ptr<const Backend> backend) : backend_(std::move(backend)) {}

    int rank() const { return backend_ ? backend_->rank() : 0; }  ///< this one, from 0
    int size() const { return backend_ ? backend_->size() : 1; }  ///< how many there are
    /// Whether this is rank 0: the one that writes files, and tells what was found.
    bool first() const { return rank() == 0; }
    /// Whether there are others.
    bool several() const { return size() > 1; }

    /// Does a loop's blocks; rank 0 has taken them all afterwards, but for those left by a cancelled run.
    void for_blocks(const Loop& loop, const Executor& executor) const;
    /// Calls work(block) for each block, at some rank, and gives every other rank what that did: give(block, to)
    /// appends it where that has been done, take(block, bytes) gets it.
    void for_blocks_at_all(std::size_t size, const Executor& executor, const std::function<void(std::size_t)>& work,
                           const std::function<void(std::size_t, Bytes&)>& give,
                           const std::function<void(std::size_t, BytesView)>& take) const;
    /// Gives every rank what rank 0 has: give(block, to) appends it there, take(block, bytes) gets it at the others.
    /// Only blocks for which has(block) at rank 0.
    void share(std::size_t size, const std::function<bool(std::size_t)>& has,
               const std::function<void(std::size_t, Bytes&)>& give,
               const std::function<void(std::size_t, BytesView)>& take) const;
    /// Does at rank 0 what the others wait for. Where that throws all throw: the others a RankError.
    void at_first(const std::function<void()>& act) const;
    /// Rank 0's number.
    std::uint64_t of_first(std::uint64_t own) const;
    /// Sums over the ranks, in place.
    void add_up(std::span<std::uint64_t> numbers) const;
    /// Whether any rank says so.
    bool any(bool own) const;
    /// The texts of all ranks where they are not all the same; else nothing.
    std::vector<std::string> differing(const std::string& own) const;

private:
    std::shared_ptr<const Backend> backend_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/run/detail/ranks_definitions.hpp>
#endif
