// Loads along elements, stages, prestress, forks and springs of structures' files, and what is read off their states:
// against closed forms, differential equations and the laws of statics.
#if __has_include(<nlohmann/json.hpp>)

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/loaded_state.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/io/structure/structure_json.hpp>
#include <equilibria/io/structure/structure_results.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::Vector3d;

namespace {

/// The critical points of the first branch that begins at the loaded state, upwards.
template <class S>
std::vector<double> critical_loads(const S& structure, const StructureInput& input) {
    const auto loaded = loaded_state(structure, continuation_options(input));
    REQUIRE(loaded.reached());
    BranchStepper<S> stepper(structure, continuation_options(input).stepping());
    const auto start = stepper.start(loaded.state, 0, 1);
    REQUIRE(start);
    const auto branch = follow(stepper, *start, continuation_options(input));
    CHECK(branch.unexplained.empty());
    std::vector<double> y;
    for (const auto& event : branch.events) y.push_back(event.point.p);
    return y;
}
std::vector<double> critical_loads(const std::string& text) {
    const auto input = parse_structure(text);
    return critical_loads(Structure(input.model), input);
}

/// The largest moment at the free end of theta'' = -(P + q (1 - s)) theta, theta(0) = 0, by theta'(0) = 1: its zero is
/// a column's critical load.
double free_end(double tip, double weight) {
    double theta = 0, slope = 1;
    const int n = 4000;
    for (int k = 0; k < n; ++k) {
        const double h = 1.0 / n, s = k * h;
        const auto bend = [&](double at, double angle) { return -(tip + weight * (1 - at)) * angle; };
        const double k1 = slope, l1 = bend(s, theta), k2 = slope + h / 2 * l1, l2 = bend(s + h / 2, theta + h / 2 * k1),
                     k3 = slope + h / 2 * l2, l3 = bend(s + h / 2, theta + h / 2 * k2), k4 = slope + h * l3,
                     l4 = bend(s + h, theta + h * k3);
        theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        slope += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return slope;
}
/// Where a function changes its sign.
double zero_between(double low, double high, const auto& of) {
    const bool sign = of(low) > 0;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        ((of(middle) > 0) == sign ? low : high) = middle;
    }
    return low;
}

std::string heavy_column(const std::string& mass, const std::string& loads, const std::string& window) {
    return R"({"nodes": {"A": [0, 0, 0], "B": [0, 1, 0]},
        "sections": {"s": {"ea": "rigid", "ga": "rigid", "ei": 1, "mass": )" +
           mass + R"(}}, "elements": [{"type": "beam", "name": "column", "nodes": ["A", "B"], "section": "s",
        "elements": 8, "order": "cubic"}], "supports": [{"node": "A", "fix": ["all"]}], "loads": )" +
           loads + R"(, "parameter": )" + window + "}";
}

Vector3d vector_of(const Json& list) { return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()}; }

}  // namespace

TEST_CASE("a column buckles under its own weight") {
    // A. G. Greenhill, Proc. Cambridge Philos. Soc. 4 (1881): q l^3 / EI = 9/4 times the square of the first zero of
    // the Bessel function of order -1/3
    const double greenhill = 2.25 * 1.8663508588 * 1.8663508588;
    CHECK(zero_between(7, 9, [](double q) { return free_end(0, q); }) == Approx(greenhill).epsilon(1e-8));
    const std::string window = R"({"low": 0, "high": 20})";
    const auto weight =
        critical_loads(heavy_column("1", R"([{"type": "self_weight", "gravity": [0, -1, 0]}])", window));
    REQUIRE(weight.size() == 1);
    CHECK(weight[0] == Approx(greenhill).epsilon(1e-5));
    // a distributed load is the same
    const auto load = critical_loads(
        heavy_column("7", R"([{"type": "distributed", "elements": ["column"], "force": [0, -1, 0]}])", window));
    REQUIRE(load.size() == 1);
    CHECK(load[0] == Approx(weight[0]).epsilon(1e-12));
}

TEST_CASE("a constant weight comes before the load") {
    for (const double mass : {3.0, 6.0, -4.0}) {
        // a negative one hangs
        const auto found = critical_loads(
            heavy_column(std::to_string(std::abs(mass)),
                         std::string(R"([{"type": "self_weight", "gravity": [0, )") + (mass > 0 ? "-1" : "1") +
                             R"(, 0], "kind": "constant"}, {"node": "B", "force": [0, -1, 0]}])",
                         R"({"low": 0, "high": 6})"));
        REQUIRE(found.size() == 1);
        CHECK(found[0] == Approx(zero_between(0, 6, [&](double p) { return free_end(p, mass); })).epsilon(1e-5));
    }
}

