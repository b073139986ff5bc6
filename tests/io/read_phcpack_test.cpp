// PHCpack's format, read: what is written comes back, expressions are multiplied out, and what is wrong is refused with
// its place.
#if __has_include(<tao/pegtl.hpp>)

#include <cmath>
#include <complex>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/laurent.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/io/read_phcpack.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

/// The error's text; empty if there is none.
std::string refusal(const std::string& text, const std::vector<std::string>& variables = {},
                    const PolynomialLimits& limits = {}) {
    try {
        parse_phcpack(text, variables, limits);
    } catch (const InvalidArgument& e) {
        return e.what();
    }
    return {};
}

using Terms = std::vector<std::pair<std::vector<int>, Z>>;

/// Each exponent vector's coefficient in equation k.
Terms terms(const PolynomialSystem<Z>& system, std::size_t k = 0) {
    Terms y;
    for (const auto& t : system.equations[k]) y.push_back({t.exponents, t.coefficient});
    return y;
}

/// Written, and read in the writer's order of variables: the same terms, in whatever order.
template <class C>
void check_round_trip(const PolynomialSystem<C>& system) {
    std::ostringstream out;
    write_phcpack(out, system);
    const auto back = parse_phcpack(out.str(), system.variables);
    CHECK(back.variables == system.variables);
    REQUIRE(back.equations.size() == system.equations.size());
    for (std::size_t k = 0; k < system.equations.size(); ++k) {
        std::map<std::vector<int>, Z> expected;
        for (const auto& t : system.equations[k]) expected[t.exponents] = t.coefficient;
        const Terms found = terms(back, k);
        CHECK(std::map<std::vector<int>, Z>(found.begin(), found.end()) == expected);
        CHECK(found.size() == expected.size());
    }
}

const std::string katsura_3 =
    "4\n"
    "u0 + 2*u1 + 2*u2 + 2*u3 - 1;\n"
    "u0^2 + 2*u1^2 + 2*u2^2 + 2*u3^2 - u0;\n"
    "2*u0*u1 + 2*u1*u2 + 2*u2*u3 - u1;\n"
    "2*u0*u2 + u1**2 + 2*u1*u3 - u2;\n";

}  // namespace

TEST_CASE("What is written for PHCpack comes back exactly") {
    using Chain = mechanisms::RotatingChain<3>;
    Parameters<Chain> p;
    Generator generator(5);
    for (double& x : p) x = uniform(generator, 0.5, 2);
    check_round_trip(polynomial_system<Chain>(p));
    check_round_trip(laurent_system<Chain>(p, LaurentForm::non_negative));
    const PolynomialSystem<Z> laurent{{"z1"}, {{{{0.5, 0.25}, {1}}, {{-3, 0}, {0}}, {{0, -1}, {-2}}}}};
    check_round_trip(laurent);
}

TEST_CASE("Expressions of a polynomial system are multiplied out") {
    CHECK(terms(parse_phcpack("1\n(x - 1)^3;")) == Terms{{{3}, 1}, {{2}, -3}, {{1}, 3}, {{0}, -1}});
    CHECK(terms(parse_phcpack("1 2\n-(x + y)*(x - y) + 2;")) == Terms{{{2, 0}, -1}, {{0, 2}, 1}, {{0, 0}, 2}});
    CHECK(terms(parse_phcpack("1\n5/7*x^2*x/2 - .5e-1;")) == Terms{{{3}, 5.0 / 7.0 / 2.0}, {{0}, -0.05}});
    CHECK(terms(parse_phcpack("1\r\n (1 + 2*i)*(x - I) - (-1);")) == Terms{{{1}, {1, 2}}, {{0}, {3, -1}}});
    CHECK(terms(parse_phcpack("1\nx - x + 2*x^(-2) + 3*x^-1;")) == Terms{{{-1}, 3}, {{-2}, 2}});
    CHECK(parse_phcpack("1\nx - x;").equations[0].empty());
    // what is rounding of cancelled terms adds no degree, and is no divisor
    CHECK(terms(parse_phcpack("1\n0.1*x^2 + 0.2*x^2 - 0.3*x^2 + x;")) == Terms{{{1}, 1}});
    CHECK(terms(parse_phcpack("1\n(0.1*x + 0.2)*(x - 2) + 0.3*x - 0.3*x - 0.1*x^2;")) == Terms{{{0}, -0.4}});
    CHECK(refusal("1\nx/(0.1 + 0.2 - 0.3);").find("must be a number other than 0") != std::string::npos);
}

