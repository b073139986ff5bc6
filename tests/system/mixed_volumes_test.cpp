#include <sstream>

#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/system/mixed_volumes.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"
#include "support/models.hpp"

using namespace equilibria;

TEST_CASE("coupled angles: C(2n, n) in exponentials, more in cosines and sines, less than the total degree in both") {
    const families::LoadedAngles model{3, families::complete(3)};
    const auto volumes = mixed_volumes(families::system_of(model, families::generic(model.parameters(), 1)));
    CHECK(volumes.in_exponentials == 20);
    REQUIRE(volumes.in_cosines_and_sines);
    CHECK(*volumes.in_cosines_and_sines > 20);
    CHECK(*volumes.in_cosines_and_sines <= 64);
}

TEST_CASE(
    "bounds of models with mixed volumes: the chain 4^n in all forms, the mechanism 6, roots with coordinates 0") {
    const auto chain = bounds_with_mixed_volumes<mechanisms::TwoLinkChain>();
    CHECK(chain.laurent_mixed_volume == PathCount{16, false});
    CHECK(chain.smallest() == PathCount{16, false});
    CHECK(bounds_with_mixed_volumes<mechanisms::HolonomicMechanism>().laurent_mixed_volume == PathCount{6, false});
    const auto pendulum = bounds_with_mixed_volumes<models::ElasticPendulum>();
    REQUIRE(pendulum.laurent_mixed_volume);
    CHECK_FALSE(pendulum.total_degree < *pendulum.laurent_mixed_volume);
    std::ostringstream text;
    text << chain;
    CHECK(text.str().find("Laurent mixed volume    16") != std::string::npos);
}
