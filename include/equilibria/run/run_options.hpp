/// \file
/// What everything that runs long needs to know beside its problem and its method.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/run/executor.hpp>
#include <equilibria/run/ranks.hpp>
#include <equilibria/run/threads.hpp>

namespace equilibria {

/// Random numbers, threads and ranks, progress, checkpoint and cancel of a run.
struct RunOptions {
    std::uint64_t seed = 1;  ///< of all random numbers; the same seed gives the same result
    Executor executor{};     ///< serial, or threads(n); does not change the result
    /// Processes that share the work, each of which calls with the same options; does not change the result, which each
    /// of them gets.
    Ranks ranks{};
    /// Called at rank 0 now and then with how much is done and how much there is (paths, roots, cells), from any
    /// thread, one call at a time.
    std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
    /// A file that keeps what is finished, rank 0's alone; if it exists already, the run goes on from there. Empty:
    /// none. An existing file of another run is refused (CheckpointError). It does not change the result.
    std::string checkpoint{};
    /// Bytes that the search for coincident endpoints may take where the endpoints are streamed; what is more is sorted
    /// in files beside the checkpoint. It does not change the result.
    std::uint64_t key_memory = std::uint64_t{1} << 30;
    /// The run ends soon after this has become true, with what is finished until then; the result says so. It may be
    /// set from a signal handler.
    const std::atomic<bool>* cancel = nullptr;

    bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }  ///< `cancel` is set and true

    /// Whether the run must be told from others: by its file, or by other ranks.
    bool is_told_apart() const { return !checkpoint.empty() || ranks.several(); }

    /// Whether any rank is: collective.
    bool cancelled_anywhere() const { return ranks.any(cancelled()); }

    /// The same options with another seed.
    RunOptions with_seed(std::uint64_t other) const {
        RunOptions run = *this;
        run.seed = other;
        return run;
    }
    /// For what solves many systems, and keeps no file. Throws InvalidArgument where one is named.
    [[gnu::cold]] void require_no_checkpoint() const {
        require(checkpoint.empty(), "checkpoint", checkpoint, "must be empty: it keeps a single enumeration");
    }
    /// For what moreover ends only when it is done. Throws InvalidArgument where a cancel is given.
    [[gnu::cold]] void require_whole(const char* what) const {
        require_no_checkpoint();
        require(cancel == nullptr, "cancel", "given", std::string("must be empty: ") + what + " cannot be cancelled");
    }
    /// For what moreover does not share its work with other ranks. Throws InvalidArgument where there are some.
    [[gnu::cold]] void require_alone(const char* what) const {
        require_whole(what);
        require(!ranks.several(), "ranks", ranks.size(),
                std::string("must be one: ") + what + " is not shared by ranks");
    }
};

}  // namespace equilibria
