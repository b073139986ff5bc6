// Systems that a floating threshold misjudges, with what exact algebra says of them: numbers of roots, of real ones,
// multiplicities, curves; and what is claimed of completeness.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/io/read_phcpack.hpp>
#include <equilibria/paths/predicted_work.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

EveryRoot solved(const std::string& text, std::uint64_t seed = 1, std::optional<StartKind> asked = {}) {
    const auto system = sparse_system(parse_phcpack(text));
    return every_root(system, fewest_paths(start_bounds(system, {}, true), asked), {.seed = seed});
}

struct Truth {
    const char* text;
    std::uint64_t regular, real;      // isolated regular roots, and the real ones
    std::vector<int> multiplicities;  // of the others, ascending
    Completeness completeness;
};

}  // namespace

TEST_CASE("every root of systems far from size 1, near to multiple roots, beside curves", "[every_root]") {
    const std::vector<Truth> systems{
        {"2\n5*x-1;\nx^9+y-20;\n", 1, 1, {}, Completeness::complete},
        {"2\nx^2+x*y-200;\nx^7+y-200;\n", 8, 2, {}, Completeness::complete},
        {"2\nx^2+x*y-200;\nx^12+y-200;\n", 13, 3, {}, Completeness::complete},
        {"1\nx^2-1e12;\n", 2, 2, {}, Completeness::complete},
        {"2\n-2*x^5*y+8*y^4;\n8*x^5*y-2*x^2*y^3+1;\n", 21, 1, {}, Completeness::complete},
        {"1\n(x-1)^2-1e-10;\n", 2, 2, {}, Completeness::complete},
        {"1\n(x-1)^3*(200*x-201);\n", 1, 1, {3}, Completeness::complete},
        {"2\n(x+y-1)^2;\nx-3*y-1;\n", 0, 0, {2}, Completeness::complete},
        {"1\ny^2+1e-18;\n", 2, 0, {}, Completeness::complete},
        {"2\n-2*x^9-9*x^5*y^2+9*x^3*y^4;\n-2*x^8*y+5*x*y^4;\n", 10, 2, {}, Completeness::explained},
        {"4\n-2*L*x+2*x*y^2*z^2;\n-2*L*y+2*x^2*y*z^2;\n-2*L*z+2*x^2*y^2*z;\nx^2+y^2+z^2-1;\n",
         8,
         8,
         {},
         Completeness::explained},
        {"2\nx*y^8+1;\nx^6+x^3*y^6;\n", 30, 2, {}, Completeness::complete},
        // 19 paths to one point, none of which ends in double
        {"2\n-6*x^4*y^3+5*x^2*y^3;\n-7*x^5-x^3*y-4*y^4-6*y^2;\n", 8, 2, {2, 2, 19}, Completeness::complete},
        {"2\n-3*x^3*y^3+8*y^5;\n7*x^4-9*y^4+9*y^2+4*y;\n", 9, 3, {15}, Completeness::complete},
        // values that rounding makes 0 next to a double root of an equation in y alone
        {"2\ny*x-x;\ny^2-2*y+1+7.2*x^3;\n", 0, 0, {5}, Completeness::complete},
        // a pitchfork point beside a regular root: x is 0 there, and the equations have no derivative with x
        {"3\n14*x^2+3*y-3*z;\nx*y-x;\ny*z-1;\n", 1, 1, {3}, Completeness::complete},
        // two roots 5e-8 i beside the real points; two paths to a double root of a face system, which is no evidence
        {"2\nx^2+4*x*y-2*x+4*y^2-4*y+1.0000000000000024;\n-2*x^2-8*x*y+3*x-8*y^2+7*y+2;\n",
         2,
         0,
         {},
         Completeness::open},
        // a triple root 2e-10 beside a simple one
        {"2\nx^4+7.9999999998*x^3+23.9999999988*x^2+31.9999999976*x+15.9999999984;\n3*x^2-2*x+y+3;\n",
         1,
         1,
         {3},
         Completeness::complete},
    };
    for (const Truth& truth : systems)
        for (const std::uint64_t seed : {1, 2, 3}) {
            INFO(truth.text << "seed " << seed);
            const EveryRoot y = solved(truth.text, seed);
            CHECK(y.proof.distinct == truth.regular);
            CHECK(y.proof.real == truth.real);
            CHECK(y.proof.real + y.proof.non_real == truth.regular);
            std::vector<int> multiplicities;
            for (std::size_t k = 0; k < y.found.roots.size(); ++k)
                if (y.found.roots[k].status == PathStatus::singular) {
                    CHECK(y.confirmed[k]);
                    multiplicities.push_back(y.found.roots[k].paths);
                }
            std::ranges::sort(multiplicities);
            CHECK(multiplicities == truth.multiplicities);
            CHECK(y.verdict.completeness == truth.completeness);
            CHECK(y.verdict.missing_at_most == (truth.completeness == Completeness::open ? 2U : 0U));
            CHECK(y.found.paths.accounted_for());
            CHECK_FALSE(y.verdict.sentence.empty());
        }
}

