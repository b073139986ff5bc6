/// \file
/// Circular arcs, as frames of curved beams.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace equilibria::fem {

/// A part of a circle, by t from 0 to 1.
struct Arc {
    Eigen::Vector3d first;    ///< an end
    Eigen::Vector3d normal;   ///< of the plane: the arc turns to the left about it
    Eigen::Vector3d tangent;  ///< at the first end
    Eigen::Vector3d inwards;  ///< there, towards the center
    double radius;            ///< of the circle
    double angle;             ///< of the arc from its first end to its last, radians

    /// From a to b, by way of m; nothing where they are on a line.
    static std::optional<Arc> through(const Eigen::Vector3d& a, const Eigen::Vector3d& m, const Eigen::Vector3d& b) {
        const Eigen::Vector3d u = m - a, v = b - m, chord = b - a, area = u.cross(v);
        const double size = u.norm() * v.norm();
        if (!(area.norm() > 1e-10 * size && std::isfinite(size) && chord.norm() > 0)) return {};
        Arc y;
        y.first = a;
        y.normal = area.normalized();
        y.angle = 2 * std::atan2(area.norm(), u.dot(v));  // twice the angle between u and v (Euclid III.20)
        y.radius = chord.norm() / (2 * std::sin(y.angle / 2));
        const Eigen::Vector3d d = chord.normalized();
        y.tangent = std::cos(y.angle / 2) * d - std::sin(y.angle / 2) * y.normal.cross(d);
        y.inwards = y.normal.cross(y.tangent);
        return y;
    }
    /// The point at t.
    Eigen::Vector3d at(double t) const {
        const double half = std::sin(angle * t / 2);
        return first + radius * (std::sin(angle * t) * tangent + 2 * half * half * inwards);
    }
    /// Unit tangent at t.
    Eigen::Vector3d direction(double t) const { return std::cos(angle * t) * tangent + std::sin(angle * t) * inwards; }
    /// The least angle between v, or -v, and the arc's directions: from 0 to pi / 2.
    double clearance(const Eigen::Vector3d& v) const {
        const double x = v.dot(tangent), y = v.dot(inwards), phi = std::atan2(y, x);
        const bool passes = std::fmod(phi + 2 * std::numbers::pi, std::numbers::pi) <= angle;
        const double nearest = passes ? 1.0 : std::max(std::abs(std::cos(phi)), std::abs(std::cos(angle - phi)));
        return std::acos(std::min(1.0, nearest * std::hypot(x, y) / v.norm()));
    }
};

}  // namespace equilibria::fem
