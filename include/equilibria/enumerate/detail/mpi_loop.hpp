/// \file
/// A loop's blocks over the ranks of a communicator: rank 0 hands out their numbers, a few ahead of what each rank is
/// at.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/enumerate/detail/block_workers.hpp>
#include <equilibria/enumerate/detail/mpi_post.hpp>
#include <equilibria/run/ranks.hpp>

namespace equilibria::detail {

/// How long the one that speaks sleeps when there is nothing to do, longer each time: a message is late by that much,
/// while blocks are at hand. It takes its time from a thread that tracks.
class Nap {
public:
    std::chrono::microseconds next(bool busy) {
        next_ = busy ? shortest : std::min(2 * next_, longest);
        return next_;
    }

private:
    static constexpr std::chrono::microseconds shortest{250}, longest{4000};
    std::chrono::microseconds next_ = shortest;
};

/// Rank 0: hands out blocks, takes what they give.
class MpiLead {
public:
    MpiLead(MPI_Comm comm, int ranks, const Ranks::Loop& loop, BlockWorkers& workers)
        : loop_(loop), workers_(workers), post_(comm), hands_(static_cast<std::size_t>(ranks)),
          left_(hands_.size() - 1) {}

    void run() {
        hands_[0].threads = workers_.threads();
        all_threads_ = workers_.threads();
        for (std::size_t k = 0; k < loop_.size; ++k)
            if (!loop_.done || !loop_.done(k)) open_.push_back(k);
        fill(0);
        Nap nap;
        MpiMessage message;
        bool busy = false, was_busy = false;
        while (true) {
            if (loop_.cancelled && loop_.cancelled()) open_.clear();
            const auto patience = busy ? std::chrono::microseconds{0} : nap.next(was_busy);
            was_busy = std::exchange(busy, false);
            for (auto& [block, bytes] : workers_.results(patience)) busy = true, take(0, block, bytes);
            if (const auto failed = workers_.failed(); failed && !failure_) fail(failed);
            while (post_.receive(message)) busy = true, handle(message);
            if (!ended_ && open_.empty() && in_hands_ == 0) finish();
            if (ended_ && left_ == 0 && workers_.idle()) break;
        }
        for (std::size_t rank = 1; rank < hands_.size(); ++rank) post_.send(static_cast<int>(rank), MpiTag::leave, {});
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    struct Hand {
        std::size_t threads = 0, blocks = 0;  ///< at work there, and given to it
        std::size_t told = 0;                 ///< the block whose bytes come next
    };

    /// As many blocks as a rank has threads, and as many ahead, which towards the end somebody else may do sooner.
    void fill(int rank) {
        if (ended_) return;
        Hand& hand = hands_[static_cast<std::size_t>(rank)];
        const std::size_t most = open_.size() > 4 * all_threads_ ? 2 * hand.threads : hand.threads;
        Ranks::Bytes bytes;
        while (hand.blocks < most && !open_.empty()) {
            const std::size_t block = open_.front();
            open_.pop_front();
            ++hand.blocks;
            ++in_hands_;
            if (rank == 0)
                workers_.give(block);
            else
                put_u64(bytes, block);
        }
        if (!bytes.empty()) post_.send(rank, MpiTag::blocks, std::move(bytes));
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
    void handle(const MpiMessage& message) {
        switch (message.tag) {
            case MpiTag::want:
                hands_[static_cast<std::size_t>(message.from)].threads = get_u64(message.bytes, 0);
                all_threads_ += get_u64(message.bytes, 0);
                if (ended_) return tell_end(message.from);
                return fill(message.from);
            case MpiTag::result:
                hands_[static_cast<std::size_t>(message.from)].told = get_u64(message.bytes, 0);
                return;
            case MpiTag::bytes:
                return take(message.from, hands_[static_cast<std::size_t>(message.from)].told, message.bytes);
            case MpiTag::cancel: open_.clear(); return;
            case MpiTag::failure:
                return fail(std::make_exception_ptr(
                    RankError("rank " + std::to_string(message.from) + ": " + text_of(message.bytes))));
            case MpiTag::done:
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
            post_.send(rank, MpiTag::failure, bytes_of("rank 0: " + sentence(failure_)));
        else
            post_.send(rank, MpiTag::end, {});
    }

    const Ranks::Loop& loop_;
    BlockWorkers& workers_;
    MpiPost post_;
    std::vector<Hand> hands_;
    std::deque<std::size_t> open_;
    std::size_t in_hands_ = 0, all_threads_ = 0;
    std::size_t left_;  // ranks that have not said that they are done
    bool ended_ = false;
    std::exception_ptr failure_;
};

/// Any other rank: does the blocks that it is given, sends back what they give.
class MpiFollow {
public:
    MpiFollow(MPI_Comm comm, const Ranks::Loop& loop, BlockWorkers& workers)
        : loop_(loop), workers_(workers), post_(comm) {}

    void run() {
        Ranks::Bytes wanted;
        put_u64(wanted, workers_.threads());
        post_.send(0, MpiTag::want, std::move(wanted));
        Nap nap;
        MpiMessage message;
        bool ended = false, done = false, left = false, told_cancel = false, busy = false;
        std::string wrong;
        std::exception_ptr own;
        while (!left) {
            auto results = workers_.results(nap.next(busy));
            busy = !results.empty();
            for (auto& [block, bytes] : results) {
                Ranks::Bytes number;
                put_u64(number, block);
                post_.send(0, MpiTag::result, std::move(number));
                post_.send(0, MpiTag::bytes, std::move(bytes));
            }
            if (loop_.cancelled && !told_cancel && loop_.cancelled()) {
                post_.send(0, MpiTag::cancel, {});
                told_cancel = true;
            }
            if (const auto failed = workers_.failed(); failed && !own) {
                own = failed;
                post_.send(0, MpiTag::failure, bytes_of(sentence(own)));
            }
            while (post_.receive(message)) {
                busy = true;
                if (message.tag == MpiTag::blocks) {
                    for (std::size_t at = 0; at < message.bytes.size(); at += 8)
                        workers_.give(static_cast<std::size_t>(get_u64(message.bytes, at)));
                } else if (message.tag == MpiTag::leave) {
                    left = true;
                } else {
                    if (message.tag == MpiTag::failure) wrong = text_of(message.bytes);
                    ended = true;
                    workers_.stop();
                }
            }
            if (ended && !done && workers_.idle()) {
                post_.send(0, MpiTag::done, {});
                done = true;
            }
            post_.empty();
        }
        if (own) std::rethrow_exception(own);
        if (!wrong.empty()) throw RankError(wrong);
    }

private:
    const Ranks::Loop& loop_;
    BlockWorkers& workers_;
    MpiPost post_;
};

}  // namespace equilibria::detail
