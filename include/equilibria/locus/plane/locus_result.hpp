/// \file
/// What tracing a locus returns: curves, cusps, regions, and the evidence that nothing is missing.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/locus/plane/curve_end.hpp>
#include <equilibria/locus/regions/regions.hpp>
#include <equilibria/paths/solution_counts.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

template <Model M>
struct LocusCurve {
    SingularityKind kind;  ///< fold or pitchfork
    std::vector<Singularity<M>> points;
    std::array<CurveEnd, 2> ends;  ///< a fold curve that ends on a symmetric branch meets a pitchfork curve there
};

/// A region of constant count.
struct LocusRegion {
    PlanePoint point;         ///< well inside
    std::uint64_t count = 0;  ///< real equilibria there
    std::vector<std::int64_t> by_index;
    double area = 0;
    bool clean = false;     ///< the enumeration at the point had nothing against it (RootSet::clean)
    bool confirmed = true;  ///< no other enumeration inside the region differed
    /// Polygons, counterclockwise, which overlap nowhere and whose union is the region.
    std::vector<std::vector<PlanePoint>> polygons;
};

template <Model M>
struct Locus {
    Window window;
    Parameters<M> parameters;
    std::vector<LocusCurve<M>> curves;
    /// The special points of the curves, in the order in which they were found: cusps (with the derivatives phi''' and
    /// phi'''' of the reduced potential, residual the largest of |F|, |J v| and |phi'''|), tricritical pitchforks, and
    /// extremal folds and pitchforks, at which the parameter number `extremal` turns back on the curve.
    std::vector<Singularity<M>> points;
    std::vector<LocusRegion> regions;
    std::vector<RegionBorder> borders;  ///< regions and curves by their numbers here

    /// The special points of these kinds, in their order.
    std::vector<Singularity<M>> of(std::same_as<SingularityKind> auto... kinds) const {
        std::vector<Singularity<M>> found;
        for (const auto& at : points)
            if (((at.kind == kinds) || ...)) found.push_back(at);
        return found;
    }

    /// The evidence of completeness.
    struct Evidence {
        std::uint64_t lines = 0, seeds = 0, checked_points = 0;
        /// By how much the borders of x and of y were moved in, in parts of the window: the model may degenerate on
        /// them. A piece of a curve that lies in a corner of that size, and has no special point, is not seen.
        std::array<double, 2> inset{};
        /// Complex solutions by kind: folds of a generic line in each direction, all special points of the plane.
        std::map<SingularityKind, SolutionCounts> solved;
        // what follows must be 0
        std::uint64_t failed_paths = 0;        ///< of the other lines
        std::uint64_t untraced_seeds = 0;      ///< points solved for that no curve passes
        std::uint64_t unseeded_crossings = 0;  ///< crossings of curves and lines that are no event of the line
        std::uint64_t unsolved_points = 0;     ///< cusps and extremal points of curves that were not solved for
        std::uint64_t broken_curves = 0;       ///< curves that the step control gave up
        std::uint64_t wrong_counts = 0;        ///< checked points whose count is not their region's
        std::uint64_t wrong_borders = 0;       ///< borders of regions whose tables by index do not fit
        double seconds = 0;

        std::uint64_t all_failed_paths() const {
            std::uint64_t failed = failed_paths;
            for (const auto& [kind, counts] : solved) failed += counts.paths.failed;
            return failed;
        }
        bool complete() const {
            return all_failed_paths() + untraced_seeds + unseeded_crossings + unsolved_points + broken_curves +
                       wrong_counts + wrong_borders ==
                   0;
        }
    } evidence;

    /// Why no curve and no cusp is missing, or what speaks against it, in words.
    std::string argument() const;
};

template <Model M>
std::string Locus<M>::argument() const {
    std::ostringstream out;
    const auto solved = [&](const char* what, SingularityKind kind) {
        const auto of_kind = evidence.solved.find(kind);
        if (of_kind == evidence.solved.end()) return;
        const SolutionCounts& c = of_kind->second;
        if (c.searches == 0) return;
        out << "; " << what << ": " << c.paths.total << " paths, " << c.solutions << " regular complex solutions, "
            << c.paths.failed << " failed";
        if (c.attempts > c.searches)
            out << " (start system " << c.attempts << " of as many as " << c.searches << " needed)";
    };
    const Evidence& e = evidence;
    out << "a curve that enters the window crosses its border";
    out << " (moved in by " << e.inset[0] << " and " << e.inset[1] << " of it)";
    out << ", a line of which all folds and pitchforks are solved for; one "
           "that does not has a cusp or points with vertical and horizontal tangents, all of which are solved for";
    solved("folds of a line", SingularityKind::fold);
    solved("cusps", SingularityKind::cusp);
    solved("such tangents of fold curves", SingularityKind::extremal_fold);
    solved("of pitchfork curves", SingularityKind::extremal_pitchfork);
    solved("degenerate pitchforks", SingularityKind::tricritical_pitchfork);
    out << "; " << e.seeds << " points in the window, " << e.untraced_seeds << " of them on no curve; "
        << e.unseeded_crossings << " crossings of " << e.lines << " lines and " << e.unsolved_points
        << " special points of curves were not solved for; " << e.wrong_counts << " of " << e.checked_points
        << " enumerations differ from their region, and " << e.wrong_borders
        << " borders of regions have tables that no fold or pitchfork explains";
    if (!e.complete()) out << "; NOT COMPLETE";
    return out.str();
}

}  // namespace equilibria
