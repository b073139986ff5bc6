#include <array>
#include <limits>
#include <locale>
#include <stdexcept>
#include <string>
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

TEST_CASE("values are written the same whatever the global locale") {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string number = to_text(1.5), integer = to_text(1234567);
    std::locale::global(before);
    CHECK(number == "1.5");
    CHECK(integer == "1234567");
}

TEST_CASE("the entry that is not finite is named") {
    CHECK_NOTHROW(require_finite(std::array{1.0, -1e308}, "p"));
    CHECK_NOTHROW(require_finite(std::vector<double>{}, "p"));
    CHECK_THROWS_WITH(require_finite(std::array{1.0, std::numeric_limits<double>::infinity()}, "p"),
                      "p[1] = inf: must be finite");
    CHECK_THROWS_AS(require_finite(std::array{std::numeric_limits<double>::quiet_NaN()}, "p"), InvalidArgument);
}