TEST_CASE("roots come back in the units of the system", "[every_root]") {
    const EveryRoot y = solved("2\n5*x-1;\nx^9+y-20;\n");
    REQUIRE(y.found.roots.size() == 1);
    CHECK(std::abs(y.found.roots[0].q[0] - 0.2) < 1e-15);
    CHECK(std::abs(y.found.roots[0].q[1] - (20 - std::pow(0.2, 9))) < 1e-14);
    CHECK(y.proof.certificates[0].radius < 1e-12);
}

TEST_CASE("multiple roots are real in the units of the system alone", "[every_root]") {
    const auto seem_real = [](const char* text) {
        const auto system = sparse_system(parse_phcpack(text));
        const auto y = every_root(system, fewest_paths(start_bounds(system, {}, true)));
        CHECK(y.verdict.completeness != Completeness::open);
        return std::count(y.seems_real.begin(), y.seems_real.end(), 1);
    };
    // double roots at x = (4.5 +- 4.9i) 1e-9, y = 0
    CHECK(seem_real("2\n-3.777893186295716e+23*x^3-15393162788864*x^2*y+3377699720527872*x^2+64*x*y^2-16777216*x"
                    "+5.587935447692871e-09*y^3-2.384185791015625e-06*y^2-0.00048828125*y;\n"
                    "-335544320*x^2-0.00390625*x*y+3*x+1.7053025658242404e-13*y^2-8.731149137020111e-11*y"
                    "-1.4901161193847656e-08;\n") == 0);
    CHECK(seem_real("1\n(x^2+2^-66)^2;\n") == 0);
    CHECK(seem_real("1\n(x^2-2^-66)^2;\n") == 2);
    // in doubles the constant loses 2^-60: u^2 (u^2 + 2^-29), u = x - 3
    CHECK(seem_real("1\n((x-3)^2+2^-30)^2;\n") == 1);
    CHECK(seem_real("1\n(x-3)^2*(x-4);\n") == 2);
}

TEST_CASE("a root whose conjugate is another root does not seem real, regular or not", "[every_root]") {
    const auto at = [](std::complex<double> z, PathStatus status) {
        Root<RuntimeUnknowns> root;
        root.q = {z};
        root.status = status;
        return root;
    };
    const double two_pi = 2 * std::numbers::pi;
    for (const auto status : {PathStatus::finite, PathStatus::singular}) {
        const std::vector pair{at({1, 1e-9}, status), at({1, -1e-9}, status), at({1 + 1e-8, 1e-17}, status)};
        CHECK(seem_real(pair, 0) == std::vector<char>{0, 0, 1});
        const std::vector turned{at({1, 1e-9}, status), at({1 - two_pi, -1e-9}, status)};
        CHECK(seem_real(turned, 0) == std::vector<char>{1, 1});
        CHECK(seem_real(turned, 1) == std::vector<char>{0, 0});
        CHECK(seem_real(std::vector{at({1, 1e-9}, status)}, 0) == std::vector<char>{1});
    }
}

