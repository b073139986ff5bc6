#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <cstdlib>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/polyhedral/mixed_area.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/run/threads.hpp>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "support/catch.hpp"
#include "support/support_families.hpp"

using namespace equilibria;

namespace {

using Rational = boost::multiprecision::cpp_rational;

struct KeptCell {
    std::vector<std::array<int, 2>> edges;
    std::uint64_t volume;
    std::vector<std::int64_t> heights;
    bool operator==(const KeptCell&) const = default;
    bool operator<(const KeptCell& b) const {
        return std::tie(edges, volume, heights) < std::tie(b.edges, b.volume, b.heights);
    }
};

std::vector<KeptCell> kept_cells(const Supports& supports, const Lifting& lifting,
                                 const MixedCellOptions& options = {}) {
    std::vector<KeptCell> y;
    mixed_cells(
        supports, lifting,
        [&](const MixedCell& cell) {
            y.push_back(
                {{cell.edges.begin(), cell.edges.end()}, cell.volume, {cell.heights.begin(), cell.heights.end()}});
        },
        options);
    return y;
}

Lifting drawn_lifting(const Supports& supports, std::uint64_t seed, std::int64_t range = 1 << 20) {
    Generator generator(seed);
    Lifting y(static_cast<std::size_t>(supports.columns()));
    for (auto& w : y) w = static_cast<std::int64_t>(generator() % static_cast<std::uint64_t>(2 * range)) - range;
    return y;
}

Supports drawn_supports(Generator& generator, int n, int points, int range) {
    support_families::Equations y(static_cast<std::size_t>(n));
    for (auto& equation : y) {
        const auto size = 1 + generator() % static_cast<std::uint64_t>(points);
        for (std::uint64_t k = 0; k < size; ++k) {
            auto& point = equation.emplace_back();
            for (int l = 0; l < n; ++l)
                point.push_back(static_cast<int>(generator() % static_cast<std::uint64_t>(2 * range + 1)) - range);
        }
    }
    return support_families::without_copies(n, std::move(y));
}

Rational determinant_of(std::vector<std::vector<Rational>> a) {
    Rational y = 1;
    for (std::size_t c = 0; c < a.size(); ++c) {
        std::size_t p = c;
        while (p < a.size() && a[p][c] == 0) ++p;
        if (p == a.size()) return 0;
        if (p != c) {
            std::swap(a[p], a[c]);
            y = -y;
        }
        y *= a[c][c];
        for (std::size_t r = c + 1; r < a.size(); ++r) {
            const Rational f = a[r][c] / a[c][c];
            for (std::size_t k = c; k < a.size(); ++k) a[r][k] -= f * a[c][k];
        }
    }
    return y;
}

/// The cell's heights from its plane, which Cramer's rule gives: volume times (w + gamma . a - beta).
void check_heights_by_the_plane(const Supports& supports, const Lifting& lifting, const KeptCell& cell) {
    const auto n = static_cast<std::size_t>(supports.unknowns());
    std::vector<std::vector<Rational>> edges(n, std::vector<Rational>(n));
    std::vector<Rational> rise(n);
    const auto lift = [&](std::size_t i, int k) {
        return lifting[static_cast<std::size_t>(supports.first_column(static_cast<int>(i)) + k)];
    };
    for (std::size_t i = 0; i < n; ++i) {
        const auto& points = supports.equations()[i];
        const auto [a, b] = cell.edges[i];
        for (std::size_t l = 0; l < n; ++l)
            edges[i][l] = points[static_cast<std::size_t>(a)][l] - points[static_cast<std::size_t>(b)][l];
        rise[i] = lift(i, b) - lift(i, a);
    }
    const Rational determinant = determinant_of(edges);
    REQUIRE(abs(determinant) == cell.volume);
    std::vector<Rational> gamma(n);
    for (std::size_t l = 0; l < n; ++l) {
        auto replaced = edges;
        for (std::size_t i = 0; i < n; ++i) replaced[i][l] = rise[i];
        gamma[l] = determinant_of(replaced) / determinant;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const auto& points = supports.equations()[i];
        const auto value = [&](int k) {
            Rational y = lift(i, k);
            for (std::size_t l = 0; l < n; ++l) y += gamma[l] * points[static_cast<std::size_t>(k)][l];
            return y;
        };
        const Rational beta = value(cell.edges[i][0]);
        for (int k = 0; k < static_cast<int>(points.size()); ++k) {
            const auto height = cell.heights[static_cast<std::size_t>(supports.first_column(static_cast<int>(i)) + k)];
            REQUIRE(height == cell.volume * (value(k) - beta));
            REQUIRE(height >= 0);
        }
    }
}

}  // namespace

