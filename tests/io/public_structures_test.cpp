// Structures from public reports, with critical loads of independent codes: nothing missed within the window, nothing
// listed outside it.
#if __has_include(<nlohmann/json.hpp>)

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/io/structure/structure_json.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;

namespace {

struct Found {
    CriticalKind kind;
    double p;
    int nullity;
};
struct Followed {
    std::vector<Found> points;          // on all branches, in their order
    std::vector<std::size_t> branches;  // of how many points each
    std::size_t not_left = 0, unexplained = 0;
    int on_first = 0;  // critical points on the branch of the unloaded state
    double largest_residual = 0, low = 0, high = 0;

    const Found* near(double p, double relative) const {
        for (const auto& point : points)
            if (std::abs(point.p - p) <= relative * std::abs(p)) return &point;
        return nullptr;
    }
};

/// The branch through the unloaded state, and those that leave it.
template <class S>
Followed followed(const S& structure, const StructureInput& input, bool sides = true) {
    Followed y;
    const ContinuationOptions options = continuation_options(input);
    BranchStepper<S> stepper(structure, options.stepping());
    std::vector<Branch<S>> known;
    const auto add = [&](const BranchPoint<S>& from) {
        known.push_back(follow(stepper, from, options));
        const auto& branch = known.back();
        y.branches.push_back(branch.points.size());
        y.unexplained += branch.unexplained.size();
        for (const auto& point : branch.points) {
            y.low = std::min(y.low, point.p);
            y.high = std::max(y.high, point.p);
        }
        for (const auto& event : branch.events) {
            y.points.push_back({event.point.kind, event.point.p, event.point.nullity});
            y.largest_residual = std::max(y.largest_residual, event.point.residual);
        }
    };
    for (const int direction : {1, -1}) {
        if (!(direction > 0 ? input.up : input.down)) continue;
        const auto start = stepper.start(structure.initial(), 0, direction);
        REQUIRE(start);
        add(*start);
        const Branch<S> first = known.back();
        y.on_first += static_cast<int>(first.events.size());
        if (!sides) continue;
        for (const auto& event : first.events) {
            if (!is_bifurcation(event.point.kind)) continue;
            const auto starts = switch_branch(stepper, event.point, first.points[event.step].tangent, 0.02);
            y.not_left += starts.empty();
            for (const auto& from : starts)
                if (std::none_of(known.begin(), known.end(),
                                 [&](const auto& branch) { return lies_on(stepper, branch, from); }))
                    add(from);
        }
    }
    return y;
}
Followed followed(const std::string& text, bool sides = true) {
    const auto input = parse_structure(text);
    const auto y = input.conservative ? followed(Structure(input.model), input, sides)
                                      : followed(NonconservativeStructure(input.model), input, sides);
    CHECK(y.unexplained == 0);
    const double slack = 1e-9 * (input.high - input.low);
    CHECK(y.low >= input.low - slack);
    CHECK(y.high <= input.high + slack);
    for (const auto& point : y.points) CHECK((point.p >= input.low - slack && point.p <= input.high + slack));
    return y;
}

std::string roorda(double stiffness, int elements) {
    return R"({"nodes": {"foot": [0, -1, 0], "corner": [0, 0, 0], "end": [1, 0, 0]},
        "sections": {"s": {"ea": )" +
           std::to_string(stiffness) + R"(, "ga": )" + std::to_string(stiffness) + R"(, "ei": 1}},
        "elements": [
            {"type": "beam", "nodes": ["foot", "corner"], "section": "s", "elements": )" +
           std::to_string(elements) + R"(, "order": "cubic"},
            {"type": "beam", "nodes": ["corner", "end"], "section": "s", "elements": )" +
           std::to_string(elements) + R"(, "order": "cubic"}],
        "supports": [{"node": "foot", "fix": ["ux", "uy"]}, {"node": "end", "fix": ["uy", "ux"]}],
        "loads": [{"node": "corner", "force": [0, -1, 0]}],
        "parameter": {"name": "P", "low": 0, "high": 30}, "measure": "corner"})";
}

/// The rings of the double-layer dome of the documentation of OpenSees from number `first` on, so many nodes a ring.
std::string double_layer_dome(int around, int first) {
    const double heights[] = {0, -0.51, 1, 0.37, 1.75, 1.12, 2.5, 1.74, 3, 2.42, 3.5, 2.62, 3.75};
    const auto name = [](int ring, int k) { return "\"r" + std::to_string(ring) + "_" + std::to_string(k) + "\""; };
    std::string nodes, bars, supports;
    const auto bar = [&](const std::string& a, const std::string& b) {
        bars += std::string(bars.empty() ? "" : ",") + R"({"type": "truss", "nodes": [)" + a + "," + b +
                R"(], "ea": 94500000.0, "strain": "engineering"})";
    };
    for (int ring = first; ring < 13; ++ring)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * (k + (ring % 2) / 2.0) / around, radius = 13 - ring;
            char place[120];
            std::snprintf(place, sizeof place, ": [%.17g, %.17g, %.17g],", radius * std::cos(angle),
                          radius * std::sin(angle), heights[ring]);
            nodes += name(ring, k) + place;
            if (ring == first)
                supports += std::string(supports.empty() ? "" : ",") + R"({"node": )" + name(ring, k) +
                            R"(, "fix": ["position"]})";
            else
                bar(name(ring, k), name(ring, (k + 1) % around));
            if (ring + 1 < 13) {
                // to the two nodes of the next ring beside it
                const int other = ring % 2 == 0 ? (k + around - 1) % around : (k + 1) % around;
                bar(name(ring, k), name(ring + 1, k));
                bar(name(ring, k), name(ring + 1, other));
            }
            bar(name(ring, k), ring + 2 < 13 ? name(ring + 2, k) : "\"apex\"");
        }
    return "{\"nodes\": {" + nodes + R"("apex": [0, 0, 3.88]}, "elements": [)" + bars + R"(], "supports": [)" +
           supports + R"(], "loads": [{"node": "apex", "force": [0, 0, -1000000.0]}],
           "parameter": {"name": "p", "low": 0, "high": 30}, "measure": "apex"})";
}

}  // namespace

