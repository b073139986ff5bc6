/// \file
/// Rotations by rotation vectors Psi = psi n (Cardona and Huespe 1999, (1)): an axis n and an angle psi, in radians.
///
///     R = exp(Psi~) = I + sin psi / psi Psi~ + (1 - cos psi) / psi^2 Psi~^2            (2)
///     right (material) increment: R exp(dPsi), components in the rotated axes           (16)
///     left (spatial) increment:   exp(dpsi) R, components in the fixed axes
///
/// Unit quaternions hold a rotation without singularities; q and -q hold the same one. What is computed from half
/// angles and Stumpff functions is good to a few units in the last place from psi = 0 to 2 pi, for T a floating-point
/// number, a multiprecision one, or a Dual of these.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/rotation/stumpff.hpp>

namespace equilibria {

/// Vectors and matrices of space, of any scalar.
/// \{
template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
/// \}

/// Psi~, the skew matrix with Psi~ v = Psi x v (3).
template <class T>
Matrix3<T> skew(const Vector3<T>& psi) {
    Matrix3<T> y;
    y << T(0.0), -psi(2), psi(1), psi(2), T(0.0), -psi(0), -psi(1), psi(0), T(0.0);
    return y;
}

/// The rotation matrix of a rotation vector (2).
template <class T>
Matrix3<T> rotation_matrix(const Vector3<T>& psi) {
    const auto c = stumpff<3>(psi.dot(psi));
    const Matrix3<T> s = skew(psi);
    return Matrix3<T>::Identity() + c[1] * s + c[2] * s * s;
}

/// The unit quaternion (cos(psi/2), sin(psi/2) n) of a rotation vector: continuous in Psi, so -1 at psi = 2 pi.
template <class T>
Eigen::Quaternion<T> quaternion(const Vector3<T>& psi) {
    const auto c = stumpff<2>(T(T(0.25) * psi.dot(psi)));
    const Vector3<T> v = T(0.5) * c[1] * psi;
    return {c[0], v(0), v(1), v(2)};
}

/// The rotation vector of a unit quaternion, psi from 0 to 2 pi: the inverse of `quaternion`. At psi = 2 pi the axis is
/// not determined and the result 0.
template <class T>
Vector3<T> rotation_vector(const Eigen::Quaternion<T>& q) {
    using std::atan2, std::sqrt;
    const Vector3<T> v = q.vec();
    const T v2 = v.dot(v);
    const double v2_plain = static_cast<double>(detail::without_derivatives(v2));
    if (v2_plain < 1e-3 && detail::without_derivatives(q.w()) > 0) {
        // psi / |v| = 2 atan(t) / (t w), t = |v| / w, by the series of atan
        using Plain = std::remove_cvref_t<decltype(detail::without_derivatives(v2))>;
        const T t2 = v2 / (q.w() * q.w());
        const double least = 0.01 * static_cast<double>(std::numeric_limits<Plain>::epsilon());
        int terms = 3;
        for (double power = 1; power > least; power *= v2_plain * 1.01, ++terms);
        T y(0.0);
        for (int k = terms; k >= 0; --k) y = T(1.0) / T(2.0 * k + 1) - t2 * y;
        return T(2.0) * y / q.w() * v;
    }
    if (v2_plain == 0) return v;
    const T length = sqrt(v2);
    return T(2.0) * atan2(length, q.w()) / length * v;
}

/// The shortest rotation vector of a unit quaternion, psi from 0 to pi: the same for q and -q.
template <class T>
Vector3<T> shortest_rotation_vector(const Eigen::Quaternion<T>& q) {
    if (detail::without_derivatives(q.w()) < 0)
        return rotation_vector(Eigen::Quaternion<T>(-q.w(), -q.x(), -q.y(), -q.z()));
    return rotation_vector(q);
}

/// The rotation vector of a rotation matrix, psi from 0 to pi: the logarithm of (2).
template <class T>
Vector3<T> rotation_vector(const Matrix3<T>& r) {
    return shortest_rotation_vector(Eigen::Quaternion<T>(r));
}

/// The rotation vector of exp(a) exp(b) (16), psi from 0 to 2 pi: b a right (material) increment of a, or a a left
/// (spatial) one of b. Along small increments of one of them it is continuous up to psi = 2 pi.
template <class T>
Vector3<T> compose(const Vector3<T>& a, const Vector3<T>& b) {
    return rotation_vector(Eigen::Quaternion<T>(quaternion(a) * quaternion(b)));
}

}  // namespace equilibria
