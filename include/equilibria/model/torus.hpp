/// \file
/// The configuration space of a model, angles on a torus and coordinates on a line: angles in one turn, the distance of
/// two configurations, the mirror image theta -> -theta.
///
/// Angles are in radians. Two configurations are apart by the largest difference of an unknown, an angle taken the
/// shorter way around; radians and units of the coordinates count alike, so that a tolerance suits models whose
/// coordinates are of the size of 1. Rounding: an angle of many turns is known to its own rounding alone, 1e-16 of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <equilibria/core/array.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The angle in (-pi, pi] that differs from `angle` by whole turns, both in radians; NaN where it is not finite.
inline double wrap(double angle) {
    const double y = std::remainder(angle, 2 * std::numbers::pi);
    return y <= -std::numbers::pi ? std::numbers::pi : y;
}

/// The same configuration with every angle in (-pi, pi].
template <ModelSizes M>
Unknowns<M> wrapped(Unknowns<M> q) {
    for (int i = 0; i < n_angles<M>; ++i) q[i] = wrap(q[i]);
    return q;
}

/// The mirror image of a configuration: every angle with the other sign.
template <ModelSizes M>
Unknowns<M> mirrored(Unknowns<M> q) {
    for (int i = 0; i < n_angles<M>; ++i) q[i] = -q[i];
    return q;
}

/// b - a, angles the shorter way around, in (-pi, pi].
template <ModelSizes M>
Unknowns<M> displacement(const Unknowns<M>& a, const Unknowns<M>& b) {
    Unknowns<M> d;
    for (int i = 0; i < n_unknowns<M>; ++i) d[i] = b[i] - a[i];
    return wrapped<M>(d);
}

/// The largest |entry| of the displacement from a to b; NaN where one is.
template <ModelSizes M>
double distance(const Unknowns<M>& a, const Unknowns<M>& b) {
    double y = 0;
    for (const double d : displacement<M>(a, b)) {
        if (std::isnan(d)) return d;
        y = std::max(y, std::abs(d));
    }
    return y;
}

/// Whether a and b are one configuration to within `tolerance`, in radians and units of the coordinates; false for NaN.
template <ModelSizes M>
bool same_unknowns(const Unknowns<M>& a, const Unknowns<M>& b, double tolerance) {
    return distance<M>(a, b) <= tolerance;
}

}  // namespace equilibria
