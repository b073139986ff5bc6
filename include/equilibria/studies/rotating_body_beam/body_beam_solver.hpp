/// \file
/// All relative equilibria of a body with a beam of K modes a direction, with either strain energy, at a given speed or
/// momentum, by homotopy continuation.
///
/// \code
/// BodyBeamEitherStrain<1, BeamControl::speed>::Values p{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, 6};
/// const BodyBeamSolver<1, BeamControl::speed> solver(p, {.executor = threads(4)});
/// for (const auto& e : solver(p).equilibria) std::cout << e.axis.transpose() << (e.stable() ? " stable\n" : "\n");
/// \endcode
///
/// The systems of BodyBeamEitherStrain are solved twice. A member at generic stiffnesses, moments and speed or momentum
/// is enumerated from the start of the least predicted cost, once; any member is reached from its roots, with hundreds
/// of paths instead of thousands (the coefficient-parameter theory of Morgan and Sommese, Appl. Math. Comput. 29,
/// 1989), along an arc of the parameters (start/coefficient_path.hpp): of the same body or of one of other masses and
/// another centre. A second generic member must have as many roots. What is enumerated are the rotations of section 2,
/// (2.6) and (2.7), of Baillieul, "Parametric dependence in the equilibrium dynamics of rotating structures".
///
/// The solver's body should be as general as those that it is asked for: where its centre of mass is 0 and theirs is
/// not, between the two may be bodies with more roots than it has.
///
/// Where it fails: two modes, coupled, at a momentum have 37,080 paths and take minutes; beams of more modes are
/// followed (rotating_body_beam_boundary.hpp). An equilibrium on a curve of others that is no circle about the third
/// axis is not isolated: it is in `families`, in words. A template of two modes takes minutes to compile, so programs
/// declare it `extern`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/certify/certificate.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_equilibria.hpp>
#include <equilibria/studies/rotating_body_beam/detail/body_beam_equilibrium.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// The systems of a body with K modes a direction, solved once, at generic stiffnesses, moments and speed or momentum,
/// for any number of members.
template <int K, BeamControl Control>
class BodyBeamSolver {
public:
    using Model = BodyBeamEitherStrain<K, Control>;  ///< the systems that are solved
    using Values = typename Model::Values;           ///< parameters of a body
    using Base = typename Model::Base;               ///< names the parameters

    /// Solves the generic members. Of the body only mass, centre and length matter, body[coupling], which is 0 or 1
    /// (linear or coupled strain), and whether turning it about the third axis changes nothing. A checkpoint, the
    /// progress and a seed are of the paths to the generic members alone; the checkpoint of the k-th, k > 1, has a name
    /// that ends in ".k". Throws InvalidArgument where RotatingBodyBeam::validate does or the coupling is neither, and
    /// CheckpointError. A path that fails is a count in the results.
    explicit BodyBeamSolver(const Values& body, RunOptions run = {});

    /// All relative equilibria of the body p at its speed or momentum, of the solver's coupling. Throws InvalidArgument
    /// where p is no body or not as symmetric about the third axis as the solver's, of another coupling, or the speed
    /// or momentum is not positive.
    BodyBeamEquilibria operator()(const Values& p) const;
    /// The same, each proved by Krawczyk's operator: `proved`, `proved_distinct` and `proved_real` say which are.
    BodyBeamEquilibria prove(const Values& p) const;

    /// Of the member that others are followed from.
    const RootSet<Model>& generic() const { return generic_; }

private:
    RunOptions further_run() const { return {.seed = run_.seed, .executor = run_.executor, .cancel = run_.cancel}; }
    void validate(const Values& p) const;
    Values target(const Values& p) const;
    RootSet<Model> enumerated(const Values& p) const;
    BodyBeamEquilibria described(const RootSet<Model>& set, const Values& p,
                                 std::span<const Certificate> certificates) const;
    std::vector<BodyBeamEquilibrium> motions(const RootSet<Model>& set, const Values& p,
                                             std::span<const Certificate> certificates) const;

    RunOptions run_;
    bool circles_, agreed_ = false;
    double coupling_ = 0;
    RootSet<Model> generic_;
    std::vector<std::uint64_t> generic_roots_;  // of each member that was drawn
    double generic_seconds_ = 0;
};

namespace detail {

/// Whether all roots can be followed to other members: each is regular, and nothing says that one is missing.
template <class Set>
bool can_be_followed(const Set& set) {
    return set.paths.failed == 0 && set.paths.singular == 0 && !set.cancelled() && set.paths.finite == set.distinct() &&
           !set.alarms.raised();
}

}  // namespace detail

template <int K, BeamControl Control>
BodyBeamSolver<K, Control>::BodyBeamSolver(const Values& body, RunOptions run)
    : run_(std::move(run)), circles_(detail::turns(body)) {
    validate(body);
    coupling_ = body[Base::coupling];
    const Values p = target(body);
    Generator generator(run_.seed);
    // a member may happen to have roots that are badly conditioned, or so far out that they seem to be at infinity: two
    // without failures must agree on their number
    for (int draw = 1; draw <= 4; ++draw) {
        RunOptions options = run_;
        if (draw > 1 && !options.checkpoint.empty()) options.checkpoint.append(".").append(std::to_string(draw));
        auto member = enumerate_with_more_digits<Model>(Model::generic(p, generator), options);
        generic_roots_.push_back(member.distinct());
        generic_seconds_ += member.seconds;
        const bool regular = detail::can_be_followed(member), had_regular = detail::can_be_followed(generic_);
        agreed_ = draw > 1 && regular && had_regular && member.distinct() == generic_.distinct();
        if (draw == 1 || (regular && (!had_regular || member.distinct() > generic_.distinct())))
            generic_ = std::move(member);
        if (agreed_ || run_.cancelled()) return;
    }
}

