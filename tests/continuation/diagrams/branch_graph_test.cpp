#include <equilibria/continuation/curves/imperfection.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

struct MirroredArch : ShallowArch {
    std::vector<VectorXd> images(const VectorXd& a) const { return {VectorXd(Eigen::Vector2d(a(0), -a(1)))}; }
};

DiagramOptions window(double low, double high) {
    DiagramOptions options;
    options.continuation.range.low = low;
    options.continuation.range.high = high;
    return options;
}

/// How often the branches cross p.
template <class P>
int crossings(const BranchGraph<P>& graph, double p) {
    int n = 0;
    for (const auto& edge : graph.branches)
        for (std::size_t k = 0; k + 1 < edge.branch.points.size(); ++k)
            n += (edge.branch.points[k].p - p) * (edge.branch.points[k + 1].p - p) < 0;
    return n;
}

/// The equilibria of a problem in two unknowns at p, from a grid of guesses.
template <class P>
int equilibria_on_grid(const P& problem, double p) {
    BranchStepper<P> stepper(problem, {});
    std::vector<VectorXd> found;
    for (double x = -4; x <= 4; x += 0.25)
        for (double y = -3; y <= 3; y += 0.25) {
            const auto point = stepper.start(Eigen::Vector2d(x, y), p, 1);
            if (point && std::none_of(found.begin(), found.end(),
                                      [&](const VectorXd& q) { return (q - point->q).norm() < 1e-6; }))
                found.push_back(point->q);
        }
    return static_cast<int>(found.size());
}

/// x (p - x^2) = 0, and the same times (x - 3/2)^2 + (p - 3/10)^2 - 1/4, a circle that nothing joins.
struct PitchforkAndCircle {
    using Vector = VectorXd;
    static constexpr bool symmetric = true;
    bool circle;

    double of(double x, double p) const { return circle ? (x - 1.5) * (x - 1.5) + (p - 0.3) * (p - 0.3) - 0.25 : 1; }
    VectorXd residual(const VectorXd& q, double p) const {
        return VectorXd::Constant(1, q(0) * (p - q(0) * q(0)) * of(q(0), p));
    }
    Eigen::MatrixXd tangent(const VectorXd& q, double p) const {
        const double x = q(0), along = circle ? 2 * (x - 1.5) : 0;
        return Eigen::MatrixXd::Constant(1, 1, (p - 3 * x * x) * of(x, p) + x * (p - x * x) * along);
    }
    VectorXd parameter_derivative(const VectorXd& q, double p) const {
        const double x = q(0), along = circle ? 2 * (p - 0.3) : 0;
        return VectorXd::Constant(1, x * of(x, p) + x * (p - x * x) * along);
    }
};

}  // namespace

TEST_CASE("the diagram of the shallow arch has every equilibrium on its branches") {
    const ShallowArch arch{2.5};
    const VectorXd start = Eigen::Vector2d(2.5, 0);
    const auto graph = bifurcation_diagram(arch, start, 0.0, window(-10, 10));
    CHECK(graph.complete());
    // both ways from the start, and the circle, which one half branch goes all around
    CHECK(graph.branches.size() == 3);
    CHECK(graph.branches[2].branch.end == BranchEnd::closed);
    REQUIRE(graph.nodes.size() == 4);
    int pitchforks = 0;
    for (const auto& node : graph.nodes) {
        pitchforks += node.point.kind == CriticalKind::pitchfork;
        if (node.point.kind == CriticalKind::pitchfork) CHECK(node.branches.size() == 2);
    }
    CHECK(pitchforks == 2);
    for (const double p : {-5.0, -1.9, 0.3, 2.6, 6.9, 7.05, 9.0}) {
        CAPTURE(p);
        CHECK(crossings(graph, p) == equilibria_on_grid(arch, p));
    }
}

TEST_CASE("branches that are images of each other are followed once") {
    // a narrow window cuts the circle in two arcs at each end
    const VectorXd start = Eigen::Vector2d(2.5, 0);
    auto options = window(4, 8);
    const auto plain = bifurcation_diagram(ShallowArch{2.5}, start, 5.0, options);
    const auto mirrored = bifurcation_diagram(MirroredArch{{2.5}}, start, 5.0, options);
    CHECK(plain.complete());
    CHECK(mirrored.complete());
    CHECK(plain.branches.size() == mirrored.branches.size() + 1);
    CHECK(mirrored.images == 1);
}

