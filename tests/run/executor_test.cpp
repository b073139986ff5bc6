#include <atomic>
#include <memory>
#include <stdexcept>
#include <vector>

#include <equilibria/run/threads.hpp>

#include "support/catch.hpp"

using equilibria::Executor, equilibria::threads;

TEST_CASE("each number is worked on once, whatever the block and the threads") {
    for (const std::size_t size : {0u, 1u, 7u, 64u, 1000u})
        for (const std::size_t block : {1u, 3u, 64u, 5000u})
            for (const unsigned count : {0u, 1u, 2u, 5u}) {
                std::vector<std::atomic<int>> visits(size);
                std::atomic<bool> in_order = true;
                threads(count).for_blocks(size, block, [&](std::size_t first, std::size_t last) {
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
    for (const unsigned count : {1u, 2u, 4u}) {
        std::atomic<int> running = 0;
        const auto work = [&](std::size_t first, std::size_t) {
            ++running;
            struct Leave {
                std::atomic<int>& count;
                ~Leave() { --count; }
            } leave{running};
            if (first == 30) throw std::runtime_error("block 30");
        };
        CHECK_THROWS_AS(threads(count).for_blocks(100, 10, work), std::runtime_error);
        CHECK(running == 0);
    }
}

TEST_CASE("an executor of one's own gets every block, and says how many run at the same time") {
    struct Backwards final : Executor::Backend {
        unsigned workers() const override { return 3; }
        void for_blocks(std::size_t size, std::size_t block, const Executor::Work& work) const override {
            for (std::size_t b = (size + block - 1) / block; b-- > 0;) work(b * block, std::min(size, (b + 1) * block));
        }
    };
    const Executor backwards(std::make_shared<const Backwards>());
    CHECK(backwards.workers() == 3);
    CHECK(Executor().workers() == 1);
    std::vector<std::size_t> order;
    backwards.for_blocks(10, 4, [&](std::size_t first, std::size_t last) {
        order.push_back(first);
        order.push_back(last);
    });
    CHECK(order == std::vector<std::size_t>{8, 10, 4, 8, 0, 4});
}

TEST_CASE("more threads than there can be are refused") {
    CHECK_THROWS_WITH(threads(1025), "threads = 1025: must be 0 (all) to 1024");
}