template <int K, BeamControl Control>
void BodyBeamSolver<K, Control>::validate(const Values& p) const {
    Base::validate(p);
    require(p[Base::coupling] == 0 || p[Base::coupling] == 1, "coupling", p[Base::coupling], "must be 0 or 1");
    require(!circles_ || detail::turns(p), "p", "a body without symmetry",
            "must be as symmetric about the third axis as the solver's");
}

/// In the units of the generic member, whose coefficients are of size 1.
template <int K, BeamControl Control>
typename BodyBeamSolver<K, Control>::Values BodyBeamSolver<K, Control>::target(const Values& p) const {
    auto y = Model::units(p).scaled;
    y[Base::second_axis] = circles_ ? 0 : 1;
    return y;
}

template <int K, BeamControl Control>
RootSet<BodyBeamEitherStrain<K, Control>> BodyBeamSolver<K, Control>::enumerated(const Values& p) const {
    validate(p);
    require(p[Base::coupling] == coupling_, "coupling", p[Base::coupling], "must be that of the solver's body");
    constexpr auto given = Model::at_speed ? Base::speed : Base::momentum;
    require(p[given] > 0, Model::at_speed ? "speed" : "momentum", p[given], "must be positive");
    return detail::can_be_followed(generic_) ? enumerate_with_more_digits(generic_, target(p), further_run())
                                             : enumerate_with_more_digits<Model>(target(p), further_run());
}

template <int K, BeamControl Control>
BodyBeamEquilibria BodyBeamSolver<K, Control>::operator()(const Values& p) const {
    return described(enumerated(p), p, {});
}

template <int K, BeamControl Control>
BodyBeamEquilibria BodyBeamSolver<K, Control>::prove(const Values& p) const {
    const auto set = enumerated(p);
    const auto proof = equilibria::prove(set, {.executor = run_.executor});
    auto y = described(set, p, proof.certificates);
    y.proved_distinct = proof.distinct;
    y.proved_real = proof.real;
    y.proving_seconds = proof.seconds;
    return y;
}

/// certificates: of the set's roots, or none.
template <int K, BeamControl Control>
BodyBeamEquilibria BodyBeamSolver<K, Control>::described(const RootSet<Model>& set, const Values& p,
                                                         std::span<const Certificate> certificates) const {
    BodyBeamEquilibria y;
    y.generic = generic_.paths;
    y.start = generic_.start.name;
    y.paths = set.paths;
    y.followed = detail::can_be_followed(generic_);
    y.generic_roots = generic_roots_;
    y.distinct = set.distinct();
    y.real = set.real();
    y.alarms = set.alarms.sentences();
    y.generic_seconds = generic_seconds_;
    y.seconds = set.seconds;
    if (y.followed && !agreed_)
        y.alarms += std::string(y.alarms.empty() ? "" : ", ") + "generic members differ in their numbers of roots";
    for (const auto& family : set.families)
        y.families.push_back(std::string(family.real() ? "a real " : "a ") + family_kind(family.dimension) +
                             " of solutions (" + std::to_string(family.paths()) + " paths)");
    for (const auto& f : set.failures)
        y.failures.push_back("path " + std::to_string(f.path) + ": " + std::string(to_string(f.reason)));
    y.equilibria = motions(set, p, certificates);
    return y;
}

template <int K, BeamControl Control>
std::vector<BodyBeamEquilibrium> BodyBeamSolver<K, Control>::motions(const RootSet<Model>& set, const Values& p,
                                                                     std::span<const Certificate> certificates) const {
    const auto units = Model::units(p);
    std::vector<BodyBeamEquilibrium> y;
    for (const auto& e : set.equilibria) {
        double omega = units.scaled[Base::speed];
        if constexpr (!Model::at_speed) {
            omega = e.q[Model::omega];
            if (!(omega > 0 && e.q[Model::multiplier] > 0)) continue;  // -omega and -lambda: of no motion
        }
        Array<double, 4 + 3 * K> q;
        for (int a = 0; a < 3; ++a) q[a] = e.q[a] / omega;
        for (int i = Model::first_mode; i < Model::multiplier; ++i) q[i] = e.q[i] * units.modes;
        q[Model::multiplier] = e.q[Model::multiplier] * units.moments;
        const double speed = omega * units.speed;
        auto found = p[Base::coupling] == 0
                         ? detail::body_beam_equilibrium<K, BeamStrain::linear>(q, speed, p, circles_)
                         : detail::body_beam_equilibrium<K, BeamStrain::coupled>(q, speed, p, circles_);
        // with the axis e_3 the plane's system leaves out an equation
        if (circles_ && !(found.inertia * found.axis - found.moment * found.axis).isZero(1e-6 * found.moment)) continue;
        if (!detail::represents(found.axis, found.circle)) continue;
        found.residual = e.residual;
        found.condition = e.condition;
        found.proved = std::any_of(certificates.begin(), certificates.end(), [&](const Certificate& c) {
            return c.path == e.path && c.exists && c.reality == Reality::real;
        });
        y.push_back(std::move(found));
    }
    std::stable_sort(y.begin(), y.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
    return y;
}

}  // namespace equilibria::mechanisms
