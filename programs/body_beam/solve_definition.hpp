// The definition of what body_beam.hpp declares, instantiated by units that compile side by side.
#pragma once

#include <algorithm>
#include <cmath>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/stability/inertia.hpp>

#include "body_beam/body_beam.hpp"

namespace {

using equilibria::mechanisms::BeamControl, equilibria::mechanisms::BeamStrain, equilibria::mechanisms::RotatingBodyBeam;
using Base = RotatingBodyBeam<1>;

/// Turning about the third axis changes nothing.
bool turns(const BodyBeamValues& p) {
    return p[Base::bending_1] == p[Base::bending_2] && p[Base::inertia_1] == p[Base::inertia_2] &&
           p[Base::centre_1] == 0 && p[Base::centre_2] == 0;
}

template <int K, BeamStrain Strain>
RelativeEquilibrium classified(const equilibria::Array<double, 4 + 3 * K>& q, double speed, const BodyBeamValues& p,
                               bool circle) {
    using M = RotatingBodyBeam<K, Strain>;
    RelativeEquilibrium y;
    y.axis = Eigen::Vector3d(q[0], q[1], q[2]);
    y.modes.assign(q.begin() + M::first_mode, q.begin() + M::multiplier);
    y.moment = q[M::multiplier];
    y.speed = speed;
    y.momentum = y.moment * speed;
    equilibria::Array<double, 3 * K> u;
    std::copy(y.modes.begin(), y.modes.end(), u.begin());
    const auto j = M::inertia(u, p);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) y.inertia(a, b) = j[a][b];
    y.energy = M::strain_energy(u, p) + 0.5 * y.moment * speed * speed;
    const auto inertia =
        equilibria::inertia(Eigen::MatrixXd(equilibria::mechanisms::momentum_hessian<K, Strain>(q, y.momentum, p)));
    y.index = inertia.negative;
    y.nullity = inertia.zero;
    y.circle = circle && (std::abs(q[0]) > 1e-9 || std::abs(q[1]) > 1e-9 || [&] {
                   for (int i = 0; i < 2 * K; ++i)
                       if (std::abs(u[i]) > 1e-9) return true;
                   return false;
               }());
    return y;
}

/// One of n and -n, and of the two points that a circle has in its plane for each.
bool represents(const Eigen::Vector3d& axis, bool circle) {
    if (circle) return axis(2) > 1e-9 ? axis(0) >= -1e-9 : std::abs(axis(2)) <= 1e-9 && axis(0) > 0;
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    return axis(largest) > 0;
}

/// Whether all roots can be followed to other members: each is regular, and nothing says that one is missing.
bool regular(const auto& set) {
    return set.paths.failed == 0 && set.paths.singular == 0 && set.paths.finite == set.distinct() &&
           !set.alarms.raised();
}

}  // namespace

template <int K, BeamControl Control>
BodyBeamSolver<K, Control>::BodyBeamSolver(const BodyBeamValues& body, BodyBeamRun run)
    : run_(std::move(run)), circles_(turns(body)) {
    auto p = Model::units(body).scaled;
    p[Base::second_axis] = circles_ ? 0 : 1;
    equilibria::Generator generator(run_.seed);
    // a member may happen to have roots that are badly conditioned, or so far out that they seem to be at infinity: two
    // without failures must agree on their number
    for (int draw = 1; draw <= 4; ++draw) {
        auto o = options();
        o.progress = run_.progress;
        o.checkpoint = run_.checkpoint;
        if (draw > 1 && !o.checkpoint.empty()) o.checkpoint += "." + std::to_string(draw);
        auto member =
            equilibria::enumerate_with_more_digits<Model, equilibria::Moving<Model>>(Model::generic(p, generator), o);
        generic_roots_.push_back(member.distinct());
        generic_seconds_ += member.seconds;
        const bool better = regular(member) && (!regular(generic_) || member.distinct() > generic_.distinct());
        agreed_ = draw > 1 && regular(member) && regular(generic_) && member.distinct() == generic_.distinct();
        if (draw == 1 || better) generic_ = std::move(member);
        if (agreed_) return;
    }
}

