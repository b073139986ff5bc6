// Newton's method at a fixed parameter: quadratic convergence, next to a fold, at one, and what it refuses.
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// x^2 + p, with a second unknown that follows: y - x^3. A fold at p = 0.
struct Fold {
    VectorXd residual(const VectorXd& q, double p) const {
        return Eigen::Vector2d(q(0) * q(0) + p, q(1) - q(0) * q(0) * q(0));
    }
    MatrixXd tangent(const VectorXd& q, double) const { return Eigen::Matrix2d{{2 * q(0), 0}, {-3 * q(0) * q(0), 1}}; }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector2d(1, 0); }
    static constexpr bool symmetric = false;
};
static_assert(ContinuationProblem<Fold>);

}  // namespace

TEST_CASE("Newton's method at a fixed parameter converges quadratically, next to a fold too") {
    const Fold problem;
    for (const double x : {1.0, 1e-2, 1e-5}) {
        CAPTURE(x);
        VectorXd q = Eigen::Vector2d(1.1 * x, 0);
        const auto y = correct_at(problem, q, -x * x, {.tolerance = 1e-14});
        REQUIRE(y.converged());
        CHECK(y.status == CorrectionStatus::converged);
        CHECK(y.steps <= 7);
        CHECK(q(0) == Approx(x).epsilon(1e-12));
        CHECK(q(1) == Approx(x * x * x).epsilon(1e-10).margin(1e-15));
    }
    // at the solution one correction says so
    VectorXd there = Eigen::Vector2d(1, 1);
    CHECK(correct_at(problem, there, -1).steps == 1);
}

TEST_CASE("Newton's method says why it ended, and leaves the last iterate") {
    const Fold problem;
    VectorXd q = Eigen::Vector2d(2, 0);
    const auto few = correct_at(problem, q, -1, {.most_steps = 1});
    CHECK(few.status == CorrectionStatus::steps);
    CHECK(few.steps == 1);
    CHECK(q(0) == Approx(1.25));  // (x + 1 / x) / 2
    // no solution: x^2 = -1
    q = Eigen::Vector2d(0.7, 0);
    CHECK(!correct_at(problem, q, 1).converged());
    q = Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN(), 0);
    const auto lost = correct_at(problem, q, -1);
    CHECK(lost.status == CorrectionStatus::not_finite);
    CHECK(lost.steps == 0);
    CHECK(std::string(to_string(lost.status)) == "not finite");
    CHECK_THROWS_WITH(correct_at(problem, q, 1, {.most_steps = 0}),
                      Catch::Matchers::Contains("most_steps = 0: must be at least 1"));
    CHECK_THROWS_AS(correct_at(problem, q, 1, {.tolerance = 0}), InvalidArgument);
    CHECK_THROWS_AS(correct_at(problem, q, 1, {.rounding = 0.5}), InvalidArgument);
}
