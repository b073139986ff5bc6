/// \file
/// A point of a bifurcation locus.
#pragma once

#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The curves of a locus.
enum class LocusKind { fold, pitchfork };

/// A point of a curve of the locus.
template <Model M>
struct LocusPoint {
    double x = 0, y = 0;  ///< the two parameters
    Unknowns<M> q;        ///< the degenerate equilibrium
    Unknowns<M> v;        ///< its unit null vector
};

}  // namespace equilibria
