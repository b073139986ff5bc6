/// \file
/// Where a node is and how it is turned, and the unknowns of its motion.
#pragma once

#include <array>

#include <equilibria/rotation/rotation_vector.hpp>

namespace equilibria::fem {

/// A node's unknowns: its position in fixed axes, and right (material) increments of its rotation, radians.
enum Component { ux, uy, uz, rx, ry, rz };
/// "ux", "uy", "uz", "rx", "ry" or "rz".
constexpr const char* to_string(Component c) {
    constexpr const char* names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
    return names[c];
}

/// What elements use of their nodes: all in space.
inline constexpr std::array spatial{ux, uy, uz, rx, ry, rz};
inline constexpr std::array positions{ux, uy, uz};     ///< in space, without rotations
inline constexpr std::array planar{ux, uy, rz};        ///< in the x-y plane
inline constexpr std::array planar_positions{ux, uy};  ///< in the x-y plane, without rotations

/// `spatial` or `planar`, by the dimension, 3 or 2.
template <int Dimension>
constexpr auto motion_components() {
    static_assert(Dimension == 2 || Dimension == 3);
    if constexpr (Dimension == 3)
        return spatial;
    else
        return planar;
}
/// `positions` or `planar_positions`, by the dimension, 3 or 2.
template <int Dimension>
constexpr auto position_components() {
    static_assert(Dimension == 2 || Dimension == 3);
    if constexpr (Dimension == 3)
        return positions;
    else
        return planar_positions;
}

/// A node: its position, and the rotation from its initial orientation, which is that of the fixed axes.
template <class T>
struct Frame {
    Vector3<T> x = Vector3<T>::Zero();                                              ///< position, in fixed axes
    Eigen::Quaternion<T> q = Eigen::Quaternion<T>(T(1.0), T(0.0), T(0.0), T(0.0));  ///< of unit length

    /// The rotation matrix: material components to spatial ones.
    Matrix3<T> rotation() const { return q.toRotationMatrix(); }
};

/// The frame moved by an increment (dx, dPsi): x + dx and q exp(dPsi).
inline Frame<double> retract(const Frame<double>& at, const Vector3<double>& dx, const Vector3<double>& dpsi) {
    if (dpsi.isZero(0)) return {at.x + dx, at.q};
    return {at.x + dx, (at.q * quaternion(dpsi)).normalized()};
}

}  // namespace equilibria::fem
