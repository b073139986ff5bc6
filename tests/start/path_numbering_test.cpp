// Numbers of paths: tracked ones, their mirror images and those that rest are all there are, each once.
#include <algorithm>
#include <cstdint>
#include <vector>

#include <equilibria/start/path_numbering.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("Without a symmetry every path is tracked and its own image") {
    const auto paths = PathNumbering::all(7);
    CHECK_FALSE(paths.symmetric());
    CHECK(paths.total() == 7);
    CHECK(paths.tracked() == 7);
    CHECK(paths.resting() == 0);
    CHECK(paths.weight() == 1);
    for (std::uint64_t k = 0; k < 7; ++k) CHECK((paths.tracked_path(k) == k && paths.mirror(k) == k));
}

TEST_CASE("Tracked paths, their mirror images and resting ones are all paths once") {
    for (const std::vector<std::uint64_t>& radices :
         {std::vector<std::uint64_t>{2}, {4}, {2, 2, 2}, {4, 6}, {6, 2, 4}, {4, 4, 4, 4}}) {
        const auto paths = PathNumbering::mirrored(radices);
        CHECK(paths.symmetric());
        CHECK(paths.resting() + paths.weight() * paths.tracked() == paths.total());
        std::vector<std::uint64_t> all;
        std::uint64_t before = 0;
        for (std::uint64_t k = 0; k < paths.tracked(); ++k) {
            const std::uint64_t path = paths.tracked_path(k), image = paths.mirror(path);
            CHECK(path < image);
            CHECK(paths.mirror(image) == path);
            if (k > 0) CHECK(path > before);
            before = path;
            all.insert(all.end(), {path, image});
        }
        for (std::uint64_t k = 0; k < paths.resting(); ++k) {
            CHECK(paths.mirror(paths.resting_path(k)) == paths.resting_path(k));
            all.push_back(paths.resting_path(k));
        }
        std::sort(all.begin(), all.end());
        REQUIRE(all.size() == paths.total());
        for (std::uint64_t k = 0; k < all.size(); ++k) CHECK(all[k] == k);
    }
}

TEST_CASE("Path numbers reach beyond 32 bits") {
    const auto paths = PathNumbering::mirrored(std::vector<std::uint64_t>(12, 16));
    CHECK(paths.total() == std::uint64_t{1} << 48);
    // the highest digit 14, of which 15 is the image, the others free
    CHECK(paths.tracked_path(paths.tracked() - 1) == paths.total() - 1 - (std::uint64_t{1} << 44));
}
