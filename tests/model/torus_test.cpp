// Angles in one turn, and distances on the torus: their laws at random configurations.
#include <cmath>
#include <limits>
#include <numbers>

#include <equilibria/core/random.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/torus.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

constexpr double pi = std::numbers::pi;

/// Two angles and a coordinate.
struct Mixed {
    static constexpr int n_angles = 2, n_coordinates = 1, n_parameters = 4;
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        return p[0] * cos(theta[0] - theta[1]) + x[0] * x[0];
    }
};

Unknowns<Mixed> random_configuration(Generator& generator) {
    Unknowns<Mixed> q;
    for (double& x : q) x = uniform(generator, -4, 4);
    return q;
}

}  // namespace

TEST_CASE("wrap(x + 2 pi k) = wrap(x), above -pi and at most pi, with the same cosine and sine") {
    Generator generator(1);
    for (int trial = 0; trial < 200; ++trial) {
        const double x = uniform(generator, -3.1, 3.1);
        CHECK(wrap(x) == x);
        for (const int k : {-1000, -3, -1, 1, 2, 1000})
            CHECK(std::abs(wrap(x + 2 * pi * k) - x) < 1e-15 * (10 + 7 * std::abs(k)));
        const double far = uniform(generator, -100, 100);
        CHECK(wrap(far) > -pi);
        CHECK(wrap(far) <= pi);
        CHECK(std::abs(std::cos(wrap(far)) - std::cos(far)) < 1e-14);
        CHECK(std::abs(std::sin(wrap(far)) - std::sin(far)) < 1e-14);
    }
    CHECK(wrap(pi) == pi);
    CHECK(wrap(-pi) == pi);
    CHECK(wrap(3 * pi) == Approx(pi).epsilon(1e-15));
    CHECK(std::isnan(wrap(std::numeric_limits<double>::infinity())));
}

TEST_CASE("the distance is a metric, that of a torus times a line, blind to whole turns of angles") {
    Generator generator(2);
    for (int trial = 0; trial < 200; ++trial) {
        const auto a = random_configuration(generator), b = random_configuration(generator),
                   c = random_configuration(generator);
        const double ab = distance<Mixed>(a, b);
        CHECK(distance<Mixed>(a, a) == 0);
        CHECK(ab == Approx(distance<Mixed>(b, a)).epsilon(1e-14));
        CHECK(ab <= distance<Mixed>(a, c) + distance<Mixed>(c, b) + 1e-14);
        CHECK(ab >= std::abs(a[2] - b[2]));
        auto turned = b;
        turned[0] += 4 * pi, turned[1] -= 2 * pi;
        CHECK(std::abs(distance<Mixed>(a, turned) - ab) < 1e-14);
        CHECK(same_unknowns<Mixed>(turned, b, 1e-14));
        CHECK(same_unknowns<Mixed>(wrapped<Mixed>(turned), b, 1e-14));
        turned = b;
        turned[2] += 2 * pi;  // a coordinate is no angle
        CHECK_FALSE(same_unknowns<Mixed>(turned, b, 1));
        // a + displacement(a, b) = b
        auto moved = a;
        for (int i = 0; i < 3; ++i) moved[i] += displacement<Mixed>(a, b)[i];
        CHECK(same_unknowns<Mixed>(moved, b, 1e-14));
    }
}

TEST_CASE("the mirror image turns the angles alone, and is its own inverse") {
    const Unknowns<Mixed> q{0.3, -1.2, 0.7};
    const auto image = mirrored<Mixed>(q);
    CHECK(image == Unknowns<Mixed>{-0.3, 1.2, 0.7});
    CHECK(mirrored<Mixed>(image) == q);
    // 0 and pi are their own images
    CHECK(same_unknowns<Mixed>(mirrored<Mixed>({pi, 0, 1}), {pi, 0, 1}, 1e-15));
}

TEST_CASE("what is not a number is no configuration") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(distance<Mixed>({nan, 0, 5}, {0, 0, 0})));
    CHECK(std::isnan(distance<Mixed>({0, 0, nan}, {1, 0, 0})));
    CHECK_FALSE(same_unknowns<Mixed>({nan, 0, 0}, {0, 0, 0}, 10));
}

TEST_CASE("parameters with other values of the active ones") {
    const Parameters<Mixed> p{1, 2, 3, 4};
    CHECK(with_active<3, 0>(p, 7.0, 8.0) == Parameters<Mixed>{8, 2, 3, 7});
    CHECK(with_active<1>(p, 9.0) == Parameters<Mixed>{1, 9, 3, 4});
    const auto lifted = detail::lifted_with_active<2, 0>(p, Array<float, 3>{0, 5, 6}, 1);
    CHECK(lifted == Array<float, 4>{6, 2, 5, 4});
}