template <int K, BeamControl Control>
equilibria::RunOptions BodyBeamSolver<K, Control>::options() const {
    return {.seed = run_.seed, .executor = equilibria::threads(run_.threads)};
}

template <int K, BeamControl Control>
RelativeEquilibria BodyBeamSolver<K, Control>::operator()(const BodyBeamValues& p) const {
    const auto units = Model::units(p);
    auto target = units.scaled;
    target[Base::second_axis] = circles_ ? 0 : 1;
    if (circles_ && !turns(p))
        throw equilibria::InvalidArgument("p", "a body without symmetry",
                                          "must be as symmetric about the third axis as the solver's");
    const auto set = regular(generic_)
                         ? equilibria::enumerate_with_more_digits(generic_, target, options())
                         : equilibria::enumerate_with_more_digits<Model, equilibria::Moving<Model>>(target, options());
    RelativeEquilibria y{.generic = generic_.paths,
                         .paths = set.paths,
                         .followed = regular(generic_),
                         .generic_roots = generic_roots_,
                         .distinct = set.distinct(),
                         .real = set.real(),
                         .alarms = set.alarms.sentences(),
                         .seconds = set.seconds,
                         .generic_seconds = generic_seconds_};
    if (regular(generic_) && !agreed_)
        y.alarms += std::string(y.alarms.empty() ? "" : ", ") + "generic members differ in their numbers of roots";
    std::vector<equilibria::Certificate> certificates;
    if (run_.prove) {
        auto proof = equilibria::prove(set, {.executor = equilibria::threads(run_.threads)});
        y.proved_distinct = proof.distinct;
        y.proved_real = proof.real;
        y.proving_seconds = proof.seconds;
        certificates = std::move(proof.certificates);
    }
    for (const auto& e : set.equilibria) {
        double omega = target[Base::speed];
        if constexpr (!Model::at_speed) {
            omega = e.q[Model::omega];
            if (!(omega > 0 && e.q[Model::multiplier] > 0)) continue;  // -omega and -lambda: of no motion
        }
        equilibria::Array<double, 4 + 3 * K> q;
        for (int a = 0; a < 3; ++a) q[a] = e.q[a] / omega;
        for (int i = Model::first_mode; i < Model::multiplier; ++i) q[i] = e.q[i] * units.modes;
        q[Model::multiplier] = e.q[Model::multiplier] * units.moments;
        const double speed = omega * units.speed;
        auto found = p[Base::coupling] == 0 ? classified<K, BeamStrain::linear>(q, speed, p, circles_)
                                            : classified<K, BeamStrain::coupled>(q, speed, p, circles_);
        // with the axis e_3 the plane's system leaves out an equation
        if (circles_ && !(found.inertia * found.axis - found.moment * found.axis).isZero(1e-6 * found.moment)) continue;
        if (!represents(found.axis, found.circle)) continue;
        found.residual = e.residual;
        found.condition = e.condition;
        found.proved = std::any_of(certificates.begin(), certificates.end(), [&](const auto& c) {
            return c.path == e.path && c.exists && c.reality == equilibria::Reality::real;
        });
        y.equilibria.push_back(std::move(found));
    }
    std::stable_sort(y.equilibria.begin(), y.equilibria.end(),
                     [](const auto& a, const auto& b) { return a.index < b.index; });
    for (const auto& family : set.families)
        y.families.push_back(std::string(family.real() ? "a real " : "a ") +
                             equilibria::family_kind(family.dimension) + " of solutions (" +
                             std::to_string(family.paths()) + " paths)");
    for (const auto& f : set.failures)
        y.failures.push_back("path " + std::to_string(f.path) + ": " + std::string(to_string(f.reason)));
    return y;
}
