/// \file
/// Ranks over MPI: paths, proofs and parameter points on as many processes as mpirun starts. Opt-in: needs <mpi.h>, and
/// the program links MPI::MPI_CXX. Open MPI and MPICH alike; the C interface alone is used.
///
///     int main(int argc, char** argv) {
///         const equilibria::MpiSession mpi(&argc, &argv);
///         const auto found = equilibria::enumerate<Model>(p, {.executor = threads(2), .ranks = mpi.ranks()});
///         if (mpi.ranks().first()) std::cout << found;
///     }
///
/// Rank 0 hands out numbers of blocks, a few ahead of what each rank is at; the others send back what the block gave.
/// Each rank does its blocks with its executor, and one more thread of it, the one that calls, speaks for all
/// (MPI_THREAD_FUNNELED): it sleeps when there is nothing to say, so that it costs no core.
///
/// A process that dies takes the run with it: that is MPI's way. What rank 0 had is in the checkpoint, and the next run
/// goes on from it, on any number of ranks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/enumerate/detail/block_workers.hpp>
#include <equilibria/enumerate/detail/mpi_loop.hpp>
#include <equilibria/run/executor.hpp>
#include <equilibria/run/ranks.hpp>

namespace equilibria {

namespace detail {

class MpiBackend final : public Ranks::Backend {
public:
    using Bytes = Ranks::Bytes;

    /// Collective over `of`, of which it makes a communicator of its own.
    explicit MpiBackend(MPI_Comm of) {
        MPI_Comm_dup(of, &comm_);
        MPI_Comm_rank(comm_, &rank_);
        MPI_Comm_size(comm_, &size_);
    }
    MpiBackend(const MpiBackend&) = delete;
    ~MpiBackend() override {
        int over = 0;
        MPI_Finalized(&over);
        if (over == 0) MPI_Comm_free(&comm_);
    }

    int rank() const override { return rank_; }
    int size() const override { return size_; }

    void for_blocks(const Ranks::Loop& loop, const Executor& executor) const override {
        BlockWorkers workers(loop, executor);
        if (rank_ == 0)
            MpiLead(comm_, size_, loop, workers).run();
        else
            MpiFollow(comm_, loop, workers).run();
    }

    void broadcast(Bytes& bytes) const override {
        std::uint64_t size = bytes.size();
        MPI_Bcast(&size, 1, MPI_UINT64_T, 0, comm_);
        bytes.resize(static_cast<std::size_t>(size));
        for (std::size_t at = 0; at < bytes.size(); at += piece)
            MPI_Bcast(&bytes[at], static_cast<int>(std::min(piece, bytes.size() - at)), MPI_BYTE, 0, comm_);
    }

    std::vector<Bytes> gather(const Bytes& own) const override {
        require(own.size() < piece, "own", own.size(), "must be less than 2^30 bytes");
        const int length = static_cast<int>(own.size());
        const auto ranks = static_cast<std::size_t>(size_);
        std::vector<int> lengths(ranks), begins(ranks);
        MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, comm_);
        std::int64_t all = 0;
        for (std::size_t k = 0; k < ranks; ++k) {
            begins[k] = static_cast<int>(all);
            all += lengths[k];
        }
        require(all <= std::numeric_limits<int>::max(), "own", all,
                "must be less than 2^31 bytes of all ranks together");
        Bytes bytes(static_cast<std::size_t>(all));
        MPI_Allgatherv(own.data(), length, MPI_BYTE, bytes.data(), lengths.data(), begins.data(), MPI_BYTE, comm_);
        std::vector<Bytes> y;
        for (std::size_t k = 0; k < ranks; ++k)
            y.emplace_back(bytes.begin() + begins[k], bytes.begin() + begins[k] + lengths[k]);
        return y;
    }

private:
    static constexpr std::size_t piece = std::size_t{1} << 30;  // MPI counts in int

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0, size_ = 1;
};

}  // namespace detail

/// The ranks of a communicator; collective. MPI must have been initialised with MPI_THREAD_FUNNELED or more, and what
/// runs on these ranks must be called by the thread that did that. Throws InvalidArgument otherwise.
inline Ranks mpi_ranks(MPI_Comm comm = MPI_COMM_WORLD) {
    int level = MPI_THREAD_SINGLE, initialised = 0;
    MPI_Initialized(&initialised);
    require(initialised != 0, "comm", "MPI without MPI_Init", "must be of an initialised MPI: MpiSession does that");
    MPI_Query_thread(&level);
    require(level >= MPI_THREAD_FUNNELED, "thread level of MPI", level, "must be MPI_THREAD_FUNNELED or more");
    return Ranks(std::make_shared<const detail::MpiBackend>(comm));
}

/// MPI from here to the end of the scope. Where an exception ends the scope, all ranks are ended: one that is gone
/// would keep the others waiting.
class MpiSession {
public:
    /// Initialises MPI with the arguments of `main`, at MPI_THREAD_FUNNELED.
    MpiSession(int* argc, char*** argv) : exceptions_(std::uncaught_exceptions()) {
        int level = MPI_THREAD_SINGLE;
        MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level);
        ranks_ = mpi_ranks();
    }
    MpiSession(const MpiSession&) = delete;
    ~MpiSession() {
        if (std::uncaught_exceptions() > exceptions_) MPI_Abort(MPI_COMM_WORLD, 1);
        ranks_ = {};
        MPI_Finalize();
    }
    const Ranks& ranks() const { return ranks_; }  ///< all processes that mpirun started

private:
    int exceptions_;
    Ranks ranks_;
};

}  // namespace equilibria
