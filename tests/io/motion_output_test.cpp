// Motions as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/io/results/motion_output.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "io/read_csv.hpp"
#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;
using Points = mechanisms::HolonomicMechanismPoints;

TEST_CASE("motion: JSON and CSV of angles") {
    const auto motion =
        integrate_motion(LagrangeSecondKind<M>(M::paper_parameters(100)), {{0.9, 0.4}, {}}, {0, 0.125, 0.25});
    REQUIRE(motion.status == MotionStatus::finished);
    const Json again = tests::read_json(json_text(json_of(motion)));
    CHECK(again["status"] == "finished");
    CHECK(again["steps"] == motion.steps);
    CHECK(again["time"].get<double>() == motion.time);  // the end of the last step
    for (const char* key : {"evaluations", "largest_balance", "largest_drift", "largest_velocity_drift"})
        CHECK(again[key].is_number());
    REQUIRE(again["points"].size() == 3);
    const Json& last = again["points"][2];
    CHECK(last["t"] == 0.25);
    CHECK(last["q"][1].get<double>() == motion.points[2].q[1]);
    CHECK(last["velocity"][0].get<double>() == motion.points[2].velocity[0]);
    CHECK(last["momentum"].size() == 2);
    CHECK(!last.contains("multipliers"));
    for (const char* key : {"kinetic", "potential", "work", "dissipated", "balance"}) CHECK(last[key].is_number());

    const auto lines = tests::read_csv(motion_csv(motion).text());
    CHECK(lines[0] == std::vector<std::string>{"t", "q1", "q2", "q1_rate", "q2_rate", "p1", "p2", "kinetic",
                                               "potential", "work", "dissipated", "balance"});
    REQUIRE(lines.size() == 4);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& x = motion.points[k];
        CHECK(std::strtod(lines[k + 1][0].c_str(), nullptr) == x.time);
        CHECK(std::bit_cast<std::uint64_t>(std::strtod(lines[k + 1][2].c_str(), nullptr)) ==
              std::bit_cast<std::uint64_t>(x.q[1]));
        CHECK(std::strtod(lines[k + 1][8].c_str(), nullptr) == x.potential);
    }
}

TEST_CASE("motion: multipliers and drift where there are constraints") {
    const auto p = M::paper_parameters(100);
    const auto motion = integrate_motion(LagrangeFirstKind<Points>(p),
                                         mechanisms::points_of(MotionState<M>{{0.9, 0.4}, {}}, p), {0, 0.125});
    const Json out = json_of(motion);
    CHECK(out["points"][1]["multipliers"].size() == 4);
    CHECK(out["points"][1]["drift"].is_number());
    const auto lines = tests::read_csv(motion_csv(motion).text());
    const std::vector<std::string> end(lines[0].end() - 5, lines[0].end());
    CHECK(end == std::vector<std::string>{"lambda1", "lambda2", "lambda3", "lambda4", "drift"});
    CHECK(lines[0].size() == 1 + 3 * 6 + 5 + 5);
    CHECK(motion_columns(1, 0, {"x", "y"}) == std::vector<std::string>{"t", "q1", "q1_rate", "p1", "x", "y", "kinetic",
                                                                       "potential", "work", "dissipated", "balance"});
}

#endif
