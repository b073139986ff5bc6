// Structures as text: what is read is what stands there, and what is wrong is refused with its place.
#if __has_include(<nlohmann/json.hpp>)

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/io/structure/structure_json.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using namespace equilibria::fem;

namespace {

/// The text with one part, which it must have, replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

/// The error's text; empty if there is none.
std::string refusal(const std::string& text, const ParseLimits& limits = {}) {
    try {
        parse_structure(text, limits);
    } catch (const InvalidArgument& e) {
        return e.what();
    }
    return {};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

const std::string column = R"({
    "name": "column",
    "nodes": {"foot": [0, 0, 0], "head": [0, 2, 0]},
    "sections": {"strip": {"ea": "rigid", "ga": "rigid", "ei": 4}},
    "elements": [{"type": "beam", "nodes": ["foot", "head"], "section": "strip"}],
    "supports": [{"node": "foot", "fix": ["all"]}],
    "loads": [{"node": "head", "force": [0, -1, 0]}],
    "parameter": {"name": "P", "low": -1, "high": 4, "first_step": 0.1, "largest_step": 0.2}
})";

/// Of everything one, in the order of the format; B, C and D are one body.
const std::string all_kinds = R"({
    "nodes": {"Z": [0, 0, 0], "A": [1, 0, 0], "B": [2, 0, 0], "C": [2, 1, 0], "D": [2, 0, 1], "E": [2, 0, 1],
              "F": [2, 0, 3], "G": [2, 1, 0], "H": [2, 1, 0]},
    "sections": {"blade": {"ea": 1e3, "ga2": 1e3, "ga3": "rigid", "gj": 1, "ei2": 2, "ei3": 30}},
    "elements": [
        {"type": "beam", "nodes": ["Z", "A"], "section": "blade", "second": [0, 1, 1], "elements": 3, "order": "linear"},
        {"type": "arc", "nodes": ["A", "B"], "through": [1.5, 0.2, 0], "section": "blade", "elements": 2,
         "order": "cubic"},
        {"type": "rigid_body", "nodes": ["B", "C", "D"]},
        {"type": "truss", "nodes": ["E", "F"], "ea": 7, "strain": "engineering"},
        {"type": "rotation_spring", "nodes": ["D", "E"], "stiffness": 3},
        {"type": "point_spring", "node": "F", "stiffness": [1, 2, 3]}
    ],
    "joints": [
        {"type": "revolute", "nodes": ["D", "E"], "axis": [0, 0, 2]},
        {"type": "spherical", "nodes": ["C", "G"]},
        {"type": "prismatic", "nodes": ["G", "H"], "axis": [1, 0, 0]},
        {"type": "prescribed_displacement", "node": "F", "direction": [0, 3, 0], "rate": 2},
        {"type": "prescribed_rotation", "node": "H", "axis": [1, 0, 0]}
    ],
    "supports": [{"node": "Z", "fix": ["position", "rx", "ry", "rz"]}],
    "loads": [{"node": "C", "force": [1, 2, 3], "kind": "constant"},
              {"node": "B", "type": "follower", "moment": [0, 0, 1]}],
    "parameter": {"low": 0, "high": 1},
    "measure": "D"
})";

}  // namespace

