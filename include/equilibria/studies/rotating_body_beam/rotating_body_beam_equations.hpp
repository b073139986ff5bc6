/// \file
/// The equations of motion of a rotating body with a beam for a number of modes known at run time: compiled once, not
/// once a model. See rotating_body_beam_motion.hpp.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>
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

    Eigen::Vector3d displacement(const BeamNode& node, const BeamVector& u) const;
    void add(BeamVector& force, const Eigen::Vector3d& f, const BeamShapes& bending, const BeamShapes& along) const;
    /// One form a direction, times u.
    BeamVector times(const std::array<Eigen::MatrixXd, 3>& forms, const BeamVector& u) const;
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
    BeamVector modal_inertia(const BeamVector& x) const;
    BeamVector modal_mobility(const BeamVector& x) const;

    Geometry geometry(const BeamVector& u) const;

    /// W and u' from the momenta: (J - P M^-1 P^T) W = a - P M^-1 p, u' = M^-1 (p - P^T W).
    void velocities(const Geometry& g, const Eigen::Vector3d& a, const BeamVector& p, Eigen::Vector3d& w,
                    BeamVector& v) const;

    double strain_energy(const BeamVector& u) const;
    std::array<double, 3> slopes(const BeamNode& node, const BeamVector& u) const;

    Rates rates(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const;

    double energy(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const;

    BodyBeamResidual residual(const Eigen::Vector3d& a, const BeamVector& u, const Rates& r) const;
};

}  // namespace equilibria::mechanisms::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_equations_definitions.hpp>
#endif
