#include <cstdint>
#include <vector>

#include <equilibria/stability/morse.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Counts = std::vector<std::int64_t>;

TEST_CASE("the least that the n-torus allows: binomials") {
    for (int n = 1; n <= 10; ++n) {
        Counts counts;
        std::int64_t binomial = 1;
        for (int k = 0; k <= n; ++k) {
            counts.push_back(binomial);
            binomial = binomial * (n - k) / (k + 1);
        }
        CHECK(morse_relations(counts).all());
        for (auto& count : counts) {
            --count;
            const auto y = morse_relations(counts);
            CHECK_FALSE(y.euler);
            CHECK_FALSE(y.weak);
            CHECK_FALSE(y.all());
            ++count;
        }
    }
}

TEST_CASE("tables of the rotating chain obey the relations") {
    for (const auto& counts : {Counts{1, 2, 1},
                               {2, 3, 1},
                               {2, 4, 2},
                               {2, 5, 3},
                               {2, 6, 4},
                               {4, 8, 4},
                               {2, 4, 3, 1},
                               {8, 24, 24, 8},
                               {2, 10, 18, 14, 4},
                               {2, 14, 37, 53, 38, 11, 1}})
        CHECK(morse_relations(counts).all());
}

TEST_CASE("a pair of neighbouring indices may come and go, other pairs may not") {
    CHECK(morse_relations({2, 3, 1}).all());
    CHECK(morse_relations({1, 3, 2}).all());
    CHECK_FALSE(morse_relations({2, 2, 1}).euler);
    CHECK_FALSE(morse_relations({2, 2, 2}).all());
}

TEST_CASE("each relation can fail alone") {
    // enough of each index, but the alternating sum is 1
    const auto sum = morse_relations({2, 3, 2});
    CHECK(sum.weak);
    CHECK_FALSE(sum.euler);
    // the alternating sum is 0, but N_0 = 0
    const auto few = morse_relations({0, 2, 2});
    CHECK(few.euler);
    CHECK_FALSE(few.weak);
    CHECK_FALSE(few.strong);
    // N_k large enough and alternating sum 0, but N_1 - N_0 = 1 < 2 = 3 - 1
    const auto strong = morse_relations({3, 4, 4, 3});
    CHECK(strong.weak);
    CHECK(strong.euler);
    CHECK_FALSE(strong.strong);
}