TEST_CASE("the first stage says what it met") {
    const std::string loads = R"([{"type": "self_weight", "gravity": [0, -1, 0], "kind": "constant"},
                                  {"node": "B", "force": [0, -1, 0]}])";
    const auto input = parse_structure(heavy_column("10", loads, R"({"low": 0, "high": 1})"));
    const auto passed = loaded_state(Structure(input.model), continuation_options(input));
    CHECK(passed.reached());
    REQUIRE(passed.passed.size() == 1);
    CHECK(passed.passed[0].first == CriticalKind::pitchfork);
    CHECK(passed.passed[0].second == Approx(0.783735).epsilon(1e-4));
    CHECK(passed.summary().find("pitchfork at 0.7837") == 0);

    // a shallow truss snaps through before all of the load is on it
    const auto toggle = parse_structure(R"({"nodes": {"A": [-1, 0, 0], "B": [0, 0.1, 0], "C": [1, 0, 0]},
        "elements": [{"type": "truss", "nodes": ["A", "B"], "ea": 100, "planar": true},
                     {"type": "truss", "nodes": ["B", "C"], "ea": 100, "planar": true}],
        "supports": [{"node": "A", "fix": ["position"]}, {"node": "C", "fix": ["position"]}],
        "loads": [{"node": "B", "force": [0, -1, 0], "kind": "constant"}, {"node": "B", "force": [1, 0, 0]}],
        "parameter": {"low": 0, "high": 1}})");
    ContinuationOptions options = continuation_options(toggle);
    options.most_critical_points = 1;
    const auto lost = loaded_state(Structure(toggle.model), options);
    CHECK_FALSE(lost.reached());
    // EA h^3 (1 - 1) ..: with Green's strain the limit load is 2 EA h^3 / (3 sqrt(3) L^3), L the drawn length
    const double length = std::sqrt(1.01), limit = 200 * 0.001 / (3 * std::sqrt(3.0) * length * length * length);
    CHECK(lost.share == Approx(limit).epsilon(0.02));
    REQUIRE(lost.passed.size() == 1);
    CHECK(lost.passed[0].second == Approx(limit).epsilon(1e-9));
}

TEST_CASE("reactions balance all loads") {
    // a bent frame in space with an arc, whose loads are along, on nodes, constant and proportional
    const auto input = parse_structure(R"({
        "nodes": {"A": [0, 0, 0], "B": [0, 0, 3], "C": [4, 1, 3], "D": [4, 1, 0]},
        "sections": {"s": {"ea": 900, "ga2": 300, "ga3": 400, "gj": 50, "ei2": 70, "ei3": 40, "mass": 2}},
        "elements": [{"type": "beam", "nodes": ["A", "B"], "section": "s", "elements": 3, "second": [0, 1, 0]},
            {"type": "arc", "name": "arch", "nodes": ["B", "C"], "through": [2, 0.5, 4], "section": "s", "elements": 6},
            {"type": "truss", "nodes": ["C", "D"], "ea": 500, "mass": 0.5, "prestress": -3}],
        "supports": [{"node": "A", "fix": ["all"]}, {"node": "D", "fix": ["position"]}],
        "loads": [{"type": "self_weight", "gravity": [0, 0, -1], "kind": "constant"},
                  {"type": "distributed", "elements": ["arch"], "force": [0, 1, -0.5]},
                  {"node": "C", "force": [1, 0, 0]}, {"node": "B", "force": [0, -2, 0], "kind": "constant"}],
        "parameter": {"low": 0, "high": 1.5}})");
    CHECK(input.notes.size() == 1);
    CHECK(input.notes.at(0).find("elements[1]") != std::string::npos);
    const Structure structure(input.model);
    const auto loaded = loaded_state(structure, continuation_options(input));
    REQUIRE(loaded.reached());
    const auto branch = continue_branch(structure, loaded.state, 0, 1, continuation_options(input));
    REQUIRE(branch.points.size() > 3);
    for (const auto& point : branch.points) {
        const Json results = structure_results(structure, input, point.q, point.p);
        Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
        for (const auto& load : input.model.loads()) {
            const double size = load.kind == LoadKind::constant ? 1 : point.p;
            force += size * load.force;
            moment += point.q.frames[static_cast<std::size_t>(load.node)].x.cross(size * load.force);
        }
        REQUIRE(results.at("reactions").size() == 2);
        for (const auto& [name, own] : results.at("reactions").items()) {
            force += vector_of(own.at("force"));
            moment +=
                vector_of(own.at("moment")) + input.model.at(input.nodes.at(name)).cross(vector_of(own.at("force")));
        }
        CHECK(force.norm() < 1e-8);
        CHECK(moment.norm() < 1e-8);
    }
    // all of the weight, and the arc's length times its load
    double weight = 0, along = 0;
    for (const auto& load : input.model.loads()) (load.kind == LoadKind::constant ? weight : along) -= load.force(2);
    const auto arc = Arc::through({0, 0, 3}, {2, 0.5, 4}, {4, 1, 3});
    const double length = (arc->at(1) - arc->at(0)).norm() / 2 / std::sin(arc->angle / 2) * arc->angle;
    CHECK(weight == Approx(2 * (3 + length) + 0.5 * 3).epsilon(1e-5));
    CHECK(along == Approx(0.5 * length).epsilon(1e-5));
}