TEST_CASE("deflation finds the branch that an imperfection cut off") {
    const ImperfectProblem<ShallowArch> arch({2.5}, Eigen::Vector2d(0, 1), 0.3);
    const VectorXd start = Eigen::Vector2d(2.5, 0);
    auto options = window(-10, 10);
    const auto joined = bifurcation_diagram(arch, start, 0.0, options);
    options.slices = 5;
    const auto all = bifurcation_diagram(arch, start, 0.0, options);
    CHECK(all.complete());
    CHECK(all.branches.size() > joined.branches.size());
    CHECK(all.branches.back().deflated);
    CHECK(crossings(joined, 5.0) < equilibria_on_grid(arch, 5.0));
    for (const double p : {-5.0, -1.5, 0.3, 2.6, 5.0, 6.5, 9.0}) {
        CAPTURE(p);
        CHECK(crossings(all, p) == equilibria_on_grid(arch, p));
    }
}

TEST_CASE("deflated Newton finds the other equilibria from two guesses, and none twice") {
    const ShallowArch arch{2.5};
    BranchStepper<ShallowArch> stepper(arch, {});
    const auto first = stepper.start(Eigen::Vector2d(2.5, 0), 3.0, 1);
    REQUIRE(first);
    const auto found = deflated_search(
        arch, 3.0, {VectorXd(Eigen::Vector2d(0.5, 0.1)), VectorXd(Eigen::Vector2d(-1, -0.5))}, {first->q});
    CHECK(static_cast<int>(found.size()) + 1 == equilibria_on_grid(arch, 3.0));
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(arch.residual(found[i], 3.0).norm() < 1e-9);
        CHECK((found[i] - first->q).norm() > 1e-3);
        for (std::size_t j = 0; j < i; ++j) CHECK((found[i] - found[j]).norm() > 1e-3);
    }
    CHECK_THROWS_AS(deflated_search(arch, 3.0, {first->q}, {}, {.power = 0.5}), InvalidArgument);
}

TEST_CASE("options of a diagram are checked by name") {
    DiagramOptions options;
    options.slices = 3;
    CHECK_THROWS_WITH(options.validate(), Catch::Contains("low"));
    options = {};
    options.most_branches = 0;
    CHECK_THROWS_WITH(options.validate(), Catch::Contains("most_branches"));
}

TEST_CASE("a diagram is verified by eigenvalues and deflation, and doubts are said") {
    DiagramOptions options;
    options.continuation.range = {-1, 1};
    options.continuation.branch.first_step = options.continuation.branch.largest_step = 0.05;
    const auto none =
        bifurcation_diagram(PitchforkAndCircle{false}, Eigen::VectorXd(Eigen::VectorXd::Zero(1)), -0.5, options);
    CHECK_FALSE(none.verification.verified());
    CHECK(none.verification.summary() == "not verified: no eigenvalues were counted, and no slices searched");

    options.slices = 4;
    options.checks = 6;
    const auto alone =
        bifurcation_diagram(PitchforkAndCircle{false}, Eigen::VectorXd(Eigen::VectorXd::Zero(1)), -0.5, options);
    CHECK(alone.verification.verified());
    CHECK(alone.verification.points + alone.verification.not_checked == 6 * static_cast<int>(alone.branches.size()));
    CHECK(alone.verification.slices == 4);
    CHECK(alone.verification.equilibria == 8);
    CHECK(alone.verification.summary().find("verified: eigenvalues at ") == 0);

    const auto beside =
        bifurcation_diagram(PitchforkAndCircle{true}, Eigen::VectorXd(Eigen::VectorXd::Zero(1)), -0.5, options);
    CHECK(beside.verification.mismatches.empty());
    CHECK(beside.verification.deflated > 0);
    CHECK_FALSE(beside.verification.verified());
    CHECK(beside.verification.summary().find("NOT VERIFIED") == 0);
}