TEST_CASE("a column whose straight state does not move has one critical load in its window") {
    const auto y = followed(R"({"nodes": {"a": [0, 0, 0], "b": [1, 0, 0]},
        "sections": {"s": {"ea": "rigid", "ga": "rigid", "ei": 1}},
        "elements": [{"type": "beam", "nodes": ["a", "b"], "section": "s", "elements": 8}],
        "supports": [{"node": "a", "fix": ["ux", "uy", "rz"]}], "loads": [{"node": "b", "force": [-1, 0, 0]}],
        "parameter": {"name": "P", "low": 0, "high": 5}})");
    REQUIRE(y.points.size() == 1);
    CHECK(y.points[0].kind == CriticalKind::pitchfork);
    CHECK(y.points[0].p == Approx(std::numbers::pi * std::numbers::pi / 4).epsilon(1e-5));
    CHECK(y.branches.size() == 3);
    CHECK(y.not_left == 0);
}

TEST_CASE("a column under a load that follows it by three tenths loses no critical load") {
    const auto y = followed(R"({"nodes": {"foot": [0, 0, 0], "top": [1, 0, 0]},
        "sections": {"s": {"ea": "rigid", "ga": "rigid", "ei": 1}},
        "elements": [{"type": "beam", "nodes": ["foot", "top"], "section": "s", "elements": 3, "order": "linear"}],
        "supports": [{"node": "foot", "fix": ["ux", "uy", "rz"]}, {"node": "top", "fix": ["uz", "rx", "ry"]}],
        "loads": [{"node": "top", "type": "follower", "force": [-0.3, 0, 0]}, {"node": "top", "force": [-0.7, 0, 0]}],
        "parameter": {"name": "P", "low": 0, "high": 60}, "measure": "top"})");
    CHECK(y.on_first == 2);
    CHECK(y.near(4.3802, 1e-5));
    CHECK(y.near(26.7669, 1e-5));
    CHECK(y.not_left == 0);
}

TEST_CASE("the limit load of Roorda's frame by shooting, for stiffnesses from 1e4 to 1e8 of the bending's") {
    // without shortening it is a bifurcation load k^2, tan k = k / (1 + k^2 / 3); an imperfection that shortening
    // makes, as 1 / stiffness, lowers it as its root
    double k = 3.7;
    for (int step = 0; step < 100; ++step) k = std::numbers::pi + std::atan(k / (1 + k * k / 3));
    for (const double stiffness : {1e4, 1e5, 1e6, 1e7, 1e8}) {
        CAPTURE(stiffness);
        const auto y = followed(roorda(stiffness, 16));
        REQUIRE(y.points.size() == 1);
        CHECK(y.points[0].kind == CriticalKind::fold);
        const double p = y.points[0].p;
        if (stiffness == 1e5) CHECK(p == Approx(13.79908554).epsilon(1e-8));
        if (stiffness == 1e6) CHECK(p == Approx(13.85832273).epsilon(2e-9));
        CHECK((k * k - p) * std::sqrt(stiffness) == Approx(27.7).epsilon(stiffness < 1e5 ? 0.05 : 0.01));
    }
}