TEST_CASE("section forces are those that statics says") {
    // a cantilever hardly bends under a small tip force: N = 0, Q = p, M = p (1 - x)
    const auto input = parse_structure(R"({"nodes": {"A": [0, 0, 0], "B": [1, 0, 0]},
        "sections": {"s": {"ea": 1e4, "ga": 1e4, "ei": 1e3}},
        "elements": [{"type": "beam", "nodes": ["A", "B"], "section": "s", "elements": 4}],
        "supports": [{"node": "A", "fix": ["all"]}], "loads": [{"node": "B", "force": [0, 1, 0]}],
        "parameter": {"low": 0, "high": 0.01}})");
    const Structure structure(input.model);
    const auto branch = continue_branch(structure, structure.initial(), 0, 1, continuation_options(input));
    const auto& end = branch.points.back();
    const Json results = structure_results(structure, input, end.q, end.p);
    REQUIRE(results.at("elements").size() == 8);
    for (const Json& row : results.at("elements")) {
        CHECK(row.at("element") == "elements[0]");
        CHECK(std::abs(row.at("N").get<double>()) < 1e-6);
        CHECK(row.at("Q").get<double>() == Approx(0.01).epsilon(1e-4));
        const double x = row.at("place")[0].get<double>();
        CHECK(row.at("M").get<double>() == Approx(0.01 * (1 - x)).epsilon(1e-3));
    }
    CHECK(vector_of(results.at("reactions").at("A").at("moment"))(2) == Approx(-0.01).epsilon(1e-6));
    const std::string csv = structure_results_csv({results}).text();
    CHECK(csv.find("0,reactions,A,,,,force y,-0.01") != std::string::npos);
    const std::string text = vtk(structure, end.q, end.p, end.p, "cantilever");
    CHECK(text.find("VECTORS reaction double") != std::string::npos);
    CHECK(text.find("CELL_DATA 4\nSCALARS M double 1") != std::string::npos);
}

TEST_CASE("prestressed bars have their force, and a string its stiffness") {
    for (const Strain strain : {Strain::green, Strain::engineering})
        for (const double share : {-0.15, 0.0, 0.02, 3.0}) {
            const auto length = StressedTruss<3>::length_of_force(50, 2, 50 * share, strain);
            REQUIRE(length);
            const StressedTruss<3> bar(50, {0, 0, 0}, {0, 0, 2}, *length, strain);
            std::array<Frame<double>, 2> at;
            at[1].x << 0, 0, 2;
            const auto force = bar.forces(at, {nullptr, 1, {}, Need::residual});
            CHECK(force.at(0).values.at(0) == Approx(50 * share).margin(1e-12));
            // drawn, it has none
            CHECK(bar.forces(at, {nullptr, 0, {}, Need::residual}).at(0).values.at(0) == Approx(0).margin(1e-12));
        }
    CHECK_FALSE(StressedTruss<3>::length_of_force(50, 2, -10, Strain::green));
    CHECK_FALSE(StressedTruss<3>::length_of_force(50, 2, -50, Strain::engineering));

    // drawn without stress the pair resists nothing sideways; then 2 N v / l = p
    const auto input = parse_structure(R"({"nodes": {"A": [-1, 0, 0], "B": [0, 0, 0], "C": [1, 0, 0]},
        "elements": [{"type": "truss", "nodes": ["A", "B"], "ea": 100, "prestress": 2, "planar": true},
                     {"type": "truss", "nodes": ["B", "C"], "ea": 100, "prestress": 2, "planar": true}],
        "supports": [{"node": "A", "fix": ["position"]}, {"node": "C", "fix": ["position"]}],
        "loads": [{"node": "B", "force": [0, -1, 0]}], "parameter": {"low": 0, "high": 0.001}})");
    const Structure structure(input.model);
    const auto loaded = loaded_state(structure, continuation_options(input));
    REQUIRE(loaded.reached());
    CHECK(loaded.passed.empty());
    const auto branch = continue_branch(structure, loaded.state, 0, 1, continuation_options(input));
    CHECK(branch.points.back().q.frames[1].x(1) == Approx(-0.001 / 4).epsilon(1e-4));
}

