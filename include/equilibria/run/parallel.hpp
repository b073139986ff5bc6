/// \file
/// Blocks of independent work over threads. Results go to places that depend on the work's number alone, so nothing
/// depends on the number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace equilibria {

/// Calls work(first, last) for consecutive blocks of [0, size), on up to `threads` threads (0: all of the machine's).
/// The first exception thrown by a block is thrown again here, after all threads have stopped.
template <class Work>
void parallel_blocks(std::size_t size, std::size_t block, unsigned threads, Work&& work) {
    const std::size_t blocks = (size + block - 1) / block;
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    threads = static_cast<unsigned>(std::min<std::size_t>(threads, blocks));
    if (threads <= 1) {
        for (std::size_t b = 0; b < blocks; ++b) work(b * block, std::min(size, (b + 1) * block));
        return;
    }
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
    for (unsigned k = 1; k < threads; ++k) pool.emplace_back(run);
    run();
    for (std::thread& t : pool) t.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace equilibria
