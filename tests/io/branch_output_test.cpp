// Branches of a shallow arch, whose critical points are known, as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <equilibria/io/results/branch_output.hpp>

#include "../programs/support/structures.hpp"
#include "io/read_csv.hpp"
#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using Eigen::VectorXd;
using support::ShallowArch;

namespace {

BranchMeasures<ShallowArch> measures() {
    return {
        .parameter = "q", .names = {"A1", "A2"}, .measure = [](const VectorXd& q) { return std::vector{q(0), q(1)}; }};
}

}  // namespace

TEST_CASE("branch: samples in their order, critical points and zeros among them") {
    const ShallowArch arch{2.5};
    ContinuationOptions options;
    options.range.low = -10, options.range.high = 10;
    BranchStepper<ShallowArch> stepper(arch, options.branch);
    const std::vector<EventFunction<ShallowArch>> functions{
        {"A1 = 0", [](const BranchPoint<ShallowArch>& at) { return at.q(0); }}};
    const auto start = stepper.start(Eigen::Vector2d(2.5, 0), 0, 1);
    REQUIRE(start);
    const auto branch = follow(stepper, *start, options, functions);
    REQUIRE(branch.events.size() == 4);
    const auto samples = samples_of(branch, measures(), functions);
    CHECK(samples.size() == branch.points.size() + branch.events.size() + branch.crossings.size());
    // A1 falls all along
    for (std::size_t k = 1; k < samples.size(); ++k) CHECK(samples[k].measures[0] <= samples[k - 1].measures[0] + 1e-9);
    int named = 0;
    for (const auto& s : samples)
        if (!s.at.empty()) {
            ++named;
            CHECK(s.at == "A1 = 0");
            CHECK(std::abs(s.measures[0]) < 1e-9);
        }
    CHECK(named == 1);
    // from a critical point on it comes first, and counts as unstable
    const auto from = samples_of(branch, measures(), functions, &branch.events[0].point);
    CHECK(from.size() == samples.size() + 1);
    CHECK(from[0].parameter == branch.events[0].point.p);
    CHECK(from[0].stable == false);

    const Json c = json_of(branch.events[1].point, measures());
    CHECK(c["kind"] == "fold");
    CHECK(c["parameter"].get<double>() == Approx(arch.fold()).epsilon(1e-10));
    CHECK(c["measures"].size() == 2);
    CHECK(c["inertia_before"] == 1);
    CHECK(c["inertia_after"] == 2);
    CHECK(c["nullity"] == 1);

    const Json b = tests::read_json(json_text(json_of(samples)));
    REQUIRE(b["points"].size() == samples.size());
    CHECK(b["stable"].size() == samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
        CHECK(b["points"][k][0].get<double>() == samples[k].parameter);
        CHECK(b["points"][k][2].get<double>() == samples[k].measures[1]);
    }
    const auto lines = tests::read_csv(branches_csv({samples, from}, {"A1", "A2"}).text());
    CHECK(lines[0] == std::vector<std::string>{"branch", "parameter", "A1", "A2", "stable", "at"});
    REQUIRE(lines.size() == 1 + samples.size() + from.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
        CHECK(lines[k + 1][0] == "0");
        CHECK(std::strtod(lines[k + 1][1].c_str(), nullptr) == samples[k].parameter);
        CHECK(lines[k + 1][4] == (samples[k].stable == true ? "1" : "0"));
        CHECK(lines[k + 1][5] == samples[k].at);
    }
    CHECK(lines.back()[0] == "1");
}

TEST_CASE("branch: a graph's nodes and branches name each other") {
    const ShallowArch arch{2.5};
    DiagramOptions options;
    options.continuation.range.low = -10, options.continuation.range.high = 10;
    const auto graph = bifurcation_diagram(arch, VectorXd(Eigen::Vector2d(2.5, 0)), 0.0, options);
    const Json again = tests::read_json(json_text(json_of(graph, measures())));
    CHECK(again["parameter"] == "q");
    CHECK(again["measures"].dump() == R"(["A1","A2"])");
    CHECK(again["complete"] == graph.complete());
    REQUIRE(again["nodes"].size() == graph.nodes.size());
    REQUIRE(again["branches"].size() == graph.branches.size());
    for (const char* key : {"seen", "images", "not_followed", "not_switched"}) CHECK(again[key].is_number());
    for (std::size_t k = 0; k < graph.branches.size(); ++k) {
        const Json& b = again["branches"][k];
        CHECK(b["end"] == to_string(graph.branches[k].branch.end));
        CHECK(b["parent"].is_null() == !graph.branches[k].parent.has_value());
        CHECK(b["points"].size() == b["stable"].size());
        for (const auto& node : b["nodes"]) CHECK(node.get<std::size_t>() < again["nodes"].size());
    }
    for (const auto& node : again["nodes"])
        for (const auto& branch : node["branches"]) CHECK(branch.get<std::size_t>() < again["branches"].size());
}

#endif