TEST_CASE("mixed volumes of families are those of gfan_mixedvolume") {
    using namespace support_families;
    const auto volume = [](const Supports& supports) { return mixed_volume(supports).value; };
    CHECK(volume(cyclic(5)) == 70);
    CHECK(volume(cyclic(7)) == 924);
    CHECK(volume(cyclic(8)) == 2560);
    CHECK(volume(cyclic(9)) == 11016);
    CHECK(volume(noon(8)) == 6545);
    CHECK(volume(noon(10)) == 59049 - 20);
    CHECK(volume(chandra(8)) == 128);
    CHECK(volume(katsura(8)) == 240);
    CHECK(volume(katsura(10)) == 990);
    CHECK(volume(gaukwa(3)) == 49);
    CHECK(volume(gaukwa(4)) == 729);
    CHECK(volume(gaukwa(5)) == 14641);
    CHECK(volume(eco(10)) == 256);
    CHECK(volume(eco(12)) == 1024);
    for (int n = 1; n <= 6; ++n) CHECK(volume(chain(n)) == std::uint64_t{1} << (2 * n));
    const std::uint64_t binomials[] = {70, 252, 924, 3432};
    for (int n = 4; n <= 7; ++n) {
        CHECK(volume(all_to_all(n)) == binomials[n - 4]);
        CHECK(volume(kuramoto_complete(n + 1)) == binomials[n - 4]);
    }
    const std::uint64_t neighbours[] = {16, 44, 120, 328, 896, 2448, 6688, 18272};
    for (int n = 3; n <= 10; ++n) CHECK(volume(nearest_neighbour(n)) == neighbours[n - 3]);
    CHECK(volume(kuramoto_grid(3, 3, false)) == 1280);
    CHECK(volume(kuramoto_grid(3, 3, true)) == 5220);
    CHECK(volume(power_flow_9()) == 768);
}

TEST_CASE("a mixed volume of two small polygons, its cells and their volumes") {
    const Supports supports(2, {{{0, 0}, {0, 2}, {1, 0}, {1, 1}}, {{0, 0}, {0, 1}, {1, 1}, {2, 0}}});
    CHECK(mixed_volume(supports).value == 4);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        std::uint64_t sum = 0;
        const auto found =
            mixed_cells(supports, drawn_lifting(supports, seed), [&](const MixedCell& cell) { sum += cell.volume; });
        CHECK(sum == 4);
        CHECK(found.value == 4);
        CHECK(found.complete);
    }
}

TEST_CASE("supports without mixed cells have mixed volume 0") {
    CHECK(mixed_volume(Supports(1, {{{3}}})).value == 0);
    CHECK(mixed_volume(Supports(1, {{{-3}, {4}, {0}}})).value == 7);
    CHECK(mixed_volume(Supports(2, {{{0, 0}, {1, 1}}, {{7, 7}}})).value == 0);
    // parallel segments, and three equations of two of the unknowns
    CHECK(mixed_volume(Supports(2, {{{0, 0}, {1, 1}}, {{2, 0}, {4, 2}, {3, 1}}})).value == 0);
    const std::vector<Supports::Point> plane{{0, 0, 5}, {1, 0, 5}, {0, 2, 5}, {-1, -1, 5}};
    CHECK(mixed_volume(Supports(3, {plane, plane, plane})).value == 0);
    CHECK(kept_cells(Supports(3, {plane, plane, plane}), Lifting(12, 7)).empty());
}

TEST_CASE("mixed volumes of random supports are those by areas, and of three equations by one more dimension") {
    Generator generator(11);
    for (int turn = 0; turn < 300; ++turn) {
        const auto supports = drawn_supports(generator, 2, 7, turn % 2 == 0 ? 3 : 40);
        std::array<std::vector<detail::LatticePoint>, 2> points;
        for (std::size_t i = 0; i < 2; ++i)
            for (const auto& a : supports.equations()[i]) points[i].push_back({a[0], a[1]});
        const auto area = detail::mixed_area(points[0], points[1]);
        REQUIRE(mixed_volume(supports).value == static_cast<std::uint64_t>(area));
        // a segment in a third direction, with a shear: its length times the mixed area along it
        support_families::Equations three;
        for (std::size_t i = 0; i < 2; ++i) {
            auto& equation = three.emplace_back();
            for (const auto& a : supports.equations()[i]) equation.push_back({a[0], a[1], 2 * a[0] - a[1]});
        }
        three.push_back({{0, 0, -1}, {0, 0, 4}, {0, 0, 2}});
        REQUIRE(mixed_volume(Supports(3, three)).value == 5 * static_cast<std::uint64_t>(area));
    }
}

