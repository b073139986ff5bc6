#include <complex>
#include <filesystem>
#include <numbers>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/paths/detail/coincidence_finder.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

namespace {

using Q = RuntimePoint<double>;
using Finder = detail::CoincidenceFinder;

const RuntimeSizes sizes(1, 1);

Q point(std::complex<double> theta, std::complex<double> x) {
    auto q = point_of_zeros<RuntimeUnknowns, double>(sizes);
    set_lane(q.c[0], 0, std::cos(theta));
    set_lane(q.s[0], 0, std::sin(theta));
    set_lane(q.x[0], 0, x);
    return q;
}

using Groups = std::vector<std::vector<std::size_t>>;

Groups groups(const std::vector<Q>& points, double tolerance, bool reflected = false) {
    return Finder(reflected, sizes)
        .groups(points.size(), [&](std::size_t k) { return PointView(points[k]); }, tolerance);
}

}  // namespace

TEST_CASE("coinciding points are grouped, others are not") {
    const auto a = point({0.3, 0.2}, 1.0), b = point({0.3, 0.2 + 1e-12}, 1.0), c = point({0.3, 0.2 + 1e-6}, 1.0);
    const auto d = point({0.3 + 2 * std::numbers::pi, 0.2}, 1.0), e = point({0.3, 0.2}, 1.0 + 1e-6);
    CHECK(groups({a, c, b, e, d}, 1e-9) == Groups{{0, 2, 4}});
    CHECK(groups({a, c, b, e, d}, 1e-5) == Groups{{0, 1, 2, 3, 4}});
    CHECK(groups({a, c, e}, 1e-9).empty());
    CHECK(groups({}, 1e-9).empty());
}

TEST_CASE("mirror images coincide only for the reflected finder") {
    const auto a = point({0.3, 0.2}, 1.0), b = point({-0.3, -0.2}, 1.0);
    CHECK(groups({a, b}, 1e-9, false).empty());
    CHECK(groups({a, b}, 1e-9, true) == Groups{{0, 1}});
}

TEST_CASE("the tolerance is relative to the size of the points") {
    const auto a = point({0.3, 12}, 1.0), b = point({0.3, 12 + 1e-11}, 1.0);
    CHECK(groups({a, b}, 1e-9) == Groups{{0, 1}});
    const auto x = point(0.3, 1e6), y = point(0.3, 1e6 + 1e-5);
    CHECK(groups({x, y}, 1e-9) == Groups{{0, 1}});
    CHECK(groups({x, y}, 1e-12).empty());
}

TEST_CASE("points that are left out are in no group") {
    const std::vector<Q> points(4, point(1, 2));
    const auto found =
        Finder(false, sizes)
            .groups(points.size(), [&](std::size_t k) { return k == 2 ? PointView() : PointView(points[k]); }, 1e-9);
    CHECK(found == Groups{{0, 1, 3}});
}

TEST_CASE("among many points, as comparing all pairs would") {
    Generator generator(4);
    std::vector<Q> points;
    Groups expected;
    for (std::size_t k = 0; k < 600; ++k) {
        const std::complex<double> theta(uniform(generator, -3, 3), uniform(generator, -2, 2)),
            x(uniform(generator), 0.1);
        if (k % 50 == 7) {
            expected.push_back({points.size(), points.size() + 1});
            points.push_back(point(theta, x));
        }
        points.push_back(point(theta, x));
    }
    CHECK(groups(points, 1e-9) == expected);
}

TEST_CASE("keys that do not fit into memory are sorted in files, and give the same groups") {
    Generator generator(3);
    std::vector<Q> points;
    for (int k = 0; k < 20000; ++k) {
        // far out as well, and twice or three times the same
        const double out = k % 7 == 0 ? 1e6 : 1;
        points.push_back(
            point({uniform(generator, -3, 3), uniform(generator, -2, 2)}, out * uniform(generator, -1, 1)));
        if (k % 11 == 0) points.push_back(points[points.size() / 2]);
    }
    const auto at = [&](std::size_t k) { return k % 13 == 5 ? PointView() : PointView(points[k]); };
    for (const double tolerance : {1e-9, 1e-5}) {
        const Groups whole = Finder(false, sizes).groups(points.size(), at, tolerance);
        CHECK(whole.size() > 1000);
        const tests::ScratchFile scratch("coincidences.ckpt");
        for (const std::uint64_t memory : {100000u, 5000u}) {
            const Finder small(false, sizes, {memory, scratch.name()});
            CHECK(small.groups(points.size(), at, tolerance) == whole);
        }
        CHECK_FALSE(std::filesystem::exists(scratch.name() + ".keys"));
    }
    const Finder nowhere(false, sizes, {1000, "missing/folder.ckpt"});
    CHECK_THROWS_AS(nowhere.groups(points.size(), at, 1e-9), CheckpointError);
}
