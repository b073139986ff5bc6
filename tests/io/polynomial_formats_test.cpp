#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <equilibria/algebra/laurent.hpp>
#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

const PolynomialSystem<double> circle_and_line{
    {"c1", "s1"}, {{{1, {2, 0}}, {1, {0, 2}}, {-1, {0, 0}}}, {{-0.5, {1, 1}}, {2, {0, 3}}}}};
const PolynomialSystem<Z> complex_laurent{{"z1"}, {{{{0, -1}, {-2}}, {{0.5, 0.25}, {1}}, {{-3, 0}, {0}}}}};

template <class C>
std::string text(void (*write)(std::ostream&, const PolynomialSystem<C>&), const PolynomialSystem<C>& system) {
    std::ostringstream out;
    write(out, system);
    return out.str();
}

/// A folder that disappears with the test.
struct Scratch {
    std::string folder = (std::filesystem::temp_directory_path() / "equilibria_formats_XXXXXX").string();
    Scratch() { REQUIRE(mkdtemp(folder.data()) != nullptr); }
    ~Scratch() { std::filesystem::remove_all(folder); }
    std::string file(const std::string& name) const { return folder + "/" + name; }
};

bool installed(const std::string& program) {
    if (std::system(("command -v " + program + " > /dev/null").c_str()) == 0) return true;
    WARN("not checked against " + program + ", which is not installed");
    return false;
}

}  // namespace

TEST_CASE("PHCpack's input") {
    CHECK(text(write_phcpack, circle_and_line) ==
          "2\n"
          "1.0000000000000000e+00*c1^2 + 1.0000000000000000e+00*s1^2 - 1.0000000000000000e+00;\n"
          "-5.0000000000000000e-01*c1*s1 + 2.0000000000000000e+00*s1^3;\n");
    CHECK(text(write_phcpack, complex_laurent) ==
          "1\n"
          "(0.0000000000000000e+00 - 1.0000000000000000e+00*i)*z1^(-2) + "
          "(5.0000000000000000e-01 + 2.5000000000000000e-01*i)*z1 - 3.0000000000000000e+00;\n");
    const PolynomialSystem<double> wide{{"c1", "s1"}, {{{1, {1, 0}}}}};
    CHECK(text(write_phcpack, wide) == "1 2\n1.0000000000000000e+00*c1;\n");
}

TEST_CASE("Bertini's input") {
    CHECK(text(write_bertini, circle_and_line) ==
          "CONFIG\nEND;\nINPUT\nvariable_group c1, s1;\nfunction equation1, equation2;\n"
          "equation1 = 1.0000000000000000e+00*c1^2 + 1.0000000000000000e+00*s1^2 - 1.0000000000000000e+00;\n"
          "equation2 = -5.0000000000000000e-01*c1*s1 + 2.0000000000000000e+00*s1^3;\n"
          "END;\n");
}

TEST_CASE("HomotopyContinuation.jl's input") {
    CHECK(text(write_homotopy_continuation, circle_and_line) ==
          "using HomotopyContinuation\n"
          "@var c1 s1\n"
          "F = System([\n"
          "    1.0000000000000000e+00*c1^2 + 1.0000000000000000e+00*s1^2 - 1.0000000000000000e+00,\n"
          "    -5.0000000000000000e-01*c1*s1 + 2.0000000000000000e+00*s1^3,\n"
          "], variables = [c1, s1])\n"
          "result = solve(F)\n");
}

TEST_CASE("Macaulay2's input") {
    CHECK(text(write_macaulay2, circle_and_line) ==
          "needsPackage \"NumericalAlgebraicGeometry\"\n"
          "R = CC[c1, s1]\n"
          "F = {\n"
          "    1.0000000000000000e+00*c1^2 + 1.0000000000000000e+00*s1^2 - 1.0000000000000000e+00,\n"
          "    -5.0000000000000000e-01*c1*s1 + 2.0000000000000000e+00*s1^3\n"
          "}\n");
}

TEST_CASE("decimals come back exactly") {
    Generator generator(1);
    for (int trial = 0; trial < 1000; ++trial) {
        const double value = std::ldexp(uniform(generator, -1, 1), static_cast<int>(uniform(generator, -300, 300)));
        CHECK(std::stod(detail::decimal(value)) == value);
    }
    const long double wide = 1 / 3.0L;
    CHECK(std::stold(detail::decimal(wide)) == wide);
    CHECK(detail::decimal(-0.0) == detail::decimal(0.0));
}

