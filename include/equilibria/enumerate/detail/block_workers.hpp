/// \file
/// The threads of a rank at the blocks that it is given.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <equilibria/run/executor.hpp>
#include <equilibria/run/ranks.hpp>

namespace equilibria::detail {

/// The threads of this rank at their blocks, between them and the one that speaks a queue each way.
class BlockWorkers {
public:
    struct Result {
        std::size_t block;
        Ranks::Bytes bytes;
    };

    BlockWorkers(const Ranks::Loop& loop, const Executor& executor)
        : loop_(loop), threads_(executor.workers()), running_(threads_),
          pool_([this, executor] { executor.for_blocks(threads_, 1, [this](std::size_t, std::size_t) { work(); }); }) {}
    ~BlockWorkers() {
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

}  // namespace equilibria::detail
