/// \file
/// What a search for curves of cusps returns: curves, the planes that were solved for their cusps, and the evidence
/// that nothing is missing.
#pragma once

#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/locus/space/cusp_curve_result.hpp>
#include <equilibria/paths/solution_counts.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// A plane z = const of which all cusps are solved for.
template <PotentialModel M>
struct CuspPlane {
    double z = 0;                       ///< where it is
    std::vector<Singularity<M>> cusps;  ///< those within the box, one of a mirror pair
    std::uint64_t outside = 0;          ///< real cusps beyond the box, one of a mirror pair
    /// Real solutions on the faces of x and y that are no cusps, one of a mirror pair: the model is degenerate there,
    /// as without a mass, and all derivatives along the null vector are 0.
    std::uint64_t degenerate = 0;
    SolutionCounts counts;  ///< of the system of all cusps, real and complex

    /// A plane that was given up, as it left paths undecided or has fewer solutions than others: the model is
    /// degenerate there or next to it.
    struct GivenUp {
        double z = 0;                    ///< where it was
        std::uint64_t failed_paths = 0;  ///< paths left undecided
        std::uint64_t solutions = 0;     ///< regular complex ones
    };
    std::vector<GivenUp> given_up;  ///< in order; the last one was replaced by this plane
};

/// The curves of cusps in a box of three parameters.
template <PotentialModel M>
struct CuspLocus {
    Box box;                           ///< of the three parameters
    Parameters<M> parameters;          ///< all of the model's; those of the three do not matter
    std::vector<CuspCurve<M>> curves;  ///< one of a mirror pair
    std::vector<CuspPlane<M>> planes;  ///< ascending

    /// The evidence of completeness.
    struct Evidence {
        std::uint64_t cusps = 0;      ///< of the planes, within the box
        std::uint64_t crossings = 0;  ///< of the curves and the planes
        SolutionCounts solved;        ///< of all planes
        /// Parts of the range of z beyond the first and beyond the last plane.
        std::array<double, 2> beyond{};
        // what follows must be 0
        std::uint64_t missing_solutions = 0;        ///< regular ones that a plane has fewer than another, of all planes
        std::uint64_t untraced_cusps = 0;           ///< cusps of planes that no curve passes
        std::uint64_t unsolved_crossings = 0;       ///< crossings that are no cusp solved for
        std::uint64_t broken_curves = 0;            ///< curves that the step control gave up, or too long
        std::uint64_t unconfirmed_transitions = 0;  ///< that Newton's method did not find, or a higher kind
        double seconds = 0;                         ///< of the whole search

        /// Whether nothing speaks against the curves being complete.
        bool complete() const {
            return solved.paths.failed + missing_solutions + untraced_cusps + unsolved_crossings + broken_curves +
                       unconfirmed_transitions ==
                   0;
        }
    } evidence;  ///< what speaks for completeness, and against it

    bool complete() const { return evidence.complete(); }  ///< see Evidence::complete
    /// Why no curve is missing but those it names, or what speaks against it, in words.
    std::string argument() const;
};

template <PotentialModel M>
std::string CuspLocus<M>::argument() const {
    std::ostringstream out;
    const auto counted = [](std::uint64_t count, const char* one, const char* many) {
        return std::to_string(count) + ' ' + (count == 1 ? one : many);
    };
    const Evidence& e = evidence;
    std::uint64_t outside = 0, degenerate = 0;
    for (const auto& plane : planes) outside += plane.outside, degenerate += plane.degenerate;
    out << "all cusps of " << planes.size() << " planes are solved for: " << e.solved.paths.total << " paths, "
        << e.solved.paths.failed << " failed, " << e.solved.solutions << " regular complex solutions";
    if (e.missing_solutions > 0)
        out << ", " << e.missing_solutions << " fewer than if each plane had as many as the one with the most";
    out << "; " << counted(e.cusps, "cusp", "cusps") << " in the box, one of a mirror pair counted, "
        << e.untraced_cusps << " of them on no curve; " << outside << " outside the box";
    if (degenerate > 0)
        out << "; " << counted(degenerate, "solution", "solutions")
            << " on its faces left out, where the model is degenerate";
    out << "; " << counted(curves.size(), "curve crosses", "curves cross") << " the planes "
        << counted(e.crossings, "time", "times") << ", " << e.unsolved_crossings
        << " of them away from the cusps solved for";
    if (e.broken_curves > 0) out << "; " << counted(e.broken_curves, "curve is", "curves are") << " broken off";
    if (e.unconfirmed_transitions > 0)
        out << "; " << counted(e.unconfirmed_transitions, "transition is", "transitions are") << " not confirmed";
    for (const auto& plane : planes)
        for (const auto& given_up : plane.given_up)
            out << "; the plane at " << given_up.z << " was given up for that at " << plane.z << " ("
                << given_up.failed_paths << " paths failed, " << given_up.solutions << " regular solutions)";
    out << "; what could be missed is a curve that crosses no plane: a closed one, or one from face to face of the "
           "box, "
           "between two neighbours of ";
    for (std::size_t k = 0; k < planes.size(); ++k) out << (k > 0 ? ", " : "") << planes[k].z;
    if (e.beyond[0] > 0) out << ", or below " << planes.front().z;
    if (e.beyond[1] > 0) out << ", or above " << planes.back().z;
    if (!e.complete()) out << "; NOT COMPLETE";
    return out.str();
}

}  // namespace equilibria