TEST_CASE("curves beside isolated roots have their dimension and degree", "[every_root]") {
    const EveryRoot circles =
        solved("4\n-2*L*x+2*x*y^2*z^2;\n-2*L*y+2*x^2*y*z^2;\n-2*L*z+2*x^2*y^2*z;\nx^2+y^2+z^2-1;\n");
    REQUIRE(circles.families.size() == 3);
    for (const auto& family : circles.families) {
        CHECK(family.dimension == 1);
        CHECK(family.degree == 2);
    }
    // a parabola, and one root beside it
    const EveryRoot y = solved("2\n(y-x^2)*(x-1);\n(y-x^2)*(y-3);\n");
    CHECK(y.proof.distinct == 1);
    REQUIRE(y.families.size() == 1);
    CHECK(y.families[0].dimension == 1);
    CHECK(y.families[0].degree == 2);
    // x = 0 and z = 1, along which squares vanish; y = x = 0, of multiplicity 3
    const EveryRoot lines = solved("2\nx*z^2-2*x*z+x;\nx^2*z-x^2;\n");
    CHECK(lines.verdict.completeness == Completeness::explained);
    CHECK(lines.found.roots.empty());
    int degree = 0;
    for (const auto& family : lines.families) degree += static_cast<int>(family.degree);
    CHECK(degree == 2);
    const EveryRoot triple = solved("3\ny^2*z;\nx^3;\ny*z-0.1*y;\n");
    CHECK(triple.verdict.completeness == Completeness::explained);
    CHECK(triple.found.roots.empty());
    for (const auto& family : triple.families) CHECK(family.dimension == 1);
}

TEST_CASE("points where all equations are singular are none of curves beside their surface", "[every_root]") {
    struct Case {
        const char* text;
        std::map<int, int> degrees;  // of families, by their dimension
    };
    const std::vector<Case> cases{
        {"3\n-4*x*y^2;\n-4*x^2*y + 8*y*z^2;\n8*y^2*z;\n", {{2, 1}, {1, 1}}},
        {"3\n-8*x^3 + 2*x*y^2 + 2*x*z^2;\n2*x^2*y;\n2*x^2*z;\n", {{2, 1}}},
        // all paths of the total degree meet the line at infinity
        {"3\n3*z^2;\nz;\n6*x*z + y;\n", {{1, 1}}},
        {"3\n4*z^3;\n-3*z^2;\n12*x*z^2 - 6*y*z;\n", {{2, 1}}},
        // double lines, next to a point of which the planes' systems have others that are no points of theirs
        {"3\n-x^2*y - x^2*z - x^2 + 4*x*y^2 + 4*x*y - 4*x*z^2 - 4*x*z - 4*y^3 + 4*y^2*z - 4*y^2 + 4*y*z^2 + 8*y*z - "
         "4*z^3"
         " - 4*z^2;\n4*x^2 + 8*x*y + 4*x*z - 4*x + 4*y^2 + 4*y*z - 4*y + z^2 - 2*z + 1;\n-2*x^2*y + 2*x^2*z + 2*x*y^2"
         " - 7*x*y*z + x*y + 5*x*z^2 - x*z + 4*y^3 - 6*y^2*z - 2*y^2 + 4*y*z + 2*z^3 - 2*z^2;\n",
         {{1, 2}}},
        // planes, of which far points are known to the rounding of large terms
        {"3\n4*x*y + 2*x*z - 4*y^2 - 6*y*z + 2*y - 2*z^2 + z;\n8*x^2*y + 4*x^2*z - 24*x*y^2 - 12*x*y*z + 20*x*y + "
         "10*x*z"
         " + 16*y^3 + 16*y^2*z - 24*y^2 - 4*y*z^2 - 24*y*z + 8*y - 4*z^3 - 6*z^2 + 4*z;\n-24*x*y^2 - 24*x*y*z - 6*x*z^2"
         " + 24*y^3 + 48*y^2*z - 12*y^2 + 30*y*z^2 - 12*y*z + 6*z^3 - 3*z^2;\n",
         {{2, 2}}},
    };
    for (const auto& [text, degrees] : cases)
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            CAPTURE(text, seed);
            const auto y = solved(text, seed);
            std::map<int, int> found;
            for (const auto& family : y.families) found[family.dimension] += family.degree;
            CHECK(found == degrees);
            CHECK(y.found.roots.empty());
        }
}

