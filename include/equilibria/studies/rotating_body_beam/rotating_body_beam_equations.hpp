/// \file
/// The equations of motion of a rotating body with a beam for a number of modes known at run time: compiled once, not
/// once a model. See rotating_body_beam_motion.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/studies/rotating_body_beam/rotating_body_beam_state.hpp>

namespace equilibria::mechanisms::detail {

inline constexpr int most_beam_modes = 8;
using BeamShapes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_beam_modes, 1>;
using BeamVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3 * most_beam_modes, 1>;
using BeamCoupling = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3 * most_beam_modes>;

/// A node of the quadrature: a particle of the beam, and the shapes there.
struct BeamNode {
    double weight = 0, place = 0;
    BeamShapes bending, stretching, bending_slope, stretching_slope;
};

/// See the file's description.
struct BeamMotion {
    int k = 0;  ///< modes a direction
    bool coupled = false;
    double length = 0, mass = 0, stretching = 0;
    Eigen::Matrix3d body_inertia;
    Eigen::Vector3d body_moment;                                 ///< mass times centre, of the body
    BeamVector mean;                                             ///< int dr_d/du_k
    std::vector<BeamNode> nodes;                                 ///< 2 k + 3
    std::array<Eigen::MatrixXd, 3> stiffness, loss, compliance;  ///< of the linear beam, a direction each

    struct Geometry {
        std::array<Eigen::Vector3d, 2 * most_beam_modes + 3> place;
        Eigen::Matrix3d inertia;
        BeamCoupling coupling;
    };
    struct Rates {
        Eigen::Vector3d angular_velocity, momentum;
        BeamVector modes, modal_momentum;
        double loss = 0;
    };

    Eigen::Vector3d displacement(const BeamNode& node, const BeamVector& u) const {
        Eigen::Vector3d y(0, 0, 0);
        for (int i = 0; i < k; ++i) {
            y(0) += node.bending(i) * u(i);
            y(1) += node.bending(i) * u(k + i);
            y(2) += node.stretching(i) * u(2 * k + i);
        }
        return y;
    }
    void add(BeamVector& force, const Eigen::Vector3d& f, const BeamShapes& bending, const BeamShapes& along) const {
        for (int i = 0; i < k; ++i) {
            force(i) += f(0) * bending(i);
            force(k + i) += f(1) * bending(i);
            force(2 * k + i) += f(2) * along(i);
        }
    }
    /// One form a direction, times u.
    BeamVector times(const std::array<Eigen::MatrixXd, 3>& forms, const BeamVector& u) const {
        BeamVector y = BeamVector::Zero(3 * k);
        for (int d = 0; d < 3; ++d)
            for (int j = 0; j < k; ++j)
                for (int i = 0; i < k; ++i) y(k * d + i) += forms[static_cast<std::size_t>(d)](i, j) * u(k * d + j);
        return y;
    }
    /// x + factor(mean . mean) mean (mean . x), a direction each.
    BeamVector with_mean(const BeamVector& x, const auto& factor) const {
        BeamVector y = x;
        for (int d = 0; d < 3; ++d) {
            double square = 0, along = 0;
            for (int i = k * d; i < k * (d + 1); ++i) square += mean(i) * mean(i), along += mean(i) * x(i);
            for (int i = k * d; i < k * (d + 1); ++i) y(i) += factor(square) * along * mean(i);
        }
        return y;
    }
    /// M x and M^-1 x.
    BeamVector modal_inertia(const BeamVector& x) const {
        return with_mean(x, [this](double) { return -1 / mass; });
    }
    BeamVector modal_mobility(const BeamVector& x) const {
        return with_mean(x, [this](double square) { return 1 / (mass - square); });
    }