TEST_CASE("a structure is what its text says") {
    const auto input = parse_structure(all_kinds);
    const fem::Model& model = input.model;
    CHECK(input.name.empty());
    CHECK(input.nodes.at("Z") == 0);
    CHECK(input.nodes.at("A") == 1);
    CHECK(input.nodes.size() == 9);
    CHECK(model.nodes() == 9 + 2 + 5);
    CHECK(input.measured == input.nodes.at("D"));
    CHECK_FALSE(input.conservative);
    CHECK(input.parameter == "p");
    CHECK_FALSE(input.first_step);
    CHECK(model.at(2) == Eigen::Vector3d(2, 0, 0));
    for (const Component c : spatial) {
        CHECK(model.fixed(0, c));
        CHECK_FALSE(model.fixed(1, c));
    }
    CHECK(model.rotates_with(input.nodes.at("D")) == input.nodes.at("B"));

    REQUIRE(model.group<MixedBeam<2>>() != nullptr);
    CHECK(model.group<MixedBeam<2>>()->size() == 3);
    REQUIRE(model.group<MixedBeam<4>>() != nullptr);
    CHECK(model.group<MixedBeam<4>>()->size() == 2);
    CHECK(model.group<RigidLink<3>>()->size() == 2);
    CHECK(model.group<RotationSpring>()->size() == 1);
    CHECK((*model.group<PointSpring<3>>())[0].stiffness == Eigen::Vector3d(1, 2, 3));
    CHECK(model.group<RevoluteJoint>()->size() == 1);
    CHECK(model.group<SphericalJoint>()->size() == 1);
    CHECK(model.group<PrismaticJoint>()->size() == 1);
    CHECK((*model.group<PrescribedDisplacement>())[0].direction == Eigen::Vector3d(0, 1, 0));
    CHECK((*model.group<PrescribedDisplacement>())[0].rate == 2);
    CHECK(model.group<PrescribedRotation>()->size() == 1);
    CHECK((*model.group<FollowerLoad>())[0].moment == Eigen::Vector3d(0, 0, 1));
    REQUIRE(model.loads().size() == 1);
    CHECK(model.loads()[0].force == Eigen::Vector3d(1, 2, 3));
    CHECK(model.loads()[0].kind == LoadKind::constant);

    // twice as long, the bar has an engineering strain of 1
    std::array<Frame<double>, 2> ends;
    ends[1].x << 0, 0, 4;
    CHECK((*model.group<Truss<3>>())[0].strain(ends) == Approx(1).epsilon(1e-15));

    // every joint holds at the start, where only the constant load is not balanced
    const NonconservativeStructure structure(model);
    const Eigen::VectorXd g = structure.residual(structure.initial(), 0);
    const int c = structure.unknown(input.nodes.at("C"), ux);
    CHECK(g.segment<3>(c) == Eigen::Vector3d(-1, -2, -3));
    CHECK(g.norm() == Approx(std::sqrt(14.0)).epsilon(1e-12));
}

TEST_CASE("what a text may leave out") {
    auto input = parse_structure(column);
    CHECK(input.name == "column");
    CHECK(input.conservative);
    CHECK(input.measured == input.nodes.at("head"));
    CHECK(input.parameter == "P");
    CHECK(*input.largest_step == 0.2);
    CHECK(input.model.group<PlanarMixedBeam<3>>()->size() == 8);
    CHECK(input.model.loads()[0].kind == LoadKind::proportional);

    // without loads the last node is looked at
    input = parse_structure(changed(column, R"("loads": [{"node": "head", "force": [0, -1, 0]}],)", ""));
    CHECK(input.measured == 1);
    // a moment about one free axis has an energy, one about any axis has none
    CHECK(parse_structure(changed(column, R"("force": [0, -1, 0])", R"("moment": [0, 0, 1])")).conservative);
    const std::string space =
        changed(column, R"({"ea": "rigid", "ga": "rigid", "ei": 4})",
                R"({"ea": "rigid", "ga2": "rigid", "ga3": "rigid", "gj": 1, "ei2": 4, "ei3": 4})");
    CHECK(parse_structure(space).conservative);
    CHECK_FALSE(parse_structure(changed(space, R"("force": [0, -1, 0])", R"("moment": [0, 0, 1])")).conservative);
    // nothing holds a free body
    CHECK(refusal(changed(column, R"("supports": [{"node": "foot", "fix": ["all"]}],)", "")).empty());
}

TEST_CASE("the critical load of a column that was read") {
    // pi^2 EI / (4 l^2) with EI = 4 and l = 2
    const double critical = std::numbers::pi * std::numbers::pi / 4;
    tests::ScratchFile file("column.json");
    file.write({column.begin(), column.end()});
    const auto input = read_structure(file.name());
    const Structure structure(input.model);
    ContinuationOptions options;
    options.range.low = input.low;
    options.range.high = input.high;
    options.branch.first_step = *input.first_step;
    options.branch.largest_step = *input.largest_step;
    options.branch.parameter_weight = 0.1;
    const auto branch = continue_branch(structure, structure.initial(), 0.0, 1, options);
    CHECK(branch.end == BranchEnd::window);
    REQUIRE(branch.events.size() == 1);
    CHECK(branch.events[0].point.p == Approx(critical).epsilon(1e-5));
}

