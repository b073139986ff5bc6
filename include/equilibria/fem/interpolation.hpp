/// \file
/// Lagrange polynomials on equally spaced nodes of [-1, 1], and Gauss points: with one point less than nodes beams
/// neither lock in shear nor in stretch (reduced integration).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>

namespace equilibria::fem {

/// The values and derivatives of the Lagrange polynomials of `Nodes` equally spaced nodes on [-1, 1] at xi.
template <int Nodes>
struct ShapeFunctions {
    static_assert(Nodes >= 2 && Nodes <= 4);
    std::array<double, static_cast<std::size_t>(Nodes)> value{};  ///< of each polynomial
    std::array<double, static_cast<std::size_t>(Nodes)> slope{};  ///< its derivative by xi

    static constexpr double node(int k) { return -1 + 2.0 * k / (Nodes - 1); }  ///< where polynomial k is 1, k from 0

    /// At xi.
    constexpr explicit ShapeFunctions(double xi) {
        for (int k = 0; k < Nodes; ++k) {
            double n = 1, d = 0;
            for (int j = 0; j < Nodes; ++j) {
                if (j == k) continue;
                const double factor = (xi - node(j)) / (node(k) - node(j));
                d = d * factor + n / (node(k) - node(j));
                n *= factor;
            }
            value[static_cast<std::size_t>(k)] = n;
            slope[static_cast<std::size_t>(k)] = d;
        }
    }
};

/// Gauss-Legendre points and weights on [-1, 1].
template <int Points>
struct GaussRule {
    std::array<double, static_cast<std::size_t>(Points)> point{};   ///< places
    std::array<double, static_cast<std::size_t>(Points)> weight{};  ///< positive, of sum 2
};
/// The rule that integrates polynomials of degree 2 Points - 1 exactly; Points is 1, 2 or 3.
template <int Points>
const GaussRule<Points>& gauss_rule() {
    static_assert(Points >= 1 && Points <= 3);
    static const GaussRule<Points> rule = [] {
        GaussRule<Points> y;
        if constexpr (Points == 1) {
            y.weight = {2};
        } else if constexpr (Points == 2) {
            y.point = {-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)};
            y.weight = {1, 1};
        } else {
            y.point = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
            y.weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};
        }
        return y;
    }();
    return rule;
}

/// A line of equally spaced nodes with its Gauss points, one less than nodes.
template <int Nodes>
class GaussLine {
public:
    static constexpr int points = Nodes - 1;  ///< Gauss points

    /// Throws InvalidArgument where the line through the nodes x has no length at a Gauss point.
    explicit GaussLine(const std::array<Eigen::Vector3d, static_cast<std::size_t>(Nodes)>& x) {
        double size = 0;
        for (const Eigen::Vector3d& at : x) size = std::max(size, (at - x[0]).norm());
        for (int g = 0; g < points; ++g) {
            const ShapeFunctions<Nodes> n = shape(g);
            Eigen::Vector3d speed = Eigen::Vector3d::Zero();
            for (std::size_t k = 0; k < x.size(); ++k) speed += n.slope[k] * x[k];
            const double jacobian = size > 0 ? speed.norm() : 0;  // of nodes that coincide the sum is rounding
            require(jacobian > 1e-9 * size && std::isfinite(jacobian), "length of an element", jacobian,
                    "must be positive and finite");
            jacobian_[static_cast<std::size_t>(g)] = jacobian;
        }
    }
    /// Of the nodes, at Gauss point g.
    ShapeFunctions<Nodes> shape(int g) const {
        return ShapeFunctions<Nodes>(gauss_rule<points>().point[static_cast<std::size_t>(g)]);
    }
    /// |dx/dxi| without load at Gauss point g.
    double jacobian(int g) const { return jacobian_[static_cast<std::size_t>(g)]; }
    /// The share of the length that Gauss point g stands for.
    double weight(int g) const { return gauss_rule<points>().weight[static_cast<std::size_t>(g)] * jacobian(g); }
    /// Of the line without load, by its Gauss points.
    double length() const {
        double y = 0;
        for (int g = 0; g < points; ++g) y += weight(g);
        return y;
    }

private:
    std::array<double, static_cast<std::size_t>(points)> jacobian_{};
};

/// The places of a line's initial frames.
template <class InitialFrame, std::size_t Nodes>
std::array<Eigen::Vector3d, Nodes> initial_places(const std::array<InitialFrame, Nodes>& at) {
    std::array<Eigen::Vector3d, Nodes> x;
    for (std::size_t k = 0; k < Nodes; ++k) x[k] = at[k].x;
    return x;
}

}  // namespace equilibria::fem
