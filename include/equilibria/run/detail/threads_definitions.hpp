/// \file
/// See run/threads.hpp.
#pragma once

#ifndef EQUILIBRIA_NO_THREADS
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>
#endif

#include <equilibria/core/error.hpp>
#include <equilibria/run/threads.hpp>

namespace equilibria {

#ifndef EQUILIBRIA_NO_THREADS
namespace detail {

/// Threads that live as long as one loop and take its blocks in order.
class ThreadBackend final : public Executor::Backend {
public:
    explicit ThreadBackend(unsigned count) : count_(count) {}
    unsigned workers() const override { return count_; }

    void for_blocks(std::size_t size, std::size_t block, const Executor::Work& work) const override {
        const std::size_t blocks = (size + block - 1) / block;
        std::atomic<std::size_t> next = 0;
        std::exception_ptr failure;
        std::mutex failure_guard;
        const auto run = [&] {
            for (std::size_t b; (b = next++) < blocks;) try {
                    work(b * block, std::min(size, (b + 1) * block));
                } catch (...) {
                    const std::lock_guard lock(failure_guard);
                    if (!failure) failure = std::current_exception();
                    next = blocks;
                }
        };
        std::vector<std::thread> pool;
        for (std::size_t k = 1; k < std::min<std::size_t>(count_, blocks); ++k) pool.emplace_back(run);
        run();
        for (std::thread& t : pool) t.join();
        if (failure) std::rethrow_exception(failure);
    }

private:
    unsigned count_;
};

}  // namespace detail
#endif

EQUILIBRIA_INLINE Executor threads(unsigned count) {
    require(count <= 1024, "threads", count, "must be 0 (all) to 1024");
#ifdef EQUILIBRIA_NO_THREADS
    return {};
#else
    if (count == 0) count = std::max(1u, std::thread::hardware_concurrency());
    if (count == 1) return {};
    return Executor(std::make_shared<const detail::ThreadBackend>(count));
#endif
}

}  // namespace equilibria