TEST_CASE("two equal cells: the branch on which one snaps while the other unloads leaves both hilltops") {
    const auto y = followed(R"({"nodes": {"a": [-1, 0, 0], "b": [0, 0.3, 0], "c": [1, 0, 0], "d": [2, 0, 0],
                                          "e": [3, 0.3, 0], "f": [4, 0, 0]},
        "elements": [{"type": "truss", "nodes": ["a", "b"], "ea": 1, "strain": "green", "planar": true},
                     {"type": "truss", "nodes": ["b", "c"], "ea": 1, "strain": "green", "planar": true},
                     {"type": "truss", "nodes": ["d", "e"], "ea": 1, "strain": "green", "planar": true},
                     {"type": "truss", "nodes": ["e", "f"], "ea": 1, "strain": "green", "planar": true}],
        "supports": [{"node": "a", "fix": ["ux", "uy"]}, {"node": "c", "fix": ["ux", "uy"]},
                     {"node": "d", "fix": ["ux", "uy"]}, {"node": "f", "fix": ["ux", "uy"]},
                     {"node": "b", "fix": ["ux"]}, {"node": "e", "fix": ["ux"]}],
        "loads": [{"node": "b", "force": [0, -1, 0]}, {"node": "e", "force": [0, -1, 0]}],
        "parameter": {"name": "p", "low": -0.02, "high": 0.02}, "measure": "b"})");
    // 2 EA y (h^2 - y^2) / L^3 with its largest value at y = h / sqrt(3), L^2 = 1 + h^2
    const double h = 0.3, hilltop = 2 * std::pow(h, 3) / (3 * std::sqrt(3.0)) / std::pow(1 + h * h, 1.5);
    for (const double p : {hilltop, -hilltop}) {
        const Found* at = y.near(p, 1e-10);
        REQUIRE(at);
        CHECK(at->kind == CriticalKind::hilltop);
        CHECK(at->nullity == 2);
    }
    CHECK(y.not_left == 0);
    CHECK(y.branches.size() >= 3);
}

TEST_CASE("the fold beside a transcritical point of a frame with two bays and a hinge") {
    const auto y = followed(R"({"nodes": {"A0": [0, 0, 0], "A1": [0, 4, 0], "B0": [6, 0, 0], "B1": [6, 4, 0],
                                          "B2": [6, 4, 0], "C0": [12, 0, 0], "C1": [12, 4, 0]},
        "sections": {"ipe": {"ea": 5.6e5, "ga": 1.0e5, "ei": 4000}},
        "elements": [{"type": "beam", "nodes": ["A0", "A1"], "section": "ipe"},
                     {"type": "beam", "nodes": ["B0", "B1"], "section": "ipe"},
                     {"type": "beam", "nodes": ["C0", "C1"], "section": "ipe"},
                     {"type": "beam", "nodes": ["A1", "B1"], "section": "ipe"},
                     {"type": "beam", "nodes": ["B2", "C1"], "section": "ipe"}],
        "joints": [{"type": "hinge", "nodes": ["B1", "B2"]}],
        "supports": [{"node": "A0", "fix": ["all"]}, {"node": "B0", "fix": ["all"]},
                     {"node": "C0", "fix": ["ux", "uy"]}],
        "loads": [{"node": "A1", "force": [0, -1, 0]}, {"node": "B1", "force": [0, -1, 0]},
                  {"node": "C1", "force": [0, -1, 0]}],
        "parameter": {"name": "P", "low": 0, "high": 2000}})");
    const Found *crossing = y.near(1199.8, 1e-4), *fold = y.near(1196.70776624, 1e-11);
    REQUIRE(crossing);
    CHECK(crossing->kind == CriticalKind::transcritical);
    REQUIRE(fold);
    CHECK(fold->kind == CriticalKind::fold);
    CHECK(y.not_left == 0);
}

TEST_CASE("a stable branch leaves a small double-layer dome at its pitchfork") {
    const auto y = followed(double_layer_dome(6, 8));
    const Found* pitchfork = y.near(19.96025737, 1e-9);
    REQUIRE(pitchfork);
    CHECK(pitchfork->kind == CriticalKind::pitchfork);
    CHECK(y.branches.size() >= 3);
    CHECK(y.not_left == 0);
}

TEST_CASE("no critical point of a double-layer dome is listed where there is none") {
    const auto y = followed(double_layer_dome(5, 4), false);
    CHECK(y.points.size() > 4);
    // the loads are about 1e7
    CHECK(y.largest_residual < 1e-9 * 1e7);
}

TEST_CASE("a start that Newton's method leads to a symmetric state within rounding is followed") {
    // x (p - 1) - x^2 from x = 0.001, p = 0: the state 0 loses its stability at 1
    struct Crossing {
        using Configuration = Eigen::VectorXd;
        Eigen::VectorXd residual(const Eigen::VectorXd& x, double p) const {
            return Eigen::VectorXd::Constant(1, x(0) * (p - 1) - x(0) * x(0));
        }
        Eigen::MatrixXd tangent(const Eigen::VectorXd& x, double p) const {
            return Eigen::MatrixXd::Constant(1, 1, p - 1 - 2 * x(0));
        }
        Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& x, double) const {
            return Eigen::VectorXd::Constant(1, x(0));
        }
    };
    for (const double start : {0.001, 0.0}) {
        const auto branch = continue_branch(Crossing{}, Eigen::VectorXd(Eigen::VectorXd::Constant(1, start)), 0.0, 1,
                                            {.range = {0, 2}});
        CHECK(branch.end == BranchEnd::window);
        REQUIRE(branch.events.size() == 1);
        CHECK(branch.events[0].point.kind == CriticalKind::transcritical);
        CHECK(branch.events[0].point.p == Approx(1).epsilon(1e-12));
        CHECK(branch.points.back().p == Approx(2).epsilon(1e-12));
        CHECK(branch.unexplained.empty());
    }
}

#endif
