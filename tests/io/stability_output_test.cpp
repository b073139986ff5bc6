// What the criteria say of an equilibrium as JSON.
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/stability_output.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/stability/linearise.hpp>

#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;

TEST_CASE("stability: criteria as JSON") {
    const auto system = linearise<M>({1.465440, -0.256}, M::paper_parameters(100));
    const auto energy = lagrange_dirichlet(system.stiffness);
    const auto motion = count_poles(system);
    Json out = json_of(energy);
    add_keys(out, json_of(motion));
    const Json again = tests::read_json(json_text(out));
    CHECK(again["hessian"].size() == 2);
    CHECK(again["hessian"][1][0].get<double>() == energy.hessian(1, 0));
    CHECK(again["minors"][0].get<double>() == energy.minors[0]);
    CHECK(again["characteristic_polynomial"].size() == 5);
    CHECK(again["characteristic_polynomial"][0] == 1.0);
    CHECK(again["routh_first_column"].size() == 5);
    CHECK(again["routh_table"].size() == 5);
    CHECK(again["hurwitz_minors"].size() == 4);
    CHECK(again["hurwitz_matrix"].size() == 4);
    CHECK(again["routh_special_cases"].empty());
    REQUIRE(again["poles"].size() == 4);
    CHECK(again["poles"][3][0].get<double>() == motion.poles[3].real());
    CHECK(again["poles_right_half_plane"] == motion.right_half_plane().value());
    CHECK(again["poles_on_axis"] == 0);
    CHECK(again["verdict"] == to_string(motion.verdict()));
}

#endif
