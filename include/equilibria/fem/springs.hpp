/// \file
/// Springs of discrete models.
#pragma once

#include <array>
#include <cmath>

#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

/// Resists the rotation between two nodes: stiffness |Psi|^2 / 2, exp(Psi) = R_A^T R_B, |Psi| below 2 pi.
struct RotationSpring {
    /// As of every element, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr std::array components{rx, ry, rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    double stiffness;  ///< moment by angle, per radian

    /// stiffness |Psi|^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> psi = rotation_vector(Eigen::Quaternion<T>(at[0].q.conjugate() * at[1].q));
        return 0.5 * stiffness * psi.dot(psi);
    }
};

/// The same in the plane, about z: the rotation may go through any number of turns of both together.
struct PlanarRotationSpring {
    /// As of every element, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr std::array components{rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    double stiffness;  ///< moment by angle, per radian

    /// stiffness angle^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 2>& at, const T&) const {
        using std::atan2;
        const Eigen::Quaternion<T> q = at[0].q.conjugate() * at[1].q;
        const T angle = T(2.0) * atan2(q.z(), q.w());
        return 0.5 * stiffness * angle * angle;
    }
};

/// Holds a node at a place by a spring along each fixed axis, in space (Dimension 3) or in the plane (2).
template <int Dimension>
struct PointSpring {
    /// As of every element, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1;
    static constexpr auto components = position_components<Dimension>();
    static constexpr bool depends_on_parameter = false;
    /// \}
    Eigen::Vector3d stiffness;  ///< along each axis
    Eigen::Vector3d origin;     ///< where no spring has a force

    /// sum stiffness_c (x_c - origin_c)^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 1>& at, const T&) const {
        T y(0.0);
        for (int c = 0; c < Dimension; ++c) {
            const T d = at[0].x(c) - T(origin(c));
            y = y + 0.5 * stiffness(c) * d * d;
        }
        return y;
    }
};

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<RotationSpring>;
extern template class ElementGroupOf<PlanarRotationSpring>;
extern template class ElementGroupOf<PointSpring<2>>;
extern template class ElementGroupOf<PointSpring<3>>;
#endif

}  // namespace equilibria::fem