TEST_CASE("arcs keep their circle and their frame") {
    for (const bool in_plane : {false, true}) {
        const std::string section = in_plane ? R"({"ea": 1, "ga": 1, "ei": 1})"
                                             : R"({"ea": 1, "ga2": 1, "ga3": 1, "gj": 1, "ei2": 1, "ei3": 1})";
        // three quarters of the unit circle, from its bottom
        const auto input =
            parse_structure(R"({"nodes": {"A": [0, -1, 0], "B": [-1, 0, 0]}, "sections": {"s": )" + section +
                            R"(}, "elements": [{"type": "arc", "nodes": ["A", "B"], "section": "s",
                                           "through": [0.6, 0.8, 0]}], "parameter": {"low": 0, "high": 1}})");
        REQUIRE(input.model.nodes() == 17);
        for (int k = 0; k < 15; ++k) {
            const double angle = 1.5 * std::numbers::pi * (k + 1) / 16;
            const Eigen::Vector3d x(std::sin(angle), -std::cos(angle), 0);
            CHECK((input.model.at(2 + k) - x).norm() < 1e-14);
        }
        // axis 1 along the curve, and curvature 1 to the left about the normal: axis 2 in space
        const auto check = [&](const auto* beams, const Eigen::VectorXd& expected) {
            REQUIRE(beams != nullptr);
            REQUIRE(beams->size() == 8);
            for (std::size_t e = 0; e < 8; ++e) {
                typename std::remove_cvref_t<decltype((*beams)[e])>::Frames at;
                for (std::size_t k = 0; k < 3; ++k) at[k].x = input.model.at(beams->nodes(e)[k]);
                const auto& geometry = (*beams)[e].geometry();
                CHECK((geometry.point(geometry.nodes(at), 0).total - expected).norm() < 2e-3);
            }
        };
        if (in_plane)
            check(input.model.group<PlanarBeam<3>>(), Eigen::Vector3d(1, 0, 1));
        else
            check(input.model.group<Beam<3>>(), Eigen::Vector<double, 6>(1, 0, 0, 0, 1, 0));
    }
    // nearly straight: the sag of a chord of 1 is a millionth
    const auto flat = Arc::through({0, 0, 0}, {0.5, 0, 1e-6}, {1, 0, 0});
    REQUIRE(flat);
    CHECK(flat->at(0.5)(2) == Approx(1e-6).epsilon(1e-9));
    CHECK((flat->at(1) - Eigen::Vector3d(1, 0, 0)).norm() < 1e-15);
    CHECK_FALSE(Arc::through({0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}));
    CHECK_FALSE(Arc::through({0, 0, 0}, {0.5, 0, 1}, {0, 0, 0}));
    // a quarter of a circle from x to y: the directions are those from x to y
    const auto quarter = Arc::through({0, -1, 0}, {std::sqrt(0.5), -std::sqrt(0.5), 0}, {1, 0, 0});
    REQUIRE(quarter);
    CHECK(quarter->clearance({0, 0, 1}) == Approx(std::numbers::pi / 2));
    CHECK(quarter->clearance({1, 1, 0}) < 1e-7);
    CHECK(quarter->clearance({-1, -1, 0}) < 1e-7);
    CHECK(quarter->clearance({1, -1, 0}) == Approx(std::numbers::pi / 4));
    CHECK(quarter->clearance({1, 1, std::sqrt(2.0)}) == Approx(std::numbers::pi / 4));
}

