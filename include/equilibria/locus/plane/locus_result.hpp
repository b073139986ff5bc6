/// \file
/// What tracing a locus returns: curves, cusps, regions, and the evidence that nothing is missing.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/plane/curve_end.hpp>
#include <equilibria/locus/plane/infinity_curve.hpp>
#include <equilibria/locus/regions/plane_point.hpp>
#include <equilibria/paths/solution_counts.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// A curve of degenerate equilibria. M: the model, or RuntimeUnknowns.
template <class M>
struct LocusCurve {
    SingularityKind kind;                ///< fold or pitchfork
    std::vector<Singularity<M>> points;  ///< in order, neighbours a step apart
    std::array<CurveEnd, 2> ends;        ///< a fold curve that ends on a symmetric branch meets a pitchfork curve there
};

/// A region of constant count.
struct LocusRegion {
    PlanePoint point;                    ///< well inside
    std::uint64_t count = 0;             ///< real equilibria there
    std::vector<std::int64_t> by_index;  ///< those of index 0, 1, .. n
    double area = 0;                     ///< in the unit of x times that of y
    bool clean = false;                  ///< the enumeration at the point had nothing against it (RootSet::clean)
    bool confirmed = true;               ///< no other enumeration inside the region differed
    /// Polygons, counterclockwise, which overlap nowhere and whose union is the region.
    std::vector<std::vector<PlanePoint>> polygons;
};

/// What speaks against a locus being complete.
enum class LocusFaultKind {
    untraced_seed,      ///< a point solved for that no curve passes
    unseeded_crossing,  ///< a crossing of a curve and a line that was not solved for
    unsolved_point,     ///< a cusp or extremal point of a curve that was not solved for
    broken_curve,       ///< the end of a curve that the step control gave up
    wrong_count,        ///< an enumeration that differs from its region's
    wrong_border,       ///< a region next to another one whose table no fold or pitchfork explains
    from_infinity,      ///< equilibria come from infinity on no traced curve, or where such a curve breaks off
    degenerate_line     ///< a point of a generic line that is more than a fold, as on pitchfork curves off symmetric
                        ///< branches
};
/// In words.
constexpr const char* to_string(LocusFaultKind kind) {
    constexpr const char* names[] = {"a point on no curve",
                                     "a crossing that was not solved for",
                                     "a special point that was not solved for",
                                     "a curve that breaks off",
                                     "an enumeration that differs from its region",
                                     "a border that nothing explains",
                                     "equilibria that come from infinity",
                                     "a point of a line that is more than a fold"};
    return names[static_cast<int>(kind)];
}
/// One of these, and where.
struct LocusFault {
    LocusFaultKind kind;  ///< what is wrong
    PlanePoint point;     ///< where
};

/// The evidence of completeness.
struct LocusEvidence {
    std::uint64_t lines = 0;           ///< solved for their folds
    std::uint64_t seeds = 0;           ///< points solved for that curves must pass
    std::uint64_t checked_points = 0;  ///< compared with their region's count
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
    std::uint64_t from_infinity = 0;       ///< see LocusFaultKind::from_infinity
    std::uint64_t degenerate_lines = 0;    ///< see LocusFaultKind::degenerate_line
    /// Points of lines at which equilibria come from infinity, which curves of that kind must pass.
    std::uint64_t seeds_from_infinity = 0;
    std::uint64_t lines_from_infinity = 0;  ///< solved for such points; 0 of a model of angles alone
    std::vector<LocusFault> faults;         ///< places of what is counted above, but for failed paths
    double seconds = 0;                     ///< of the whole search

    /// Counts a fault, and keeps its place.
    void add(LocusFaultKind kind, const PlanePoint& point);

    /// Of the lines and of all searches.
    std::uint64_t all_failed_paths() const {
        std::uint64_t failed = failed_paths;
        for (const auto& [kind, counts] : solved) failed += counts.paths.failed;
        return failed;
    }
    /// Whether nothing speaks against the locus being complete.
    bool complete() const {
        return all_failed_paths() + untraced_seeds + unseeded_crossings + unsolved_points + broken_curves +
                   wrong_counts + wrong_borders + from_infinity + degenerate_lines ==
               0;
    }

    /// Why no curve and no cusp is missing, or what speaks against it, in words.
    std::string argument() const;
};

/// The degenerate equilibria of a model in a window of two parameters, and the regions that they bound.
template <class M>
struct Locus {
    Window window;                         ///< of the two parameters, x and y
    ParameterArray<M, double> parameters;  ///< all of the model's; those of x and y do not matter
    std::vector<LocusCurve<M>> curves;     ///< of folds and of pitchforks
    /// The special points of the curves, in the order in which they were found: cusps (with the derivatives phi''' and
    /// phi'''' of the reduced potential, residual the largest of |F|, |J v| and |phi'''|), tricritical pitchforks, and
    /// extremal folds and pitchforks, at which the parameter number `extremal` turns back on the curve.
    std::vector<Singularity<M>> points;
    /// Curves on which equilibria come from infinity, or go there; none of a model of angles alone.
    std::vector<InfinityCurve> from_infinity;
    std::vector<LocusRegion> regions;  ///< into which the curves cut the window
    /// Regions and curves by their numbers here; numbers from curves.size() on are those of `from_infinity`.
    std::vector<RegionBorder> borders;

    /// The special points of these kinds, in their order.
    std::vector<Singularity<M>> of(std::same_as<SingularityKind> auto... kinds) const {
        std::vector<Singularity<M>> found;
        for (const auto& at : points)
            if (((at.kind == kinds) || ...)) found.push_back(at);
        return found;
    }

    using Evidence = LocusEvidence;  ///< the type of `evidence`
    Evidence evidence;               ///< what speaks for completeness, and against it

    std::string argument() const { return evidence.argument(); }  ///< see LocusEvidence::argument
};

namespace detail {

/// `to` with everything of `from`, its points converted.
template <class To, class From>
To converted_locus(const From& from, To to, const auto& convert) {
    to.window = from.window;
    for (const auto& curve : from.curves) {
        to.curves.push_back({curve.kind, {}, curve.ends});
        for (const auto& at : curve.points) to.curves.back().points.push_back(convert(at));
    }
    for (const auto& at : from.points) to.points.push_back(convert(at));
    to.from_infinity = from.from_infinity;
    to.regions = from.regions;
    to.borders = from.borders;
    to.evidence = from.evidence;
    return to;
}

}  // namespace detail

/// The same locus, its numbers in arrays of a size known at run time, and back.
/// \{
template <Model M>
Locus<RuntimeUnknowns> runtime_locus(const Locus<M>& locus) {
    Locus<RuntimeUnknowns> y;
    y.parameters = runtime_array(locus.parameters);
    return detail::converted_locus(locus, y, [](const Singularity<M>& at) { return runtime_singularity(at); });
}
template <Model M>
Locus<M> typed(const Locus<RuntimeUnknowns>& locus) {
    Locus<M> y;
    y.parameters = parameters_from<M>(locus.parameters);
    return detail::converted_locus(locus, y, [](const RuntimeSingularity<>& at) { return typed<M>(at); });
}
/// \}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/plane/detail/locus_result_definitions.hpp>
#endif
