/// \file
/// Where the blocks of a parallel loop run. What a loop computes goes to places that depend on the block's number
/// alone, so that no result depends on the executor: serially, over threads (threads.hpp), or over what a user derives
/// from Backend.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace equilibria {

/// An executor is copied freely; by default it is serial.
class Executor {
public:
    /// Does the work of consecutive blocks, each once.
    using Work = std::function<void(std::size_t first, std::size_t last)>;

    /// What an executor of one's own derives from.
    class Backend {
    public:
        virtual ~Backend() = default;
        /// How many blocks run at the same time; at least 1.
        virtual unsigned workers() const = 0;
        /// Calls work(first, last) for consecutive blocks of [0, size). The first exception of a block is thrown again
        /// here, after all that run have stopped; blocks that had not begun may be left out then.
        virtual void for_blocks(std::size_t size, std::size_t block, const Work& work) const = 0;
    };

    Executor() = default;
    /// With a backend of one's own; null: serial.
    explicit Executor(std::shared_ptr<const Backend> backend) : backend_(std::move(backend)) {}

    /// How many blocks run at the same time: what a block's size is chosen for.
    unsigned workers() const { return backend_ ? backend_->workers() : 1; }

    /// Calls work(first, last) for consecutive blocks of [0, size) of at most `block` (at least 1) each.
    template <class Block>
    void for_blocks(std::size_t size, std::size_t block, Block&& work) const {
        if (backend_ && size > block) return backend_->for_blocks(size, block, Work(std::ref(work)));
        for (std::size_t first = 0; first < size; first += block) work(first, std::min(size, first + block));
    }

private:
    std::shared_ptr<const Backend> backend_;
};

}  // namespace equilibria