    Geometry geometry(const BeamVector& u) const {
        Geometry y;
        Eigen::Vector3d centre = body_moment;
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            y.place[q] = displacement(nodes[q], u);
            y.place[q](2) += nodes[q].place;
            centre += nodes[q].weight * y.place[q];
        }
        centre /= mass;
        Eigen::Matrix3d second = -mass * centre * centre.transpose();
        y.coupling.setZero(3, 3 * k);
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            const Eigen::Vector3d& r = y.place[q];
            const double w = nodes[q].weight;
            second += w * r * r.transpose();
            // r x e_d for the directions d of the modes
            const Eigen::Vector3d arm = w * (r - centre);
            for (int i = 0; i < k; ++i) {
                const double phi = nodes[q].bending(i), psi = nodes[q].stretching(i);
                y.coupling(1, i) += phi * arm(2);
                y.coupling(2, i) -= phi * arm(1);
                y.coupling(0, k + i) -= phi * arm(2);
                y.coupling(2, k + i) += phi * arm(0);
                y.coupling(0, 2 * k + i) += psi * arm(1);
                y.coupling(1, 2 * k + i) -= psi * arm(0);
            }
        }
        y.inertia = body_inertia - second;
        y.inertia.diagonal().array() += second.trace();
        return y;
    }

    /// W and u' from the momenta: (J - P M^-1 P^T) W = a - P M^-1 p, u' = M^-1 (p - P^T W).
    void velocities(const Geometry& g, const Eigen::Vector3d& a, const BeamVector& p, Eigen::Vector3d& w,
                    BeamVector& v) const {
        BeamCoupling scaled(3, 3 * k);  // P M^-1
        for (int row = 0; row < 3; ++row) scaled.row(row) = modal_mobility(g.coupling.row(row).transpose()).transpose();
        Eigen::Matrix3d reduced = g.inertia;
        Eigen::Vector3d rest = a;
        for (int i = 0; i < 3 * k; ++i) {
            const Eigen::Vector3d left = scaled.col(i), right = g.coupling.col(i);
            reduced -= left * right.transpose();
            rest -= p(i) * left;
        }
        w = reduced.inverse() * rest;
        BeamVector beam = p;
        for (int i = 0; i < 3 * k; ++i) beam(i) -= g.coupling.col(i).dot(w);
        v = modal_mobility(beam);
    }

    double strain_energy(const BeamVector& u) const {
        double y = 0.5 * u.dot(times(stiffness, u));
        if (coupled)
            for (const BeamNode& node : nodes) {
                const auto [s1, s2, s3] = slopes(node, u);
                const double bend = 0.5 * (s1 * s1 + s2 * s2);
                y += 0.5 * stretching * node.weight * bend * (2 * s3 + bend);
            }
        return y;
    }
    std::array<double, 3> slopes(const BeamNode& node, const BeamVector& u) const {
        std::array<double, 3> y{};
        for (int i = 0; i < k; ++i) {
            y[0] += node.bending_slope(i) * u(i);
            y[1] += node.bending_slope(i) * u(k + i);
            y[2] += node.stretching_slope(i) * u(2 * k + i);
        }
        return y;
    }

    Rates rates(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const {
        const Geometry g = geometry(u);
        Rates y;
        velocities(g, a, p, y.angular_velocity, y.modes);
        const Eigen::Vector3d& w = y.angular_velocity;
        y.momentum = a.cross(w);
        const BeamVector damping = times(loss, y.modes);
        y.loss = damping.dot(y.modes);
        y.modal_momentum = -damping - times(stiffness, u);
        // dT/du at given velocities: the particles' velocities s, less their mean, times W
        std::array<Eigen::Vector3d, 2 * most_beam_modes + 3> speed;
        Eigen::Vector3d mean_speed = w.cross(body_moment);
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            speed[q] = w.cross(g.place[q]) + displacement(nodes[q], y.modes);
            mean_speed += nodes[q].weight * speed[q];
        }
        mean_speed /= mass;
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            const Eigen::Vector3d f = nodes[q].weight * (speed[q] - mean_speed).cross(w);
            add(y.modal_momentum, f, nodes[q].bending, nodes[q].stretching);
        }
        if (coupled)
            // mu_3/2 (e^2 - u3'^2), e = u3' + bend
            for (const BeamNode& node : nodes) {
                const auto [s1, s2, s3] = slopes(node, u);
                const double bend = 0.5 * (s1 * s1 + s2 * s2), e = s3 + bend;
                const Eigen::Vector3d f = -stretching * node.weight * Eigen::Vector3d(e * s1, e * s2, bend);
                add(y.modal_momentum, f, node.bending_slope, node.stretching_slope);
            }
        return y;
    }

    double energy(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const {
        Eigen::Vector3d w;
        BeamVector v;
        velocities(geometry(u), a, p, w, v);
        return 0.5 * (a.dot(w) + p.dot(v)) + strain_energy(u);
    }

    BodyBeamResidual residual(const Eigen::Vector3d& a, const BeamVector& u, const Rates& r) const {
        const double unit = length * std::sqrt(length);
        const Eigen::Vector3d& w = r.angular_velocity;
        const double turn = w.norm();
        const Eigen::Vector3d spin = geometry(u).inertia * w, n = w / turn;
        BodyBeamResidual y;
        y.velocity = r.modes.norm() / (turn * unit);
        y.deflection = times(compliance, r.modal_momentum).norm() / unit;
        y.misalignment = std::max(a.cross(w).norm() / (a.norm() * turn), (spin - n.dot(spin) * n).norm() / spin.norm());
        return y;
    }
};

}  // namespace equilibria::mechanisms::detail
