// Newton's method of the refinements, on equations in one unknown whose course is known.
#include <cmath>
#include <limits>
#include <utility>

#include <equilibria/singularity/singularity_newton.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE(
    "Newton's method: quadratic to the last digit, and not converged where it diverges or meets what is no number") {
    struct Report {
        int steps = 0;
        double correction = 0;
        bool converged = false;
    };
    const auto solve = [](double start, auto&& f) {
        Report at;
        Array<double, 1> y{start};
        detail::newton_method(y, at, [&](const auto& now, auto& r, auto& jacobian) {
            const auto u = detail::independent(now);
            detail::split_duals(Array<Dual<double, 1>, 1>{f(u[0])}, r, jacobian);
            return true;
        });
        return std::pair(y[0], at);
    };
    const auto [root, at] = solve(1.5, [](const auto& x) { return x * x - 2.0 * Dual<double, 1>(1.0); });
    CHECK(at.converged);
    CHECK(at.steps <= 6);
    CHECK(std::abs(root - std::sqrt(2)) < 1e-15);
    // a double root: linear, half of the error a step
    const auto [twofold, slow] = solve(1.0, [](const auto& x) { return x * x; });
    CHECK(slow.steps > 30);
    // no zero, and no number
    CHECK_FALSE(solve(0.3, [](const auto& x) { return x * x + Dual<double, 1>(1.0); }).second.converged);
    CHECK_FALSE(solve(0.5, [](const auto& x) { return sqrt(x - Dual<double, 1>(1.0)); }).second.converged);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(detail::largest(Array<double, 3>{1, nan, 2})));
    CHECK(std::isnan(detail::largest(Array<double, 2>{nan, 2})));
}
