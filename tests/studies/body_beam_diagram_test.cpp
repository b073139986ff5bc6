// The branches of relative equilibria over the momentum, their critical points, and curves of these over the ratio of
// the stiffnesses: nothing that an enumeration elsewhere finds is missing.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_diagram.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::mechanisms;

namespace {

using Solver = BodyBeamSolver<1, BeamControl::momentum>;
using Names = Solver::Base;
constexpr double inertia_3 = 0.8;

Solver::Values body(double coupling, double stretching = 100) {
    Solver::Values p{2, 1.2, 1.3, inertia_3, 0, 0, 0, 1, 1, 1.2};
    p[Names::stretching] = stretching;
    p[Names::coupling] = coupling;
    p[Names::momentum] = 6;
    return p;
}

/// On a piece of a branch, as near as its points are apart.
bool runs_by(const BodyBeamBranch& branch, const BodyBeamEquilibrium& e) {
    if (branch.index != e.index) return false;
    for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
        const auto &a = branch.points[k], &b = branch.points[k + 1];
        if ((a.momentum - e.momentum) * (b.momentum - e.momentum) > 0) continue;
        const double share = (e.momentum - a.momentum) / (b.momentum - a.momentum);
        const auto off = [&](double x, double y, double at) { return std::abs((1 - share) * x + share * y - at); };
        double away = off(a.moment, b.moment, e.moment), apart = std::abs(a.moment - b.moment);
        for (std::size_t i = 0; i < 3; ++i) {
            away += off(a.modes[i], b.modes[i], e.modes[i]);
            apart += std::abs(a.modes[i] - b.modes[i]);
        }
        if (away < 0.1 * apart + 1e-9) return true;
    }
    return false;
}
/// Of the point that a curve was followed from.
double momentum_at(const BodyBeamCurve& curve, double slice) {
    for (const auto& [second, momentum] : curve.points)
        if (std::abs(second / slice - 1) < 1e-12) return momentum;
    return 0;
}
double whirl_momentum(const Solver::Values& p, int plane) { return inertia_3 * whirl_speeds<1>(p, plane)[0]; }

}  // namespace

TEST_CASE("Branches over the momentum pass every equilibrium that is enumerated at momenta between the slices") {
    for (const auto& [coupling, stretching] : {std::pair(0.0, 100.0), {1.0, 100.0}, {1.0, 20.0}}) {
        CAPTURE(coupling, stretching);
        auto p = body(coupling, stretching);
        const Solver solver(p);
        const auto diagram = body_beam_diagram(solver, p, {3, 8});
        CHECK(diagram.complete());
        CHECK(diagram.slices.size() == 4);
        for (const double momentum : {3.2, 4.3, 5.6, 6.9, 7.95}) {
            CAPTURE(momentum);
            p[Names::momentum] = momentum;
            const auto all = solver(p);
            for (const auto& e : all.equilibria)
                CHECK(std::count_if(diagram.branches.begin(), diagram.branches.end(),
                                    [&](const auto& branch) { return runs_by(branch, e); }) == 1);
            // Morse's relation on the sphere, of which n and -n count once here
            int sum = 0;
            std::size_t crossing = 0;
            for (const auto& branch : diagram.branches)
                if ((branch.points.front().momentum - momentum) * (branch.points.back().momentum - momentum) < 0) {
                    ++crossing;
                    sum += branch.index % 2 == 0 ? 1 : -1;
                }
            CHECK(crossing == all.equilibria.size());
            CHECK(sum == 1);
        }
        for (const auto& branch : diagram.branches)
            for (const auto& e : branch.points) {
                CHECK(e.residual < 1e-10);
                CHECK(e.axis.norm() == Approx(1).epsilon(1e-10));
                CHECK(e.moment * e.speed == Approx(e.momentum).epsilon(1e-10));
                CHECK((e.inertia * e.axis - e.moment * e.axis).norm() < 1e-9);
            }
        // the spin about the beam begins to whirl in either plane
        for (const int plane : {1, 2})
            CHECK(std::count_if(diagram.critical_points.begin(), diagram.critical_points.end(), [&](const auto& c) {
                      return c.kind == CriticalKind::pitchfork && std::abs(c.at.axis(2)) > 1 - 1e-9 &&
                             std::abs(c.at.momentum / whirl_momentum(p, plane) - 1) < 1e-10;
                  }) == 1);
    }
}

// roots of condition 3e9 at distances of 650, whose loops in double close after two turns or eight
TEST_CASE("Every path of a stiff beam ends at a regular rotation, whatever the seed") {
    auto p = body(1);
    for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(seed);
        p[Names::momentum] = 6;
        const Solver solver(p, {.seed = seed});
        for (const double momentum : {6.0825, 6.125, 6.15125}) {
            CAPTURE(momentum);
            p[Names::momentum] = momentum;
            const auto all = solver(p);
            CHECK(all.accounted_for());
            CHECK(all.distinct == 566);
        }
    }
}

