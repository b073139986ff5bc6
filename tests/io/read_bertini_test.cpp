// Bertini's classic input, read: what is written comes back, names stand for their sums, and what is wrong is refused
// with its place.
#if __has_include(<tao/pegtl.hpp>)

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/io/read_bertini.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

/// The error's text; empty if there is none.
std::string refusal(const std::string& text, const PolynomialLimits& limits = {}) {
    try {
        parse_bertini(text, limits);
    } catch (const InvalidArgument& e) {
        return e.what();
    }
    return {};
}

using Terms = std::vector<std::pair<std::vector<int>, Z>>;

/// Each exponent vector's coefficient in the first equation.
Terms terms(const std::string& text) {
    const auto system = parse_bertini(text).polynomials;
    Terms y;
    for (const auto& t : system.equations.at(0)) y.push_back({t.exponents, t.coefficient});
    return y;
}

/// Written and read: the same terms, in whatever order.
template <class C>
void check_round_trip(const PolynomialSystem<C>& system) {
    std::ostringstream out;
    write_bertini(out, system);
    const auto back = parse_bertini(out.str());
    CHECK(back.polynomials.variables == system.variables);
    CHECK(back.grouping == std::vector<int>(system.variables.size()));
    REQUIRE(back.polynomials.equations.size() == system.equations.size());
    for (std::size_t k = 0; k < system.equations.size(); ++k) {
        std::map<std::vector<int>, Z> expected, found;
        for (const auto& t : system.equations[k]) expected[t.exponents] = t.coefficient;
        for (const auto& t : back.polynomials.equations[k]) found[t.exponents] = t.coefficient;
        CHECK(found == expected);
    }
}

const std::string declared = "variable_group x, y;\nfunction f;\n";

}  // namespace

TEST_CASE("What is written for Bertini comes back exactly") {
    using Chain = mechanisms::RotatingChain<3>;
    Parameters<Chain> p;
    Generator generator(7);
    for (double& x : p) x = uniform(generator, 0.5, 2);
    check_round_trip(polynomial_system<Chain>(p));
    check_round_trip(PolynomialSystem<Z>{{"x", "y_1"}, {{{{0.1, -0.3}, {2, 1}}, {{-1e-300, 0}, {0, 0}}}, {}}});
}

TEST_CASE("Names of a Bertini system stand for their sums") {
    CHECK(terms("variable_group x;\nfunction f;\nconstant a, b;\na = 1/4; b = 2*a - I;\ng = x - a;\nf = g^2*b;\n") ==
          Terms{{{2}, {0.5, -1}}, {{1}, {-0.25, 0.5}}, {{0}, {0.03125, -0.0625}}});
    CHECK(terms(declared + "f = Pi*x - .5e1*y^(2);") == Terms{{{0, 2}, -5}, {{1, 0}, std::numbers::pi}});
    // functions come in the order of their declaration, and may be named by others
    const auto system = parse_bertini(
        "CONFIG\nEND_GAME: 3; % END;\nTrackType: 0;\nEND;\n\nINPUT % the system\nvariable_group x;\nfunction f, g;\n"
        "g = x % and\n- 1;f = g*g;\nEND;\nand what follows is not read");
    CHECK(system.polynomials.equations[0].size() == 3);
    CHECK(system.polynomials.equations[1].size() == 2);
}

TEST_CASE("Groups of variables of a Bertini system are kept") {
    CHECK(parse_bertini("variable_group a, b;\nvariable_group c;function f;f = a*b*c;").grouping ==
          std::vector<int>{0, 0, 1});
    CHECK(parse_bertini("variable a;variable_group c;variable b;function f;f = a*b*c;").grouping ==
          std::vector<int>{0, 1, 0});
}

TEST_CASE("An eigenproblem from a file of Bertini's is solved by its two groups") {
    const tests::ScratchFile file("eigenvectors");
    // A v = lambda v with v = (1, x, y): total degree 8, three eigenvectors
    const std::string text =
        "INPUT\nvariable_group l;\nvariable_group x, y;\nfunction f1, f2, f3;\n"
        "f1 = 2 + x - y - l;\nf2 = 1 - 3*x + 2*y - l*x;\nf3 = 0.5 + x + y - l*y;\nEND;\n";
    file.write({text.begin(), text.end()});
    const auto system = read_bertini(file.name());
    const auto found = solve_multihomogeneous(sparse_system(system.polynomials), system.grouping, {.seed = 2});
    CHECK(found.paths.total == 3);
    CHECK(found.roots.size() == 3);
    for (const auto& root : found.roots)
        for (const Z& value : evaluate(system.polynomials, std::vector<Z>(root.q.begin(), root.q.end())))
            CHECK(std::abs(value) < 1e-12);
}

