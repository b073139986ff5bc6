// Structures as continuation problems: derivatives, rigid turns, charts, multipliers, threads, and what is refused.
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/loose_motion.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/fem/truss.hpp>

#include "../programs/support/buckling_cases.hpp"
#include "fem/charted_structure.hpp"
#include "fem/loaded.hpp"
#include "fem/random_states.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Roorda's frame in space, turned by `turn`: two inextensible bars at a right angle, hinged at their ends, which move
/// in the frame's plane alone; load on the corner, along the column. Its bifurcation is transcritical.
Structure roorda(const Eigen::Quaterniond& turn) {
    Model model;
    const int foot = model.add_node({0, 0, 0}), corner = model.add_node(turn * Vector3d(0, 1, 0)),
              end = model.add_node(turn * Vector3d(1, 1, 0)), ground_foot = model.add_node(model.at(foot)),
              ground_end = model.add_node(model.at(end));
    const Section section{rigid, rigid, rigid, 4, 3, 1};
    add_straight_beam<3>(model, section, foot, corner, turn * Vector3d::UnitX(), 4);
    add_straight_beam<3>(model, section, corner, end, turn * Vector3d::UnitY(), 4);
    // hinges about the normal of the plane
    for (const int ground : {ground_foot, ground_end}) model.fix(ground, spatial);
    model.add(RevoluteJoint(turn * Vector3d::UnitZ()), {ground_foot, foot});
    model.add(RevoluteJoint(turn * Vector3d::UnitZ()), {ground_end, end});
    model.load(corner, turn * Vector3d(0, -1, 0));
    return Structure(std::move(model));
}

/// Increments of the given size at the unloaded state, of multipliers too.
StructureState random_state(const Structure& structure, std::mt19937& draw, double size) {
    return structure.retract(structure.initial(), states::random_vector(draw, structure.size(), size));
}

}  // namespace

TEST_CASE("K of whole structures is dR/dq and symmetric in random states") {
    std::mt19937 draw(37);
    support::CaseData data;
    data.elements = 4;
    data.nodes = 3;
    for (const auto& entry : support::buckling_cases()) {
        CAPTURE(entry.name);
        const auto c = entry.make(data);
        const VectorXd v = equilibria::detail::generic_vector(c.structure.size());
        for (int k = 0; k < 3; ++k) {
            const auto q = random_state(c.structure, draw, 0.2);
            const auto errors = states::derivative_errors(c.structure, q, 0.7, v, 1e-4);
            CHECK(errors.tangent < 1e-9);
            CHECK(errors.symmetry < 1e-14);
        }
    }
}

TEST_CASE("The whole problem turned by a rotation has the same critical loads to 10 digits") {
    std::mt19937 draw(41);
    const Structure plain = roorda(Eigen::Quaterniond::Identity());
    const auto branch = states::loaded(plain, -1, 20);
    REQUIRE(branch.events.size() >= 1);
    CHECK(branch.events[0].point.kind == CriticalKind::transcritical);
    // sqrt(P / EI) = 3.7279...: tan k = 3 k / (3 + k^2)
    const double k = std::sqrt(branch.events[0].point.p);
    CHECK(std::tan(k) == Approx(3 * k / (3 + k * k)).epsilon(1e-2));
    for (int n = 0; n < 3; ++n) {
        const Structure turned = roorda(quaternion<double>(states::random_rotation(draw)));
        const auto other = states::loaded(turned, -1, 20);
        REQUIRE(other.events.size() == branch.events.size());
        for (std::size_t e = 0; e < branch.events.size(); ++e) {
            CHECK(other.events[e].point.p == Approx(branch.events[e].point.p).epsilon(1e-10));
            CHECK(other.events[e].point.kind == branch.events[e].point.kind);
        }
    }
}

