/// \file
/// Whether anything speaks against an enumeration's count of equilibria: one definition for root sets and for streams.
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/enumerate/alarm.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/stability/morse.hpp>

namespace equilibria {

/// What the verdict rests on.
struct CountVerdict {
    const PathCounts* paths;             ///< how the paths ended
    const Alarms* alarms;                ///< tests that betray lost or doubled roots
    std::uint64_t distinct;              ///< roots
    std::uint64_t degenerate;            ///< real ones whose Hessian is singular
    std::vector<std::int64_t> by_index;  ///< nondegenerate equilibria of each index 0 .. n
    bool potential_on_torus;             ///< the unknowns are angles alone, and there is a potential
    bool curves = false;                 ///< curves of solutions were found

    bool cancelled() const { return paths->cancelled > 0; }  ///< some paths were not tracked
    /// Whether the Morse relations of the n-torus apply: only angles, a potential, no curve, nothing degenerate, a
    /// finished run. (Singular endpoints that are not real may lie on curves of equilibria.)
    bool morse_applies() const {
        return potential_on_torus && !curves && degenerate == 0 && paths->singular == 0 && !cancelled();
    }
    /// The Morse relations hold. False where they do not apply.
    bool morse() const { return morse_applies() && morse_relations(by_index).all(); }
    /// Nothing speaks against the count: the run was not cancelled, no path failed, every root is regular and reached
    /// by a path of its own, no alarm is raised, and the Morse relations hold where they apply.
    bool clean() const {
        return !cancelled() && !alarms->raised() && paths->failed == 0 && paths->singular == 0 && degenerate == 0 &&
               paths->finite == distinct && (!morse_applies() || morse());
    }
};

}  // namespace equilibria
