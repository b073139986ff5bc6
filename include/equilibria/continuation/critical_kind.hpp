/// \file
/// The kinds of critical points of a branch.
#pragma once

#include <cstddef>

namespace equilibria {

/// What a critical point of a branch is.
enum class CriticalKind {
    fold,           ///< limit point: the branch turns back in p
    transcritical,  ///< two branches cross, both transversal to p = const
    pitchfork,      ///< a branch leaves along the null vector
    isola_center,   ///< an isolated point of the set: the bifurcation equation has no real tangent
    hilltop,        ///< a fold and a bifurcation in one point, or tangential branches: the equation is degenerate
    cusp,           ///< a fold whose quadratic coefficient vanishes
    multiple,       ///< more than one null vector
    kinematic,      ///< dead point: the constraints lose rank, the null vector is one of multipliers alone
    // of lines of parameters alone (locus/line/line_events.hpp):
    from_infinity,  ///< equilibria come from infinity, or go there
    continuum,      ///< an equation vanishes identically: there are curves or surfaces of equilibria
    unexplained,    ///< the equilibria change, and it is not known how
};
/// In words, as the names above; isola_center is "isola centre".
constexpr const char* to_string(CriticalKind kind) {
    constexpr const char* names[] = {"fold",     "transcritical", "pitchfork",     "isola centre", "hilltop",    "cusp",
                                     "multiple", "kinematic",     "from infinity", "continuum",    "unexplained"};
    return names[static_cast<int>(kind)];
}
/// Whether other branches may leave there: all but folds and cusps.
constexpr bool is_bifurcation(CriticalKind kind) { return kind != CriticalKind::fold && kind != CriticalKind::cusp; }

/// Whether so many half branches through a point with so many null vectors are turns of one, by a continuous symmetry
/// along which K is singular: more than a discrete symmetry has, 12 of a hexagon, 26 of a cube.
constexpr bool leave_in_every_direction(int nullity, std::size_t half_branches) {
    return half_branches > (nullity <= 2 ? 12U : 20U * static_cast<unsigned>(nullity));
}

}  // namespace equilibria
