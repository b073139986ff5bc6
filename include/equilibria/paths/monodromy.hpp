/// \file
/// All roots of a generic member of a family of systems from a single one, by loops in the space of the parameters: for
/// families whose members have far fewer roots than their equations' mixed volume, of which other starts track them
/// all.
///
/// Along a loop of complex parameters roots change places. Where the pairs (root, parameters) are one irreducible
/// variety, as they are where the parameters that enter linearly can make any point a root, loops lead from each root
/// to every other; so each loop that all known roots follow finds some more, about as many as are known, until there
/// are none left (Duff, Hill, Jensen, Lee, Leykin, Sommars, Solving polynomial systems via homotopy continuation and
/// monodromy, IMA J. Numer. Anal. 39 (2019)). The loops are triangles of arcs (start/coefficient_path.hpp) by two
/// random members: two arcs between the same two enclose less, and find less. The first root is got with its
/// parameters, by Newton's method with least steps from a random point in unknowns and parameters, and followed to the
/// generic member.
///
/// When to stop: after a loop without a new root a trace test is made. Constants s c, c random, are added to the
/// equations, and the roots are followed from s = 0 to s = 1 and s = -1. Over all roots the sums of exp(i theta),
/// exp(-i theta) and the coordinates are rational in s, and affine where no root comes from infinity on the way and
/// none grows faster than s; over a part of the roots they are neither (Sommese, Verschelde, Wampler, Symmetric
/// functions applied to decomposing solution varieties, J. Symbolic Comput. 33 (2002); Leykin, Rodriguez, Sottile,
/// Trace test, Arnold Math. J. 4 (2018)). So affine sums end the search. Sums that are not affine do not say that a
/// root is missing; then it ends after several loops without a new root.
///
/// Neither is a proof. Where the pairs have several components (a symmetry, solutions at rest) loops stay in those of
/// the roots that are known, and affine sums may be those of some components; where components hang together by few
/// points, a loop seldom leads from one to the other. So after each loop without a new root Newton's method looks for
/// others from random points, of the generic member and of random ones: it finds what it finds. Of the 182 roots of a
/// body with a beam and coupled strain 20 searches of 20 found all; with 6 quiet loops 14 did, the others 166 to 180.
/// Two seeds that agree, a count that is known from elsewhere, or a bound that is reached say more.
///
/// A search takes 10 to 80 paths a root. It pays where the mixed volume is larger still, or where the generic member
/// serves many others.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

/// When a search ends, and what it leaves alone.
struct MonodromyOptions {
    int quiet_loops = 10;  ///< so many loops without a new root, one after the other, end the search
    int most_loops = 100;  ///< so many in all end it in any case
    int newton_starts =
        100;  ///< random points for Newton's method, at most for the first root, and after each quiet loop
    std::vector<int> fixed = {};  ///< numbers of parameters that stay at their typical values: switches, integers

    /// Throws InvalidArgument for options out of range.
    void validate() const;
};

/// What ended a search.
enum class MonodromyEnd : std::uint8_t {
    trace_test,   ///< the sums over the roots are affine
    quiet_loops,  ///< several loops found nothing new
    most_loops,   ///< the loops ran out
    no_root,      ///< Newton's method found no first root
    cancelled     ///< the run was cancelled
};
/// In words, as results name it.
std::string_view to_string(MonodromyEnd end);

/// The roots that a search found, the generic member that they are roots of, and the evidence.
struct MonodromyRoots {
    std::vector<std::complex<double>> parameters;  ///< of a generic member
    std::vector<Root<RuntimeUnknowns>> roots;      ///< its roots, in the order of their discovery
    MonodromyEnd end = MonodromyEnd::no_root;      ///< which of the rules it was
    int loops = 0;                                 ///< number of all loops
    int quiet_loops = 0;                           ///< loops at the end without a new root
    int newton_starts = 0;                         ///< for the first root
    std::uint64_t found_by_newton = 0;  ///< roots that Newton's method found before a loop did, but for the first
    std::uint64_t paths = 0;            ///< number of paths that were tracked
    std::uint64_t lost = 0;             ///< those that reached no regular root
    /// The second difference of the sums, relative to their terms, in the last trace test; NaN where there was none, or
    /// paths of it were lost.
    double trace = 0;
    std::uint64_t seed = 0;  ///< that of the run
    double seconds = 0;      ///< of wall-clock time

    /// Whether one of the two rules ended the search: nothing speaks against there being no other root.
    bool closed() const { return end == MonodromyEnd::trace_test || end == MonodromyEnd::quiet_loops; }
    /// What was done and what it says, in a sentence.
    std::string sentence() const;
};

/// typical: parameters of the size that they are asked for at; a typical 0 stands for the size 1. The result is the
/// same for a seed, whatever the executor. Throws InvalidArgument where the family has no parameters that are free,
/// where there are other numbers of them, where no arcs to random members avoid the poles of the coefficients, where
/// the run names a checkpoint or options are out of range. The run's progress is told the loops.
MonodromyRoots monodromy(const SystemFamily& family, std::span<const double> typical, const RunOptions& run = {},
                         const MonodromyOptions& options = {}, const TrackerOptions& tracker = {});

/// The solutions of the member at real parameters, from the roots of a generic member: as solve_along. As many paths as
/// there are roots.
ComplexRoots<> solve_from(const MonodromyRoots& generic, const SystemFamily& family, std::span<const double> p,
                          const RunOptions& run = {}, const TrackerOptions& options = {});

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/monodromy_definitions.hpp>
#endif
