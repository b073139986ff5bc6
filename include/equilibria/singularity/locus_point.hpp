/// \file
/// A point of a bifurcation locus.
#pragma once

#include <cmath>
#include <numbers>

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

namespace detail {

/// Whether a is b, or its mirror image theta -> -theta (mirror = -1), to within the tolerance; angles modulo 2 pi.
template <Model M>
bool same_unknowns(const Unknowns<M>& a, const Unknowns<M>& b, double tolerance, int mirror = 1) {
    for (int i = 0; i < n_unknowns<M>; ++i) {
        const double d = a[i] - (i < n_angles<M> ? mirror : 1) * b[i];
        if (!(std::abs(i < n_angles<M> ? std::remainder(d, 2 * std::numbers::pi) : d) <= tolerance)) return false;
    }
    return true;
}

}  // namespace detail

}  // namespace equilibria