TEST_CASE("a double root beside a surface and lines is found", "[every_root]") {
    const auto y = solved(
        "3\n"
        "-2*x*y^2*z + 2*x*y^2 + 2*x*y*z^2 - 10*x*y*z + 6*x*y + 4*x*z^3 - 6*x*z^2 + 4*y^3*z - 4*y^3 - 2*y^2*z^2 + "
        "8*y^2*z"
        " - 2*y^2 - 8*y*z^3 + 14*y*z^2 - 16*y*z + 6*y - 2*z^4 + 10*z^3 - 6*z^2;\n"
        "4*x^2*y*z - 4*x^2*y + 4*x^2*z^2 - 6*x*y^2*z + 6*x*y^2 - 8*x*y*z^2 + 12*x*y*z - 10*x*y - 2*x*z^3 + 10*x*z^2"
        " + 4*y^2*z^2 - 10*y^2*z + 6*y^2 + 4*y*z^2 - 8*y*z + 2*y - 4*z^4 + 6*z^3 - 2*z^2;\n"
        "-4*x*y^2*z + 4*x*y^2 - 8*x*y*z + 4*x*y + 4*x*z^3 - 4*x*z^2 + 8*y^3*z - 8*y^3 + 4*y^2*z + 4*y^2 - 8*y*z^3 - 4*y"
        " + 4*z^3 + 4*z^2;\n");
    // (y z - y + z^2) times three quadrics with the double root (-1, 1, 2) and two lines in common
    REQUIRE(y.found.roots.size() == 1);
    CHECK(std::abs(y.found.roots[0].q[0] + 1.0) < 1e-9);
    CHECK(y.found.roots[0].paths == 2);
    CHECK(y.confirmed[0]);
}

TEST_CASE("a singular point that more digits lead to a proved root is not proved to be another", "[every_root]") {
    const auto y = solved(
        "3\n-2*x^3 - 7*x^2*y - x^2*z - 3*x^2 - 8*x*y^2 - 4*x*y*z - 13*x*y + 12*x*z^2 + 17*x*z - 3*x - 3*y^3 - 3*y^2*z"
        " - 5*y^2 + 15*y*z^2 - y*z + 3*y - 9*z^3 + 6*z^2 + 1;\n-x^3 - x^2*y - x^2*z - 2*x^2 + x*y^2 + 2*x*y*z + 5*x*z^2"
        " + 6*x*z - 9*x + y^3 + 3*y^2*z + y^2 - y*z^2 + 4*y*z - 3*y - 3*z^3 + 4*z^2 - 3*z + 1;\nx^3 + x^2*y + 2*x^2*z"
        " + 6*x^2 - x*y^2 + 5*x*y - 3*x*z^2 + 7*x*z + 13*x - y^3 - 2*y^2*z + y^2 + 3*y*z^2 + 5*y*z + 5*y - 9*z^2 + 12*z"
        " - 3;\n");
    CHECK(y.proof.distinct == 7);
    CHECK(y.proof.real == 3);
    CHECK(y.distinct() == y.found.roots.size());
}

TEST_CASE("a double root is none of a plane's points whose others are far away", "[every_root]") {
    // L = y + 2 z + 2 and x = L, x - 2 y + z + 1 = 0, (2 x + y + 2 z + 1)^2 = 0; one path ends on L = 0 at |x| = 119
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto y =
            solved("3\n-(x-2*y+z+1)*(y+2*z+2)^2;\n-2*(y+2*z+2)^2*(2*x+y+2*z+1)^2;\n(y+2*z+2)*(x-y-2*z-2);\n", seed);
        CHECK(y.distinct() == 1);
        CHECK(y.verdict.completeness == Completeness::explained);
        REQUIRE(y.families.size() == 1);
        CHECK(y.families[0].dimension == 2);
        CHECK(y.families[0].degree <= 1);  // 0: not counted
    }
}

TEST_CASE("roots 1e-59 apart are no double root", "[every_root]") {
    // s^3 + 7 s^2 - 2.8e-58 s with s = 2 x - 3 y
    const auto y = solved(
        "2\n8*x^3 - 36*x^2*y + 28*x^2 + 54*x*y^2 - 84*x*y - 5.575821688963583e-58*x - 27*y^3 + 63*y^2"
        " + 8.363732533445374e-58*y;\n-3*x + 4*y + 2;\n");
    CHECK(y.verdict.completeness == Completeness::open);
    CHECK(y.verdict.missing_at_most == 2);
    // roots 1e-119 apart are no line
    const auto near =
        solved("2\ny^4 + 11*y^3 + 18*y^2 + 4.223146227930097e-238*y + 6.910602918431067e-238;\nx + 3*y^2 + 2*y;\n");
    CHECK(near.families.empty());
    CHECK(near.verdict.completeness == Completeness::open);
    for (const std::string apart : {"5e-110", "5.053968264940244e-175", "3e-290"}) {
        INFO(apart);
        const auto two = solved("2\ny^4 - 2*y^3 - 8*y^2 - " + apart + "*y;\nx - 3*y^2 + y;\n");
        CHECK(two.families.empty());
        CHECK(two.verdict.completeness == Completeness::open);
    }
    // and the double root without that term is one
    const auto double_root =
        solved("2\n8*x^3 - 36*x^2*y + 28*x^2 + 54*x*y^2 - 84*x*y - 27*y^3 + 63*y^2;\n-3*x + 4*y + 2;\n");
    CHECK(double_root.verdict.completeness == Completeness::complete);
    CHECK(double_root.distinct() == 2);
}

