// Complex roots as JSON: counts that agree, each root by the names of its unknowns.
#if __has_include(<nlohmann/json.hpp>)

#include <string>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/io/results/complex_roots_output.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("complex roots as JSON: paths, counts, roots by name, certificates") {
    // x^2 = 1, and y^2 = -1 or a double 0 at x = 1 or -1
    const PolynomialSystem<double> polynomials{
        {"x", "y"}, {{{1, {2, 0}}, {-1, {0, 0}}}, {{1, {0, 2}}, {0.5, {1, 0}}, {0.5, {0, 0}}}}};
    const auto system = sparse_system(polynomials);
    const auto found = solve_total_degree(system);
    Json json = json_of(found, polynomials.variables);
    CHECK(json["paths"] == 4);
    CHECK(json["finite"] == 2);
    CHECK(json["singular"] == 2);
    CHECK(json["distinct"] == 2);
    CHECK(json["real"] == 0);
    CHECK(json["singular_roots"] == 1);
    CHECK(json["failures"].empty());
    REQUIRE(json["roots"].size() == 3);
    add_root_certificates(json["roots"], prove(system, found, bezout_bounds(system)));
    for (const auto& root : json["roots"]) {
        CHECK(root["unknowns"]["x"].size() == 2);
        CHECK(root["unknowns"].contains("y"));
        CHECK(root["certificate"]["exists"] == !root["singular"].get<bool>());
        CHECK(root["multiplicity"] == (root["singular"].get<bool>() ? 2 : 1));
    }
    CHECK_THROWS_WITH(json_of(found, std::vector<std::string>{"x"}), "names = 1: must be one for each unknown");
}

#endif
