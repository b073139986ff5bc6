#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <equilibria/core/key_sort.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("things are sorted by their keys, of whatever size and sign") {
    struct Thing {
        double key;
        std::size_t k;
    };
    Generator generator(2);
    for (const std::size_t size : {0, 1, 2, 100, 5000, 40000}) {
        std::vector<Thing> things(size);
        for (std::size_t k = 0; k < size; ++k) {
            const double spread = k % 3 == 0 ? std::pow(10.0, uniform(generator, -300, 300)) : 1.0;
            things[k] = {k % 7 == 0 && k > 0 ? things[k - 1].key : spread * uniform(generator, -1, 1), k};
        }
        if (size > 2) things[1].key = std::numeric_limits<double>::infinity(), things[2].key = -things[1].key;
        std::vector<double> keys;
        for (const auto& thing : things) keys.push_back(thing.key);
        const auto given = keys;
        std::sort(keys.begin(), keys.end());
        sort_by_key(things);
        bool same = true;
        for (std::size_t k = 0; k < size; ++k) same = same && things[k].key == keys[k] && given[things[k].k] == keys[k];
        CHECK(same);
    }
}
