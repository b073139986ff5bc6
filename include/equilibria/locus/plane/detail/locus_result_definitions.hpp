/// \file
/// See locus/plane/locus_result.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

#include <equilibria/locus/plane/locus_result.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::string LocusEvidence::argument() const {
    std::ostringstream out;
    const auto add = [&](const char* what, SingularityKind kind) {
        const auto of_kind = solved.find(kind);
        if (of_kind == solved.end()) return;
        const SolutionCounts& c = of_kind->second;
        if (c.searches == 0) return;
        out << "; " << what << ": " << c.paths.total << " paths, " << c.solutions << " regular complex solutions, "
            << c.paths.failed << " failed";
        if (c.attempts > c.searches)
            out << " (start system " << c.attempts << " of as many as " << c.searches << " needed)";
    };
    const LocusEvidence& e = *this;
    out << "a curve that enters the window crosses its border";
    out << " (moved in by " << e.inset[0] << " and " << e.inset[1] << " of it)";
    out << ", a line of which all folds and pitchforks are solved for; one "
           "that does not has a cusp or points with vertical and horizontal tangents, all of which are solved for";
    add("folds of a line", SingularityKind::fold);
    add("cusps", SingularityKind::cusp);
    add("such tangents of fold curves", SingularityKind::extremal_fold);
    add("of pitchfork curves", SingularityKind::extremal_pitchfork);
    add("degenerate pitchforks", SingularityKind::tricritical_pitchfork);
    out << "; " << e.seeds << " points in the window, " << e.untraced_seeds << " of them on no curve; "
        << e.unseeded_crossings << " crossings of " << e.lines << " lines and " << e.unsolved_points
        << " special points of curves were not solved for, and " << e.broken_curves << " ends of curves break off; "
        << e.wrong_counts << " of " << e.checked_points << " enumerations differ from their region, and "
        << e.wrong_borders << " borders of regions have tables that no fold or pitchfork explains";
    if (e.lines_from_infinity > 0)
        out << "; on " << e.lines_from_infinity
            << " lines all points at which equilibria come from infinity are solved for, " << e.seeds_from_infinity
            << " of them, and curves of that kind pass them, but for " << e.from_infinity
            << " faults; such a curve that crosses none of these lines is seen by enumerations alone";
    if (e.complete()) return out.str();
    out << "; NOT COMPLETE: ";
    if (e.all_failed_paths() > 0) out << e.all_failed_paths() << " paths failed";
    // one place of each kind
    std::array<bool, 8> said{};
    const char* before = e.all_failed_paths() > 0 ? ", " : "";
    for (const LocusFault& fault : e.faults) {
        if (std::exchange(said[static_cast<std::size_t>(fault.kind)], true)) continue;
        out << before << to_string(fault.kind) << " at (" << fault.point.x << ", " << fault.point.y << ")";
        before = ", ";
    }
    return out.str();
}

EQUILIBRIA_INLINE void LocusEvidence::add(LocusFaultKind kind, const PlanePoint& point) {
    std::uint64_t* const counts[] = {&untraced_seeds, &unseeded_crossings, &unsolved_points, &broken_curves,
                                     &wrong_counts,   &wrong_borders,      &from_infinity,   &degenerate_lines};
    ++*counts[static_cast<std::size_t>(kind)];
    faults.push_back({kind, point});
}

}  // namespace equilibria
