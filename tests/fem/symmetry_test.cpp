// Symmetries of structures: the groups of frames, domes and rods, what breaks them, and branches followed once.
#include <cmath>
#include <numbers>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/fem/symmetry.hpp>

#include "support/buckling_cases.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::Vector3d;

namespace {

/// A portal frame of beams of two nodes in the x-y plane, its feet clamped; which load acts on its corners.
Structure portal(const Vector3d& left, const Vector3d& right, double ei2, bool images = true) {
    Model model;
    const int a = model.add_node({-1, 0, 0}), b = model.add_node({-1, 2, 0}), c = model.add_node({1, 2, 0}),
              d = model.add_node({1, 0, 0});
    const Section section{1000, 400, 400, 3, ei2, 5};
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{d, c}})
        add_straight_beam<2>(model, section, from, to, Vector3d::UnitZ(), 4);
    model.fix(a, spatial);
    model.fix(d, spatial);
    model.load(b, left);
    model.load(c, right);
    return Structure(std::move(model), {.symmetric_images = images});
}

std::size_t proper(const std::vector<Symmetry>& all) {
    std::size_t y = 0;
    for (const Symmetry& s : all) y += s.turn.determinant() > 0;
    return y;
}

}  // namespace

TEST_CASE("Places of a square and of a hexagon have the symmetries of their polygons, in space") {
    for (const int corners : {4, 6}) {
        std::vector<Vector3d> places;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            places.push_back({std::cos(angle), std::sin(angle), 0.3});
        }
        // the dihedral group and its product with the reflection in the plane, but for the identity
        const auto all = symmetries_of(places);
        CHECK(all.size() == static_cast<std::size_t>(4 * corners - 1));
        for (const Symmetry& s : all) {
            CHECK((s.turn * s.turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            for (std::size_t k = 0; k < places.size(); ++k)
                CHECK(
                    (s.center + s.turn * (places[k] - s.center) - places[static_cast<std::size_t>(s.node[k])]).norm() <
                    1e-12);
        }
    }
    CHECK(symmetries_of({{0, 0, 0}, {1, 0.1, 0}, {0.2, 2, 0.3}, {0.7, 0.1, 1}}).empty());
}

TEST_CASE("A portal frame has the symmetries that its loads leave it") {
    const Vector3d down(0, -1, 0), aside(0.2, -1, 0), out(0, -1, 0.1);
    CHECK(portal(down, down, 4).symmetries().size() == 3);    // two planes, and a turn about their axis
    CHECK(portal(aside, aside, 4).symmetries().size() == 1);  // its own plane
    CHECK(portal(out, out, 4).symmetries().size() == 1);      // the plane between its legs
    CHECK(portal(out, -out + 2 * Vector3d(0, -1, 0), 4).symmetries().size() <= 1);
    CHECK(portal(down, aside, 4).symmetries().size() == 1);
    CHECK(portal(down, out, 4).symmetries().empty());
    CHECK(proper(portal(down, down, 4).symmetries()) == 1);
    CHECK(portal(down, down, 4, false).images(portal(down, down, 4).initial()).empty());
}

TEST_CASE("Images of equilibria are equilibria, and the images of what is followed are branches") {
    const Structure frame = portal({0, -1, 0}, {0, -1, 0}, 4);
    ContinuationOptions options{.range = {0, 12}, .most_steps = 200};
    options.branch.first_step = 0.02;
    options.branch.largest_step = 0.1;
    options.branch.parameter_weight = 0.1;
    BranchStepper stepper(frame, options.branch);
    const auto start = stepper.start(frame.initial(), 0.0, 1);
    REQUIRE(start);
    const auto main = follow(stepper, *start, options);
    int left = 0;
    for (const auto& [step, point] : main.events) {
        if (point.kind != CriticalKind::pitchfork) continue;
        const auto starts = switch_branch(stepper, point, main.points[step].tangent, 0.02);
        REQUIRE(starts.size() == 2);
        const auto branch = follow(stepper, starts[0], options);
        const auto image = known_image(stepper, branch, starts[1]);
        REQUIRE(image);
        ++left;
        const auto followed = follow(stepper, starts[1], options);
        CHECK(image->end == branch.end);
        CHECK(image->events.size() == followed.events.size());
        for (std::size_t k = 0; k < image->points.size(); ++k) {
            const auto& at = image->points[k];
            CHECK(frame.residual(at.q, at.p).lpNorm<Eigen::Infinity>() < 1e-7);
            const Eigen::VectorXd rest =
                frame.tangent(at.q, at.p) * at.tangent.q + frame.parameter_derivative(at.q, at.p) * at.tangent.p;
            CHECK(rest.lpNorm<Eigen::Infinity>() < 1e-4);
            if (k > 0) CHECK(lies_on(stepper, followed, at));
        }
        for (std::size_t k = 0; k < std::min(image->events.size(), followed.events.size()); ++k) {
            CHECK(image->events[k].point.p == Approx(followed.events[k].point.p).epsilon(1e-7));
            CHECK(image->events[k].point.kind == followed.events[k].point.kind);
        }
        if (left == 2) break;
    }
    CHECK(left >= 1);
}

TEST_CASE("A rod's closed branch goes back by images: the same points and events as followed whole") {
    support::CaseData data;
    data.elements = 8;
    data.nodes = 4;
    data.ei3 = 1.5;
    data.gj = 1;
    const auto rod = support::twisted_rod(data);
    REQUIRE(rod.structure.symmetries().size() >= 1);
    BranchStepper stepper(rod.structure, rod.options.branch);
    const auto start = stepper.start(rod.structure.initial(), 0.0, 1);
    REQUIRE(start);
    const auto main = follow(stepper, *start, rod.options);
    REQUIRE(!main.events.empty());
    const auto& [step, point] = main.events.front();
    const auto starts = switch_branch(stepper, point, main.points[step].tangent, rod.amplitude);
    REQUIRE(starts.size() == 2);
    const auto branch = follow(stepper, starts[0], rod.options);
    CHECK(branch.end == BranchEnd::closed);
    CHECK(branch.unexplained.empty());
    // the moment changes its sign with the rod's mirror image: events come in pairs
    double sum = 0;
    for (const auto& event : branch.events) sum += rod.value(event.point.q, event.point.p);
    CHECK(std::abs(sum) < 1e-3);
    for (const auto& at : branch.points) CHECK(rod.structure.residual(at.q, at.p).lpNorm<Eigen::Infinity>() < 1e-5);
    CHECK(lies_on(stepper, branch, starts[1]));
}
