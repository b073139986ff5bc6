// Systems of terms: what a system refuses, and that it is its polynomials.
#include <cmath>
#include <complex>
#include <span>
#include <string>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

template <class C>
std::string refusal(const PolynomialSystem<C>& system) {
    try {
        sparse_system(system);
    } catch (const InvalidArgument& e) {
        return e.what();
    }
    return {};
}

}  // namespace

TEST_CASE("A sparse system holds its equations, their largest coefficients and degrees") {
    const PolynomialSystem<double> circle_and_line{
        {"x", "y"}, {{{1, {2, 0}}, {1, {0, 2}}, {-4, {0, 0}}}, {{-0.5, {1, 1}}, {2, {0, 3}}, {1, {0, 3}}}}};
    const auto system = sparse_system(circle_and_line);
    CHECK(system.terms().size() == 5);  // those of equal exponents added
    CHECK(system.scale() == std::vector<double>{4, 3});
    CHECK(system.degrees() == std::vector<int>{2, 3});
    using Polynomial = TrigonometricPolynomial<0, 2>;
    const auto term = [](double coefficient, int x, int y) {
        Polynomial::Basis product;
        product.set_code(0, x), product.set_code(1, y);
        return Polynomial(product, coefficient);
    };
    const SparseSystem again(
        std::vector<Polynomial>{term(1, 2, 0) + term(1, 0, 2) + term(-4, 0, 0), term(-0.5, 1, 1) + term(3, 0, 3)});
    REQUIRE(again.terms().size() == system.terms().size());
    for (std::size_t k = 0; k < system.terms().size(); ++k) {
        CHECK(again.terms()[k].equation == system.terms()[k].equation);
        CHECK(again.terms()[k].monomial == system.terms()[k].monomial);
        CHECK(again.terms()[k].coefficient == system.terms()[k].coefficient);
    }
}

TEST_CASE("A model's sparse system has the terms that it has at its parameters") {
    using Chain = mechanisms::TwoLinkChain;
    Parameters<Chain> p{0.3, 1.2, 1.5};
    const auto all = sparse_system<Chain>(p).terms().size();
    p[Chain::omega] = 0;
    CHECK(sparse_system<Chain>(p).terms().size() < all);
}

TEST_CASE("A sparse system refuses what it cannot hold") {
    CHECK(refusal(PolynomialSystem<double>{{}, {}}) == "variables = 0: must not be none");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {}}) == "equations = 0: must be 1");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{1, {1}}, {1, {1, 0}}}}}) ==
          "exponents in equation 1 = 2: must be 1");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{1, {}}}}}) == "exponents in equation 1 = 0: must be 1");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{1, {-1}}}}}) ==
          "exponent of x in equation 1 = -1: must be from 0 to 1000");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{1, {1001}}}}}) ==
          "exponent of x in equation 1 = 1001: must be from 0 to 1000");
    CHECK(refusal(PolynomialSystem<Z>{{"x"}, {{{{1, 2}, {1}}}}}) == "coefficient in equation 1 = (1,2): must be real");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{1, {1}}, {-1, {1}}}}}) == "equations = equation 1: must not be 0");
    CHECK(refusal(PolynomialSystem<double>{{"x"}, {{{NAN, {1}}}}}) ==
          "equations = equation 1: has a coefficient that is not finite");
}

TEST_CASE("A constant is added to each equation of a system, to the one that it has or as a term of its own") {
    const auto system =
        sparse_system(PolynomialSystem<double>{{"x", "y"}, {{{1, {1, 0}}, {2, {0, 0}}}, {{3, {0, 2}}}}});
    const double constants[] = {0.5, -7};
    const auto moved = system.with_constants(constants);
    REQUIRE(moved.terms().size() == 4);
    for (const auto& t : moved.terms())
        if (t.monomial.degree() == 0) CHECK(t.coefficient == (t.equation == 0 ? 2.5 : -7));
    CHECK(moved.scale() == std::vector<double>{2.5, 7});
    CHECK_THROWS_WITH(system.with_constants(std::span(constants, 1)),
                      "constants = 1: must be as many as there are equations");
}

TEST_CASE("Terms of no equation of the system, or of other unknowns, are refused") {
    const auto of = [](int equation, std::vector<int> codes) {
        return [=] { SparseSystem({0, 1}, {{equation, SparseMonomial(codes), 1.0}}); };
    };
    CHECK_THROWS_WITH(of(1, {1})(), "equation of a term = 1: must be below the number of unknowns");
    CHECK_THROWS_WITH(of(0, {1, 0})(), "codes of a term = 2: must be as many as there are unknowns");
}
