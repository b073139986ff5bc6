#include <array>
#include <string>

#include <equilibria/certify/refine_root.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// x^2 = p.
struct Root2 {
    static constexpr int n_angles = 0, n_coordinates = 1, n_parameters = 1;
    constexpr auto equations(const auto&, const auto& x, const auto& p) const { return std::array{x[0] * x[0] - p[0]}; }
};
/// sin(theta) = p.
using models::Pendulum;

}  // namespace

TEST_CASE("the square root of two to 1,000 digits") {
    const auto root = refine<Root2>({{1.4}}, {{2}}, 1000);
    REQUIRE(root.proved_real);
    CHECK(root.real[0].size() == 1002);
    // sqrt(2) = 1.41421356237309504880168872420969807856967187537694807317667973799...
    CHECK(root.real[0].substr(0, 60) == "1.4142135623730950488016887242096980785696718753769480731766");
    // its square is 2, to 999 digits
    using S = Multiprecision<1100>;
    const S x(root.real[0]);
    S ulp(1);
    for (int k = 0; k < 1000; ++k) ulp = ulp / S(10);
    CHECK(abs(x * x - S(2)) < S(4) * ulp);
}

TEST_CASE("asin 1/2 is pi / 6, and non-real angles have imaginary parts") {
    const auto sixth = refine<Pendulum>({{0.5}}, {{0.5}}, 50);
    REQUIRE(sixth.proved_real);
    CHECK(sixth.real[0] == "0.52359877559829887307710723054658381403286156656252");
    CHECK(Multiprecision<60>(sixth.imaginary[0]) == Multiprecision<60>(0));
    // sin(theta) = 2: pi/2 - i log(2 + sqrt 3)
    const auto over = refine<Pendulum>({{{1.5, -1.3}}}, {{2}}, 40);
    REQUIRE(over.proved);
    CHECK_FALSE(over.proved_real);
    CHECK(over.real[0] == "1.5707963267948966192313216916397514420986");
    const Multiprecision<60> expected = -log(Multiprecision<60>(2) + sqrt(Multiprecision<60>(3)));
    CHECK(abs(Multiprecision<60>(over.imaginary[0]) - expected) < Multiprecision<60>(1e-40));
}

TEST_CASE("more digits continue fewer ones") {
    using M = mechanisms::TwoLinkChain;
    const Parameters<M> p{{.3, 1.5, 2}};
    const auto few = refine<M>({{1.39806, 1.47023}}, p, 80), many = refine<M>({{1.39806, 1.47023}}, p, 1000);
    REQUIRE(few.proved_real);
    REQUIRE(many.proved_real);
    for (int i = 0; i < 2; ++i) CHECK(many.real[i].substr(0, 80) == few.real[i].substr(0, 80));
}

TEST_CASE("nothing is proved of a double root, and bad arguments are refused") {
    CHECK_FALSE(refine<Root2>({{1e-3}}, {{0}}, 20).proved);
    CHECK_THROWS_WITH(refine<Root2>({{1}}, {{2}}, 0), "digits = 0: must be 1 to 1000");
    CHECK_THROWS_WITH(refine<Root2>({{1}}, {{2}}, 1001), "digits = 1001: must be 1 to 1000");
    CHECK_THROWS_AS(refine<Root2>({{std::nan("")}}, {{2}}, 10), InvalidArgument);
}