TEST_CASE("Variables of a polynomial system come as they appear, or as they are named") {
    CHECK(parse_phcpack("2\n y - x;\n x*y;").variables == std::vector<std::string>{"y", "x"});
    const auto system = parse_phcpack("2\n y - x;\n x*y;\nTITLE : what follows is not read ;", {"x", "y"});
    CHECK(system.variables == std::vector<std::string>{"x", "y"});
    CHECK(terms(system) == Terms{{{1, 0}, -1}, {{0, 1}, 1}});
    CHECK(parse_phcpack("1 2\nx;", {"x", "y"}).variables.size() == 2);
}

TEST_CASE("A polynomial system is read with blanks, comments, other names and Fortran's numbers") {
    const auto circle = parse_phcpack(" 2 \n x^2 + y^2 - 5;\n\n x*y - 2 ;\n\nTHE SOLUTIONS :\n1 2\n");
    CHECK(terms(circle) == Terms{{{2, 0}, 1}, {{0, 2}, 1}, {{0, 0}, -5}});
    CHECK(terms(circle, 1) == Terms{{{1, 1}, 1}, {{0, 0}, -2}});
    CHECK(terms(parse_phcpack("# a line\n  % and one\n 1 1\t\n-- and one\n x**2\n# - 1\n - 3;\n")) ==
          Terms{{{2}, 1}, {{0}, -3}});
    // a mistake keeps its place behind a comment
    CHECK(refusal("# +\n1\nx + ;") == "line 3, column 5 = ;: a number, a variable or ( must stand here");
    const auto named = parse_phcpack("2 6\n e1 + 2*ii - x_i*pi1;\n e + x[1]*e1;");
    CHECK(named.variables == std::vector<std::string>{"e1", "ii", "x_i", "pi1", "e", "x[1]"});
    CHECK(terms(parse_phcpack("1\n1.0D+03*x^4 + 1.5d0*x^3 + .5*x^2 + 5.*x + 2.e-1;")) ==
          Terms{{{4}, 1000}, {{3}, 1.5}, {{2}, 0.5}, {{1}, 5}, {{0}, 0.2}});
    CHECK(terms(parse_phcpack("1\n1.5e3*x - 1/3;")) == Terms{{{1}, 1500}, {{0}, -1.0 / 3.0}});
    CHECK(terms(parse_phcpack("1\n2 * x - 1;")) == Terms{{{1}, 2}, {{0}, -1}});
    // behind the system: one of one more equation alone is no text
    CHECK(parse_phcpack("1\nx - 1;\n\nsolution 1 : 1 - 2 ; x").equations.size() == 1);
}

TEST_CASE("A polynomial system from a file is solved") {
    const tests::ScratchFile file("katsura");
    file.write({katsura_3.begin(), katsura_3.end()});
    const auto system = sparse_system(read_phcpack(file.name()));
    const auto found = solve_multihomogeneous(system, Array<int, 4>{}, {.seed = 3});
    CHECK(found.paths.total == 8);
    CHECK(found.paths.accounted_for());
    CHECK(found.roots.size() == 8);  // 2^n of katsura-n, Katsura (1990), Nonlinear network dynamics, World Scientific
    const auto equations = parse_phcpack(katsura_3);
    for (const auto& root : found.roots)
        for (const Z& value : evaluate(equations, std::vector<Z>(root.q.begin(), root.q.end())))
            CHECK(std::abs(value) < 1e-12);
}

