// The polynomials of models at run time: those of the same model as a type; what is no polynomial is refused.
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/system/runtime_formulation.hpp>

#include "support/catch.hpp"
#include "support/random_parameters.hpp"

using namespace equilibria;

namespace {

template <int N>
void check_chain() {
    using M = mechanisms::RotatingChain<N>;
    using F = Formulation<M>;
    const mechanisms::RuntimeRotatingChain model{N};
    const RuntimeFormulation own(model);
    CHECK(own.sizes().unknowns == N);
    CHECK(own.has_potential());
    CHECK(own.reflection_symmetric() == F::reflection_symmetric);
    CHECK(own.degrees() == std::vector<int>(F::degrees.begin(), F::degrees.end()));
    Generator generator(N);
    const auto p = tests::random_parameters<M>(generator);
    const auto expected = coefficients<M>(p);
    const auto terms = own.terms(model, runtime_array(p));
    REQUIRE(static_cast<int>(terms.size()) == F::terms);
    for (int k = 0; k < F::terms; ++k) {
        const auto& term = terms[static_cast<std::size_t>(k)];
        CHECK(term.equation == F::support[k].equation);
        CHECK(term.monomial == sparse_monomial(F::support[k].monomial));
        CHECK(term.coefficient == Approx(expected[k]).epsilon(1e-14));
    }
}

/// A pendulum whose potential is one of several, not all of them polynomials.
struct Pendulum {
    int kind;
    int n = 1;
    int angles() const { return n; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto& p) const {
        const auto c = cos(theta[0]), s = sin(theta[0]);
        switch (kind) {
            case 0: return p[0] * c;
            case 1: return p[0] * exp(c);
            case 2: return s / (c + 2.0);
            case 3: return p[0] * pow(c, 1200);
            default: return 0 * s + p[0];
        }
    }
};

RuntimeFormulation formulation(int kind, int n = 1) { return RuntimeFormulation(Pendulum{kind, n}); }

}  // namespace

TEST_CASE("a chain at run time has the support, the degrees and the coefficients of the chain as a type") {
    check_chain<1>();
    check_chain<2>();
    check_chain<5>();
}

TEST_CASE("a model at run time that is no trigonometric polynomial is refused in a sentence") {
    CHECK_NOTHROW(formulation(0));
    CHECK_THROWS_WITH(formulation(1),
                      Catch::Contains("model = equation 1: must be a trigonometric polynomial: it takes"));
    CHECK_THROWS_WITH(formulation(2), Catch::Contains("it divides by something that depends on the angles"));
    CHECK_THROWS_WITH(formulation(3), Catch::Contains("above 1000"));
    CHECK_THROWS_WITH(formulation(4), Catch::Contains("must depend on the unknowns"));
    CHECK_THROWS_WITH(formulation(0, 17), "model.angles() = 17: must be at most 16");
}

TEST_CASE("parameters of a model at run time: as many as it says, finite coefficients") {
    const Pendulum model{0};
    const RuntimeFormulation own(model);
    CHECK_THROWS_WITH(own.terms(model, {1, 2}), "parameters = 2: must be as many as model.parameters()");
    CHECK_THROWS_WITH(own.terms(model, {std::numeric_limits<double>::infinity()}),
                      "model = equation 1: has a coefficient that is not finite at these parameters");
    CHECK(own.terms(model, {0})[0].coefficient == 0);
}
