/// \file
/// What tracing a locus returns: curves, cusps, regions, and the evidence that nothing is missing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line_events.hpp>
#include <equilibria/locus/regions.hpp>

namespace equilibria {

/// A point of a curve of the locus.
template <Model M>
struct LocusPoint {
    double x = 0, y = 0;  ///< the two parameters
    Unknowns<M> q;        ///< the degenerate equilibrium
    Unknowns<M> v;        ///< its unit null vector
};

/// Why a curve ends.
enum class CurveEnd {
    window,     ///< at the border of the window
    closed,     ///< where it began
    symmetric,  ///< on a symmetric branch, where a fold curve meets a pitchfork curve and turns into its mirror image
    step,       ///< the step control gave up
    length      ///< too many points
};

template <Model M>
struct LocusCurve {
    LocusKind kind;
    std::vector<LocusPoint<M>> points;
    std::array<CurveEnd, 2> ends;
};

/// A cusp (A3): third = 0, fourth != 0.
template <Model M>
struct Cusp {
    LocusPoint<M> at;
    double residual;  ///< the largest of |F|, |J v| and |third|
    double fourth;    ///< the reduced fourth derivative
};

/// A region of constant count.
struct LocusRegion {
    PlanePoint point;                    ///< well inside
    std::uint64_t count = 0;             ///< real equilibria there
    std::vector<std::int64_t> by_index;
    double area = 0;
    bool clean = false;      ///< the enumeration at the point had nothing against it (RootSet::clean)
    bool confirmed = true;   ///< no other enumeration inside the region differed
};

template <Model M>
struct Locus {
    PlaneWindow window;
    Parameters<M> parameters;
    std::vector<LocusCurve<M>> curves;
    std::vector<Cusp<M>> cusps;
    std::vector<LocusPoint<M>> degenerate_pitchforks;  ///< where a pitchfork turns from super- to subcritical
    std::vector<LocusRegion> regions;

    /// The evidence of completeness; all but the first three must be 0.
    struct Evidence {
        std::uint64_t lines = 0, seeds = 0, checked_points = 0;
        std::uint64_t failed_paths = 0;        ///< of the lines' enumerations
        std::uint64_t untraced_seeds = 0;      ///< events on lines that no curve passes
        std::uint64_t unseeded_crossings = 0;  ///< crossings of curves and lines that are no event of the line
        std::uint64_t broken_curves = 0;       ///< curves that the step control gave up
        std::uint64_t wrong_counts = 0;        ///< checked points whose count is not their region's
        double seconds = 0;
        bool complete() const {
            return failed_paths + untraced_seeds + unseeded_crossings + broken_curves + wrong_counts == 0;
        }
    } evidence;
};

}  // namespace equilibria