TEST_CASE("a fork holds the twist and lets all slopes be") {
    // S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability (1961), 6.3: a simply supported beam of narrow section
    // buckles sideways under a force at its middle of 16.94 sqrt(EI GJ) / l^2
    const auto text = [](const std::string& forks) {
        return R"({"nodes": {"A": [0, 0, 0], "M": [0.5, 0, 0], "B": [1, 0, 0]},
            "sections": {"s": {"ea": 1e9, "ga2": 1e9, "ga3": 1e9, "gj": 4, "ei2": 1e6, "ei3": 1}},
            "elements": [{"type": "beam", "nodes": ["A", "M"], "section": "s", "second": [0, 1, 0], "elements": 6},
                         {"type": "beam", "nodes": ["M", "B"], "section": "s", "second": [0, 1, 0], "elements": 6}],
            "supports": [{"node": "A", "fix": ["position"]}, {"node": "B", "fix": ["uy", "uz"]}],
            "joints": [)" +
               forks + R"(], "loads": [{"node": "M", "force": [0, 0, -1]}], "parameter": {"low": 0, "high": 50}})";
    };
    const auto found = critical_loads(text(R"({"type": "fork", "node": "A", "axis": [1, 0, 0], "upright": [0, 0, 1]},
                                              {"type": "fork", "node": "B", "axis": [1, 0, 0], "upright": [0, 0, 1]})"));
    REQUIRE(found.size() == 1);
    CHECK(found[0] == Approx(2 * 16.94).epsilon(1e-3));
}

TEST_CASE("springs against the ground hold a column's foot") {
    // k tan(k l) = c / EI with P = EI k^2, here EI = l = 1
    for (const double c : {0.5, 4.0, 1000.0}) {
        const double k = zero_between(1e-9, std::numbers::pi / 2 - 1e-9, [&](double x) { return x * std::tan(x) - c; });
        const auto text = [&](bool space) {
            const std::string stiffness = std::to_string(c);
            return R"({"nodes": {"A": [0, 0, 0], "B": [0, 1, 0]}, "sections": {"s": )" +
                   std::string(space
                                   ? R"({"ea": "rigid", "ga2": "rigid", "ga3": "rigid", "gj": 1, "ei2": 50, "ei3": 1})"
                                   : R"({"ea": "rigid", "ga": "rigid", "ei": 1})") +
                   R"(}, "elements": [{"type": "beam", "nodes": ["A", "B"], "section": "s", "elements": 6)" +
                   (space ? R"(, "second": [1, 0, 0])" : "") + R"(},
                   {"type": "rotation_spring", "node": "A", "stiffness": )" +
                   (space ? "[1000, 1000, " + stiffness + "]" : stiffness + R"(, "planar": true)") +
                   R"(}], "supports": [{"node": "A", "fix": ["position"]}],
                   "loads": [{"node": "B", "force": [0, -1, 0]}], "parameter": {"low": 0, "high": 2.6}})";
        };
        for (const bool space : {false, true}) {
            const auto found = critical_loads(text(space));
            REQUIRE(found.size() == 1);
            CHECK(found[0] == Approx(k * k).epsilon(1e-4));
        }
    }
}

TEST_CASE("a point spring says its force") {
    const auto input = parse_structure(R"({"nodes": {"A": [0, 0, 0], "B": [0, 0, 2]},
        "elements": [{"type": "truss", "nodes": ["A", "B"], "ea": 100},
                     {"type": "point_spring", "node": "B", "stiffness": [3, 4, 5]}],
        "supports": [{"node": "A", "fix": ["position"]}], "loads": [{"node": "B", "force": [6, 0, 0]}],
        "parameter": {"low": 0, "high": 0.1}})");
    const Structure structure(input.model);
    const auto branch = continue_branch(structure, structure.initial(), 0, 1, continuation_options(input));
    const auto& end = branch.points.back();
    const Json results = structure_results(structure, input, end.q, end.p);
    const Vector3d reaction = vector_of(results.at("reactions").at("A").at("force"));
    for (const Json& row : results.at("elements"))
        if (row.contains("F1")) {
            CHECK(row.at("element") == "elements[1]");
            const Vector3d spring(row.at("F1").get<double>(), row.at("F2").get<double>(), row.at("F3").get<double>());
            CHECK((spring + reaction + Vector3d(0.6, 0, 0)).norm() < 1e-9);
            CHECK(spring(0) < -0.5);
        }
}

