/// \file
/// All relative equilibria of a body with a beam, as BodyBeamSolver finds them, whatever the number of modes: records
/// that know no solver. See body_beam_solver.hpp.
///
/// Lengths, masses and times are in any consistent units in which the beam's line density is 1; vectors are in the body
/// frame of RotatingBodyBeamBase.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <equilibria/paths/path_counts.hpp>

namespace equilibria::mechanisms {

/// A relative equilibrium: the body turns uniformly about a principal axis of its deformed shape, (2.6) of Baillieul. n
/// and -n are one, turning either way.
struct BodyBeamEquilibrium {
    /// n, |n| = 1, the largest component positive. Of a circle: in the plane of the axes 1 and 3, n_3 positive; or
    /// where n_3 is 0, n_1.
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    std::vector<double> modes;                          ///< u1, u2, u3, K each, as of RotatingBodyBeam<K>
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< J(u), (2.5), about the common centre of mass
    double moment = 0;                                  ///< lambda: J n = lambda n
    double speed = 0;                                   ///< omega, radians a unit of time
    double momentum = 0;                                ///< the size of the angular momentum: lambda omega
    double energy = 0;                                  ///< V(u) + lambda omega^2 / 2
    int index = 0;                                      ///< of momentum_hessian(): at fixed momentum
    int nullity = 0;                                    ///< of the same; 1 on a circle
    double residual = 0;                                ///< as of the enumeration's root
    double condition = 0;                               ///< as of the enumeration's root
    bool circle = false;                                ///< one of a circle, turned about the third axis
    bool proved = false;  ///< by Krawczyk's operator, an isolated real solution; by prove() alone

    /// Damping leads to it: a minimum of the energy at fixed momentum, but for the turn of a circle.
    bool stable() const { return index == 0 && nullity == (circle ? 1 : 0); }
};

/// All that an enumeration of relative equilibria says.
struct BodyBeamEquilibria {
    PathCounts generic;     ///< to the generic member
    std::string start;      ///< the start of those
    PathCounts paths;       ///< to this one
    bool followed = false;  ///< from the generic member's roots; else that is too irregular, and the start is the same
    std::vector<std::uint64_t> generic_roots;     ///< of each generic member that was solved: the last two should agree
    std::uint64_t distinct = 0;                   ///< complex solutions
    std::uint64_t real = 0;                       ///< n and -n among them, and all points of a circle in its plane
    std::vector<BodyBeamEquilibrium> equilibria;  ///< by their index, one of each n and -n
    std::vector<std::string> families;            ///< in words: what is not isolated though no circle was expected
    std::vector<std::string> failures;            ///< in words: the paths that failed
    std::string alarms;                           ///< in words; empty: none
    std::uint64_t proved_distinct = 0;            ///< complex solutions proved; by prove() alone
    std::uint64_t proved_real = 0;                ///< real ones among these
    double generic_seconds = 0;                   ///< to solve the generic members
    double seconds = 0;                           ///< to follow their roots to this one
    double proving_seconds = 0;                   ///< by prove() alone

    /// Whether the run was cancelled: equilibria may be missing.
    bool cancelled() const { return generic.cancelled + paths.cancelled > 0; }
    /// Whether every path to this member ended at a regular solution or at infinity, and nothing speaks against it.
    bool accounted_for() const { return paths.failed == 0 && paths.singular == 0 && alarms.empty() && !cancelled(); }
};

}  // namespace equilibria::mechanisms