TEST_CASE("What is no Bertini system is refused with its place") {
    CHECK(refusal("") == "number of variables = 0: must be at least 1: variable_group declares them");
    CHECK(refusal("variable_group x;") == "number of functions = 0: must be at least 1: function declares them");
    CHECK(refusal("CONFIG\nTrackType: 0;\n") == "line 3, column 1 = the end: END; must stand here");
    CHECK(refusal(declared + "2 = x;") ==
          "line 3, column 1 = 2 = x;: a declaration, name = sum; or END; must stand here");
    CHECK(refusal("variable_group x\n") == "line 2, column 1 = the end: a comma or ; must stand here");
    CHECK(refusal("variable_group x,;") == "line 1, column 18 = ;: a name must stand here");
    CHECK(refusal("variable_group;") == "line 1, column 15 = ;: = or names must stand here");
    CHECK(refusal("variables x;") ==
          "line 1, column 1 = variables x;: must be followed by =, or be variable_group, variable, function or "
          "constant before a list of names");
    CHECK(refusal("hom_variable_group x, y;") ==
          "line 1, column 1 = hom_variable_group x, y;: is of projective space, which is not read: a variable_group, "
          "in which one of these variables is put to 1, must stand here");
    CHECK(refusal("% homotopy\npathvariable t;").starts_with("line 2, column 1 = pathvariable t;: is of a homotopy"));
    CHECK(refusal("variable_group x, I;") == "line 1, column 19 = I;: is a word of Bertini's own, and no name");
    CHECK(refusal(declared + "constant x;") == "line 3, column 10 = x;: is declared already");
    CHECK(refusal(declared) == "line 2, column 10 = f;: is a function that gets no value");
    CHECK(refusal(declared + "f = x;\nf = y;") == "line 4, column 1 = f = y;: has a value already");
    CHECK(refusal(declared + "x = 1;") == "line 3, column 1 = x = 1;: is a variable, which gets no value");
    CHECK(refusal(declared + "constant a;\na = x;") ==
          "line 4, column 3 = = x;: must be a number, for it is the value of a constant");
    CHECK(refusal(declared + "constant a;\nf = a*x;") ==
          "line 4, column 5 = a*x;: has no value yet: name = sum; must stand before");
    CHECK(refusal(declared + "f = z;").starts_with("line 3, column 5 = z;: is no name yet"));
    CHECK(refusal(declared + "f = sin(x);").starts_with("line 3, column 5 = sin(x);: is not of a polynomial"));
    CHECK(refusal(declared + "f = x^y;") == "line 3, column 7 = y;: an integer must stand here, or one in parentheses");
    CHECK(refusal(declared + "f = x^-1;") == "line 3, column 3 = = x^-1;: must have no negative power of a variable");
    CHECK(refusal(declared + "f = x y;") == "line 3, column 7 = y;: an operator or ; must stand here");
    CHECK(refusal(declared + "f = ;") == "line 3, column 5 = ;: a number, a variable or ( must stand here");
}

TEST_CASE("A Bertini system beyond the limits is refused") {
    CHECK(refusal(declared, {.variables = 1}) == "line 1, column 19 = y;: is one variable more than 1, the limit");
    CHECK(refusal("function f, g;", {.equations = 1}) ==
          "line 1, column 13 = g;: is one function more than 1, the limit");
    // a sum that doubles with each name
    std::string text = "variable_group x, y, z;\nfunction f;\ns0 = x + y + z;\n";
    for (int k = 1; k < 40; ++k) {
        const std::string before = "s" + std::to_string(k - 1);
        text += "s" + std::to_string(k) + " = " + before + "*" + before + ";\n";
    }
    CHECK(refusal(text).find(", the limit") != std::string::npos);
}

#endif
