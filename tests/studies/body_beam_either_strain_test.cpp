// All relative equilibria of a body with a beam, one mode a direction: for both strain energies, at given speeds and
// momenta, every path accounted for, every root proved; symmetries, Morse relations, circles of a symmetric body.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using mechanisms::BeamControl, mechanisms::BeamStrain, mechanisms::BodyBeamEitherStrain, mechanisms::momentum_hessian,
    mechanisms::RotatingBodyBeam;

namespace {

using Momentum = BodyBeamEitherStrain<1, BeamControl::momentum>;
using Values = Momentum::Values;

Values body(double momentum, double coupling) {
    Values p{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100};
    p[Momentum::momentum] = momentum;
    p[Momentum::coupling] = coupling;
    p[Momentum::second_axis] = 1;
    return p;
}

/// At generic stiffnesses, moments and momentum.
RootSet<Momentum> generic_member(const Values& p, std::uint64_t seed = 1) {
    Generator generator(seed);
    return enumerate<Momentum, TotalDegree<Momentum>>(Momentum::generic(Momentum::units(p).scaled, generator));
}

struct Found {
    Array<double, 7> q;  // n, u, lambda
    double speed;
    int index;
};

/// The real solutions that are motions, as unknowns of RotatingBodyBeam at the parameters p, with their index.
template <BeamStrain Strain>
std::vector<Found> motions(const RootSet<Momentum>& set, const Values& p) {
    using M = RotatingBodyBeam<1, Strain>;
    const auto units = Momentum::units(p);
    std::vector<Found> y;
    for (const auto& e : set.equilibria) {
        const double omega = e.q[Momentum::omega];
        if (!(omega > 0)) continue;
        Found found;
        for (int a = 0; a < 3; ++a) found.q[a] = e.q[a] / omega;
        for (int i = 3; i < 6; ++i) found.q[i] = e.q[i] * units.modes;
        found.q[M::multiplier] = e.q[Momentum::multiplier] * units.moments;
        found.speed = omega * units.speed;
        found.index = inertia(Eigen::MatrixXd(momentum_hessian<1, Strain>(found.q, p[M::momentum], p))).negative;
        auto there = p;
        there[M::speed] = found.speed;
        const auto g = equations<M>(found.q, there);
        // the equation that a plane of axes leaves out, where it does not follow
        if (set.parameters[M::second_axis] == 0 && std::abs(found.q[0]) < 1e-9 && std::abs(g[1]) > 1e-6) continue;
        for (const double gi : g) CHECK(std::abs(gi) < 1e-8);
        CHECK(found.speed * found.q[M::multiplier] == Approx(p[M::momentum]).epsilon(1e-10));
        y.push_back(found);
    }
    return y;
}

bool contains(const std::vector<Found>& all, const Array<double, 7>& q) {
    return std::any_of(all.begin(), all.end(), [&](const Found& f) {
        double difference = 0;
        for (int k = 0; k < 7; ++k) difference = std::max(difference, std::abs(f.q[k] - q[k]));
        return difference < 1e-6;
    });
}

template <BeamStrain Strain>
void check_symmetries_and_indices(const std::vector<Found>& found) {
    int alternating = 0, minima = 0;
    for (const Found& f : found) {
        alternating += f.index % 2 == 0 ? 1 : -1;
        minima += f.index == 0;
        auto other = f.q;
        for (int a = 0; a < 3; ++a) other[a] = -f.q[a];
        CHECK(contains(found, other));  // turning the other way
        for (int a = 0; a < 2; ++a) {   // reflected in the plane of the beam and the other axis
            other = f.q;
            other[a] = -f.q[a];
            other[3 + a] = -f.q[3 + a];
            CHECK(contains(found, other));
        }
    }
    // the energy at fixed momentum grows without bounds: critical points on the sphere and the modes sum to 2
    CHECK(alternating == 2);
    CHECK(minima >= 2);
}

}  // namespace