TEST_CASE("a, b and c do not depend on the chart, null vectors are transported by T") {
    std::mt19937 draw(43);
    const Structure structure = roorda(quaternion<double>(Vector3d(0.3, -0.7, 0.4)));
    const auto branch = states::loaded(structure, -1, 20);
    REQUIRE(branch.events.size() >= 1);
    const auto& point = branch.events[0].point;
    REQUIRE(point.kind == CriticalKind::transcritical);

    const auto charts = [&] {
        std::vector<std::vector<Eigen::Quaterniond>> y(4);
        for (const auto& frame : point.q.frames) {
            y[0].push_back(frame.q);                         // the present configuration
            y[1].push_back(Eigen::Quaterniond::Identity());  // the unloaded one: total rotations
            y[2].push_back(frame.q * quaternion<double>(Vector3d(0.5, 0, 0.2)));
            y[3].push_back(frame.q * quaternion<double>(states::random_rotation(draw, 0.8)));
        }
        return y;
    }();
    for (const auto& reference : charts) {
        const states::ChartedStructure<Structure> charted(structure, reference);
        const VectorXd q = charted.coordinates(point.q);
        CHECK(check_derivatives(charted, q, point.p, 1e-7).symmetry < 1e-12);
        CriticalPointSolver<states::ChartedStructure<Structure>> solver(charted);
        const auto there = solver.solve(q, point.p * 1.001);
        REQUIRE(there);
        CHECK(there->p == Approx(point.p).epsilon(1e-12));
        // in spins, both null vectors are the same line
        VectorXd phi = charted.spin(q, there->null_vector), w = charted.spin(q, there->slope);
        const double scale = phi.dot(point.null_vector) / point.null_vector.squaredNorm();
        CHECK((phi - scale * point.null_vector).norm() < 1e-8 * phi.norm());
        // w is determined up to phi: w' = w + r phi, b' = b + r a, c' = c + 2 r b + r^2 a
        const VectorXd off = w - point.slope;
        const double r = off.dot(phi) / phi.squaredNorm();
        CHECK((off - r * phi).norm() < 1e-7 * (1 + w.norm()));
        const double a = there->a / (scale * scale * scale), b = (there->b - r * there->a) / (scale * scale),
                     c = (there->c - 2 * r * there->b + r * r * there->a) / scale;
        const double size = std::max({std::abs(point.a), std::abs(point.b), std::abs(point.c)});
        CHECK(a == Approx(point.a).epsilon(1e-8).margin(1e-8 * size));
        CHECK(b == Approx(point.b).epsilon(1e-8).margin(1e-8 * size));
        CHECK(c == Approx(point.c).epsilon(1e-8).margin(1e-8 * size));
    }
}

TEST_CASE("Transport moves tangent vectors along with their frames") {
    std::mt19937 draw(47);
    support::CaseData data;
    data.elements = 2;
    const auto c = support::right_angle_frame(data);
    const Structure& s = c.structure;
    const auto q = random_state(s, draw, 0.3);
    const VectorXd step = states::random_vector(draw, s.size(), 0.5), v = states::random_vector(draw, s.size(), 1);
    const auto there = s.retract(q, step);
    CHECK((s.difference(q, there) - step).norm() < 1e-12);
    const double h = 1e-6;
    const auto off = [&](double by) { return s.difference(there, s.retract(q, step + by * v)); };
    const VectorXd moved = (off(h) - off(-h)) / (2 * h);
    CHECK((s.transport(q, step, v) - moved).norm() < 1e-8 * v.norm());
}

TEST_CASE("Assembly gives the same bits with any number of threads") {
    std::mt19937 draw(53);
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    add_straight_beam<2>(model, {100, 50, 50, 1, 1, 2}, a, b, Vector3d::UnitY(), 2000);
    model.fix(a, spatial);
    model.load(b, {0, -1, 0});
    const Structure one(model), two(model, {.executor = threads(2)});
    const auto q = random_state(one, draw, 1e-5);
    CHECK((one.residual(q, 0.3) - two.residual(q, 0.3)).norm() == 0);
    CHECK((one.tangent(q, 0.3) - two.tangent(q, 0.3)).norm() == 0);
}