TEST_CASE("Mirror images of a bent beam are branches of their own, and a critical point's are there once") {
    const auto p = body(0);
    const auto diagram = body_beam_diagram(Solver(p), p, {3, 8});
    // at 7.846 the spin about the second axis gives its stability to beams bent to either side
    std::vector<double> tips;
    for (const auto& branch : diagram.branches)
        if (branch.index == 0 && branch.points.back().momentum == 8) tips.push_back(branch.points.back().modes[0]);
    REQUIRE(tips.size() == 2);
    CHECK(tips[0] == Approx(-tips[1]).epsilon(1e-9));
    CHECK(std::abs(tips[0]) > 0.01);
    for (std::size_t i = 0; i < diagram.critical_points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK(std::abs(diagram.critical_points[i].at.momentum - diagram.critical_points[j].at.momentum) > 1e-6);
}

TEST_CASE("A body in other units of length and time has the same branches and curves") {
    const auto p = body(0);
    const Solver solver(p);
    const auto diagram = body_beam_diagram(solver, p, {3, 8});
    const auto curves = body_beam_curves(solver, p, Names::bending_2, {{0.9, 1.5}, {3, 8}}, {.slices = 1});
    for (const auto& [length, time] : {std::pair(10.0, 0.01), {0.1, 1.0}, {1000.0, 30.0}}) {
        CAPTURE(length, time);
        const double cube = length * length * length, momentum = cube / time, bending = length * cube / (time * time);
        auto q = p;
        q[Names::length] *= length;
        q[Names::body_mass] *= length;
        for (int k = 0; k < 3; ++k) q[Names::inertia_1 + k] *= cube;
        for (int k = 0; k < 2; ++k) q[Names::bending_1 + k] *= bending;
        q[Names::stretching] *= length * length / (time * time);
        q[Names::momentum] *= momentum;
        const auto scaled = body_beam_diagram(solver, q, {3 * momentum, 8 * momentum});
        CHECK(scaled.complete());
        REQUIRE(scaled.critical_points.size() == diagram.critical_points.size());
        for (std::size_t k = 0; k < diagram.critical_points.size(); ++k) {
            const auto &one = diagram.critical_points[k].at, &other = scaled.critical_points[k].at;
            CHECK(other.momentum == Approx(momentum * one.momentum).epsilon(1e-9));
            CHECK(other.moment == Approx(cube * one.moment).epsilon(1e-9));
            CHECK(other.speed == Approx(one.speed / time).epsilon(1e-9));
        }
        REQUIRE(scaled.branches.size() == diagram.branches.size());
        for (std::size_t k = 0; k < diagram.branches.size(); ++k) {
            CHECK(scaled.branches[k].index == diagram.branches[k].index);
        }
        const Window window{{0.9 * bending, 1.5 * bending}, {3 * momentum, 8 * momentum}};
        const auto found = body_beam_curves(solver, q, Names::bending_2, window, {.slices = 1});
        CHECK(found.complete());
        REQUIRE(found.curves.size() == curves.curves.size());
        for (std::size_t k = 0; k < curves.curves.size(); ++k) {
            CHECK(found.curves[k].kind == curves.curves[k].kind);
            CHECK(momentum_at(found.curves[k], 1.2 * bending) ==
                  Approx(momentum * momentum_at(curves.curves[k], 1.2)).epsilon(1e-9));
        }
    }
}

TEST_CASE("Over the ratio of the stiffnesses pitchforks follow the whirling speeds") {
    const auto p = body(0);
    const Solver solver(p);
    const Window window{{0.7, 1.7}, {3, 8}};
    const auto found = body_beam_curves(solver, p, Names::bending_2, window, {.slices = 2});
    CHECK(found.complete());
    CHECK(found.slices.size() == 2);
    for (const auto& curve : found.curves) CHECK(curve.residual < 1e-9);
    for (const int plane : {1, 2}) {
        const auto whirls = [&](const BodyBeamCurve& curve) {
            return curve.kind == CriticalKind::pitchfork &&
                   std::all_of(curve.points.begin(), curve.points.end(), [&](const auto& at) {
                       auto there = p;
                       there[Names::bending_2] = at[0];
                       return std::abs(at[1] / whirl_momentum(there, plane) - 1) < 1e-9;
                   });
        };
        CHECK(std::count_if(found.curves.begin(), found.curves.end(), whirls) == 1);
    }
    // each critical point of a diagram between the slices lies on a curve
    auto there = p;
    there[Names::bending_2] = 1.35;
    for (const auto& c : body_beam_diagram(solver, there, window.y).critical_points)
        CHECK(std::any_of(found.curves.begin(), found.curves.end(), [&](const BodyBeamCurve& curve) {
            for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
                const auto &a = curve.points[k], &b = curve.points[k + 1];
                if ((a[0] - 1.35) * (b[0] - 1.35) > 0) continue;
                const double at = a[1] + (1.35 - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
                if (std::abs(at - c.at.momentum) < 1e-2) return true;
            }
            return false;
        }));
}

TEST_CASE("What no diagram of a body with a beam can be drawn of is refused") {
    const auto p = body(0);
    const Solver solver(p);
    const auto message = [](const auto& call) -> std::string {
        try {
            call();
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message([&] { body_beam_diagram(solver, p, {0, 8}); }) == "momenta.low = 0: must be positive");
    CHECK(message([&] { body_beam_diagram(solver, p, {8, 3}); }).find("momenta") == 0);
    CHECK(message([&] { body_beam_diagram(solver, p, {3, 8}, {.slices = 0}); }) == "slices = 0: must be at least 1");
    auto round = p;
    round[Names::inertia_2] = round[Names::inertia_1];
    round[Names::bending_2] = round[Names::bending_1];
    CHECK(message([&] { body_beam_diagram(solver, round, {3, 8}); }).find("circles") != std::string::npos);
    const Window window{{0.7, 1.7}, {3, 8}};
    CHECK(message([&] { body_beam_curves(solver, p, Names::speed, window); }).find("second") == 0);
    CHECK(message([&] { body_beam_curves(solver, p, Names::inertia_3, {{1, 4}, {3, 8}}); }).find("inertia") == 0);
}
