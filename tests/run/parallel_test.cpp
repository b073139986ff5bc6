#include <atomic>
#include <stdexcept>
#include <vector>

#include <equilibria/run/parallel.hpp>

#include "support/catch.hpp"

using equilibria::parallel_blocks;

TEST_CASE("each number is worked on once, whatever the block and the threads") {
    for (const std::size_t size : {0u, 1u, 7u, 64u, 1000u})
        for (const std::size_t block : {1u, 3u, 64u, 5000u})
            for (const unsigned threads : {0u, 1u, 2u, 5u}) {
                std::vector<std::atomic<int>> visits(size);
                std::atomic<bool> in_order = true;
                parallel_blocks(size, block, threads, [&](std::size_t first, std::size_t last) {
                    if (first >= last || last > size || last - first > block) in_order = false;
                    for (std::size_t k = first; k < last; ++k) ++visits[k];
                });
                bool once = true;
                for (const auto& v : visits) once = once && v == 1;
                CHECK(once);
                CHECK(in_order);
            }
}

TEST_CASE("an exception of a block arrives at the caller, after all threads have stopped") {
    for (const unsigned threads : {1u, 2u, 4u}) {
        std::atomic<int> running = 0;
        const auto work = [&](std::size_t first, std::size_t) {
            ++running;
            struct Leave {
                std::atomic<int>& count;
                ~Leave() { --count; }
            } leave{running};
            if (first == 30) throw std::runtime_error("block 30");
        };
        CHECK_THROWS_AS(parallel_blocks(100, 10, threads, work), std::runtime_error);
        CHECK(running == 0);
    }
}
