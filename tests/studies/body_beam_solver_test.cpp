// The solver for all relative equilibria of a body with a beam, one mode a direction, at given speeds: every path
// accounted for, roots in pairs n and -n, each record a rotation about a principal axis that solves the model.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/paths/monodromy.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/system/system_family.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using mechanisms::BeamControl, mechanisms::BeamStrain, mechanisms::BodyBeamEquilibria, mechanisms::BodyBeamEquilibrium,
    mechanisms::BodyBeamSolver, mechanisms::RotatingBodyBeam;

namespace {

using Solver = BodyBeamSolver<1, BeamControl::speed>;
using Names = RotatingBodyBeam<1>;

Solver::Values body(double speed, double coupling) {
    Solver::Values p{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, speed};
    p[Names::coupling] = coupling;
    return p;
}

/// The residual of RotatingBodyBeam's equations at a record.
template <BeamStrain Strain>
void check_residual(const BodyBeamEquilibrium& e, const Solver::Values& p) {
    using M = RotatingBodyBeam<1, Strain>;
    Unknowns<M> q;
    for (int i = 0; i < 3; ++i) {
        q[i] = e.axis(i);
        q[M::first_mode + i] = e.modes[static_cast<std::size_t>(i)];
    }
    q[M::multiplier] = e.moment;
    const double stiffest = p[M::stretching];
    for (const double f : equations<M>(q, p)) CHECK(std::abs(f) < 1e-9 * stiffest);
}

/// Whether a record is what it says of itself.
void check_equilibrium(const BodyBeamEquilibrium& e, const Solver::Values& p) {
    if (p[Names::coupling] == 0)
        check_residual<BeamStrain::linear>(e, p);
    else
        check_residual<BeamStrain::coupled>(e, p);
    CHECK(e.axis.norm() == Approx(1).epsilon(1e-12));
    CHECK((e.inertia * e.axis - e.moment * e.axis).norm() < 1e-10);
    CHECK(e.speed == Approx(p[Names::speed]).epsilon(1e-12));
    CHECK(e.momentum == Approx(e.moment * e.speed).epsilon(1e-14));
    Eigen::Index largest = 0;
    e.axis.cwiseAbs().maxCoeff(&largest);
    CHECK(e.axis(largest) > 0);
    CHECK(e.residual < 1e-12);
    CHECK(!e.circle);
}

/// Laws of any answer for a body without symmetry.
void check_complete(const BodyBeamEquilibria& y) {
    CHECK(y.accounted_for());
    CHECK(y.followed);
    CHECK(y.start == "polyhedral");
    CHECK(y.generic.total < 1458);  // the total degree
    CHECK(y.generic.accounted_for());
    CHECK(y.generic.failed == 0);
    REQUIRE(y.generic_roots.size() >= 2);
    CHECK(y.generic_roots.back() == y.generic_roots[y.generic_roots.size() - 2]);
    CHECK(y.paths.total == y.generic_roots.back());
    CHECK(y.paths.finite == y.distinct);
    CHECK(y.failures.empty());
    CHECK(y.families.empty());
    // n and -n, and no root is its own mirror image
    CHECK(y.distinct % 2 == 0);
    CHECK(y.real == 2 * y.equilibria.size());
    CHECK(std::is_sorted(y.equilibria.begin(), y.equilibria.end(),
                         [](const auto& a, const auto& b) { return a.index < b.index; }));
}

}  // namespace

TEST_CASE("The solver finds all rotations of a body with a beam at each speed, and proves them") {
    for (const double coupling : {0.0, 1.0}) {
        CAPTURE(coupling);
        const Solver solver(body(1, coupling));
        const auto p = body(6, coupling);
        const auto y = solver.prove(p);
        check_complete(y);
        CHECK(y.proved_distinct == y.distinct);
        CHECK(y.proved_real == y.real);
        for (const auto& e : y.equilibria) {
            CHECK(e.proved);
            check_equilibrium(e, p);
        }
        // another speed, from the same generic member
        const auto slow = body(2, coupling);
        const auto z = solver(slow);
        check_complete(z);
        CHECK(z.paths.total == y.paths.total);
        for (const auto& e : z.equilibria) check_equilibrium(e, slow);
        if (coupling != 0) continue;
        // without a proof the same
        const auto same = solver(p);
        REQUIRE(same.equilibria.size() == y.equilibria.size());
        for (std::size_t k = 0; k < y.equilibria.size(); ++k) {
            CHECK(same.equilibria[k].axis == y.equilibria[k].axis);
            CHECK(!same.equilibria[k].proved);
        }
    }
}

