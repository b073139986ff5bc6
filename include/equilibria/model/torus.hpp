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
#include <equilibria/model/equations.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The angle in (-pi, pi] that differs from `angle` by whole turns, both in radians; NaN where it is not finite.
inline double wrap(double angle) {
    const double y = std::remainder(angle, 2 * std::numbers::pi);
    return y <= -std::numbers::pi ? std::numbers::pi : y;
}

// Of configurations of a model M, or of so many unknowns at run time.

/// The same configuration with every angle in (-pi, pi].
/// \{
template <class Q>
Q wrapped(const RuntimeSizes& sizes, Q q) {
    for (int i = 0; i < sizes.angles; ++i) q[i] = wrap(q[i]);
    return q;
}
template <ModelSizes M>
Unknowns<M> wrapped(const Unknowns<M>& q) {
    return wrapped(RuntimeSizes(Sizes<M>()), q);
}
/// \}

/// The mirror image of a configuration: every angle with the other sign.
/// \{
template <class Q>
Q mirrored(const RuntimeSizes& sizes, Q q) {
    for (int i = 0; i < sizes.angles; ++i) q[i] = -q[i];
    return q;
}
template <ModelSizes M>
Unknowns<M> mirrored(const Unknowns<M>& q) {
    return mirrored(RuntimeSizes(Sizes<M>()), q);
}
/// \}

/// b - a, angles the shorter way around, in (-pi, pi].
/// \{
template <class Q>
Q displacement(const RuntimeSizes& sizes, const Q& a, const Q& b) {
    Q d = b;
    for (int i = 0; i < sizes.unknowns; ++i) d[i] -= a[i];
    return wrapped(sizes, d);
}
template <ModelSizes M>
Unknowns<M> displacement(const Unknowns<M>& a, const Unknowns<M>& b) {
    return displacement(RuntimeSizes(Sizes<M>()), a, b);
}
/// \}

/// The largest |entry| of the displacement from a to b; NaN where one is.
/// \{
template <class Q>
double distance(const RuntimeSizes& sizes, const Q& a, const Q& b) {
    double y = 0;
    for (const double d : displacement(sizes, a, b)) {
        if (std::isnan(d)) return d;
        y = std::max(y, std::abs(d));
    }
    return y;
}
template <ModelSizes M>
double distance(const Unknowns<M>& a, const Unknowns<M>& b) {
    return distance(RuntimeSizes(Sizes<M>()), a, b);
}
/// \}

/// Whether a and b are one configuration to within `tolerance`, in radians and units of the coordinates; false for NaN.
/// \{
template <class Q>
bool same_unknowns(const RuntimeSizes& sizes, const Q& a, const Q& b, double tolerance) {
    return distance(sizes, a, b) <= tolerance;
}
template <ModelSizes M>
bool same_unknowns(const Unknowns<M>& a, const Unknowns<M>& b, double tolerance) {
    return distance<M>(a, b) <= tolerance;
}
/// \}

}  // namespace equilibria
