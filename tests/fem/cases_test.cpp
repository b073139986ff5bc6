// The numbered cases against their references, and orders of convergence against shooting.
#include <equilibria/fem/section.hpp>
#include <map>

#include "../programs/support/buckling_cases.hpp"
#include "fem/reference_paths.hpp"
#include "support/catch.hpp"
#include "support/rod_shooting.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::Vector3d;
using support::BucklingCase;
using support::CaseData;

namespace {

struct Traced {
    std::vector<CriticalPoint<Structure>> points;              // of the main branch, in both directions
    std::vector<double> values;                                // their parameters in the case's unit
    std::map<std::string, std::pair<double, Vector3d>> named;  // parameter and tip at the first place of each name
    std::vector<Branch<Structure>> sides;                      // from the first bifurcation
    bool explained = true;
};

Traced trace(const BucklingCase& c, bool sides = false, int most_steps = 400) {
    Traced y;
    BranchStepper<Structure> stepper(c.structure, c.options.branch);
    std::vector<EventFunction<Structure>> functions;
    for (const auto& point : c.points)
        functions.push_back(
            {point.name, [f = point.value](const BranchPoint<Structure>& at) { return f(at.q, at.p); }});
    const auto enter = [&](const Branch<Structure>& branch) {
        y.explained = y.explained && branch.unexplained.empty();
        for (const auto& crossing : branch.crossings)
            y.named.try_emplace(c.points[crossing.function].name,
                                std::pair{c.value(crossing.point.q, crossing.point.p),
                                          crossing.point.q.frames[static_cast<std::size_t>(c.tip)].x});
    };
    for (const int direction : {1, -1}) {
        if (direction < 0 && !c.both_ways) break;
        const auto start = stepper.start(c.structure.initial(), 0, direction);
        REQUIRE(start);
        const auto main = follow(stepper, *start, c.options, functions);
        enter(main);
        CHECK(main.end == BranchEnd::window);
        for (const auto& event : main.events) {
            y.points.push_back(event.point);
            y.values.push_back(c.value(event.point.q, event.point.p));
        }
        if (!sides || direction < 0) continue;
        auto options = c.options;
        options.most_steps = most_steps;
        for (const auto& event : main.events) {
            if (!is_bifurcation(event.point.kind)) continue;
            for (const auto& from : switch_branch(stepper, event.point, main.points[event.step].tangent, c.amplitude)) {
                y.sides.push_back(follow(stepper, from, options, functions));
                enter(y.sides.back());
            }
            break;
        }
    }
    return y;
}

struct Reference {
    double value;
    CriticalKind kind;
};
void check(const Traced& y, const std::vector<Reference>& expected, double tolerance) {
    CHECK(y.explained);
    REQUIRE(y.points.size() >= expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(k);
        CHECK(y.values[k] == Approx(expected[k].value).epsilon(tolerance));
        CHECK(y.points[k].kind == expected[k].kind);
        CHECK(y.points[k].nullity == (expected[k].kind == CriticalKind::multiple ? 2 : 1));
    }
}
CaseData with(int elements, int nodes = 4) {
    CaseData y;
    y.elements = elements;
    y.nodes = nodes;
    return y;
}

constexpr auto fold = CriticalKind::fold, pitchfork = CriticalKind::pitchfork, multiple = CriticalKind::multiple;
const double pi = std::numbers::pi;

}  // namespace

TEST_CASE("1: Euler's column with all ends, sheared and stretched, and the elastica") {
    auto data = with(32);
    const auto y = trace(support::euler_column(data), true);
    check(y, {{pi * pi / 4, pitchfork}, {9 * pi * pi / 4, pitchfork}}, 1e-8);
    for (const auto& e : references::elastica) {
        const auto& [load, tip] = y.named.at("angle of the tip = " + to_text(e[0]) + " degrees");
        CHECK(load / (pi * pi / 4) == Approx(e[1]).epsilon(1e-8));
        CHECK((tip - Vector3d(e[2], std::copysign(e[3], tip(1)), 0)).norm() < 2e-8);
    }
    // p = p_c (1 + angle^2 / 8): the pitchfork's curvature
    const auto& point = y.points[0];
    const double angle = point.null_vector(support::euler_column(data).structure.unknown(1, rz));
    CHECK(point.curvature / (angle * angle) == Approx(pi * pi / 16).epsilon(1e-5));

    data.ends = "hinged";
    check(trace(support::euler_column(data)), {{pi * pi, pitchfork}, {4 * pi * pi, pitchfork}}, 1e-7);
    data.ends = "clamped";
    check(trace(support::euler_column(data)), {{4 * pi * pi, pitchfork}, {80.762914222, pitchfork}}, 1e-7);
    data.ends = "clamped-hinged";
    check(trace(support::euler_column(data)), {{20.190728556, pitchfork}}, 1e-7);
    data.ends = "cantilever";
    for (const auto& [ea, ga, load] : {std::tuple{1e4, 5e3, 2.4667925937}, std::tuple{1e3, 4e2, 2.45833597661}}) {
        data.ea = ea;
        data.ga = ga;
        check(trace(support::euler_column(data)), {{load, pitchfork}}, 1e-8);
    }
}