TEST_CASE("A model given to a structure may be changed without changing it") {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    model.add(Truss<3>(1, 1), {a, b});
    model.fix(a, positions);
    const Structure structure(model), copy = structure;
    model.add(Truss<3>(5, 1), {a, b});
    CHECK(structure.tangent(structure.initial(), 0).coeff(0, 0) == Approx(1));
    CHECK(copy.tangent(copy.initial(), 0).coeff(0, 0) == Approx(1));
    CHECK(Structure(model).tangent(structure.initial(), 0).coeff(0, 0) == Approx(6));
}

TEST_CASE("Nodes of one body share its rotation") {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0}), c = model.add_node({0, 2, 0}),
              ground = model.add_node({0, 0, 0});
    add_rigid_body(model, {a, b, c});
    model.fix(ground, spatial);
    model.add(SphericalJoint{}, {ground, a});
    model.add(RotationSpring{2}, {ground, a});
    model.load(b, {0, 0, 1});
    const Structure structure(std::move(model));
    CHECK(structure.unknown(b, rx) == structure.unknown(a, rx));
    CHECK_NOTHROW(check_derivatives(structure, structure.initial(), 0.0));
    BranchStepper<Structure> stepper(structure, {});
    const auto at = stepper.start(structure.initial(), 1.5, 1);
    REQUIRE(at);
    CHECK(at->stable() == true);
    // spring 2 |Psi| = p cos |Psi|
    const Vector3d psi = shortest_rotation_vector(at->q.frames[0].q);
    CHECK(2 * psi.norm() == Approx(1.5 * std::cos(psi.norm())).epsilon(1e-12));
    for (const int node : {b, c}) {
        const auto& frame = at->q.frames[static_cast<std::size_t>(node)];
        CHECK((frame.x - at->q.frames[0].q * structure.model().at(node)).norm() < 1e-13);
        CHECK(frame.q.angularDistance(at->q.frames[0].q) < 1e-15);
    }
}

TEST_CASE("Dead moments, and loads that follow, on nodes that turn freely") {
    // a cantilever in space rolled up by a moment that follows, and by a dead one about a fixed axis: the same
    for (const bool follower : {true, false}) {
        double before = 0;
        for (const int elements : {8, 16}) {
            Model model;
            const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
            add_straight_beam<3>(model, {rigid, rigid, rigid, 1, 1, 1}, a, b, Vector3d::UnitY(), elements);
            model.fix(a, spatial);
            const Vector3d moment(0, 0, 2 * std::numbers::pi);
            if (follower)
                model.add(FollowerLoad{{0, 0, 0}, moment}, {b});
            else
                model.load(b, {0, 0, 0}, moment);
            CHECK_THROWS_WITH(Structure(model), Catch::Contains("NonconservativeStructure"));
            const NonconservativeStructure structure(model);
            const auto branch = states::loaded(structure, -0.1, 0.8, {.first_step = 0.02, .parameter_weight = 0.1});
            // an arc of radius 1 / (2 pi p)
            const auto& last = branch.points.back();
            const double angle = 2 * std::numbers::pi * last.p;
            const Vector3d tip = last.q.frames[static_cast<std::size_t>(b)].x;
            const double error = (tip - Vector3d(std::sin(angle), 1 - std::cos(angle), 0) / angle).norm();
            CHECK(error < 2e-4);
            if (before > 0) CHECK(before / error > 10);  // fourth order, at loads that differ a little
            before = error;
        }
    }
}

