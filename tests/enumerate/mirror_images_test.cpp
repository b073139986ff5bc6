#include <complex>
#include <numbers>
#include <vector>

#include <equilibria/enumerate/detail/mirror_images.hpp>

#include "support/catch.hpp"

using equilibria::detail::MirrorImages;
using std::numbers::pi;

namespace {

using Unknowns = std::vector<std::complex<double>>;

MirrorImages images(const std::vector<Unknowns>& roots) {
    return {roots.size(), [&](std::size_t k) { return MirrorImages::Unknowns(roots[k]); }};
}

constexpr auto none = MirrorImages::none;

}  // namespace

TEST_CASE("roots are paired that are each other's image to the last bit") {
    const Unknowns a{{0.5, 0.25}, {-1, 2}}, image{{-0.5, -0.25}, {1, -2}}, conjugate{{0.5, -0.25}, {-1, -2}},
        near{{-0.5, -0.25}, {1, -2.0000000000000004}};
    CHECK(images({a, conjugate, near, image}).image == std::vector<std::uint32_t>{3, none, none, none});
    CHECK(images({a, conjugate, near, image}).is_image == std::vector<std::uint8_t>{0, 0, 0, 1});
    CHECK(images({image, a}).image == std::vector<std::uint32_t>{1, none});
    CHECK(images({a, near}).image == std::vector<std::uint32_t>{none, none});
}

TEST_CASE("pi is its own image, as 0 is, and a root is not its own partner") {
    const Unknowns up{{pi, 0.5}, {0.0, 1}}, image{{pi, -0.5}, {-0.0, -1}}, straight{{pi, 0}, {0, 0}};
    CHECK(images({up, image}).image == std::vector<std::uint32_t>{1, none});
    CHECK(images({straight}).image == std::vector<std::uint32_t>{none});
}

TEST_CASE("each root has one partner at most, and one without unknowns none") {
    const Unknowns a{{0.5, 0.25}}, image{{-0.5, -0.25}};
    CHECK(images({a, image, image, a}).image == std::vector<std::uint32_t>{1, none, 3, none});
    CHECK(images({{}, {}}).image == std::vector<std::uint32_t>{none, none});
    CHECK(images({}).image.empty());
}

TEST_CASE("among many roots") {
    std::vector<Unknowns> roots;
    for (int k = 0; k < 1000; ++k) roots.push_back({{0.001 * k + 0.0005, 0.1 * k}, {1.0, -0.7 * k}});
    for (int k = 999; k >= 0; --k)
        roots.push_back({-roots[static_cast<std::size_t>(k)][0], -roots[static_cast<std::size_t>(k)][1]});
    const auto found = images(roots);
    for (std::size_t k = 0; k < 1000; ++k) {
        CHECK(found.image[k] == 1999 - k);
        CHECK(found.is_image[1999 - k] == 1);
    }
}
