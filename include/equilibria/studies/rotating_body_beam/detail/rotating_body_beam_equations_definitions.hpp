/// \file
/// See studies/rotating_body_beam/rotating_body_beam_equations.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/studies/rotating_body_beam/rotating_body_beam_equations.hpp>

namespace equilibria::mechanisms::detail {

EQUILIBRIA_INLINE Eigen::Vector3d BeamMotion::displacement(const BeamNode& node, const BeamVector& u) const {
    Eigen::Vector3d y(0, 0, 0);
    for (int i = 0; i < k; ++i) {
        y(0) += node.bending(i) * u(i);
        y(1) += node.bending(i) * u(k + i);
        y(2) += node.stretching(i) * u(2 * k + i);
    }
    return y;
}

EQUILIBRIA_INLINE void BeamMotion::add(BeamVector& force, const Eigen::Vector3d& f, const BeamShapes& bending,
                                       const BeamShapes& along) const {
    for (int i = 0; i < k; ++i) {
        force(i) += f(0) * bending(i);
        force(k + i) += f(1) * bending(i);
        force(2 * k + i) += f(2) * along(i);
    }
}

EQUILIBRIA_INLINE BeamVector BeamMotion::times(const std::array<Eigen::MatrixXd, 3>& forms, const BeamVector& u) const {
    BeamVector y = BeamVector::Zero(3 * k);
    for (int d = 0; d < 3; ++d)
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < k; ++i) y(k * d + i) += forms[static_cast<std::size_t>(d)](i, j) * u(k * d + j);
    return y;
}

EQUILIBRIA_INLINE BeamVector BeamMotion::modal_inertia(const BeamVector& x) const {
    return with_mean(x, [this](double) { return -1 / mass; });
}

EQUILIBRIA_INLINE BeamVector BeamMotion::modal_mobility(const BeamVector& x) const {
    return with_mean(x, [this](double square) { return 1 / (mass - square); });
}

EQUILIBRIA_INLINE BeamMotion::Geometry BeamMotion::geometry(const BeamVector& u) const {
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

EQUILIBRIA_INLINE void BeamMotion::velocities(const Geometry& g, const Eigen::Vector3d& a, const BeamVector& p,
                                              Eigen::Vector3d& w, BeamVector& v) const {
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

EQUILIBRIA_INLINE double BeamMotion::strain_energy(const BeamVector& u) const {
    double y = 0.5 * u.dot(times(stiffness, u));
    if (coupled)
        for (const BeamNode& node : nodes) {
            const auto [s1, s2, s3] = slopes(node, u);
            const double bend = 0.5 * (s1 * s1 + s2 * s2);
            y += 0.5 * stretching * node.weight * bend * (2 * s3 + bend);
        }
    return y;
}

EQUILIBRIA_INLINE std::array<double, 3> BeamMotion::slopes(const BeamNode& node, const BeamVector& u) const {
    std::array<double, 3> y{};
    for (int i = 0; i < k; ++i) {
        y[0] += node.bending_slope(i) * u(i);
        y[1] += node.bending_slope(i) * u(k + i);
        y[2] += node.stretching_slope(i) * u(2 * k + i);
    }
    return y;
}

EQUILIBRIA_INLINE BeamMotion::Rates BeamMotion::rates(const Eigen::Vector3d& a, const BeamVector& u,
                                                      const BeamVector& p) const {
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

EQUILIBRIA_INLINE double BeamMotion::energy(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const {
    Eigen::Vector3d w;
    BeamVector v;
    velocities(geometry(u), a, p, w, v);
    return 0.5 * (a.dot(w) + p.dot(v)) + strain_energy(u);
}

EQUILIBRIA_INLINE BodyBeamResidual BeamMotion::residual(const Eigen::Vector3d& a, const BeamVector& u,
                                                        const Rates& r) const {
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

}  // namespace equilibria::mechanisms::detail
