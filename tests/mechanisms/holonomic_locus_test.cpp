// Where the mechanism's equilibria are born and die: on lines of the force, and in the plane of c2 and the force.
#include <algorithm>
#include <cmath>
#include <vector>

#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;

namespace {

/// The stiffnesses c2 at which the mechanism without a force has a singular Hessian at q1 = +-pi/2, q2 in {0, pi}:
/// there it branches symmetrically, and the plane has a cusp. With s, t the signs of sin q1 and cos q2, a = m g and all
/// over l: V11 = -2 a s + l (c1 s t + c2 s), V12 = l c1 s t, V22 = a t + l c1 s t.
std::vector<double> symmetric_cusps() {
    const auto p = M::paper_parameters(0);
    const double a = p[M::mass_1] * p[M::gravity], l = p[M::length], c1 = l * p[M::stiffness_1];
    std::vector<double> y;
    for (const double s : {1.0, -1.0})
        for (const double t : {1.0, -1.0}) {
            const double mixed = c1 * s * t, second = a * t + mixed;
            y.push_back((mixed * mixed / second + 2 * a * s - mixed) / (l * s));
        }
    std::sort(y.begin(), y.end());
    return y;
}

}  // namespace

TEST_CASE("The mechanism's locus in the plane of c2 and the force has ten cusps, mirror images of each other") {
    const auto locus = trace_locus<M, M::stiffness_2, M::force>(M::paper_parameters(0), {{0, 600}, {-300, 300}});
    CAPTURE(locus.argument());
    CHECK(locus.evidence.complete());
    const auto cusps = locus.of(SingularityKind::cusp);
    REQUIRE(cusps.size() == 10);
    std::vector<double> symmetric;
    for (const auto& cusp : cusps) {
        CHECK(cusp.residual < 1e-10);
        CHECK(std::abs(cusp.derivative(4)) > 1);
        if (std::abs(cusp.y()) < 1e-9) symmetric.push_back(cusp.x());
        // x -> -x
        CHECK(std::any_of(cusps.begin(), cusps.end(), [&](const auto& other) {
            return std::abs(other.x() - cusp.x()) < 1e-9 && std::abs(other.y() + cusp.y()) < 1e-9;
        }));
    }
    std::sort(symmetric.begin(), symmetric.end());
    const auto expected = symmetric_cusps();
    REQUIRE(symmetric.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK(std::abs(symmetric[k] - expected[k]) < 1e-9);

    CHECK(locus.regions.size() > 5);
    for (const auto& region : locus.regions) {
        CHECK(region.clean);
        CHECK(region.confirmed);
        CHECK(region.count % 2 == 0);
        CHECK(region.by_index[0] - region.by_index[1] + region.by_index[2] == 0);
    }
}

TEST_CASE("Every event of the mechanism as the force grows, folds one and all") {
    auto p = M::paper_parameters(0);
    p[M::stiffness_2] = 150;
    const auto found = find_events<M, M::force>(p, {-300, 300});
    CAPTURE(found.argument());
    CHECK(found.complete());
    CHECK(found.events.size() >= 4);
    CHECK(found.events.size() % 2 == 0);
    for (std::size_t k = 0; k < found.events.size(); ++k) {
        const auto &event = found.events[k], &mirror = found.events[found.events.size() - 1 - k];
        CHECK(event.kind == CriticalKind::fold);
        CHECK(std::abs(event.value + mirror.value) < 1e-9);
    }
}

TEST_CASE("Without a force the equilibria change their number at four pitchforks as c2 grows, to 10 digits") {
    const auto found = find_events<M, M::stiffness_2>(M::paper_parameters(0), {0, 400});
    CAPTURE(found.argument());
    CHECK(found.complete());
    const auto expected = symmetric_cusps();  // the cusps of the plane: there the line F = 0 has pitchforks
    REQUIRE(found.events.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const auto& event = found.events[k];
        CHECK(std::abs(event.value - expected[k]) < 1e-10 * expected[k]);
        CHECK(event.kind == CriticalKind::pitchfork);
        CHECK(std::abs(std::cos(event.q[0])) < 1e-12);
        CHECK(std::abs(std::sin(event.q[1])) < 1e-12);
    }
    REQUIRE(found.intervals.size() == 5);
    const std::vector<std::int64_t> tables[] = {{1, 2, 1}, {2, 3, 1}, {1, 2, 1}, {1, 3, 2}, {1, 2, 1}};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(found.intervals[k].by_index == tables[k]);
        CHECK(found.intervals[k].clean);
    }
}
