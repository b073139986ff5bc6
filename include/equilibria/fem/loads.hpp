/// \file
/// Loads that follow the structure. Dead ones are Model::load.
#pragma once

#include <array>
#include <cmath>

#include <equilibria/fem/element.hpp>
#include <equilibria/fem/interpolation.hpp>

namespace equilibria::fem {

/// p times a force and a moment that turn with their node. They have no energy: NonconservativeStructure.
struct FollowerLoad {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1;
    static constexpr auto components = spatial;
    /// \}
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< in the node's axes, for p = 1
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< in the node's axes, for p = 1

    /// Minus the force in fixed axes, and minus the moment in those of the node.
    template <class T>
    Eigen::Matrix<T, 6, 1> residual(const std::array<Frame<T>, 1>& at, const T& p) const {
        const Vector3<T> f = force.cast<T>(), m = moment.cast<T>();
        Eigen::Matrix<T, 6, 1> y;
        y << -p * (at[0].q * f), -p * m;
        return y;
    }
};

/// p times a force towards a fixed center, of constant size, in space (Dimension 3) or in the plane (2): energy
/// p force |x - center|.
template <int Dimension>
struct CentralLoad {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1;
    static constexpr auto components = position_components<Dimension>();
    /// \}
    double force;            ///< for p = 1, towards the centre where positive
    Eigen::Vector3d center;  ///< in fixed axes

    /// p force |x - center|.
    template <class T>
    T energy(const std::array<Frame<T>, 1>& at, const T& p) const {
        using std::sqrt;
        const Vector3<T> d = at[0].x - center.cast<T>();
        return force * p * sqrt(d.template head<Dimension>().squaredNorm());
    }
};

/// p times a pressure on a line of `Nodes` nodes in the x-y plane, per length of the deformed line, from the right hand
/// side of its direction: energy p pressure times the area that the line sweeps around the origin. It is conservative
/// where the line is closed, or its ends are fixed or move towards the origin.
template <int Nodes>
struct PlanarPressure {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = Nodes;
    static constexpr auto components = planar_positions;
    /// \}
    double pressure;  ///< for p = 1, per length

    /// p pressure times the area.
    template <class T>
    T energy(const std::array<Frame<T>, static_cast<std::size_t>(Nodes)>& at, const T& p) const {
        // x cross x' is a polynomial of degree 2 Nodes - 3: Nodes - 1 Gauss points integrate it exactly
        const auto& rule = gauss_rule<Nodes - 1>();
        T area(0.0);
        for (std::size_t g = 0; g < rule.point.size(); ++g) {
            const ShapeFunctions<Nodes> n(rule.point[g]);
            T x(0.0), y(0.0), dx(0.0), dy(0.0);
            for (std::size_t k = 0; k < at.size(); ++k) {
                x = x + n.value[k] * at[k].x(0);
                y = y + n.value[k] * at[k].x(1);
                dx = dx + n.slope[k] * at[k].x(0);
                dy = dy + n.slope[k] * at[k].x(1);
            }
            area = area + 0.5 * rule.weight[g] * (x * dy - y * dx);
        }
        return pressure * p * area;
    }
};

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<FollowerLoad>;
extern template class ElementGroupOf<CentralLoad<2>>;
extern template class ElementGroupOf<CentralLoad<3>>;
extern template class ElementGroupOf<PlanarPressure<2>>;
extern template class ElementGroupOf<PlanarPressure<3>>;
extern template class ElementGroupOf<PlanarPressure<4>>;
#endif

}  // namespace equilibria::fem
