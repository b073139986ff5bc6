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
    std::array<double, static_cast<std::size_t>(Nodes)> value{}, slope{};

    static constexpr double node(int k) { return -1 + 2.0 * k / (Nodes - 1); }

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
    std::array<double, static_cast<std::size_t>(Points)> point{}, weight{};
};
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

/// |dx/dxi| at the Gauss points of a line of equally spaced nodes. Throws InvalidArgument where it has no length.
template <int Nodes>
std::array<double, static_cast<std::size_t>(Nodes - 1)> jacobians(
    const std::array<Eigen::Vector3d, static_cast<std::size_t>(Nodes)>& x) {
    std::array<double, static_cast<std::size_t>(Nodes - 1)> y{};
    double size = 0;
    for (const Eigen::Vector3d& at : x) size = std::max(size, (at - x[0]).norm());
    for (std::size_t g = 0; g < y.size(); ++g) {
        const ShapeFunctions<Nodes> n(gauss_rule<Nodes - 1>().point[g]);
        Eigen::Vector3d speed = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < x.size(); ++k) speed += n.slope[k] * x[k];
        y[g] = speed.norm();
        require(y[g] > 1e-9 * size && std::isfinite(y[g]), "length of an element", y[g], "must be positive and finite");
    }
    return y;
}

}  // namespace equilibria::fem
