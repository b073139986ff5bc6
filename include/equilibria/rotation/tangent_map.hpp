/// \file
/// How rotation vectors change with the rotation: Omega = T(Psi) dPsi/dt, the material angular velocity
/// (Cardona and Huespe 1999, (7) and (8)), its inverse, and derivatives of both (24).
///
///     T      = I - c_2 Psi~ + c_3 Psi~^2                      material (right): R^T dR = (T dPsi)~
///     T^T    = I + c_2 Psi~ + c_3 Psi~^2                      spatial (left):   dR R^T = (T^T dPsi)~
///     T^(-1) = I + Psi~ / 2 + (c_3 - 2 c_4) / (2 c_2) Psi~^2  singular at psi = 2 pi, as det T = 2 c_2 says
///
/// with the Stumpff functions c_k of psi^2. All of them, and exp, have the form I + f Psi~ + g Psi~^2 with f and g
/// smooth in psi^2, which is differentiated once for all.
#pragma once

#include <equilibria/rotation/rotation_vector.hpp>

namespace equilibria {

/// I + f Psi~ + g Psi~^2, with f and g functions of psi^2 and their derivatives (2 d/d(psi^2), once and twice).
template <class T>
struct AxialMap {
    Vector3<T> psi;  ///< Psi
    Array<T, 3> f;   ///< f and its derivatives
    Array<T, 3> g;   ///< g and its derivatives

    /// The matrix.
    Matrix3<T> value() const {
        const Matrix3<T> s = skew(psi);
        return Matrix3<T>::Identity() + f[0] * s + g[0] * s * s;
    }
    /// The map whose matrix is the transpose.
    AxialMap transposed() const {
        AxialMap y = *this;
        for (T& a : y.f) a = -a;
        return y;
    }
    /// The derivative of the matrix as Psi changes by d.
    Matrix3<T> derivative(const Vector3<T>& d) const {
        const Matrix3<T> s = skew(psi), sd = skew(d);
        const T a = psi.dot(d);
        return f[1] * a * s + f[0] * sd + g[1] * a * s * s + g[0] * (sd * s + s * sd);
    }
    /// The second derivative, along d and e.
    Matrix3<T> second_derivative(const Vector3<T>& d, const Vector3<T>& e) const {
        const Matrix3<T> s = skew(psi), sd = skew(d), se = skew(e), s2 = s * s;
        const T a = psi.dot(d), b = psi.dot(e), c = d.dot(e);
        return (f[2] * a * b + f[1] * c) * s + f[1] * (a * se + b * sd) + (g[2] * a * b + g[1] * c) * s2 +
               g[1] * (a * (se * s + s * se) + b * (sd * s + s * sd)) + g[0] * (sd * se + se * sd);
    }
    /// The matrix G with G d = derivative(d) v: of (24), where the map is T^T and v a moment.
    Matrix3<T> gradient(const Vector3<T>& v) const {
        const Vector3<T> psi_v = psi.cross(v);
        const Matrix3<T> s = skew(psi), sv = skew(v);
        const Vector3<T> along = f[1] * psi_v + g[1] * psi.cross(psi_v);
        return along * psi.transpose() - f[0] * sv - g[0] * (skew(psi_v) + s * sv);
    }
};

/// R = exp(Psi~) (2) with its derivatives.
template <class T>
AxialMap<T> exponential_map(const Vector3<T>& psi) {
    const auto c = stumpff<6>(psi.dot(psi));
    return {
        psi, {{c[1], c[3] - c[2], 3 * c[5] - 3 * c[4] + c[3]}}, {{c[2], 2 * c[4] - c[3], 8 * c[6] - 5 * c[5] + c[4]}}};
}

/// T (8) with its derivatives; its transpose is the left (spatial) form.
template <class T>
AxialMap<T> tangent_map(const Vector3<T>& psi) {
    const auto c = stumpff<7>(psi.dot(psi));
    return {psi,
            {{-c[2], c[3] - 2 * c[4], 5 * c[5] - 8 * c[6] - c[4]}},
            {{c[3], 3 * c[5] - c[4], 15 * c[7] - 7 * c[6] + c[5]}}};
}

/// T^(-1) with its derivatives, psi below 2 pi.
template <class T>
AxialMap<T> inverse_tangent_map(const Vector3<T>& psi) {
    const auto c = stumpff<8>(psi.dot(psi));
    // g = n / m
    const T n[] = {c[3] - 2 * c[4], 5 * c[5] - c[4] - 8 * c[6], 33 * c[7] - 9 * c[6] + c[5] - 48 * c[8]};
    const T m[] = {2 * c[2], 4 * c[4] - 2 * c[3], 16 * c[6] - 10 * c[5] + 2 * c[4]};
    AxialMap<T> y{psi, {{T(0.5), T(0.0), T(0.0)}}, {}};
    y.g[0] = n[0] / m[0];
    y.g[1] = (n[1] - y.g[0] * m[1]) / m[0];
    y.g[2] = (n[2] - 2 * y.g[1] * m[1] - y.g[0] * m[2]) / m[0];
    return y;
}

}  // namespace equilibria