TEST_CASE("2: a cantilever rolled up to four full circles") {
    const auto c = support::roll_up(with(16, 3));
    const auto y = trace(c);
    CHECK(y.points.empty());
    CHECK(y.explained);
    for (const int n : {1, 2, 3, 4}) {
        const auto& [load, tip] = y.named.at("at " + std::to_string(n));
        CHECK(load == Approx(n).epsilon(1e-12));
        CHECK(tip.norm() < 1e-10);
    }
}

TEST_CASE("3: lateral buckling of a cantilever") {
    const auto y = trace(support::lateral_cantilever(with(16)), true, 40);
    check(y, {{references::lateral_critical_load, pitchfork}}, 1e-8);
    for (const auto& e : references::lateral_cantilever) {
        const auto& [load, tip] = y.named.at("z of the tip = " + to_text(e[0]));
        CHECK(load / references::lateral_critical_load == Approx(e[1]).epsilon(1e-7));
        CHECK((tip - Vector3d(e[2], e[3], e[0])).norm() < 2e-7);
    }
    auto stiff = with(16);
    stiff.ei3 = rigid;
    check(trace(support::lateral_cantilever(stiff)), {{4.012599343578901 * std::sqrt(1.343), pitchfork}}, 1e-8);
}

TEST_CASE("4: lateral buckling of a strip") {
    const double plain = pi * std::sqrt(1.343);
    check(trace(support::lateral_strip(with(16))), {{plain / std::sqrt((1 - 1. / 25) * (1 - 1.343 / 25)), pitchfork}},
          1e-7);
    auto stiff = with(16);
    stiff.ei3 = rigid;
    check(trace(support::lateral_strip(stiff)), {{plain, pitchfork}}, 1e-7);
}

TEST_CASE("5: the right-angle frame and its post-critical path") {
    const auto y = trace(support::right_angle_frame(with(16)), true, 60);
    check(y, {{references::right_angle_critical_load, pitchfork}}, 1e-7);
    for (const auto& [z, load] : references::right_angle_frame)
        CHECK(y.named.at("z of the tip = " + to_text(z)).first == Approx(load).epsilon(1e-7));
}

TEST_CASE("6: the hinged frame's two close points") {
    const auto y = trace(support::hinged_frame(with(32)));
    check(y, {{622.22166, pitchfork}, {-622.22186, pitchfork}, {-631.56664, pitchfork}}, 1e-7);
}

TEST_CASE("7 and 8: deep arches") {
    auto data = with(32);
    check(trace(support::deep_arch(data)), {{897.308997, fold}}, 1e-7);
    data.ea = data.ga = 1e8;
    check(trace(support::deep_arch(data)), {{897.289134, fold}}, 1e-7);
    check(trace(support::hinged_arch(with(32))), {{5.86053763, pitchfork}, {10.15034386, fold}}, 1e-7);
}

TEST_CASE("10 and 11: Lee's frame with its snap-back, and Williams' toggle") {
    check(trace(support::lee_frame(with(32))), {{1.855672754, fold}, {-0.941443156, fold}}, 1e-7);
    check(trace(support::williams_toggle(with(32))), {{33.8612330, fold}, {31.2625831, fold}}, 1e-7);
}

TEST_CASE("12 and 13: trusses") {
    // H = 2, a = 1
    const double h = 2, l3 = std::pow(5.0, 1.5), limit = 2 * h * h * h / (3 * std::sqrt(3.0) * l3),
                 sway = 2 * std::sqrt(h * h - 2) / l3;
    const auto y = trace(support::von_mises_truss({}), true);
    check(y, {{sway, pitchfork}, {limit, fold}, {-limit, fold}, {-sway, pitchfork}}, 1e-11);
    for (const auto& side : y.sides)
        for (const auto& at : side.points) {
            const Vector3d& x = at.q.frames[1].x;
            CHECK(x(0) * x(0) + x(1) * x(1) == Approx(h * h - 2).epsilon(1e-10));
        }
    check(trace(support::star_dome({})),
          {{8.64367449817e-4, pitchfork},
           {1.02026178545e-3, multiple},
           {1.54281129992e-3, multiple},
           {1.81039958136e-3, fold}},
          1e-10);
    CaseData apex;
    apex.load = "apex";
    check(trace(support::star_dome(apex)), {{3.15579970840e-4, fold}, {-2.76052681472e-4, fold}}, 1e-10);
}