TEST_CASE("From the generic member of one body the solver reaches all rotations of another") {
    for (const double coupling : {0.0, 1.0}) {
        CAPTURE(coupling);
        auto one = body(6, coupling), other = body(4, coupling);
        one[Names::centre_1] = 0.12, one[Names::centre_2] = -0.07, one[Names::centre_3] = 0.05;
        other[Names::body_mass] = 3.4;
        other[Names::centre_1] = -0.2, other[Names::centre_2] = 0.11, other[Names::centre_3] = 0.16;
        const Solver solver(one), own(other);
        const auto y = solver(other), cold = own(other);
        check_complete(y);
        check_complete(cold);
        CHECK(y.distinct == cold.distinct);
        REQUIRE(y.equilibria.size() == cold.equilibria.size());
        for (const auto& e : y.equilibria) {
            check_equilibrium(e, other);
            CHECK(std::any_of(cold.equilibria.begin(), cold.equilibria.end(), [&](const auto& c) {
                return c.index == e.index && (c.axis - e.axis).norm() < 1e-8 && std::abs(c.moment - e.moment) < 1e-8;
            }));
        }
    }
}

TEST_CASE("Monodromy finds from one root as many as paths from a total-degree start") {
    auto p = body(6, 0);
    p[Names::centre_1] = 0.12, p[Names::centre_2] = -0.07, p[Names::centre_3] = 0.05;
    const Solver solver(p);
    const auto& member = solver.generic().parameters;
    const auto generic = monodromy(system_family<Solver::Model>(), std::vector<double>(member.begin(), member.end()),
                                   {}, {.fixed = {Names::coupling, Names::second_axis, Names::length}});
    CHECK(generic.closed());
    CHECK(generic.roots.size() == solver.generic().distinct());
}

TEST_CASE("The circles of a symmetric body are one equilibrium each") {
    auto p = body(6, 0);
    p[Names::inertia_2] = p[Names::inertia_1];
    p[Names::bending_2] = p[Names::bending_1];
    const auto y = Solver(p)(p);
    CHECK(y.accounted_for());
    int circles = 0;
    for (const auto& e : y.equilibria) {
        CHECK((e.inertia * e.axis - e.moment * e.axis).norm() < 1e-9);
        CHECK(e.nullity == (e.circle ? 1 : 0));
        CHECK(std::abs(e.axis(1)) < 1e-9);
        if (e.circle) ++circles;
    }
    CHECK(circles > 0);
}

TEST_CASE("The solver refuses what is no body, and says when it was cancelled") {
    using Catch::Matchers::Contains;
    auto bad = body(1, 0.5);
    CHECK_THROWS_WITH(Solver(bad), Contains("coupling = 0.5: must be 0 or 1"));
    const std::atomic<bool> at_once = true;
    CHECK_THROWS_WITH(Solver(body(1, 0), {.cancel = &at_once})(body(1, 1)),
                      Contains("coupling = 1: must be that of the solver's body"));
    bad = body(1, 0);
    bad[Names::length] = 0;
    CHECK_THROWS_WITH(Solver(bad), Contains("length = 0: must be positive"));

    const std::atomic<bool> cancel = true;
    auto round = body(2, 0);
    round[Names::inertia_2] = round[Names::inertia_1];
    round[Names::bending_2] = round[Names::bending_1];
    const Solver cancelled(round, {.cancel = &cancel});
    CHECK(cancelled(round).cancelled());
    CHECK(!cancelled(round).accounted_for());
    CHECK(cancelled(round).equilibria.empty());
    CHECK_THROWS_WITH(cancelled(body(2, 0)), Contains("must be as symmetric"));
    round[Names::speed] = 0;
    CHECK_THROWS_WITH(cancelled(round), Contains("speed = 0: must be positive"));
}
