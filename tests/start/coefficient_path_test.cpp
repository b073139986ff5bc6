// The coefficients of a family along an arc: its values and Taylor coefficients, the degree where they are polynomials,
// poles and cuts.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/start/coefficient_path.hpp>
#include <equilibria/system/system_family.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using Number = std::complex<double>;
using Numbers = std::vector<Number>;

/// a_1 x + a_2 = 0 with what `of` gives for a_1, a_2.
SystemFamily one_equation(int parameters, SystemFamily::Coefficients of) {
    const RuntimeSizes sizes(0, 1);
    return {sizes, {{0, SparseMonomial({0}), 0}, {0, SparseMonomial({1}), 0}}, parameters, std::move(of)};
}

/// The coefficient a_1, a_2 at t, of a term of the path.
Number expected(const SystemFamily& family, const CoefficientPath& path, std::size_t term, double t) {
    const auto a = family.coefficients(path.arc().at(t));
    for (std::size_t k = 0; k < a.size(); ++k)
        if (family.support()[k].monomial == path.terms()[term].monomial) return a[k];
    return 0;
}

Number value(const Complex<double>& z) { return {z.re, z.im}; }

}  // namespace

TEST_CASE("the law of a path is its family's coefficients, and its Taylor coefficients") {
    const auto family = one_equation(
        2, [](std::span<const Number> p) { return Numbers{std::exp(p[0]) / (3.0 + p[1]), p[0] * p[1] * p[1]}; });
    Generator generator(7);
    for (int draw = 0; draw < 5; ++draw) {
        const ParameterArc arc{
            {uniform(generator, -1, 1), unit_complex(generator)}, {0.3, uniform(generator)}, random_bend(generator)};
        const auto path = CoefficientPath::along(family, arc);
        REQUIRE(path);
        REQUIRE(path->terms().size() == 2);
        for (std::size_t k = 0; k < 2; ++k) {
            const int term = static_cast<int>(k);
            CHECK(std::abs(value(path->law<0, double>(term, 1.0)) - path->to()[k]) < 1e-15);
            for (const double t : {0.0, 0.17, 0.5, 0.83, 1.0}) {
                CHECK(std::abs(value(path->law<0, double>(term, t)) - expected(family, *path, k, t)) < 2e-14);
                const Number a[] = {value(path->law<0, double>(term, t)), value(path->law<1, double>(term, t)),
                                    value(path->law<2, double>(term, t)), value(path->law<3, double>(term, t))};
                for (const double h : {-1e-3, 1e-3}) {
                    const Number near = value(path->law<0, double>(term, t + h));
                    // the fourth derivative is below 500
                    CHECK(std::abs(a[0] + h * (a[1] + h * (a[2] + h * a[3])) - near) < 500 * std::pow(1e-3, 4) / 24);
                }
            }
        }
    }
}

TEST_CASE("polynomials have the law of their degree, constants none, and what does not move stays") {
    const auto family = one_equation(3, [](std::span<const Number> p) { return Numbers{p[2], p[0] * p[0] * p[1]}; });
    const ParameterArc arc{{0.4, -1.2, 0.7}, {1.9, 0.3, 0.7}, 1.1};
    for (const double t : {0.2, 0.6}) CHECK(arc.at(t)[2] == 0.7);
    const auto path = CoefficientPath::along(family, arc);
    REQUIRE(path);
    CHECK(path->degree() == 6);
    for (std::size_t k = 0; k < 2; ++k)
        if (path->terms()[k].monomial.code(0) == 0)
            for (const double t : {0.0, 0.4, 1.0}) {
                CHECK(std::abs(value(path->law<0, double>(static_cast<int>(k), t)) - 0.7) < 1e-15);
                CHECK(value(path->law<1, double>(static_cast<int>(k), t)) == 0.0);
            }
}

TEST_CASE("a pole or a cut on the way is not passed silently") {
    const auto pole = one_equation(1, [](std::span<const Number> p) { return Numbers{1.0 / p[0], 1}; });
    CHECK(!CoefficientPath::along(pole, {{-1}, {1}, 0}));
    CHECK(!CoefficientPath::along(pole, {{-1}, {1.2}, 0}));  // between the points of an interpolation
    Generator generator(1);
    const Numbers from{-1}, to{1.2};
    const auto around = CoefficientPath::between(pole, from, to, generator);
    CHECK(std::abs(around.arc().bend) >= 0.6);
    for (const double t : {0.1, 0.5, 0.9})
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(std::abs(value(around.law<0, double>(static_cast<int>(k), t)) - expected(pole, around, k, t)) <
                  1e-12);

    const auto cut = one_equation(1, [](std::span<const Number> p) { return Numbers{std::sqrt(p[0]), 1}; });
    CHECK(!CoefficientPath::along(cut, {{Number(-1, 1)}, {Number(-1, -1)}, 0}));

    // everywhere
    const auto wall =
        one_equation(1, [](std::span<const Number> p) { return Numbers{p[0].real() < 0.5 ? 1.0 : 2.0, 1}; });
    try {
        CoefficientPath::between(wall, Numbers{0}, Numbers{1}, generator);
        FAIL("an arc was found");
    } catch (const InvalidArgument& e) {
        CHECK(std::string(e.what()).find("of 12 arcs each passes a pole or a cut") != std::string::npos);
    }
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(CoefficientPath::along(pole, {{0}, {1}, 1}), Contains("must be parameters at which"));
    CHECK_THROWS_WITH(CoefficientPath::along(pole, {{1, 2}, {1, 2}, 1}), Contains("as many parameters as the family"));
}

TEST_CASE("a family of a model has the model's coefficients at complex parameters") {
    using M = models::Everything;
    const auto family = system_family<M>();
    Parameters<M> p{0.4, 0.9, -0.3};
    const auto own = coefficients<M, double>(p);
    const auto a = family.coefficients(complex_parameters(p));
    REQUIRE(static_cast<int>(a.size()) == own.size());
    for (int k = 0; k < own.size(); ++k) CHECK(a[static_cast<std::size_t>(k)] == own[k]);
    // analytic: the Cauchy-Riemann equations by differences
    const double h = 1e-6;
    for (std::size_t m = 0; m < 3; ++m) {
        auto at = [&](Number by) {
            Numbers q{Number(0.4, 0.2), Number(0.9, -0.1), Number(-0.3, 0.5)};
            q[m] += by;
            return family.coefficients(q);
        };
        const auto right = at(h), left = at(-h), up = at(Number(0, h)), down = at(Number(0, -h));
        for (std::size_t k = 0; k < a.size(); ++k)
            CHECK(std::abs((right[k] - left[k]) - (up[k] - down[k]) / Number(0, 1)) < 1e-9 * h);
    }
}