TEST_CASE("A branch that leaves a double point of the star dome passes it again, and all its steps are explained") {
    const auto dome = support::star_dome({});
    BranchStepper<Structure> stepper(dome.structure, dome.options.branch);
    const auto start = stepper.start(dome.structure.initial(), 0, 1);
    REQUIRE(start);
    const auto main = follow(stepper, *start, dome.options);
    REQUIRE(main.events.size() == 4);
    auto options = dome.options;
    options.most_steps = 400;
    int passed = 0;
    for (const std::size_t number : {1, 2}) {
        const auto& left = main.events[number];
        for (const auto& from : switch_branch(stepper, left.point, main.points[left.step].tangent, dome.amplitude)) {
            const auto side = follow(stepper, from, options);
            CHECK(side.unexplained.empty());
            for (const auto& event : side.events) {
                if (event.point.kind != multiple || std::abs(event.point.p / left.point.p - 1) > 1e-3) continue;
                ++passed;
                CHECK(event.point.nullity == 2);
                CHECK(event.point.p == Approx(left.point.p).epsilon(1e-6));
            }
        }
    }
    CHECK(passed > 0);
}

TEST_CASE("14: rings under pressure") {
    for (const auto& [load, expected] :
         {std::pair{"hydrostatic", 3.0}, std::pair{"fixed", 4.0}, std::pair{"central", 4.5}}) {
        auto data = with(32, 3);
        data.load = load;
        CAPTURE(load);
        check(trace(support::pressed_ring(data)), {{expected, pitchfork}}, 2e-6);
    }
}

TEST_CASE("15: a twisted rod has two null vectors") {
    auto data = with(16);
    const auto y = trace(support::twisted_rod(data));
    check(y, {{8.986818916, multiple}}, 1e-6);
    // independent of the torsional stiffness
    data.gj = 2.5;
    check(trace(support::twisted_rod(data)), {{8.986818916, multiple}}, 1e-6);
    // tension helps
    data.tension = 10;
    CHECK(trace(support::twisted_rod(data)).values.at(0) > 9.5);
}

TEST_CASE("18: the 45 degree bend") {
    const auto y = trace(support::bend(with(16)));
    CHECK(y.points.empty());
    for (const auto& e : references::bend)
        CHECK((y.named.at("at " + to_text(e[0])).second - Vector3d(e[1], e[2], e[3])).norm() < 1e-6);
}

TEST_CASE("19: chains of rigid links, by the augmented Lagrangian") {
    for (const int links : {1, 2, 3, 8}) {
        CaseData data;
        data.links = links;
        const auto y = trace(support::rigid_link_chain(data));
        CHECK(y.explained);
        REQUIRE(static_cast<int>(y.points.size()) == links);
        for (int k = 0; k < links; ++k) {
            const double expected = 2 * (1 - std::cos((2 * k + 1) * pi / (2 * links + 1)));
            CHECK(y.values[static_cast<std::size_t>(k)] == Approx(expected).epsilon(1e-10));
        }
    }
}

TEST_CASE("20: the shallow arch of two modes, an element of the example's own") {
    const double l = 2.5, f = 2 * std::pow(l * l - 1, 1.5) / (3 * std::sqrt(3.0)), b = 3 * std::sqrt(l * l - 4);
    const auto y = trace(support::shallow_arch({}), true);
    check(y, {{l + b, pitchfork}, {l + f, fold}, {l - f, fold}, {l - b, pitchfork}}, 1e-10);
    for (const auto& side : y.sides)
        for (const auto& at : side.points) CHECK(at.p == Approx(l + 3 * at.q.frames[0].x(0)).epsilon(1e-10));
}

TEST_CASE("Orders of convergence: 2, 4 and 6 with 2, 3 and 4 nodes") {
    const double frame =
        rods::cantilever(rods::right_angle_frame(), Vector3d::UnitX()).first_bifurcation(1.3, 6).at.p();

    const rods::Shooting rods_arch = rods::arch({rods::rigid, rods::rigid, rods::rigid, 1, 1, 1e6}, 100, 215 * pi / 180,
                                                rods::Support::clamped, rods::Support::hinged);
    const auto crossing = rods_arch.crossings(rods_arch.follow(rods_arch.unloaded(), rods::position(1, 0), 14, 30));
    const double arch = rods_arch.fold(crossing.at(0)).at.p();

    for (const int nodes : {2, 3, 4}) {
        CAPTURE(nodes);
        const double order = 2.0 * (nodes - 1);
        const int coarse = nodes == 2 ? 16 : nodes == 3 ? 8 : 4;
        double frame_error[2], arch_error[2];
        for (const int fine : {0, 1}) {
            const auto data = with(coarse << fine, nodes);
            frame_error[fine] = trace(support::right_angle_frame(data)).values.at(0) / frame - 1;
            auto arch_data = with((2 * coarse) << fine, nodes);
            arch_error[fine] = trace(support::deep_arch(arch_data)).values.at(0) / arch - 1;
        }
        CHECK(std::log2(std::abs(frame_error[0] / frame_error[1])) > order - 0.4);
        CHECK(std::log2(std::abs(arch_error[0] / arch_error[1])) > order - 0.4);
    }
}
