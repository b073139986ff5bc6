// Systems of terms: what a system refuses, and that it is its polynomials.
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

template <int n, class C>
std::string refusal(const PolynomialSystem<C>& system) {
    try {
        sparse_system<n>(system);
    } catch (const InvalidArgument& e) {
        return e.what();
    }
    return {};
}

}  // namespace

TEST_CASE("A sparse system holds its equations, their largest coefficients and degrees") {
    const PolynomialSystem<double> circle_and_line{
        {"x", "y"}, {{{1, {2, 0}}, {1, {0, 2}}, {-4, {0, 0}}}, {{-0.5, {1, 1}}, {2, {0, 3}}, {1, {0, 3}}}}};
    const auto system = sparse_system<2>(circle_and_line);
    CHECK(system.terms().size() == 5);  // those of equal exponents added
    CHECK(system.scale() == Array<double, 2>{4, 3});
    CHECK(system.degrees() == Array<int, 2>{2, 3});
    const auto equations = system.equations();
    const SparseSystem<0, 2> again(equations);
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
    CHECK(refusal<2>(PolynomialSystem<double>{{"x"}, {{{1, {1}}}}}) == "variables = 1: must be 2");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {}}) == "equations = 0: must be 1");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{1, {1}}, {1, {1, 0}}}}}) ==
          "exponents in equation 0 = 2: must be 1");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{1, {}}}}}) == "exponents in equation 0 = 0: must be 1");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{1, {-1}}}}}) ==
          "exponent of x in equation 0 = -1: must be from 0 to 127");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{1, {128}}}}}) ==
          "exponent of x in equation 0 = 128: must be from 0 to 127");
    CHECK(refusal<1>(PolynomialSystem<Z>{{"x"}, {{{{1, 2}, {1}}}}}) ==
          "coefficient in equation 0 = (1,2): must be real");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{1, {1}}, {-1, {1}}}}}) ==
          "equations = equation 0: must not be 0");
    CHECK(refusal<1>(PolynomialSystem<double>{{"x"}, {{{NAN, {1}}}}}) ==
          "equations = equation 0: has a coefficient that is not finite");
}
