/// \file
/// What moves without a force: a support that was forgotten, a mechanism.
#pragma once

#include <optional>

#include <equilibria/core/compiled.hpp>
#include <equilibria/fem/structure.hpp>

namespace equilibria::fem {

/// A motion that meets no stiffness, by the component that takes most part in it.
struct LooseMotion {
    int node = 0;              ///< number of the node
    Component component = ux;  ///< of this node
};

/// A motion along which K is 0 to rounding, one of several if there are; nothing where all meet a stiffness. No branch
/// can be followed from there. A slender beam of thousands of nodes looks alike: its bending is lost in rounding.
template <bool Conservative>
std::optional<LooseMotion> loose_motion(const BasicStructure<Conservative>& structure, const StructureState& q,
                                        double p);

}  // namespace equilibria::fem

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/fem/detail/loose_motion_definitions.hpp>
#endif
