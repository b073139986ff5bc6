// Neville's scheme reproduces polynomials, of numbers and of vectors.
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/interpolated.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("a polynomial of degree five through six of its points") {
    const auto f = [](double x) { return 1 + x * (2 - x * (0.5 + x * x * (1 - 3 * x))); };
    const std::vector<double> places{-1, -0.6, -0.1, 0.2, 0.7, 1.1};
    std::vector<double> values;
    std::vector<Eigen::VectorXd> vectors;
    for (const double x : places) {
        values.push_back(f(x));
        vectors.push_back(Eigen::Vector2d(f(x), x));
    }
    for (const double x : {-0.9, 0.0, 0.5, 2.0}) {
        CHECK(interpolated(x, places, values) == Approx(f(x)).epsilon(1e-12));
        CHECK((interpolated(x, places, vectors) - Eigen::Vector2d(f(x), x)).norm() < 1e-11);
    }
    CHECK(interpolated(7, {3}, std::vector<double>{4}) == 4);
}