TEST_CASE("what is wrong in a structure is refused with its place") {
    struct Case {
        std::string from, to;
        std::vector<std::string> said;
    };
    const std::string beam = R"({"type": "beam", "nodes": ["foot", "head"], "section": "strip"})";
    const std::vector<Case> cases{
        {R"("foot", "head"])", R"("foot", "B7"])", {R"(elements[0].nodes[1] = "B7": must be the name of a node)"}},
        {"[0, 2, 0]", "[0, 0, 0]", {R"(elements[0].nodes = ["foot","head"]: must not both be at (0, 0, 0))"}},
        {R"("foot", "head"])", R"("foot", "foot"])", {"elements[0].nodes", "must be different nodes"}},
        {R"("foot", "head"])", R"("foot"])", {R"(elements[0].nodes = ["foot"]: must be a list of 2 nodes)"}},
        {R"("section": "strip")", R"("section": "strap")", {R"(elements[0].section = "strap": must be the name of a)"}},
        {R"(, "section": "strip")", "", {"elements[0] = {", R"(must have "section")"}},
        {R"("section": "strip")",
         R"("sektion": "x", "section": "strip")",
         {R"(elements[0].sektion = "x": is no key of a beam, whose keys are type, nodes, section, second, elements, order)"}},
        {R"("section": "strip")",
         R"("second": [1, 0, 0], "section": "strip")",
         {"elements[0].second = [1,0,0]", "planar"}},
        {R"("section": "strip")",
         R"("elements": 0, "section": "strip")",
         {"elements[0].elements = 0: must be an integer from 1 to 100000"}},
        {R"("section": "strip")", R"("elements": 8.5, "section": "strip")", {"elements[0].elements = 8.5"}},
        {R"("section": "strip")", R"("elements": 1e6, "section": "strip")", {"elements[0].elements = 1000000.0"}},
        {R"("section": "strip")",
         R"("order": "cubical", "section": "strip")",
         {R"(elements[0].order = "cubical": must be "linear", "quadratic" or "cubic")"}},
        {R"("type": "beam")", R"("type": "cable")", {R"(elements[0].type = "cable": must be "beam", "arc")"}},
        {R"("type": "beam")", R"("type": 3)", {"elements[0].type = 3"}},
        {R"("type": "beam")", R"("type": "arc", "through": [0, 1, 0])", {"elements[0].through = [0,1,0]", "on a line"}},
        {R"("type": "beam")", R"("type": "arc", "through": [1, 1, 1])", {"elements[0].through", "z = 0"}},
        {R"("type": "beam")",
         R"("elements": 1, "type": "arc", "through": [30, 1, 0])",
         {"elements[0] = ", "right angle"}},
        {"[0, 2, 0]", "[0, 2, 1]", {R"(elements[0].nodes[1] = "head": must be in the plane z = 0)", "(0, 2, 1)"}},
        {"[0, 2, 0]", "[0, 2]", {"nodes.head = [0,2]: must be a list of 3 numbers"}},
        {"[0, 2, 0]", "[0, true, 0]", {"nodes.head[1] = true: must be a number"}},
        {"[0, 2, 0]", "[0, 1e200, 0]", {"elements[0].nodes", "finite distance"}},
        {"[0, 2, 0]", "[0, 2e-170, 0]", {"elements[0].nodes"}},
        {"[0, 2, 0]", "[0, 2, 0], \"lost\": [0, 0, 0]", {"nodes.lost = [0,0,0]: is used by no element and no joint"}},
        {"[0, 2, 0]", "[0, 2, 0], \"a b\\n\": 1", {R"(nodes["a b\n"] = 1: must be a list)"}},
        {R"({"foot": [0, 0, 0], "head": [0, 2, 0]})", "{}", {"nodes = {}: must not be empty"}},
        {R"({"foot": [0, 0, 0], "head": [0, 2, 0]})", "[1]", {"nodes = [1]: must be an object"}},
        {"[" + beam + "]", "[]", {"elements = []: must not be empty"}},
        {"[" + beam + "]", "7", {"elements = 7: must be a list"}},
        {beam, "7", {"elements[0] = 7: must be an object"}},
        {R"("ei": 4)", R"("ei": -4)", {"sections.strip.ei = -4: must be a positive number"}},
        {R"("ei": 4)", R"("ei": "rigid")", {R"(sections.strip.ei = "rigid": must be a positive number)"}},
        {R"("ei": 4)", R"("ei": 1e308)", {"scale = inf"}},
        {R"("ea": "rigid")",
         R"("ea": "stiff")",
         {R"(sections.strip.ea = "stiff": must be a positive number or "rigid")"}},
        {R"("ea": "rigid", )", "", {"sections.strip = ", R"(must have "ea")"}},
        {R"("ga": "rigid", "ei": 4)",
         R"("ga2": 1, "ga3": 1, "gj": "rigid", "ei2": "rigid", "ei3": "rigid")",
         {"sections.strip", "all rigid"}},
        {R"("fix": ["all"])", R"("fix": ["al"])", {R"(supports[0].fix[0] = "al": must be "ux")"}},
        {R"("fix": ["all"])", R"("fix": [])", {"supports[0].fix = []: must not be empty"}},
        {R"("fix": ["all"])", R"("fix": "all")", {R"(supports[0].fix = "all": must be a list)"}},
        {R"("fix": ["all"]})",
         R"("fix": ["all"]}, {"node": "head", "fix": ["all"]})",
         {"elements[0] = ", "over-constrained"}},
        {"[0, -1, 0]", "[0, -1, 1]", {"loads[0].force = [0,-1,1]: must act on what elements use: not along uz"}},
        {R"("force": [0, -1, 0])", R"("moment": [1, 0, 0])", {"loads[0].moment", "not along rx"}},
        {R"(, "force": [0, -1, 0])", "", {R"(loads[0] = {"node":"head"}: must have a force or a moment)"}},
        {R"(, "force": [0, -1, 0])",
         R"(, "force": [0, -1, 0], "kind": "variable")",
         {R"(loads[0].kind = "variable": must be "proportional" or "constant")"}},
        {R"(, "force": [0, -1, 0])",
         R"(, "force": [0, -1, 0], "type": "follower", "kind": "steady")",
         {R"(loads[0].kind = "steady": must be "proportional" or "constant")"}},
        {R"(, "force": [0, -1, 0])",
         R"(, "force": [0, -1, 0], "type": "follower")",
         {"loads[0].node = \"head\"", "uz is not"}},
        {R"("low": -1)", R"("low": 4)", {R"(parameter.low = 4: must be below high, 4)"}},
        {R"("low": -1, )", "", {R"(must have "low")"}},
        {R"("first_step": 0.1)",
         R"("first_step": 0.3)",
         {"parameter.first_step = 0.3: must not be above largest_step, 0.2"}},
        {R"("first_step": 0.1)", R"("first_step": 0)", {"parameter.first_step = 0: must be a positive number"}},
        {R"("name": "column")", R"("name": 1)", {"name = 1: must be a string"}},
        {R"("name": "column")", R"("measure": "top")", {R"(measure = "top": must be the name of a node)"}},
        {R"("name": "column")", R"("comment": "!")", {R"(comment = "!": is no key of a structure)"}},
        {R"("name": "column")",
         R"("joints": [{"type": "revolute", "nodes": ["foot", "head"], "axis": [0, 0, 1]}])",
         {"joints[0].nodes", "at one place", "(0, 2, 0)"}},
        {R"("name": "column")",
         R"("joints": [{"type": "prismatic", "nodes": ["foot", "head"], "axis": [0, 0, 0]}])",
         {"joints[0].axis = [0,0,0]: must have a positive and finite length"}},
        {R"("name": "column")",
         R"("joints": [{"type": "prescribed_displacement", "node": "head", "direction": [1.7e308, 1.7e308, 0]}])",
         {"joints[0].direction"}},
        {R"("name": "column")",
         R"("joints": [{"type": "hinge", "nodes": ["foot", "head"], "axis": [0, 0, 1]}])",
         {"joints[0].axis", "is no key of a hinge"}},
    };
    REQUIRE(refusal(column).empty());
    for (const auto& [from, to, said] : cases) {
        INFO(to);
        const std::string error = refusal(changed(column, from, to));
        INFO(error);
        for (const std::string& part : said) CHECK(has(error, part));
    }
}