TEST_CASE("All relative equilibria at a given momentum are proved, symmetric, and fulfil the Morse relation") {
    for (const double coupling : {0.0, 1.0}) {
        CAPTURE(coupling);
        const auto generic = generic_member(body(6, coupling));
        CHECK(generic.paths.total == 2916);
        CHECK(generic.paths.accounted_for());
        CHECK(generic.paths.singular == 0);
        CHECK(generic.alarms.sentences() == "");
        CHECK(generic.paths.failed == 0);
        CHECK(generic.distinct() == generic_member(body(6, coupling), 2).distinct());
        for (const double momentum : coupling == 0 ? std::vector{6.0, 9.0} : std::vector{6.0}) {
            CAPTURE(momentum);
            const auto p = body(momentum, coupling);
            const auto set = enumerate(generic, Momentum::units(p).scaled);
            CHECK(set.paths.total == generic.distinct());
            CHECK(set.paths.accounted_for());
            const auto proof = prove(set);
            CHECK(proof.contradictions == 0);
            if (coupling == 0) {
                const auto found = motions<BeamStrain::linear>(set, p);
                check_symmetries_and_indices<BeamStrain::linear>(found);
            } else {
                const auto found = motions<BeamStrain::coupled>(set, p);
                check_symmetries_and_indices<BeamStrain::coupled>(found);
            }
            // each real root is proved, half of them have omega < 0
            CHECK(proof.real == set.real());
        }
    }
}

TEST_CASE("A body that turns about its beam has circles of relative equilibria, points of the plane 1-3") {
    Values p = body(6, 0);
    p[Momentum::inertia_2] = p[Momentum::inertia_1];
    p[Momentum::bending_2] = p[Momentum::bending_1];
    p[Momentum::second_axis] = 0;
    const auto generic = generic_member(p);
    CHECK(generic.alarms.sentences() == "");
    CHECK(generic.paths.failed == 0);
    const auto set = enumerate(generic, Momentum::units(p).scaled);
    p[Momentum::second_axis] = 1;
    const auto found = motions<BeamStrain::linear>(set, p);
    CHECK(found.size() >= 6);
    for (const Found& f : found) {
        CHECK(std::abs(f.q[1]) < 1e-12);
        // turned about the third axis it is an equilibrium too, and its Hessian is singular along the circle
        Array<double, 7> q = f.q;
        const double c = std::cos(0.7), s = std::sin(0.7);
        q[0] = c * f.q[0], q[1] = s * f.q[0];
        q[3] = c * f.q[3] - s * f.q[4], q[4] = s * f.q[3] + c * f.q[4];
        auto there = p;
        there[Momentum::speed] = f.speed;
        for (const double g : equations<RotatingBodyBeam<1>>(q, there)) CHECK(std::abs(g) < 1e-8);
        const Eigen::MatrixXd hessian = momentum_hessian<1, BeamStrain::linear>(f.q, 6, p);
        if (std::hypot(f.q[0], f.q[1]) > 1e-9) CHECK(inertia(hessian).zero == 1);
    }
}

TEST_CASE("Units change nothing: a longer, slower beam has the same relative equilibria") {
    // times 2 in length and 3 in time
    const double l = 2, t = 3;
    const auto p = body(6, 1);
    auto longer = p;
    longer[Momentum::body_mass] *= l;
    longer[Momentum::length] *= l;
    for (int k = 0; k < 3; ++k) longer[Momentum::inertia_1 + k] *= l * l * l;
    for (int k = 0; k < 2; ++k) longer[Momentum::bending_1 + k] *= l * l * l * l / (t * t);
    longer[Momentum::stretching] *= l * l / (t * t);
    longer[Momentum::momentum] *= l * l * l / t;
    const auto a = Momentum::units(p), b = Momentum::units(longer);
    for (int k = 0; k < a.scaled.size(); ++k) CHECK(b.scaled[k] == Approx(a.scaled[k]).epsilon(1e-14));
    CHECK(b.modes == Approx(a.modes * l * std::sqrt(l)).epsilon(1e-14));
    CHECK(b.speed == Approx(a.speed / t).epsilon(1e-14));
    CHECK(b.moments == Approx(a.moments * l * l * l).epsilon(1e-14));
}
