// All relative equilibria of a rotating body with a beam, for what is known at run time: how many modes, which strain
// energy, whether the speed or the momentum is given. One family of systems is solved at generic parameters and
// followed to the ones that are asked for. Two units have a number of modes each, so that they compile side by side:
// solve_1_mode.cpp, solve_2_mode.cpp.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using BodyBeamValues = equilibria::mechanisms::RotatingBodyBeam<1>::Values;

struct BodyBeamRun {
    std::uint64_t seed = 1;
    unsigned threads = 1;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
    std::string checkpoint{};  // of the paths to the generic member
    bool prove = false;
};

// One of a pair n, -n.
struct RelativeEquilibrium {
    Eigen::Vector3d axis;       // n, its largest component positive
    std::vector<double> modes;  // u1, u2, u3
    Eigen::Matrix3d inertia;
    double moment, speed, momentum;  // lambda, omega, lambda omega
    double energy;                   // V(u) + lambda omega^2 / 2
    int index, nullity;              // at fixed momentum, over its direction and the modes; nullity 1 on a circle
    double residual, condition;
    bool circle;  // one of a circle, turned about the third axis
    bool proved;  // by Krawczyk's operator, an isolated real solution
    bool stable() const { return index == 0 && nullity == (circle ? 1 : 0); }
};

struct RelativeEquilibria {
    equilibria::PathCounts generic, paths;     // to the generic member: the total degree; to this one
    bool followed;                             // from the generic member's roots, not from a total-degree start again
    std::vector<std::uint64_t> generic_roots;  // of the generic members that were solved: the last two agree
    std::uint64_t distinct, real;              // real: n and -n, and all points of a circle in its plane
    std::vector<RelativeEquilibrium> equilibria{};
    std::vector<std::string> families{};  // in words: what is not isolated though no circle was expected
    std::vector<std::string> failures{};
    std::string alarms;
    std::uint64_t proved_distinct = 0, proved_real = 0;
    double seconds, generic_seconds, proving_seconds = 0;
};

inline constexpr int most_solved_modes = 2;

/// The systems of a body with K modes a direction, solved once, at generic stiffnesses, moments and speed or momentum,
/// for any number of members.
template <int K, equilibria::mechanisms::BeamControl Control>
class BodyBeamSolver {
public:
    using Model = equilibria::mechanisms::BodyBeamFamily<K, Control>;

    /// Of the body only masses, centre and length matter, p[coupling], which is 0 or 1, and whether turning it about
    /// the third axis changes nothing.
    BodyBeamSolver(const BodyBeamValues& body, BodyBeamRun run);
    /// At any stiffnesses and moments, and the speed or the momentum of p.
    RelativeEquilibria operator()(const BodyBeamValues& p) const;

private:
    equilibria::RunOptions options() const;

    BodyBeamRun run_;
    bool circles_, agreed_ = false;
    equilibria::RootSet<Model> generic_;
    std::vector<std::uint64_t> generic_roots_;  // of each member that was drawn
    double generic_seconds_ = 0;
};
