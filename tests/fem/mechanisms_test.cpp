// Flexible mechanisms, driven and loaded: folds, bifurcations and kinematic dead points told apart, with rigid bodies
// and joints in the loop.
#include <boost/math/tools/minima.hpp>
#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <numbers>

#include "fem/loaded.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::Vector3d;

namespace {

constexpr double crank = 1, coupler = 2.5;

/// A slider-crank: a rigid crank at the angle `start` from the x axis, a flexible coupler, a slider on the x axis.
struct SliderCrank {
    Model model;
    int pivot, ground, slider;

    SliderCrank(double start, const PlanarSection& section, int elements) {
        const Vector3d pin(crank * std::cos(start), crank * std::sin(start), 0);
        pivot = model.add_node({0, 0, 0});
        ground = model.add_node({0, 0, 0});
        const int joint = model.add_node(pin);
        slider = model.add_node({slider_at(start), 0, 0});
        model.fix(ground, planar);
        model.fix(pivot, {ux, uy});
        model.fix(slider, {uy});
        // the joint's node has the coupler's rotation: a hinge
        model.add(RigidLink<2>{pin}, {pivot, joint});
        add_straight_planar_beam<4>(model, section, joint, slider, elements);
    }
    /// Where the slider is at a crank angle, the coupler straight.
    static double slider_at(double angle) {
        return crank * std::cos(angle) + std::sqrt(coupler * coupler - std::pow(crank * std::sin(angle), 2));
    }
};

/// A four-bar linkage whose ground and coupler have the length 3, crank and rocker 1; the crank is driven from -0.6 on,
/// the rocker has a weak spring. A flexible coupler is a beam.
Structure parallelogram(bool flexible) {
    Model model;
    const double start = -0.6;
    const Vector3d arm(std::cos(start), std::sin(start), 0), across(3, 0, 0);
    const int ground = model.add_node({0, 0, 0}), first = model.add_node({0, 0, 0}), second = model.add_node(across),
              a = model.add_node(arm), b = model.add_node(across + arm);
    model.fix(ground, planar);
    model.fix(first, {ux, uy});
    model.fix(second, {ux, uy});
    model.add(RigidLink<2>{arm}, {first, a});
    model.add(RigidLink<2>{arm}, {second, b});
    if (flexible) {
        add_straight_planar_beam<3>(model, {100, 50, 10}, a, b, 4);
    } else {
        model.share_rotation(b, a);
        model.add(RigidLink<2>{across}, {a, b});
    }
    model.add(PlanarRotationDrive(), {ground, first});
    return Structure(std::move(model));
}

}  // namespace

TEST_CASE("The coupler of a slider-crank buckles: a pitchfork at Euler's load") {
    const double start = 1.1, ei = 0.7;
    SliderCrank mechanism(start, {rigid, rigid, ei}, 16);
    mechanism.model.add(PlanarRotationDrive(0), {mechanism.ground, mechanism.pivot});  // the crank is held
    mechanism.model.load(mechanism.slider, {-1, 0, 0});
    const Structure structure(std::move(mechanism.model));
    const auto branch = states::loaded(structure, -0.1, 2, {.first_step = 0.02, .parameter_weight = 1});
    REQUIRE(branch.events.size() == 1);
    const auto& point = branch.events[0].point;
    CHECK(point.kind == CriticalKind::pitchfork);
    CHECK(point.negative_before == 0);
    CHECK(point.negative_after == 1);
    const double slope = std::asin(crank * std::sin(start) / coupler);
    const double expected = std::pow(std::numbers::pi / coupler, 2) * ei * std::cos(slope);
    CHECK(point.p == Approx(expected).epsilon(1e-8));
}

TEST_CASE("A slider-crank against a spring has a largest moment: a fold, and passes its dead centre without an event") {
    const double start = 0.5, stiffness = 3;
    SliderCrank mechanism(start, {rigid, rigid, 1e3}, 1);
    mechanism.model.add(PointSpring<2>{{stiffness, 0, 0}, {SliderCrank::slider_at(start), 0, 0}}, {mechanism.slider});
    mechanism.model.load(mechanism.pivot, {0, 0, 0}, {0, 0, 1});
    const int pivot = mechanism.pivot;
    const Structure structure(std::move(mechanism.model));
    const auto branch = states::loaded(structure, -3, 10);

    // M = -k (x - x0) dx/dangle with a straight coupler
    const auto moment = [&](double angle) {
        const double s = std::sin(angle), c = std::cos(angle), root = std::sqrt(coupler * coupler - s * s);
        return -stiffness * (SliderCrank::slider_at(angle) - SliderCrank::slider_at(start)) * (-s - s * c / root);
    };
    const auto largest = boost::math::tools::brent_find_minima(moment, start, 3.1, 50);
    REQUIRE(branch.events.size() >= 1);
    const auto& fold = branch.events[0].point;
    CHECK(fold.kind == CriticalKind::fold);
    CHECK(std::abs(fold.p) == Approx(std::abs(largest.second)).epsilon(1e-9));
    bool passed = false;
    for (const auto& at : branch.points) {
        const auto& q = at.q.frames[static_cast<std::size_t>(pivot)].q;
        const double angle = start + 2 * std::atan2(q.z(), q.w());
        CHECK(-at.p == Approx(moment(angle)).margin(1e-8));
        passed = passed || angle > std::numbers::pi;
    }
    CHECK(passed);
}

TEST_CASE("A parallelogram linkage at its dead point: kinematic with a rigid coupler, else a bifurcation") {
    for (const bool flexible : {false, true}) {
        CAPTURE(flexible);
        const auto branch = states::loaded(parallelogram(flexible), -0.1, 1.3);
        REQUIRE(branch.events.size() == 1);
        const auto& point = branch.events[0].point;
        INFO(to_string(point.kind));
        CHECK(is_bifurcation(point.kind));
        CHECK((point.kind == CriticalKind::kinematic) == !flexible);
        CHECK(point.p == Approx(0.6).epsilon(1e-5));
    }
}

TEST_CASE("A drive turns a mechanism through many turns") {
    SliderCrank mechanism(0.5, {100, 50, 10}, 2);
    mechanism.model.add(PlanarRotationDrive(), {mechanism.ground, mechanism.pivot});
    mechanism.model.add(PointSpring<2>{{1, 0, 0}, {2, 0, 0}}, {mechanism.slider});
    const int slider = mechanism.slider;
    const Structure structure(std::move(mechanism.model));
    const BranchOptions options{.first_step = 0.02, .largest_step = 0.5, .parameter_weight = 1};
    const auto branch = states::loaded(structure, -0.1, 8 * std::numbers::pi, options);
    CHECK(branch.events.empty());
    for (const auto& at : branch.points) {
        const double x = at.q.frames[static_cast<std::size_t>(slider)].x(0);
        CHECK(x == Approx(SliderCrank::slider_at(0.5 + at.p)).margin(0.1));  // the spring stretches the coupler
    }
}
