#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include <equilibria/core/error.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("an error names the argument, its value and what is allowed") {
    CHECK_NOTHROW(require(true, "step", 0.1, "must be positive"));
    CHECK_THROWS_WITH(require(false, "step", -0.1, "must be positive"),
                      "step = -0.10000000000000001: must be positive");
    CHECK_THROWS_WITH(require(false, "name", "x y", "must not contain a blank"),
                      "name = x y: must not contain a blank");
    CHECK_THROWS_AS(require(false, "count", 0, "must be positive"), std::invalid_argument);
}

TEST_CASE("the entry that is not finite is named") {
    CHECK_NOTHROW(require_finite(std::array{1.0, -1e308}, "p"));
    CHECK_NOTHROW(require_finite(std::vector<double>{}, "p"));
    CHECK_THROWS_WITH(require_finite(std::array{1.0, std::numeric_limits<double>::infinity()}, "p"),
                      "p[1] = inf: must be finite");
    CHECK_THROWS_AS(require_finite(std::array{std::numeric_limits<double>::quiet_NaN()}, "p"), InvalidArgument);
}
