/// \file
/// Strains of geometrically exact (Reissner) beams in the x-y plane, and their first and second derivatives:
///
///     Gamma = A(theta)^T x' - its initial value,   kappa = theta' - its initial value
///
/// theta is interpolated from the nodes' angles against the first node's, which may reach 2 pi.
/// Source: Reissner, On one-dimensional finite-strain beam theory: the plane problem, ZAMP 23 (1972).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/frame.hpp>
#include <equilibria/fem/interpolation.hpp>

namespace equilibria::fem {

/// Where a planar beam's node is without load, and the direction of the beam there.
struct PlanarSectionFrame {
    Eigen::Vector3d x;  ///< its place
    double angle;       ///< from the x axis to the beam's, radians
};

/// The strains (Gamma_1, Gamma_2, kappa) of a planar beam element of equally spaced nodes at its Gauss points, one less
/// than nodes.
template <int Nodes>
class PlanarGeometry {
    static constexpr std::size_t count = static_cast<std::size_t>(Nodes);
    static constexpr std::size_t place(int k) { return static_cast<std::size_t>(k); }

public:
    static constexpr int gauss_points = Nodes - 1;    ///< one less than nodes
    static constexpr int n_strains = 3;               ///< Gamma_1, Gamma_2, kappa
    using Frames = std::array<Frame<double>, count>;  ///< of the nodes, moved
    using InitialFrame = PlanarSectionFrame;          ///< of a node without load
    using Strains = Eigen::Vector3d;                  ///< (Gamma_1, Gamma_2, kappa)
    using StrainDerivative = Eigen::Matrix3d;         ///< by a node's dx, dy and dtheta

    /// What the moved nodes are to all Gauss points.
    struct MovedNodes {
        std::array<Eigen::Vector2d, count> x;  ///< places
        double turned = 0;                     ///< of the first node, radians
        std::array<double, count> angle;       ///< of the cross-sections, against the first node's turn
    };
    /// A Gauss point of the moved element.
    struct Point {
        Strains strain;                         ///< Gamma and kappa, without their initial values
        std::array<StrainDerivative, count> b;  ///< of the strains, by each node
        double weight = 0;                      ///< of the point: its share of the element's length

        std::array<double, count> n;  ///< shape functions
        std::array<double, count> d;  ///< their slopes by arc length
        Eigen::Matrix2d axes;         ///< A
        Strains total;                ///< the strains with their initial values
    };

    /// at: the nodes from one end to the other, equally spaced along the beam; angles of neighbours within pi of each
    /// other. Throws InvalidArgument for nodes at one place.
    explicit PlanarGeometry(const std::array<PlanarSectionFrame, count>& at) : line_(initial_places(at)) {
        Frames initial;
        for (std::size_t k = 0; k < count; ++k) {
            require(std::isfinite(at[k].angle), "angle", at[k].angle, "must be finite");
            angle_[k] = at[k].angle;
            initial[k].x = at[k].x;
        }
        for (int g = 0; g < gauss_points; ++g) {
            Point y;
            interpolate(nodes(initial), g, y);
            initial_strain_[place(g)] = y.total;
        }
    }

    /// Gamma and kappa at Gauss point g.
    Strains strain(const Frames& at, int g) const {
        Point y;
        interpolate(nodes(at), g, y);
        return y.total - initial_strain_[place(g)];
    }
    const GaussLine<Nodes>& line() const { return line_; }  ///< the nodes' places without load, and the Gauss points

    /// The nodes at these frames.
    MovedNodes nodes(const Frames& at) const {
        MovedNodes y;
        y.turned = 2 * std::atan2(at[0].q.z(), at[0].q.w());
        for (std::size_t k = 0; k < count; ++k) {
            y.x[k] = at[k].x.template head<2>();
            y.angle[k] = angle_[k];
            if (k == 0) continue;
            const Eigen::Quaterniond turned = at[0].q.conjugate() * at[k].q;
            y.angle[k] += 2 * std::atan2(turned.z(), turned.w());
        }
        return y;
    }

    /// Strains and their derivatives at Gauss point g.
    Point point(const MovedNodes& at, int g) const {
        Point y;
        interpolate(at, g, y);
        y.strain = y.total - initial_strain_[place(g)];
        y.weight = line_.weight(g);
        // Gamma = A^T x': by theta it changes as -J Gamma, J = [0 -1; 1 0]
        const Eigen::Vector2d slope(y.total(1), -y.total(0));
        for (std::size_t k = 0; k < count; ++k) {
            y.b[k].template topLeftCorner<2, 2>() = y.d[k] * y.axes.transpose();
            y.b[k].template topRightCorner<2, 1>() = y.n[k] * slope;
            y.b[k].row(2) << 0, 0, y.d[k];
        }
        return y;
    }

    /// Adds the second derivatives of weight stress . strain to a tangent whose first unknowns are the nodes'.
    void add_geometric(const MovedNodes&, const Point& y, const Strains& stress,
                       Eigen::Matrix<double, 3 * Nodes, 3 * Nodes>& tangent) const {
        // n . Gamma: by x' and theta A J n, by theta twice -n . Gamma
        const Eigen::Vector2d n = stress.template head<2>(), mixed = y.axes * Eigen::Vector2d(-n(1), n(0));
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j) {
                auto k =
                    tangent.template block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j));
                k.template topRightCorner<2, 1>() += y.weight * y.d[i] * y.n[j] * mixed;
                k.template bottomLeftCorner<1, 2>() += y.weight * y.n[i] * y.d[j] * mixed.transpose();
                k(2, 2) -= y.weight * y.n[i] * y.n[j] * n.dot(y.total.template head<2>());
            }
    }

private:
    void interpolate(const MovedNodes& at, int g, Point& y) const {
        const ShapeFunctions<Nodes> shape = line_.shape(g);
        Eigen::Vector2d dx = Eigen::Vector2d::Zero();
        double theta = at.turned, kappa = 0;
        for (std::size_t k = 0; k < count; ++k) {
            y.n[k] = shape.value[k];
            y.d[k] = shape.slope[k] / line_.jacobian(g);
            theta += y.n[k] * at.angle[k];
            kappa += y.d[k] * at.angle[k];
            dx += y.d[k] * at.x[k];
        }
        y.axes << std::cos(theta), -std::sin(theta), std::sin(theta), std::cos(theta);
        y.total << y.axes.transpose() * dx, kappa;
    }

    std::array<double, count> angle_;  // of each node's cross-section
    GaussLine<Nodes> line_;
    std::array<Strains, count - 1> initial_strain_;
};

}  // namespace equilibria::fem