TEST_CASE("elements that a list of beams has not") {
    struct Case {
        std::string from, to;
        std::vector<std::string> said;
    };
    const std::vector<Case> cases{
        {"[0, 1, 1]", "[3, 0, 0]", {"elements[0].second = [3,0,0]: must not be along the beam"}},
        {R"("through": [1.5, 0.2, 0])",
         R"("second": [1, 0, 0.05], "through": [1.5, 0.2, 0])",
         {"elements[1].second = [1,0,0.05]: must be 0.1 radians off"}},
        {R"(["B", "C", "D"])", R"(["B", "C", "D", "C"])", {R"(elements[2].nodes[3] = "C": must be named once)"}},
        {R"(["B", "C", "D"])", R"(["B"])", {"elements[2].nodes", "at least 2"}},
        {R"("ea": 7)", R"("ea": 0)", {"elements[3].ea = 0: must be a positive number"}},
        {R"("strain": "engineering")", R"("strain": "true")", {R"(elements[3].strain = "true": must be "green" or)"}},
        {R"("strain": "engineering")", R"("planar": 1)", {"elements[3].planar = 1: must be true or false"}},
        {R"("strain": "engineering")", R"("planar": true)", {R"(elements[3].nodes[0] = "E": must be in the plane)"}},
        {R"("stiffness": 3})", R"("stiffness": "3"})", {R"(elements[4].stiffness = "3": must be a positive number)"}},
        {"[1, 2, 3]}\n", "[0, 0, 0]}\n", {"elements[5].stiffness = [0,0,0]"}},
        {"[1, 2, 3]}\n", "[1, -1, 0]}\n", {"elements[5].stiffness = [1,-1,0]"}},
        {R"("axis": [0, 0, 2])", R"("axis": "z")", {R"(joints[0].axis = "z": must be a list of 3 numbers)"}},
        {R"({"type": "spherical", "nodes": ["C", "G"]},)",
         R"({"type": "spherical", "nodes": ["C", "G"]}, {"type": "spherical", "nodes": ["G", "C"]},)",
         {R"(joints[2] = {"nodes":["G","C"],"type":"spherical"}: must not be over-constrained: at the start 3 of)"}},
        {R"("prescribed_rotation", "node": "H")",
         R"("prescribed_rotation", "node": "Z")",
         {"joints[4]", "over-constrained", "at the start 3 of"}},
        {R"({"node": "C", "force": [1, 2, 3], "kind": "constant"})",
         R"({"node": "F", "moment": [1, 0, 0]})",
         {"loads[0].moment", "not along rx"}},
        {R"("node": "B", "type": "follower")",
         R"("node": "F", "type": "follower")",
         {R"(loads[1].node = "F")", "rx is not"}},
        {R"("measure": "D")", R"("measure": ["D"])", {R"(measure = ["D"]: must be a string)"}},
    };
    REQUIRE(refusal(all_kinds).empty());
    for (const auto& [from, to, said] : cases) {
        INFO(to);
        const std::string error = refusal(changed(all_kinds, from, to));
        INFO(error);
        for (const std::string& part : said) CHECK(has(error, part));
    }

    // a planar four-bar of hinges, one body a bar, is as it should be; with spatial joints it is over-constrained
    const std::string bars = R"({"nodes": {"a0": [0, 0, 0], "a1": [0, 0, 0], "b1": [0, 1, 0], "b2": [0, 1, 0],
        "c2": [1, 2, 0], "c3": [1, 2, 0], "d3": [1, 0, 0], "d0": [1, 0, 0]},
        "elements": [{"type": "rigid_body", "nodes": ["a1", "b1"], "planar": true},
                     {"type": "rigid_body", "nodes": ["b2", "c2"], "planar": true},
                     {"type": "rigid_body", "nodes": ["c3", "d3"], "planar": true},
                     {"type": "rotation_spring", "nodes": ["a0", "a1"], "stiffness": 1, "planar": true}],
        "joints": [{"type": "hinge", "nodes": ["a0", "a1"]}, {"type": "hinge", "nodes": ["b1", "b2"]},
                   {"type": "hinge", "nodes": ["c2", "c3"]}, {"type": "hinge", "nodes": ["d3", "d0"]}],
        "supports": [{"node": "a0", "fix": ["all"]}, {"node": "d0", "fix": ["all"]}],
        "parameter": {"low": 0, "high": 1}})";
    CHECK(refusal(bars) == "");
    std::string rigid_bars = bars;
    for (int k = 0; k < 4; ++k) rigid_bars = changed(rigid_bars, ", \"planar\": true", "");
    for (int k = 0; k < 4; ++k) rigid_bars = changed(rigid_bars, "\"hinge\"", R"("revolute", "axis": [0, 0, 1])");
    CHECK(has(refusal(rigid_bars), "joints[3]"));
    CHECK(has(refusal(rigid_bars), "3 of the structure's 29 constraints"));
}