TEST_CASE("polynomials known for ill-conditioned roots are solved and proved", "[every_root]") {
    const auto polynomial = [](const std::vector<double>& c) {
        std::string text = "1\n";
        for (std::size_t k = 0; k < c.size(); ++k) {
            char term[64];
            std::snprintf(term, sizeof term, "%+.17g*x^%zu", c[k], k);
            if (c[k] != 0) text += k == 0 ? std::string(term).substr(0, std::string(term).find('*')) : term;
        }
        return text + ";\n";
    };
    const auto all_proved = [&](const std::vector<double>& c, std::uint64_t real) {
        const EveryRoot y = solved(polynomial(c));
        CHECK(y.proof.distinct == c.size() - 1);
        CHECK(y.proof.real == real);
        CHECK(y.verdict.completeness == Completeness::complete);
    };
    // Wilkinson's: the product of x - k
    std::vector<double> w{1};
    for (std::uint64_t k = 1; k <= 20; ++k) {
        std::vector<double> next(w.size() + 1);
        for (std::size_t i = 0; i < w.size(); ++i) next[i + 1] += w[i], next[i] -= static_cast<double>(k) * w[i];
        w = next;
        if (k % 5 == 0) all_proved(w, k);
    }
    // Chebyshev's: 2 x T_k - T_(k-1)
    std::vector<double> before{1}, t{0, 1};
    for (std::uint64_t k = 2; k <= 50; ++k) {
        std::vector<double> next(t.size() + 1);
        for (std::size_t i = 0; i < t.size(); ++i) next[i + 1] += 2 * t[i];
        for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
        before = t, t = next;
        if (k % 10 == 0) all_proved(t, k);
    }
    // Mignotte's: x^n - 2 (a x - 1)^2, two real roots 2^(1/2) a^-(n/2 + 1) apart
    for (const auto& [a, n] : {std::pair<double, std::size_t>{10, 3}, {10, 14}, {10, 25}, {100, 8}, {100, 13}}) {
        std::vector<double> m(n + 1);
        m[n] = 1, m[2] -= 2 * a * a, m[1] = 4 * a, m[0] = -2;
        all_proved(m, n % 2 == 0 ? 4 : 3);
    }
}

TEST_CASE("units of unknowns and equations change neither counts nor claims", "[every_root]") {
    const auto counts = [](const EveryRoot& y) {
        return std::vector<std::uint64_t>{y.proof.distinct, y.proof.real, y.proof.non_real,
                                          static_cast<std::uint64_t>(y.verdict.completeness)};
    };
    const char* text = "2\nx^3+2*x*y-7*y+1;\ny^2*x-3*x^2+5;\n";
    const auto system = sparse_system(parse_phcpack(text));
    const auto before = counts(solved(text));
    for (const double a : {1e-9, 1e-4, 1e9})
        for (const double b : {1e-7, 1e3}) {
            std::vector<SparseTerm> terms = system.terms();
            for (auto& t : terms)
                t.coefficient *=
                    std::pow(a, t.monomial.code(0)) * std::pow(b, t.monomial.code(1)) * (t.equation == 0 ? 1e8 : 1e-6);
            const SparseSystem other(system.sizes(), std::move(terms));
            CHECK(counts(every_root(other, fewest_paths(start_bounds(other, {}, true)))) == before);
        }
}

TEST_CASE("every root and the verdict are the same for any number of threads", "[every_root]") {
    const auto system = sparse_system(parse_phcpack("1\n(x-1)^3*(200*x-201);\n"));
    const auto choice = fewest_paths(start_bounds(system, {}, true));
    const EveryRoot one = every_root(system, choice), two = every_root(system, choice, {.executor = threads(2)});
    REQUIRE(one.found.roots.size() == two.found.roots.size());
    for (std::size_t k = 0; k < one.found.roots.size(); ++k) CHECK(one.found.roots[k].q[0] == two.found.roots[k].q[0]);
    CHECK(one.verdict.sentence == two.verdict.sentence);
}

