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

// without these g++ wants MPI's C++ library, which nobody has any more
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/endian/conversion.hpp>

#include <equilibria/core/error.hpp>
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
        Workers workers(loop, executor);
        if (rank_ == 0)
            Lead(*this, loop, workers).run();
        else
            Follow(*this, loop, workers).run();
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

    /// What messages say, by their tag. To rank 0: threads that want blocks; a block and its bytes; that the run is
    /// cancelled; what went wrong; that no more comes. From rank 0: blocks; that there are no more; what went wrong;
    /// that all have said so, and the next loop may begin.
    enum Tag : int { want = 1, result, cancel, failure, done, blocks, end, leave };

    /// The threads of this rank at their blocks, between them and the one that speaks a queue each way.
    class Workers {
    public:
        struct Result {
            std::size_t block;
            Bytes bytes;
        };

        Workers(const Ranks::Loop& loop, const Executor& executor)
            : loop_(loop), threads_(executor.workers()), running_(threads_), pool_([this, executor] {
                  executor.for_blocks(threads_, 1, [this](std::size_t, std::size_t) { work(); });
              }) {}
        ~Workers() {
            stop();
            pool_.join();
        }

        unsigned threads() const { return threads_; }
        void give(std::size_t block) {
            const std::lock_guard lock(guard_);
            queue_.push_back(block);
            work_.notify_one();
        }
        /// Blocks that were not begun are left.
        void stop() {
            const std::lock_guard lock(guard_);
            stopped_ = true;
            queue_.clear();
            work_.notify_all();
        }
        /// What is finished by now; waits so long for it.
        std::vector<Result> results(std::chrono::microseconds patience) {
            std::unique_lock lock(guard_);
            if (patience.count() > 0) news_.wait_for(lock, patience, [this] { return new_; });
            new_ = false;
            return std::exchange(results_, {});
        }
        /// Whether all threads have ended and nothing of theirs is left.
        bool idle() {
            const std::lock_guard lock(guard_);
            return running_ == 0 && results_.empty();
        }
        std::exception_ptr failed() {
            const std::lock_guard lock(guard_);
            return failure_;
        }

    private:
        void work() {
            std::unique_lock lock(guard_);
            while (true) {
                work_.wait(lock, [this] { return stopped_ || !queue_.empty(); });
                if (queue_.empty()) break;
                const std::size_t block = queue_.front();
                queue_.pop_front();
                lock.unlock();
                Result done{block, {}};
                std::exception_ptr failure;
                try {
                    done.bytes = loop_.work(block);
                } catch (...) {
                    failure = std::current_exception();
                }
                lock.lock();
                if (failure) {
                    if (!failure_) failure_ = failure;
                    stopped_ = true;
                    queue_.clear();
                    work_.notify_all();
                } else {
                    results_.push_back(std::move(done));
                }
                tell();
            }
            --running_;
            tell();
        }
        void tell() {
            new_ = true;
            news_.notify_one();
        }

        const Ranks::Loop& loop_;
        unsigned threads_, running_;
        std::mutex guard_;
        std::condition_variable work_, news_;
        std::deque<std::size_t> queue_;
        std::vector<Result> results_;
        std::exception_ptr failure_;
        bool stopped_ = false, new_ = false;
        std::thread pool_;  // last: it uses all of the others
    };

    struct Message {
        int from, tag;
        Bytes bytes;
    };
    /// Messages on their way, from and to this rank. Nothing here waits.
    class Post {
    public:
        explicit Post(MPI_Comm comm) : comm_(comm) {}
        /// Messages that are still on their way are let go: the run failed.
        ~Post() {
            while (!empty()) std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        void send(int to, Tag tag, Bytes bytes) {
            sent_.push_back({std::move(bytes), MPI_REQUEST_NULL});
            auto& [kept, request] = sent_.back();
            MPI_Isend(kept.data(), static_cast<int>(kept.size()), MPI_BYTE, to, tag, comm_, &request);
        }
        /// The next message of any rank that is all there. A large one comes in parts, for which its sender has to be
        /// awake: nobody waits for it but those that the same rank has sent after it.
        bool receive(Message& message) {
            while (coming_.size() < most_coming && begin_receiving()) {
            }
            std::vector<int> late;
            for (auto at = coming_.begin(); at != coming_.end(); ++at) {
                int there = 0;
                if (std::find(late.begin(), late.end(), at->message.from) == late.end())
                    MPI_Test(&at->request, &there, MPI_STATUS_IGNORE);
                if (there == 0) {
                    late.push_back(at->message.from);
                    continue;
                }
                message = std::move(at->message);
                coming_.erase(at);
                return true;
            }
            return false;
        }
        /// Whether all has been sent.
        bool empty() {
            sent_.remove_if([](auto& of) {
                int gone = 0;
                MPI_Test(&of.request, &gone, MPI_STATUS_IGNORE);
                return gone != 0;
            });
            return sent_.empty();
        }

    private:
        bool begin_receiving() {
            int there = 0;
            MPI_Message handle = MPI_MESSAGE_NULL;
            MPI_Status status;
            MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, comm_, &there, &handle, &status);
            if (there == 0) return false;
            int length = 0;
            MPI_Get_count(&status, MPI_BYTE, &length);
            coming_.push_back(
                {{status.MPI_SOURCE, status.MPI_TAG, Bytes(static_cast<std::size_t>(length))}, MPI_REQUEST_NULL});
            auto& [message, request] = coming_.back();
            MPI_Imrecv(message.bytes.data(), length, MPI_BYTE, &handle, &request);
            return true;
        }

        static constexpr std::size_t most_coming = 1024;  // some 200 MB; the others wait where they are

        struct Sent {
            Bytes bytes;
            MPI_Request request;
        };
        struct Coming {
            Message message;
            MPI_Request request;
        };
        MPI_Comm comm_;
        std::list<Sent> sent_;
        std::list<Coming> coming_;
    };

    static void put(Bytes& to, std::uint64_t number) {
        to.resize(to.size() + 8);
        boost::endian::store_little_u64(&to[to.size() - 8], number);
    }
    static std::uint64_t get(const Bytes& from, std::size_t at) { return boost::endian::load_little_u64(&from[at]); }
    static Bytes text(const std::string& of) { return {of.begin(), of.end()}; }
    static std::string text(const Bytes& of) { return {of.begin(), of.end()}; }
    static std::string sentence(const std::exception_ptr& failure) {
        try {
            std::rethrow_exception(failure);
        } catch (const std::exception& error) {
            return error.what();
        } catch (...) {
            return "an unknown exception";
        }
    }

    /// How long the one that speaks sleeps when there is nothing to do: a message is late by that much, while blocks
    /// are at hand.
    static constexpr std::chrono::microseconds nap{500};

    /// Rank 0: hands out blocks, takes what they give.
    class Lead {
    public:
        Lead(const MpiBackend& mpi, const Ranks::Loop& loop, Workers& workers)
            : loop_(loop), workers_(workers), post_(mpi.comm_), hands_(static_cast<std::size_t>(mpi.size_)),
              left_(hands_.size() - 1) {}

        void run() {
            hands_[0].threads = workers_.threads();
            all_threads_ = workers_.threads();
            for (std::size_t k = 0; k < loop_.size; ++k)
                if (!loop_.done || !loop_.done(k)) open_.push_back(k);
            fill(0);
            while (true) {
                bool busy = false;
                if (loop_.cancelled && loop_.cancelled()) open_.clear();
                for (auto& [block, bytes] : workers_.results(busy_ ? std::chrono::microseconds{0} : nap))
                    busy = true, take(0, block, bytes);
                if (const auto failed = workers_.failed(); failed && !failure_) fail(failed);
                for (Message message; post_.receive(message);) busy = true, handle(message);
                busy_ = busy;
                if (!ended_ && open_.empty() && in_hands_ == 0) finish();
                if (ended_ && left_ == 0 && workers_.idle()) break;
            }
            for (std::size_t rank = 1; rank < hands_.size(); ++rank) post_.send(static_cast<int>(rank), Tag::leave, {});
            if (failure_) std::rethrow_exception(failure_);
        }

    private:
        struct Hand {
            std::size_t threads = 0, blocks = 0;  ///< at work there, and given to it
        };

        /// As many blocks as a rank has threads, and as many ahead, which towards the end somebody else may do sooner.
        void fill(int rank) {
            if (ended_) return;
            Hand& hand = hands_[static_cast<std::size_t>(rank)];
            const std::size_t most = open_.size() > 4 * all_threads_ ? 2 * hand.threads : hand.threads;
            Bytes bytes;
            while (hand.blocks < most && !open_.empty()) {
                const std::size_t block = open_.front();
                open_.pop_front();
                ++hand.blocks;
                ++in_hands_;
                if (rank == 0)
                    workers_.give(block);
                else
                    put(bytes, block);
            }
            if (!bytes.empty()) post_.send(rank, Tag::blocks, std::move(bytes));
        }
        void take(int rank, std::size_t block, Ranks::BytesView bytes) {
            --hands_[static_cast<std::size_t>(rank)].blocks;
            --in_hands_;
            if (!failure_) try {
                    loop_.take(block, bytes);
                } catch (...) {
                    fail(std::current_exception());
                }
            fill(rank);
        }
        void handle(const Message& message) {
            switch (message.tag) {
                case Tag::want:
                    hands_[static_cast<std::size_t>(message.from)].threads = get(message.bytes, 0);
                    all_threads_ += get(message.bytes, 0);
                    if (ended_) return tell_end(message.from);
                    return fill(message.from);
                case Tag::result:
                    return take(message.from, get(message.bytes, 0), Ranks::BytesView(message.bytes).subspan(8));
                case Tag::cancel: open_.clear(); return;
                case Tag::failure:
                    return fail(std::make_exception_ptr(
                        RankError("rank " + std::to_string(message.from) + ": " + text(message.bytes))));
                case Tag::done:
                    --left_;
                    // what it was given and did not begin
                    in_hands_ -= std::exchange(hands_[static_cast<std::size_t>(message.from)].blocks, 0);
                    return;
                default: return;
            }
        }
        void fail(std::exception_ptr failure) {
            if (failure_) return;
            failure_ = std::move(failure);
            open_.clear();
            finish();
        }
        /// No block is left, or the run failed: all are told. A rank that has not come yet is told when it does.
        void finish() {
            if (ended_) return;
            ended_ = true;
            workers_.stop();
            for (std::size_t rank = 1; rank < hands_.size(); ++rank)
                if (hands_[rank].threads > 0) tell_end(static_cast<int>(rank));
        }
        void tell_end(int rank) {
            if (failure_)
                post_.send(rank, Tag::failure, text("rank 0: " + sentence(failure_)));
            else
                post_.send(rank, Tag::end, {});
        }

        const Ranks::Loop& loop_;
        Workers& workers_;
        Post post_;
        std::vector<Hand> hands_;
        std::deque<std::size_t> open_;
        std::size_t in_hands_ = 0, all_threads_ = 0;
        std::size_t left_;  // ranks that have not said that they are done
        bool ended_ = false, busy_ = false;
        std::exception_ptr failure_;
    };

    /// Any other rank.
    class Follow {
    public:
        Follow(const MpiBackend& mpi, const Ranks::Loop& loop, Workers& workers)
            : loop_(loop), workers_(workers), post_(mpi.comm_) {}

        void run() {
            Bytes wanted;
            put(wanted, workers_.threads());
            post_.send(0, Tag::want, std::move(wanted));
            bool ended = false, done = false, left = false, told_cancel = false;
            std::string wrong;
            std::exception_ptr own;
            while (!left) {
                for (auto& [block, bytes] : workers_.results(nap)) {
                    Bytes with_number;
                    with_number.reserve(bytes.size() + 8);
                    put(with_number, block);
                    with_number.insert(with_number.end(), bytes.begin(), bytes.end());
                    post_.send(0, Tag::result, std::move(with_number));
                }
                if (loop_.cancelled && !told_cancel && loop_.cancelled()) {
                    post_.send(0, Tag::cancel, {});
                    told_cancel = true;
                }
                if (const auto failed = workers_.failed(); failed && !own) {
                    own = failed;
                    post_.send(0, Tag::failure, text(sentence(own)));
                }
                for (Message message; post_.receive(message);) {
                    if (message.tag == Tag::blocks) {
                        for (std::size_t at = 0; at < message.bytes.size(); at += 8)
                            workers_.give(static_cast<std::size_t>(get(message.bytes, at)));
                    } else if (message.tag == Tag::leave) {
                        left = true;
                    } else {
                        if (message.tag == Tag::failure) wrong = text(message.bytes);
                        ended = true;
                        workers_.stop();
                    }
                }
                if (ended && !done && workers_.idle()) {
                    post_.send(0, Tag::done, {});
                    done = true;
                }
                post_.empty();
            }
            if (own) std::rethrow_exception(own);
            if (!wrong.empty()) throw RankError(wrong);
        }

    private:
        const Ranks::Loop& loop_;
        Workers& workers_;
        Post post_;
    };

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
    const Ranks& ranks() const { return ranks_; }

private:
    int exceptions_;
    Ranks ranks_;
};

}  // namespace equilibria
