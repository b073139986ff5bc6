// Endpoints are the same wherever they are kept.
#include <equilibria/storage/endpoint_store.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

namespace {
const RuntimeSizes sizes(2, 0);
}

TEST_CASE("endpoints are the same in memory, in a file and in both, in whatever order they are looked at") {
    constexpr std::uint64_t size = 103, block = 10;
    const tests::ScratchFile scratch("file.ckpt"), second("both.ckpt");
    const detail::CheckpointFields header{{"model", "numbers"}};
    detail::EndpointStore memory(size, block, sizes), file(size, block, scratch.name(), header, false, sizes),
        both(size, block, second.name(), header, true, sizes);
    const auto each = [&](auto&& action) { action(memory), action(file), action(both); };
    const auto numbered = [](std::uint64_t k) {
        Endpoint end;
        end.q = point_of_zeros<RuntimeUnknowns, double>(sizes);
        end.t = end.q.s[1].re = static_cast<double>(k);
        return end;
    };
    for (const std::uint64_t which : {3, 10, 0, 1, 2, 9, 8, 7, 6, 5}) {
        std::vector<Endpoint> ends;
        for (std::uint64_t k = 10 * which; k < std::min(size, 10 * which + 10); ++k) ends.push_back(numbered(k));
        each([&](auto& store) {
            CHECK_FALSE(store.has_block(which));
            CHECK_FALSE(store.finished(10 * which));
            store.put(which, ends, which);
            CHECK(store.has_block(which));
            CHECK(store.finished(10 * which));
        });
    }
    each([&](auto& store) {
        CHECK_FALSE(store.complete());  // block 4
        CHECK(store.finished() == size - block);
        std::vector<Endpoint> ends;
        for (std::uint64_t k = 40; k < 50; ++k) ends.push_back(numbered(k));
        store.put(4, ends, 4);
        CHECK(store.complete());
        CHECK(store.retracked() == 55);

        const auto value = [](std::uint64_t k) { return k == 17 ? 1e6 : static_cast<double>(k); };
        store.replace(17, numbered(1000000));
        for (std::uint64_t k = 0; k < size; ++k) {
            CHECK(store[k].t == value(k));
            CHECK(store.record(k).t == value(k));
            CHECK(store.point(k).c.size() == 2);
            CHECK(store.point(k).s[1].re == value(k));
        }
        // pairs: a reference outlives the next call
        for (std::uint64_t k = 0; k < 2000; ++k) {
            const std::uint64_t i = k * 7919 % size, j = k * k * 31 % size;
            const Endpoint &a = store[i], &b = store[j];
            CHECK(a.t == value(i));
            CHECK(b.t == value(j));
        }
        for (std::uint64_t k = 0; k + 1 < size; ++k) {
            const Endpoint &a = store[k], &b = store[size - 1 - k];
            CHECK(a.t == value(k));
            CHECK(b.t == value(size - 1 - k));
        }
        store.unsettle(5);
        CHECK_FALSE(store.complete());
        CHECK_FALSE(store.finished(5));
        CHECK(store.finished() == size - 1);
    });
}

TEST_CASE("a store takes up what its checkpoint holds") {
    const tests::ScratchFile scratch("taken_up.ckpt");
    const detail::CheckpointFields header{{"model", "numbers"}};
    for (const bool in_memory : {false, true})
        for (std::uint64_t which = 0; which < 3; ++which) {
            detail::EndpointStore store(25, 10, scratch.name(), header, in_memory, sizes);
            if (in_memory) CHECK(store.complete());
            if (in_memory) continue;
            CHECK(store.finished() == 10 * which);
            CHECK(store.retracked() == which);
            std::vector<Endpoint> ends(which == 2 ? 5 : 10);
            for (Endpoint& end : ends) end.q = point_of_zeros<RuntimeUnknowns, double>(sizes);
            store.put(which, ends, 1);
        }
}
