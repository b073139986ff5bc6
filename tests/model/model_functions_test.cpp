// A model's functions as an object against the derivatives of the model itself, with and without a potential, with
// coordinates, and over many digits.
#include <cmath>

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model_functions.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

template <class A>
A random_array(Generator& generator) {
    A a;
    for (double& x : a) x = uniform(generator, 0.2, 1.5);
    return a;
}

template <class A, class B>
void check_equal(const A& a, const B& b, int n) {
    for (int i = 0; i < n; ++i) CHECK(std::abs(a[i] - b[i]) < 1e-12 * (1 + std::abs(b[i])));
}
template <class M>
void check_equal(const RuntimeMatrix<double>& a, const UnknownMatrix<M>& b) {
    REQUIRE(a.size() == n_unknowns<M>);
    for (int r = 0; r < a.size(); ++r)
        for (int c = 0; c < a.size(); ++c) CHECK(std::abs(a[r][c] - b(r, c)) < 1e-12 * (1 + std::abs(b(r, c))));
}

template <class M>
void check_functions() {
    constexpr int n = n_unknowns<M>;
    Generator generator(1);
    const ModelFunctions<>& functions = functions_of<M>();
    CHECK(functions.unknowns() == n);
    CHECK(functions.sizes().angles == n_angles<M>);
    CHECK(functions.parameters() == n_parameters<M>);
    CHECK(functions.has_potential() == PotentialModel<M>);
    for (int trial = 0; trial < 10; ++trial) {
        const auto q = random_array<Unknowns<M>>(generator), v = random_array<Unknowns<M>>(generator);
        const auto p = random_array<Parameters<M>>(generator);
        const auto at = runtime_array(q), along = runtime_array(v), values = runtime_array(p);
        for (const ModelDerivatives<>* model :
             {&derivatives_of<M>(), static_cast<const ModelDerivatives<>*>(&functions)}) {
            check_equal(equations(*model, at, values), equations<M>(q, p), n);
            check_equal<M>(jacobian(*model, at, values), jacobian<M>(q, p));
            check_equal<M>(jacobian_derivative(*model, at, along, values), jacobian_derivative<M>(q, v, p));
            for (int k = 0; k < n_parameters<M>; ++k) {
                const auto [f, j] = parameter_derivatives(*model, at, values, k);
                check_equal(f, parameter_derivative<M>(q, p, k), n);
                check_equal<M>(j, jacobian_parameter_derivative<M>(q, p, k));
            }
        }
        check_equal(directional_derivative(functions, 1, at, along, values), directional_derivative<1, M>(q, v, p), n);
        check_equal(directional_derivative(functions, 2, at, along, values), directional_derivative<2, M>(q, v, p), n);
        check_equal(directional_derivative(functions, 4, at, along, values), directional_derivative<4, M>(q, v, p), n);
        CHECK(unknowns_from<M>(at) == q);
        CHECK(parameters_from<M>(values) == p);
    }
}

}  // namespace

TEST_CASE("a model's functions are the model's, whatever it is") {
    check_functions<mechanisms::TwoLinkChain>();
    check_functions<models::TorquePendulum>();
    check_functions<models::ElasticPendulum>();
    check_functions<models::CoupledAngles<3>>();
}

TEST_CASE("a model's functions of many digits keep them") {
    using M = models::ElasticPendulum;
    using F = Multiprecision<40>;
    const F third = F(1) / 3;
    const auto f = equations(functions_of<M, F>(), RuntimeArray<F>{third, F(1)}, RuntimeArray<F>{F(1), F(2)});
    CHECK(abs(f[0] - 2 * sin(third)) < F(1e-38));
    CHECK(abs(f[1] + 2 * cos(third)) < F(1e-38));
}