TEST_CASE("what a program would misread is refused") {
    const auto named = [](const std::string& name) { return PolynomialSystem<double>{{name}, {{{1, {1}}}}}; };
    std::ostringstream out;
    for (const char* name : {"i", "I", "e", "E", "i1", "e1", "", "1x", "x-y", "x y", "_x"})
        CHECK_THROWS_AS(write_phcpack(out, named(name)), InvalidArgument);
    for (const char* name : {"I", "Pi", "END", "equation1"})
        CHECK_THROWS_AS(write_bertini(out, named(name)), InvalidArgument);
    for (const char* name : {"im", "pi", "end"})
        CHECK_THROWS_AS(write_homotopy_continuation(out, named(name)), InvalidArgument);
    for (const char* name : {"ii", "x_1", "F"}) CHECK_THROWS_AS(write_macaulay2(out, named(name)), InvalidArgument);

    CHECK_THROWS_WITH(write_bertini(out, complex_laurent), "exponent of z1 = -2: must not be negative for Bertini");
    CHECK_THROWS_AS(write_homotopy_continuation(out, complex_laurent), InvalidArgument);
    CHECK_THROWS_AS(write_macaulay2(out, complex_laurent), InvalidArgument);

    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(write_phcpack(out, PolynomialSystem<double>{{"x"}, {{{infinity, {1}}}}}), InvalidArgument);
    CHECK_THROWS_AS(write_phcpack(out, PolynomialSystem<Z>{{"x"}, {{{Z(1, infinity), {1}}}}}), InvalidArgument);
    CHECK(out.str().empty());
}

TEST_CASE("every variable of ours is a name everywhere") {
    const auto system = polynomial_system<mechanisms::TwoLinkChain>({{0.3, 1.5, 2.0}});
    const auto laurent = laurent_system<mechanisms::TwoLinkChain>({{0.3, 1.5, 2.0}}, LaurentForm::non_negative);
    CHECK_NOTHROW(text(write_phcpack, system) + text(write_bertini, system) + text(write_macaulay2, system) +
                  text(write_homotopy_continuation, system));
    CHECK_NOTHROW(text(write_phcpack, laurent) + text(write_bertini, laurent) + text(write_macaulay2, laurent) +
                  text(write_homotopy_continuation, laurent));
}

// Computed independently: r = 1.5, (alpha, omega) = (.331, 2.1) has 16 real equilibria, so every solution is real.
TEST_CASE("PHCpack solves the two-link chain as written") {
    if (!installed("phc")) return;
    const Parameters<mechanisms::TwoLinkChain> p{{0.331, 1.5, 2.1}};
    const Scratch scratch;
    const auto solve = [&](const auto& system, const std::string& name) {
        {
            std::ofstream file(scratch.file(name));
            write_phcpack(file, system);
        }
        const auto run = "cd " + scratch.folder + " && phc -b -0 " + name + " " + name + ".out > /dev/null 2>&1";
        REQUIRE(std::system(run.c_str()) == 0);
        std::ifstream file(scratch.file(name + ".out"));
        int solutions = 0;
        for (std::string line; std::getline(file, line);) {
            int count = 0;  // of one of the lists in the output: subsystems with a variable at 0 are solved apart
            if (std::sscanf(line.c_str(), "Number of regular solutions : %d", &count) == 1) solutions += count;
        }
        return solutions;
    };
    CHECK(solve(polynomial_system<mechanisms::TwoLinkChain>(p), "polynomial") == 16);
    CHECK(solve(laurent_system<mechanisms::TwoLinkChain>(p), "laurent") == 16);
}

TEST_CASE("Macaulay2 solves the two-link chain as written") {
    if (!installed("M2")) return;
    const Scratch scratch;
    {
        std::ofstream file(scratch.file("chain.m2"));
        write_macaulay2(file, polynomial_system<mechanisms::TwoLinkChain>({{0.331, 1.5, 2.1}}));
        file << "setRandomSeed 1\nS = solveSystem F\nprint(#S, #(realPoints S))\n";
    }
    REQUIRE(std::system(("M2 --script " + scratch.file("chain.m2") + " > " + scratch.file("out")).c_str()) == 0);
    std::ifstream file(scratch.file("out"));
    std::string line;
    std::getline(file, line);
    CHECK(line == "(16, 16)");
}
