/// \file
/// Springs of discrete models.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

/// Resists the rotation between two nodes: stiffness |Psi|^2 / 2, exp(Psi) = R_A^T R_B, |Psi| below 2 pi.
struct RotationSpring {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr std::array components{rx, ry, rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    double stiffness;  ///< moment by angle, per radian

    static constexpr std::array force_names{"M1", "M2", "M3"};  ///< see element.hpp
    /// The moment, in the axes of node A.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 2>& at, const ElementQuery&) const {
        const Vector3<double> m = stiffness * rotation_vector(Eigen::Quaternion<double>(at[0].q.conjugate() * at[1].q));
        return {{at[0].x, {m.begin(), m.end()}}};
    }

    /// stiffness |Psi|^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> psi = rotation_vector(Eigen::Quaternion<T>(at[0].q.conjugate() * at[1].q));
        return 0.5 * stiffness * psi.dot(psi);
    }
};

/// The same in the plane, about z: the rotation may go through any number of turns of both together.
struct PlanarRotationSpring {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr std::array components{rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    double stiffness;  ///< moment by angle, per radian

    static constexpr std::array force_names{"M"};  ///< see element.hpp
    /// The moment.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 2>& at, const ElementQuery&) const {
        const Eigen::Quaterniond q = at[0].q.conjugate() * at[1].q;
        return {{at[0].x, {stiffness * 2 * std::atan2(q.z(), q.w())}}};
    }

    /// stiffness angle^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 2>& at, const T&) const {
        using std::atan2;
        const Eigen::Quaternion<T> q = at[0].q.conjugate() * at[1].q;
        const T angle = T(2.0) * atan2(q.z(), q.w());
        return 0.5 * stiffness * angle * angle;
    }
};

/// Resists the rotation between two nodes, or of one node against the ground (Nodes 1), with a stiffness about each
/// fixed axis, as it is without load: sum stiffness_c Psi_c^2 / 2, exp(Psi) = R_A^T R_B or R, |Psi| below 2 pi.
template <int Nodes>
struct RotationSprings {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = Nodes;
    static constexpr std::array components{rx, ry, rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    Eigen::Vector3d stiffness;  ///< moment by angle, per radian, about each axis

    static constexpr std::array force_names{"M1", "M2", "M3"};  ///< see element.hpp
    /// The moments, in the axes of node A or of the ground.
    std::vector<InternalForce> forces(const std::array<Frame<double>, static_cast<std::size_t>(Nodes)>& at,
                                      const ElementQuery&) const {
        Eigen::Quaterniond q = at.back().q;
        if constexpr (Nodes == 2) q = at[0].q.conjugate() * q;
        const Vector3<double> m = stiffness.cwiseProduct(rotation_vector(q));
        return {{at[0].x, {m.begin(), m.end()}}};
    }

    /// sum stiffness_c Psi_c^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, static_cast<std::size_t>(Nodes)>& at, const T&) const {
        Eigen::Quaternion<T> q = at.back().q;
        if constexpr (Nodes == 2) q = at[0].q.conjugate() * q;
        const Vector3<T> psi = rotation_vector(q);
        T y(0.0);
        for (int c = 0; c < 3; ++c) y = y + 0.5 * stiffness(c) * psi(c) * psi(c);
        return y;
    }
};

/// A spring against the ground about z, in the plane: stiffness angle^2 / 2, |angle| below 2 pi.
struct PlanarGroundSpring {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1;
    static constexpr std::array components{rz};
    static constexpr bool depends_on_parameter = false;
    /// \}
    double stiffness;  ///< moment by angle, per radian

    static constexpr std::array force_names{"M"};  ///< see element.hpp
    /// The moment.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 1>& at, const ElementQuery&) const {
        return {{at[0].x, {stiffness * 2 * std::atan2(at[0].q.z(), at[0].q.w())}}};
    }

    /// stiffness angle^2 / 2.
    template <class T>
    T energy(const std::array<Frame<T>, 1>& at, const T&) const {
        using std::atan2;
        const T angle = T(2.0) * atan2(at[0].q.z(), at[0].q.w());
        return 0.5 * stiffness * angle * angle;
    }
};

/// Holds a node at a place by a spring along each fixed axis, in space (Dimension 3) or in the plane (2).
template <int Dimension>
struct PointSpring {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1;
    static constexpr auto components = position_components<Dimension>();
    static constexpr bool depends_on_parameter = false;
    /// \}
    Eigen::Vector3d stiffness;  ///< along each axis
    Eigen::Vector3d origin;     ///< where no spring has a force

    static constexpr std::array force_names{"F1", "F2", "F3"};  ///< see element.hpp
    /// The force on the node, in fixed axes.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 1>& at, const ElementQuery&) const {
        InternalForce y{at[0].x, {0, 0, 0}};
        for (int c = 0; c < Dimension; ++c)
            y.values[static_cast<std::size_t>(c)] = -stiffness(c) * (at[0].x(c) - origin(c));
        return {y};
    }

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
extern template class ElementGroupOf<RotationSprings<1>>;
extern template class ElementGroupOf<RotationSprings<2>>;
extern template class ElementGroupOf<PlanarGroundSpring>;
extern template class ElementGroupOf<PointSpring<2>>;
extern template class ElementGroupOf<PointSpring<3>>;
#endif

}  // namespace equilibria::fem
