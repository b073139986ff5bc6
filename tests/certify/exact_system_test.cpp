// The exact equations: their terms at doubles, the enclosures of all parameters in intervals, their derivatives.
#include <cmath>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::ElasticPendulum;  // x g sin(theta) = 0, k (x - 1) - g cos(theta) = 0

/// The coefficient of the one term of an equation with these codes, theta and x.
template <class System>
const ExactBall* coefficient(const System& system, int equation, int theta, int x) {
    for (const auto& t : system.terms)
        if (t.equation == equation && t.monomial.code(0) == theta && t.monomial.code(1) == x) return &t.coefficient;
    return nullptr;
}

bool holds(const ExactBall* ball, double value) {
    return ball && std::abs((ball->mid() - Dyadic(value)).to<double>()) <= ball->rad();
}

}  // namespace

TEST_CASE("the terms are those of the model, their coefficients without any rounding") {
    const auto system = ExactSystem<M>::at(Parameters<M>{{0.1, 9.81}});
    REQUIRE(system.terms.size() == 4);
    CHECK(*coefficient(system, 0, -1, 1) == 9.81);
    CHECK(*coefficient(system, 1, 0, 1) == 0.1);
    CHECK(*coefficient(system, 1, 0, 0) == -0.1);
    CHECK(*coefficient(system, 1, 1, 0) == -9.81);
    CHECK(system.degrees()[0] == 2);
    CHECK(system.degrees()[1] == 1);
    CHECK(system.within_support());
}

TEST_CASE("terms that vanish are absent, and a system outside of the support is told") {
    auto system = ExactSystem<M>::at(Parameters<M>{{2, 0}});
    CHECK(system.terms.size() == 2);
    CHECK(system.degrees()[0] == 0);
    CHECK(system.within_support());
    system.terms.front().monomial.set_code(1, 5);
    CHECK_FALSE(system.within_support());
}

TEST_CASE("a parameter that is not finite is refused") {
    CHECK_THROWS_WITH(ExactSystem<M>::at(Parameters<M>{{NAN, 1}}), "parameters[0] = nan: must be finite");
    CHECK_THROWS_WITH(ExactSystem<M>::at(Parameters<M>{{1, INFINITY}}), "parameters[1] = inf: must be finite");
}

TEST_CASE("systems over an interval hold each one of them, and the derivative by the parameter") {
    const ExactSystems<M, 1> systems({{2, 9.5}}, {M::gravity}, {9.0}, {10.0});
    CHECK(systems.half_width[0] >= 0.5);
    CHECK(systems.half_width[0] == Approx(0.5).epsilon(1e-14));
    CHECK(*coefficient(systems.center, 0, -1, 1) == 9.5);
    for (const double g : {9.0, 9.3, 10.0}) {
        CHECK(holds(coefficient(systems.all, 0, -1, 1), g));
        CHECK(holds(coefficient(systems.all, 1, 1, 0), -g));
    }
    CHECK_FALSE(holds(coefficient(systems.all, 0, -1, 1), 10.1));
    CHECK(holds(coefficient(systems.all, 1, 0, 1), 2));
    REQUIRE(systems.derivative[0].terms.size() == 2);
    CHECK(holds(coefficient(systems.derivative[0], 0, -1, 1), 1));
    CHECK(holds(coefficient(systems.derivative[0], 1, 1, 0), -1));
}

TEST_CASE("equations are odd where each term has an odd number of sines") {
    using Chain = mechanisms::RotatingChain<3>;
    using Pendulum = models::Pendulum;
    CHECK(ExactTerms(ExactSystem<Chain>::at(Parameters<Chain>{{1, 2, 3, 1, 1, 1, 2, 1}})).odd());
    CHECK_FALSE(ExactTerms(ExactSystem<Pendulum>::at(Parameters<Pendulum>{0.5})).odd());  // sin theta - 0.5
    CHECK(ExactTerms(ExactSystem<Pendulum>::at(Parameters<Pendulum>{0.0})).odd());
}