TEST_CASE("A node that moves without a force is named") {
    // a cantilever; its foot free along x; free to turn
    for (const auto& [held, loose] :
         {std::pair{std::vector{ux, uy, rz}, false}, std::pair{std::vector{uy, rz}, true},
          std::pair{std::vector{ux, uy}, true}, std::pair{std::vector<Component>{}, true}}) {
        Model model;
        const int foot = model.add_node({0, 0, 0}), head = model.add_node({0, 2, 0});
        add_straight_planar_beam<3>(model, {rigid, rigid, 4}, foot, head, 50);
        model.fix(foot, held);
        model.load(head, {0, -1, 0});
        const Structure column(std::move(model));
        const auto found = loose_motion(column, column.initial(), 0);
        REQUIRE(found.has_value() == loose);
        if (held.size() == 2 && held[0] == uy) CHECK(found->component == ux);
    }
    // nor does what only the load holds
    Model model;
    const int pivot = model.add_node({0, 0, 0}), weight = model.add_node({0, -1, 0});
    model.add(Truss<2>(100, model.at(pivot), model.at(weight)), {pivot, weight});
    model.fix(pivot, planar_positions);
    model.load(weight, {0, -1, 0});
    const Structure pendulum(std::move(model));
    const auto found = loose_motion(pendulum, pendulum.initial(), 0);
    REQUIRE(found);
    CHECK(found->node == weight);
    CHECK(found->component == ux);
    auto hanging = pendulum.initial();
    hanging.frames[1].x(1) = -1.01;
    CHECK_FALSE(loose_motion(pendulum, hanging, 1));
}

TEST_CASE("Nodes that share a rotation with several others are one body") {
    Model model;
    for (int k = 0; k < 4; ++k) model.add_node({1.0 * k, 0, 0});
    model.share_rotation(1, 0);
    model.share_rotation(3, 2);
    model.share_rotation(1, 3);
    for (int k = 0; k < 4; ++k) CHECK(model.rotates_with(k) == 2);
    model.share_rotation(0, 3);
    for (int k = 0; k < 4; ++k) CHECK(model.rotates_with(k) == 2);
}

TEST_CASE("What a structure refuses, it names") {
    Model model;
    CHECK_THROWS_WITH(model.add_node({0, std::nan(""), 0}), Catch::Contains("x of node 0"));
    CHECK_THROWS_WITH(model.fix(0, {ux}), Catch::Contains("no nodes yet"));
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    CHECK_THROWS_WITH(model.add(Truss<3>(1, 1), {a, 2}), Catch::Contains("nodes[1] = 2"));
    CHECK_THROWS_WITH(model.add(Truss<3>(1, 1), {a, a}), Catch::Contains("nodes[1] = 0"));
    CHECK_THROWS_WITH(Structure(model), Catch::Contains("can move"));
    model.add(Truss<3>(1, 1), {a, b});
    CHECK_THROWS_WITH(model.load(b, {0, HUGE_VAL, 0}), Catch::Contains("force"));
    model.load(b, {0, 0, 0}, {0, 0, 1});
    CHECK_THROWS_WITH(Structure(model), Catch::Contains("load on node 1") && Catch::Contains("rotations"));
    model.share_rotation(b, a);
    CHECK_THROWS_WITH(model.share_rotation(a, b), Catch::Contains("with"));

    // held about one axis of three: increments without it are no constraint on the rotation
    Model half;
    const int f = half.add_node({0, 0, 0}), g = half.add_node({1, 0, 0});
    add_straight_beam<2>(half, {10, 10, 10, 1, 1, 1}, f, g, Vector3d::UnitY(), 2);
    half.fix(f, spatial);
    half.fix(g, {rx});
    CHECK_THROWS_WITH(Structure(half), Catch::Contains("rotation of node 1") && Catch::Contains("two axes"));

    // the same joint twice
    Model twice;
    const int c = twice.add_node({0, 0, 0}), d = twice.add_node({1, 0, 0}), e = twice.add_node({1, 0, 0});
    add_straight_beam<2>(twice, {10, 10, 10, 1, 1, 1}, c, d, Vector3d::UnitY(), 2);
    twice.fix(c, spatial);
    twice.add(PointSpring<3>{{1, 1, 1}, {1, 0, 0}}, {e});
    twice.add(RotationSpring{1}, {c, e});
    twice.add(SphericalJoint{}, {d, e});
    CHECK_NOTHROW([&] {
        Structure s(twice);
        check_derivatives(s, s.initial(), 0.0);
    }());
    twice.add(SphericalJoint{}, {d, e});
    const Structure redundant(twice);
    CHECK_THROWS_WITH(check_derivatives(redundant, redundant.initial(), 0.0), Catch::Contains("independent"));
}