TEST_CASE("mixed volumes are linear in each support and symmetric") {
    Generator generator(12);
    for (int turn = 0; turn < 60; ++turn) {
        const auto supports = drawn_supports(generator, 3, 6, 4);
        const auto volume = mixed_volume(supports).value;
        auto doubled = supports.equations();
        for (auto& point : doubled[static_cast<std::size_t>(turn % 3)])
            for (auto& x : point) x = 3 * x - 5;
        REQUIRE(mixed_volume(Supports(3, doubled)).value == 3 * volume);
        auto rotated = supports.equations();
        std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
        REQUIRE(mixed_volume(Supports(3, rotated)).value == volume);
    }
}

TEST_CASE("mixed volumes and cells do not depend on the order of the equations, nor volumes on the lifting") {
    for (const auto& supports : {support_families::cyclic(6), support_families::nearest_neighbour(5),
                                 support_families::noon(4), support_families::eco(6)}) {
        const auto n = static_cast<std::size_t>(supports.unknowns());
        const auto volume = mixed_volume(supports).value;
        MixedCellOptions other;
        for (std::size_t i = 0; i < n; ++i) other.order.push_back(static_cast<int>((3 * i + 2) % n));
        if (n % 3 == 0)
            for (std::size_t i = 0; i < n; ++i) other.order[i] = static_cast<int>(n - 1 - i);
        CHECK(mixed_volume(supports, other).value == volume);
        CHECK(mixed_volume(supports, other).order == other.order);
        for (const std::uint64_t seed : {1u, 2u}) {
            const auto lifting = drawn_lifting(supports, seed);
            auto cells = kept_cells(supports, lifting), same = kept_cells(supports, lifting, other);
            std::uint64_t sum = 0;
            for (const auto& cell : cells) sum += cell.volume;
            CHECK(sum == volume);
            std::sort(cells.begin(), cells.end());
            std::sort(same.begin(), same.end());
            CHECK(std::adjacent_find(cells.begin(), cells.end()) == cells.end());
            CHECK(cells == same);
        }
    }
}

TEST_CASE("heights of mixed cells are those above their planes") {
    for (const auto& supports :
         {support_families::cyclic(5), support_families::nearest_neighbour(4), support_families::gaukwa(2)}) {
        const auto lifting = drawn_lifting(supports, 5);
        const auto cells = kept_cells(supports, lifting);
        REQUIRE(!cells.empty());
        for (const auto& cell : cells) check_heights_by_the_plane(supports, lifting, cell);
    }
}

TEST_CASE("liftings with ties end, and tell the cells that are not fine") {
    const auto supports = support_families::cyclic(5);
    const auto count_fine = [&](const Lifting& lifting, std::uint64_t& volume) {
        int fine = 0;
        volume =
            mixed_cells(supports, lifting, [&](const MixedCell& cell) {
                fine += cell.fine();
                for (const auto h : cell.heights) REQUIRE(h >= 0);
                for (std::size_t i = 0; i < cell.edges.size(); ++i)
                    for (const int k : cell.edges[i])
                        REQUIRE(
                            cell.heights[static_cast<std::size_t>(supports.first_column(static_cast<int>(i)) + k)] ==
                            0);
            }).value;
        return fine;
    };
    std::uint64_t volume = 0;
    CHECK(count_fine(Lifting(static_cast<std::size_t>(supports.columns()), 3), volume) == 0);
    CHECK(volume == 70);
    count_fine(drawn_lifting(supports, 3, 2), volume);
    CHECK(volume == 70);
    CHECK(count_fine(drawn_lifting(supports, 3), volume) > 10);
    CHECK(volume == 70);
}

TEST_CASE("wider integers, where entries might not fit, give the same cells") {
    const auto supports = support_families::cyclic(6);
    const auto lifting = drawn_lifting(supports, 9);
    const auto expected = kept_cells(supports, lifting);
    const auto narrow = mixed_volume(supports);
    CHECK(narrow.exchanges_by_width[0] == narrow.exchanges);
    for (const auto& [largest_narrow, largest_wide] :
         {std::pair<std::int32_t, std::int64_t>{100, 1 << 30}, {40, 300}, {1, 1 << 30}, {1, 1}, {20, 20}}) {
        MixedCellOptions options;
        options.largest_narrow = largest_narrow;
        options.largest_wide = largest_wide;
        const auto volume = mixed_volume(supports, options);
        CHECK(volume.value == 156);
        CHECK(volume.exchanges == narrow.exchanges);
        CHECK(volume.exchanges_by_width[0] < narrow.exchanges);
        if (largest_narrow == 1 && largest_wide == 1) CHECK(volume.exchanges_by_width[2] > narrow.exchanges / 2);
        CHECK(kept_cells(supports, lifting, options) == expected);
    }
}

