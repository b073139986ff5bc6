// Loops shared by ranks, here threads of one process that speak through memory: what each has afterwards.
#include <array>
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <equilibria/run/ranks.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/run/threads.hpp>

#include "support/catch.hpp"
#include "support/thread_ranks.hpp"

using namespace equilibria;

TEST_CASE("one rank does all blocks itself") {
    const Ranks alone;
    CHECK(alone.first());
    CHECK_FALSE(alone.several());
    std::vector<int> taken(10);
    alone.for_blocks({.size = 10,
                      .done = [](std::size_t k) { return k == 3; },
                      .work = [](std::size_t k) { return Ranks::Bytes{static_cast<std::uint8_t>(k)}; },
                      .take = [&](std::size_t k, Ranks::BytesView bytes) { taken[k] += bytes[0] == k ? 1 : 100; },
                      .cancelled = {}},
                     threads(2));
    for (std::size_t k = 0; k < 10; ++k) CHECK(taken[k] == (k == 3 ? 0 : 1));
    CHECK(alone.any(true));
    CHECK_FALSE(alone.any(false));
    CHECK(alone.differing("text").empty());
}

TEST_CASE("what rank 0 has is shared with all, in pieces, but for the blocks that it has not") {
    for (const int size : {2, 3}) {
        std::vector<std::vector<std::size_t>> got(static_cast<std::size_t>(size));
        tests::on_ranks(size, [&](const Ranks& ranks) {
            auto& own = got[static_cast<std::size_t>(ranks.rank())];
            ranks.share(
                40, [](std::size_t k) { return k % 7 != 2; },
                [](std::size_t k, Ranks::Bytes& to) { to.resize(to.size() + (k == 5 ? std::size_t{1} << 25 : k), 1); },
                [&](std::size_t k, Ranks::BytesView bytes) {
                    own.push_back(k);
                    if (k != 5 && bytes.size() != k) own.push_back(1000);
                });
        });
        CHECK(got[0].empty());
        for (std::size_t r = 1; r < got.size(); ++r) CHECK(got[r].size() == 34);
    }
}

TEST_CASE("numbers are added up over the ranks, and rank 0's is told") {
    std::atomic<int> right = 0;
    for (const int size : {1, 3})
        tests::on_ranks(size, [&](const Ranks& ranks) {
            const auto rank = static_cast<std::uint64_t>(ranks.rank());
            std::array<std::uint64_t, 2> numbers{rank, std::uint64_t{1} << 60};
            ranks.add_up(numbers);
            right +=
                numbers == std::array<std::uint64_t, 2>{size == 1 ? 0U : 3U, static_cast<std::uint64_t>(size) << 60};
            right += ranks.of_first(rank + 7) == 7;
        });
    CHECK(right == 8);
}

TEST_CASE("ranks agree, or are told who differs") {
    std::atomic<int> equal = 0, told = 0;
    tests::on_ranks(3, [&](const Ranks& ranks) {
        equal += ranks.differing("the same").empty();
        const auto texts = ranks.differing(ranks.rank() == 2 ? "another" : "the same");
        told += texts == std::vector<std::string>{"the same", "the same", "another"};
        equal += ranks.any(ranks.rank() == 1) && !ranks.any(false);
    });
    CHECK(equal == 6);
    CHECK(told == 3);
}

TEST_CASE("what goes wrong at rank 0 goes wrong at all") {
    std::atomic<int> done = 0, own = 0, others = 0;
    tests::on_ranks(3, [&](const Ranks& ranks) {
        ranks.at_first([&] { done += 1 + 100 * ranks.rank(); });
        try {
            ranks.at_first([] { throw std::out_of_range("no room"); });
        } catch (const std::out_of_range&) {
            ++own;
        } catch (const RankError& error) {
            others += std::string(error.what()) == "rank 0: no room";
        }
    });
    CHECK(done == 1);
    CHECK(own == 1);
    CHECK(others == 2);
}

TEST_CASE("what is not shared refuses ranks") {
    std::atomic<int> refused = 0;
    tests::on_ranks(2, [&](const Ranks& ranks) {
        const RunOptions run{.ranks = ranks};
        run.require_whole("a proof");
        try {
            run.require_alone("a locus");
        } catch (const InvalidArgument& error) {
            refused += std::string(error.what()).find("a locus is not shared by ranks") != std::string::npos;
        }
    });
    CHECK(refused == 2);
    RunOptions().require_alone("a locus");
}