TEST_CASE("what is no JSON is refused") {
    const auto has_place = [](const std::string& error, const std::string& part) {
        INFO(error);
        CHECK(has(error, part));
        for (const char c : error) CHECK((c >= ' ' && c <= '~'));
    };
    has_place(refusal(""), "JSON text, line 1, column 1 = '': must be JSON");
    has_place(refusal(changed(column, "[0, 2, 0]", "[0, NaN, 0]")), "JSON text, line 3, column 46 = '...");
    has_place(refusal(changed(column, "[0, 2, 0]", "[0, Infinity, 0]")), "line 3");
    has_place(refusal(changed(column, "[0, 2, 0]", "[0, 1e999, 0]")), "nodes.head[1] = out of range: must be a number");
    has_place(refusal(changed(column, "[0, 2, 0]", "[0, -1e999, 0]")), "nodes.head[1]");
    has_place(refusal(changed(column, "[0, 2, 0]", "[0, 2, 0], \"foot\": [0, 1, 0]")),
              "nodes.foot = \"foot\": must not be a key twice");
    has_place(refusal(changed(column, R"("type": "beam")", R"("type": "beam", "type": "beam")")), "elements[0].type");
    has_place(refusal(changed(column, "column", "col\xFFumn")), "must be JSON");
    has_place(refusal(changed(column, "column", "col\xC3")), "must be JSON");
    has_place(refusal(changed(column, "column", std::string("col\0", 4))), "must be JSON");
    has_place(refusal(column + "{}"), "line 9");
    has_place(refusal("// comment\n" + column), "line 1");
    has_place(refusal(std::string(17, '[')), "deeper than 16");
    has_place(refusal(std::string(1 << 20, '[')), "deeper than 16");
    has_place(refusal(std::string(1 << 20, '"')), "must be JSON");
    CHECK(refusal(std::string(1 << 20, '"')).size() < 300);
    CHECK(refusal("\"" + std::string(1 << 20, 'x') + "\"").size() < 300);
    has_place(refusal("[" + std::string(1 << 20, '1') + "]"), "out of range");
    for (const char* text : {"null", "1", "\"x\"", "[]", "true"}) has_place(refusal(text), "JSON text = ");
    has_place(refusal("{}"), R"(JSON text = {}: must have "nodes")");
    for (std::size_t length = 0; length < column.size(); ++length)
        CHECK_FALSE(refusal(column.substr(0, length)).empty());
}

