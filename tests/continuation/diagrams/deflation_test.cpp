// Deflated Newton: the equilibria of a polynomial, none twice, and none where there is none.
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/diagrams/deflation.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// (q - 1)(q - 2)(q + 3) = p, and a second unknown that follows it.
struct Cubic {
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        return Eigen::Vector2d((q(0) - 1) * (q(0) - 2) * (q(0) + 3) - p, q(1) - q(0) * q(0));
    }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double) const {
        Eigen::Matrix2d k;
        k << (q(0) - 2) * (q(0) + 3) + (q(0) - 1) * (q(0) + 3) + (q(0) - 1) * (q(0) - 2), 0, -2 * q(0), 1;
        return k;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd&, double) const { return Eigen::Vector2d(-1, 0); }
};

const Eigen::VectorXd guess = Eigen::Vector2d(0.3, 0.1), far = Eigen::Vector2d(-2, 0);

}  // namespace

TEST_CASE("Deflation finds more equilibria than it has guesses") {
    auto found = deflated_search(Cubic{}, 0, {guess, far}, {});
    REQUIRE(found.size() == 3);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a(0) < b(0); });
    const double roots[] = {-3, 1, 2};
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(found[k](0) == Approx(roots[k]).epsilon(1e-12));
        CHECK(found[k](1) == Approx(roots[k] * roots[k]).epsilon(1e-12));
    }
}

TEST_CASE("Deflation does not return what is known, and stops where no more is there") {
    std::vector<Eigen::VectorXd> known(2);
    known[0] = Eigen::Vector2d(1, 1);
    known[1] = Eigen::Vector2d(2, 4);
    CHECK_FALSE(deflated_newton(Cubic{}, 0, known[0], known));  // the guess is known itself
    const auto third = deflated_newton(Cubic{}, 0, far, known);
    REQUIRE(third);
    CHECK((*third)(0) == Approx(-3).epsilon(1e-12));
    known.push_back(*third);
    CHECK_FALSE(deflated_newton(Cubic{}, 0, guess, known));
    CHECK(deflated_search(Cubic{}, 100, {guess}, {}).size() == 1);  // one real root there
}

TEST_CASE("Deflation names options out of range") {
    DeflationOptions options;
    options.power = 0.5;
    CHECK_THROWS_WITH(deflated_newton(Cubic{}, 0, guess, {}, options), "power = 0.5: must be at least 1");
    options = {};
    options.longest_step = 0;
    CHECK_THROWS_WITH(deflated_newton(Cubic{}, 0, guess, {}, options), "longest_step = 0: must be positive");
}