TEST_CASE("a ring under pressure, and one whose pressure has no energy") {
    // M. Levy, J. Math. Pures Appl. 10 (1884): 3 EI / R^3
    const std::string ring = R"({"nodes": {"W": [-1, 0, 0], "E": [1, 0, 0]},
        "sections": {"s": {"ea": "rigid", "ga": "rigid", "ei": 1}},
        "elements": [{"type": "arc", "name": "lower", "nodes": ["W", "E"], "through": [0, -1, 0], "section": "s",
                      "elements": 16, "order": "cubic"},
                     {"type": "arc", "name": "upper", "nodes": ["E", "W"], "through": [0, 1, 0], "section": "s",
                      "elements": 16, "order": "cubic"}],
        "supports": [{"node": "W", "fix": ["all"]}],
        "loads": [{"type": "pressure", "elements": ["lower", "upper"], "pressure": 1}],
        "parameter": {"low": 0, "high": 5}})";
    const auto found = critical_loads(ring);
    REQUIRE_FALSE(found.empty());
    CHECK(found[0] == Approx(3).epsilon(1e-4));
    std::string half = ring;
    half.replace(half.find(R"(["lower", "upper"])"), 18, R"(["lower"])");
    CHECK_THROWS_WITH(parse_structure(half), Catch::Matchers::Contains("loads[0].elements") &&
                                                 Catch::Matchers::Contains("closed line in one direction"));
}

TEST_CASE("a constant motion comes first, and its force is known") {
    const auto input = parse_structure(R"({"nodes": {"A": [0, 0, 0], "B": [2, 0, 0]},
        "elements": [{"type": "truss", "nodes": ["A", "B"], "ea": 100, "strain": "engineering", "planar": true}],
        "supports": [{"node": "A", "fix": ["position"]}, {"node": "B", "fix": ["uy", "uz"]}],
        "joints": [{"type": "prescribed_displacement", "node": "B", "direction": [1, 0, 0], "rate": 0.1,
                    "kind": "constant"}],
        "loads": [{"node": "B", "force": [1, 0, 0]}], "parameter": {"low": 0, "high": 2}})");
    const Structure structure(input.model);
    const auto loaded = loaded_state(structure, continuation_options(input));
    REQUIRE(loaded.reached());
    CHECK(loaded.state.frames[1].x(0) == Approx(2.1).epsilon(1e-12));
    const auto branch = continue_branch(structure, loaded.state, 0, 1, continuation_options(input));
    const auto& end = branch.points.back();
    // the bar has 100 * 0.05, the load carries 2 of it
    const Json rows = structure_results(structure, input, end.q, end.p).at("elements");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("N").get<double>() == Approx(5).epsilon(1e-9));
    CHECK(rows[1].at("element") == "joints[0]");
    CHECK(rows[1].at("F").get<double>() == Approx(3).epsilon(1e-9));
}

TEST_CASE("loads along elements are refused with their place") {
    const auto refused = [](const std::string& loads, const std::string& place, const std::string& words) {
        CHECK_THROWS_WITH(parse_structure(heavy_column("1", loads, R"({"low": 0, "high": 1})")),
                          Catch::Matchers::Contains(place) && Catch::Matchers::Contains(words));
    };
    refused(R"([{"type": "distributed", "elements": ["beam"], "force": [0, 1, 0]}])", "loads[0].elements[0] = \"beam\"",
            "must be the name of a beam, an arc or a truss");
    refused(R"([{"type": "distributed", "elements": ["column"], "force": [0, 0, 1]}])", "loads[0].force",
            "not along uz");
    refused(R"([{"type": "snow", "elements": ["column"], "force": [0, 0, 1]}])", "loads[0].type", "\"self_weight\"");
    refused(R"([{"type": "pressure", "elements": ["column"], "pressure": 1}])", "loads[0].elements", "(0, 1, 0)");
}

#endif
