/// \file
/// See locus/plane/locus_result.hpp.
#pragma once

#include <sstream>
#include <string>

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
        << " special points of curves were not solved for; " << e.wrong_counts << " of " << e.checked_points
        << " enumerations differ from their region, and " << e.wrong_borders
        << " borders of regions have tables that no fold or pitchfork explains";
    if (!e.complete()) out << "; NOT COMPLETE";
    return out.str();
}

}  // namespace equilibria