TEST_CASE("no text takes more than its limits") {
    CHECK(refusal(column, {.bytes = column.size()}).empty());
    CHECK(has(refusal(column, {.bytes = column.size() - 1}), "must have at most"));
    CHECK(refusal(column, {.elements = 8}).empty());
    CHECK(has(refusal(column, {.elements = 7}), "must not take the model above 7 elements"));
    CHECK(has(refusal(all_kinds, {.elements = 10}), "must not take the model above 10 elements"));
    CHECK(has(refusal(column, {.depth = 3}), "depth = 3"));
    CHECK(has(refusal(column, {.elements = 0}), "elements = 0"));
    CHECK(has(refusal(column, {.constraints = -1}), "constraints = -1"));
    // constraints beyond the limit are not looked at
    const std::string held =
        changed(column, R"("fix": ["all"]})", R"("fix": ["all"]}, {"node": "head", "fix": ["all"]})");
    CHECK(has(refusal(held, {.constraints = 32}), "over-constrained"));
    CHECK(refusal(held, {.constraints = 31}).empty());
}

TEST_CASE("files that cannot be read as a structure") {
    const auto refusal_of = [](const std::string& path, const ParseLimits& limits = {}) -> std::string {
        try {
            read_structure(path, limits);
        } catch (const InvalidArgument& e) {
            return e.what();
        }
        return {};
    };
    tests::ScratchFile file("structure.json");
    CHECK(has(refusal_of(file.name()), "must be a file that can be read: No such file"));
    CHECK(has(refusal_of(""), "path = \"\": must be a file"));
    CHECK(has(refusal_of(std::filesystem::temp_directory_path().string()), "must be a file, not a folder"));
    CHECK(has(refusal_of("/dev/zero"), "must be a file of at most 67108864 bytes"));
    file.write({});
    CHECK(has(refusal_of(file.name()), "must be JSON"));
    // a gigabyte without contents
    std::filesystem::resize_file(file.name(), std::uintmax_t{1} << 30);
    CHECK(has(refusal_of(file.name()), "must be a file of at most 67108864 bytes, not 1073741824"));
    file.write({column.begin(), column.end()});
    std::filesystem::resize_file(file.name(), column.size());
    CHECK(refusal_of(file.name()) == "");
    CHECK(has(refusal_of(file.name(), {.bytes = 100}), "at most 100 bytes"));
}

#endif
