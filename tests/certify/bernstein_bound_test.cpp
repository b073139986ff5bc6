// Mixed volumes as bounds of the number of roots.
#include <equilibria/certify/bernstein_bound.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

TEST_CASE("The bounds of models: the two-link chain 16, the mechanism 6 where nothing cancels, a pendulum 2") {
    using Chain = mechanisms::TwoLinkChain;
    using Mechanism = mechanisms::HolonomicMechanism;
    CHECK(bernstein_bound(ExactSystem<Chain>::at(Parameters<Chain>{0.3, 1.5, 2})) == 16U);
    for (const auto& p :
         {Mechanism::paper_parameters(100), Mechanism::paper_parameters(0), Mechanism::appendix_parameters(100)}) {
        const auto system = ExactSystem<Mechanism>::at(p);
        CHECK(bernstein_bound(system) == 6U);
        const auto bound = smallest_proved_bound<Mechanism>(system);
        REQUIRE(bound);
        CHECK(bound->value == 6);
        CHECK(bound->theorem == "Bernstein's");
    }
    // c2 l = (m1 + m2) g exactly, without a force: the first equation is c1 l^2 cos(q1 + q2) = 0
    auto p = Mechanism::paper_parameters(0);
    p[Mechanism::gravity] = 10;
    p[Mechanism::stiffness_2] = 160;
    CHECK(bernstein_bound(ExactSystem<Mechanism>::at(p)) == 4U);
    // an equation that vanishes has no polygon
    p[Mechanism::stiffness_1] = 0;
    CHECK_FALSE(bernstein_bound(ExactSystem<Mechanism>::at(p)));
    using models::Pendulum;
    CHECK(bernstein_bound(ExactSystem<Pendulum>::at(Parameters<Pendulum>{0.5})) == 2U);
}
