/// \file
/// Every isolated complex root of a system that is data, with a verdict on its completeness that says what was checked.
///
/// The system is solved in units that suit it (unit_scaling.hpp), and its roots are proved by Krawczyk's test. Where
/// they are as many as a theorem allows, nothing is missing. Where they are fewer, every path of a polyhedral start has
/// to be explained: by a proved root; by a multiple root, of which the local dual space has as many dimensions as paths
/// end there; by a curve of solutions; or by a root of a face system at infinity (path_limit.hpp). Paths that nothing
/// explains are followed again from starts with other seeds. What is left then is said, with the number of roots that
/// may be missing at most.
///
/// Source: D. N. Bernstein, The number of roots of a system of equations, Functional Analysis and its Applications 9
/// (1975) 183-185: a system has fewer isolated roots than the mixed volume only if a face system has a root.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/every_root_options.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/roots_verdict.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// All isolated complex roots of a system, and curves of solutions beside them.
struct EveryRoot {
    StartChoice start;            ///< from which `found` comes
    ComplexRoots<> found;         ///< the account of the paths, and the roots, regular ones first
    std::vector<char> confirmed;  ///< of each root that is singular: its multiplicity, `paths`, was confirmed
    /// A mark for each root: no imaginary part is 1e-8 (1 + |x|) or more, in units in which coefficients are about 1,
    /// and no other root is nearer to its conjugate than itself. What is proved of regular roots is in `proof`.
    std::vector<char> seems_real;
    ProofOfRoots proof;                             ///< of the regular ones
    std::vector<Family<RuntimeUnknowns>> families;  ///< curves and surfaces of solutions
    std::vector<DivergingPaths> at_infinity;        ///< explained paths, by their direction
    RootsVerdict verdict;                           ///< what is known of others
    int starts = 1;                                 ///< how many were tried
    double tracking_seconds = 0;                    ///< of the paths in double
    double seconds = 0;                             ///< of everything

    /// Isolated roots, each counted once; and real ones among them, of which that is proved.
    std::uint64_t distinct() const;
};

/// Marks of the roots that seem real, one for each root, as EveryRoot::seems_real has them. roots: in units in which
/// coefficients are about 1. angles: how many unknowns, the first ones, are angles, in radians.
std::vector<char> seem_real(std::span<const Root<RuntimeUnknowns>> roots, int angles);

/// Every isolated root of the system. choice: the start to begin with; a polyhedral one follows where it leaves
/// something open. Of a cancelled run the verdict is open, and what was not followed is counted. Throws InvalidArgument
/// where the run names a checkpoint, and where options are out of range.
EveryRoot every_root(const SparseSystem& system, const StartChoice& choice, const RunOptions& run = {},
                     const EveryRootOptions& options = {});

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/every_root_definitions.hpp>
#endif