TEST_CASE("exponents and liftings as large as they may be") {
    // two triangles of degree d: d^2, in 64 bits up to d = 2^31
    const int d = 1 << 30;
    const std::vector<Supports::Point> triangle{{-d, -d}, {d, -d}, {-d, d}};
    const auto volume = mixed_volume(Supports(2, {triangle, triangle}));
    CHECK(volume.value == std::uint64_t{1} << 62);
    CHECK(volume.exchanges_by_width[0] < volume.exchanges);
    std::vector<Supports::Point> corners{{-d, -d, -d}, {d, -d, -d}, {-d, d, -d}, {-d, -d, d}};
    try {
        mixed_volume(Supports(3, {corners, corners, corners}));
        FAIL("a mixed volume of 2^93 was told");
    } catch (const InvalidArgument& error) {
        CHECK(std::string(error.what()) ==
              "supports = 9903520314283042199192993792: must have a mixed volume below 2^64");
    }
    const auto supports = support_families::cyclic(4);
    const auto lifting = drawn_lifting(supports, 2, std::int64_t{1} << 56);
    std::uint64_t sum = 0;
    mixed_cells(supports, lifting, [&](const MixedCell& cell) { sum += cell.volume; });
    CHECK(sum == mixed_volume(supports).value);
    CHECK_THROWS_AS(mixed_cells(supports, drawn_lifting(supports, 2, std::int64_t{1} << 60), [](const MixedCell&) {}),
                    InvalidArgument);
    // the same heights, times 2^36
    const auto small = drawn_lifting(supports, 2);
    auto large = small;
    for (auto& w : large) w <<= 36;
    auto cells = kept_cells(supports, small);
    for (auto& cell : cells)
        for (auto& h : cell.heights) h <<= 36;
    CHECK(kept_cells(supports, large) == cells);
}

TEST_CASE("threads find the same cells in the same order") {
    const auto supports = support_families::nearest_neighbour(7);
    const auto lifting = drawn_lifting(supports, 4);
    const auto expected = kept_cells(supports, lifting);
    const auto alone = mixed_volume(supports);
    for (const unsigned count : {2u, 3u, 5u}) {
        MixedCellOptions options;
        options.executor = threads(count);
        CHECK(kept_cells(supports, lifting, options) == expected);
        const auto together = mixed_volume(supports, options);
        CHECK(together.value == alone.value);
        CHECK(together.cells == alone.cells);
        CHECK(together.exchanges_by_width == alone.exchanges_by_width);
    }
}

TEST_CASE("a sink ends the walk by false, or by an exception") {
    const auto supports = support_families::nearest_neighbour(6);
    const auto lifting = drawn_lifting(supports, 4);
    const auto expected = kept_cells(supports, lifting);
    for (const unsigned count : {1u, 3u}) {
        MixedCellOptions options;
        options.executor = threads(count);
        std::vector<std::uint64_t> volumes;
        const auto found = mixed_cells(
            supports, lifting,
            [&](const MixedCell& cell) {
                volumes.push_back(cell.volume);
                return volumes.size() < 5;
            },
            options);
        CHECK(!found.complete);
        CHECK(found.cells == 5);
        REQUIRE(volumes.size() == 5);
        for (std::size_t k = 0; k < 5; ++k) CHECK(volumes[k] == expected[k].volume);
        CHECK_THROWS_AS(mixed_cells(
                            supports, lifting, [](const MixedCell&) { throw std::runtime_error("enough"); }, options),
                        std::runtime_error);
    }
}

TEST_CASE("orders and liftings that are none are refused") {
    const auto supports = support_families::cyclic(3);
    const auto refusal = [&](const MixedCellOptions& options, const Lifting& lifting) -> std::string {
        try {
            mixed_cells(supports, lifting, [](const MixedCell&) {}, options);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "none";
    };
    const Lifting flat(static_cast<std::size_t>(supports.columns()));
    CHECK(refusal({.order = {0, 1}}, flat) == "options.order.size() = 2: must be the number of equations, 3, or 0");
    CHECK(refusal({.order = {0, 1, 1}}, flat) ==
          "options.order = 1: must have each number of an equation, from 0 on, once");
    CHECK(refusal({.largest_narrow = 0}, flat) == "options.largest_narrow = 0: must be at least 1");
    CHECK(refusal({}, {1, 2}) == "lifting.size() = 2: must be the number of columns of the supports, 8");
    auto high = flat;
    high[1] = (std::int64_t{1} << 60) + 1;
    CHECK(refusal({}, high) == "lifting[1] = 1152921504606846977: must be from -2^60 to 2^60");
}

TEST_CASE("a mixed volume is counted up to the most that is asked for, with any number of threads") {
    const Supports supports = support_families::all_to_all(5);
    for (const unsigned workers : {1U, 3U}) {
        const auto below = mixed_volume(supports, {.executor = threads(workers), .most_volume = 100});
        CHECK_FALSE(below.complete);
        CHECK(below.value == 100);
        const auto whole = mixed_volume(supports, {.executor = threads(workers), .most_volume = 252});
        CHECK(whole.complete);
        CHECK(whole.value == 252);
    }
}