TEST_CASE("What is no polynomial system is refused with its place") {
    CHECK(refusal("x;") == "line 1, column 1 = x;: the number of equations must stand here");
    CHECK(refusal("") == "line 1, column 1 = the end: the number of equations must stand here");
    CHECK(refusal("2\nx;") == "number of equations = 1: must be 2, as the first line says");
    CHECK(refusal("1\nx;\n 2*y - 1 ;") == "number of equations = more than 1: must be 1, as the first line says");
    CHECK(refusal("1\nx + ;") == "line 2, column 5 = ;: a number, a variable or ( must stand here");
    CHECK(refusal("1\nx +\n y z;") == "line 3, column 4 = z;: an operator or ; must stand here");
    CHECK(refusal("1\n(x + 1;") == "line 2, column 7 = ;: an operator or ) must stand here");
    CHECK(refusal("1\nx^y;") == "line 2, column 3 = y;: an integer must stand here, or one in parentheses");
    CHECK(refusal("1\nx^1.5;") == "line 2, column 4 = .5;: an operator or ; must stand here");
    CHECK(refusal("1\n1/x;") == "line 2, column 3 = x;: must be a number other than 0, for it is a divisor");
    CHECK(refusal("1\nx/(1 - 1);") ==
          "line 2, column 3 = (1 - 1);: must be a number other than 0, for it is a divisor");
    CHECK(refusal("1\n(x + 1)^(-1);") ==
          "line 2, column 10 = -1);: must not be negative, for it is not the power of one term");
    CHECK(refusal("1\n1e999*x;") == "line 2, column 1 = 1e999*x;: must be a number that fits its type");
    CHECK(refusal("1\n(1e-200*x)^2 - 1;") ==
          "line 2, column 12 = 2 - 1;: makes a coefficient that is too small for a double");
    CHECK(refusal("1\n1e-200/1e200*x;") ==
          "line 2, column 8 = 1e200*x;: makes a coefficient that is too small for a double");
    CHECK(terms(parse_phcpack("1\n1e200*x - 1e-200;")) == Terms{{{1}, 1e200}, {{0}, -1e-200}});
    CHECK(refusal("1\n1e200*1e200*x;") == "line 2, column 1 = 1e200*1e200*x;: has a coefficient that is not finite");
    CHECK(refusal("1\ny;", {"x"}) == "line 2, column 1 = y;: is not among the names of the variables");
    CHECK(refusal("1\nx*y;") == "number of variables = 2: must be 1, as the first line says");
    CHECK(refusal("0\n") == "number of equations = 0: must be from 1 to 1000, the limit");
    CHECK(refusal("99999999999\n") == "line 1, column 1 = 99999999999: must be a number that fits its type");
}

TEST_CASE("A polynomial system beyond the limits is refused, not multiplied out") {
    CHECK(refusal("1\nx^9;", {}, {.exponent = 8}) == "line 2, column 3 = 9;: must be at most 8, the limit");
    CHECK(refusal("1\nx^5*x^4;", {}, {.exponent = 8}) == "line 2, column 5 = x^4;: has an exponent above 8, the limit");
    CHECK(refusal("1\n((x));", {}, {.nesting = 1}) ==
          "line 2, column 2 = (x));: is nested deeper than 1 parentheses, the limit");
    CHECK(refusal("1\nx + y;", {}, {.variables = 1}) ==
          "line 2, column 5 = y;: is one variable more than 1, the limit");
    CHECK(refusal("1\n(a+b+c+d+f+g+h)^1000;", {}, {.products = 50'000})
              .find("takes more than 50000 products of terms, the limit") != std::string::npos);
    CHECK(refusal("1\n" + std::string(1'000'000, '(')).find("is nested deeper than 100") != std::string::npos);
    CHECK(refusal("1\nx;", {}, {.bytes = 3}) == "text = 4: must have at most 3 bytes, the limit");
    CHECK(refusal("1\nx;", {}, {.nesting = 0}) == "nesting = 0: must be at least 1");
}

#endif