TEST_CASE("a run that is stopped counts what it left, and claims nothing", "[every_root]") {
    // cyclic 6: 156 paths of a polyhedral start, which are tracked in several blocks
    const auto system =
        sparse_system(parse_phcpack("6\na+b+c+d+e+f;\na*b+b*c+c*d+d*e+e*f+f*a;\na*b*c+b*c*d+c*d*e+d*e*f+e*f*a+f*a*b;\n"
                                    "a*b*c*d+b*c*d*e+c*d*e*f+d*e*f*a+e*f*a*b+f*a*b*c;\n"
                                    "a*b*c*d*e+b*c*d*e*f+c*d*e*f*a+d*e*f*a*b+e*f*a*b*c+f*a*b*c*d;\na*b*c*d*e*f-1;\n"));
    const auto bounds = start_bounds(system, {}, true);
    for (const auto kind : {StartKind::polyhedral, StartKind::total_degree}) {
        const StartChoice choice = fewest_paths(bounds, kind);
        std::atomic<bool> stopped = true;
        const auto none = every_root(system, choice, {.cancel = &stopped});
        CHECK(none.found.paths.accounted_for());
        CHECK(none.found.paths.cancelled == none.found.paths.total);
        CHECK(none.verdict.completeness == Completeness::open);
        CHECK(none.verdict.missing_at_most == bounds.mixed_volume);

        stopped = false;
        const auto some =
            every_root(system, choice,
                       {.progress = [&](std::uint64_t done, std::uint64_t) { stopped = stopped || done > 0; },
                        .cancel = &stopped});
        CHECK(some.found.paths.accounted_for());
        CHECK(some.found.paths.total == (kind == StartKind::polyhedral ? 156U : 720U));
        CHECK(some.found.paths.cancelled > 0);
        CHECK(some.verdict.completeness == Completeness::open);
        CHECK(some.verdict.sentence.find("the run was stopped") != std::string::npos);

        stopped = false;
        const auto all = every_root(system, choice, {.cancel = &stopped}), same = every_root(system, choice);
        CHECK(all.found.paths.cancelled == 0);
        CHECK(all.verdict.sentence == same.verdict.sentence);
        CHECK(all.found.roots.size() == same.found.roots.size());
    }
    const std::atomic<bool> stopped = true;
    CHECK_FALSE(start_bounds(system, {}, true, {.cancel = &stopped}).mixed_volume);
}

TEST_CASE("the work that is predicted counts the paths of the start", "[every_root]") {
    const auto system = sparse_system(parse_phcpack("3\nx^2+y^2+z^2-3;\nx*y+z-2;\nx^3-y*z;\n"));
    const auto bounds = start_bounds(system, {}, true);
    const auto degrees = predicted_work(system, fewest_paths(bounds, StartKind::total_degree), {}, 1);
    CHECK(degrees.paths.value == 12);
    CHECK(degrees.seconds.value() > 0);
    CHECK(degrees.bytes > 0);
    const auto cells = predicted_work(system, fewest_paths(bounds, StartKind::polyhedral), {}, 1);
    CHECK(static_cast<std::uint64_t>(cells.paths.value) == bounds.mixed_volume);
    CHECK_FALSE(predicted_work(system, fewest_paths(bounds, StartKind::total_degree)).seconds);
}

TEST_CASE("Chandrasekhar's H-equation in 8 unknowns: ill-conditioned roots are all found and proved", "[every_root]") {
    constexpr int n = 8;
    std::string text = std::to_string(n) + "\n";
    for (int k = 1; k <= n; ++k) {
        const std::string x = "x" + std::to_string(k);
        std::string f = "15.48766*" + x + "-16";
        for (int i = 1; i < n; ++i) {
            std::ostringstream c;
            c.precision(17);
            c << 0.51234 * k / (i + k);
            f += "-" + c.str() + "*" + x + "*x" + std::to_string(i);
        }
        text += f + ";\n";
    }
    const auto y = solved(text);
    CHECK(y.proof.distinct == 128);
    CHECK(y.proof.real == 128);
    CHECK(y.verdict.completeness == Completeness::complete);
}
