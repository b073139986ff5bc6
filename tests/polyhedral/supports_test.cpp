#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <string>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

std::string refusal_of_supports(int unknowns, std::vector<std::vector<Supports::Point>> equations) {
    try {
        Supports(unknowns, std::move(equations));
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("supports number the points of all equations as columns") {
    const Supports supports(2, {{{0, 0}, {0, -2}, {1, 0}}, {{5, 5}}});
    CHECK(supports.unknowns() == 2);
    CHECK(supports.columns() == 4);
    CHECK(supports.first_column(0) == 0);
    CHECK(supports.first_column(1) == 3);
    CHECK(supports.first_column(2) == 4);
    CHECK(supports.equations()[0][1] == Supports::Point{0, -2});
}

TEST_CASE("supports that are none are refused by name, value and what is allowed") {
    CHECK(refusal_of_supports(0, {}) == "unknowns = 0: must be from 1 to 1024");
    CHECK(refusal_of_supports(2, {{{0, 0}}}) ==
          "equations.size() = 1: must be the number of unknowns, 2: the system is square");
    CHECK(refusal_of_supports(1, {{}}) ==
          "equations[0].size() = 0: must be at least 1: an equation without a term is none");
    CHECK(refusal_of_supports(2, {{{0, 0}}, {{0, 0}, {1}}}) ==
          "equations[1][1].size() = 1: must be the number of unknowns, 2");
    CHECK(refusal_of_supports(1, {{{2}, {0}, {2}}}) ==
          "equations[0][2] = the same point as number 0: must be another one: add their coefficients");
    CHECK(refusal_of_supports(1, {{{0}, {(1 << 30) + 1}}}) ==
          "equations[0][1] = 1073741825: must have exponents from -2^30 to 2^30");
}
