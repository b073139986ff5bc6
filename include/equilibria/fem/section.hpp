/// \file
/// Cross-sections of beams. Stiffnesses may be infinite, one of bending or torsion apart: the beam is inextensible, or
/// its cross-sections stay normal to the axis (Kirchhoff).
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>

namespace equilibria::fem {

/// An infinite stiffness.
inline constexpr double rigid = std::numeric_limits<double>::infinity();

/// The stiffness of a beam's cross-section: forces N = EA Gamma_1, Q_2 = GA2 Gamma_2, Q_3 = GA3 Gamma_3 and moments
/// M_1 = GJ kappa_1, M_2 = EI2 kappa_2, M_3 = EI3 kappa_3, axis 1 along the beam; EI2 bends about axis 2.
struct Section {
    static constexpr int n_forces = 3;  ///< N, Q_2 and Q_3, before the moments
    double ea;                          ///< of stretch
    double ga2;                         ///< of shear along axis 2
    double ga3;                         ///< of shear along axis 3
    double gj;                          ///< of torsion
    double ei2;                         ///< of bending about axis 2
    double ei3;                         ///< of bending about axis 3

    /// In the order of the strains.
    Eigen::Matrix<double, 6, 1> stiffness() const { return {ea, ga2, ga3, gj, ei2, ei3}; }
    /// Throws InvalidArgument unless all are positive, and one of gj, ei2 and ei3 finite.
    void validate() const {
        constexpr const char* names[] = {"ea", "ga2", "ga3", "gj", "ei2", "ei3"};
        const auto values = stiffness();
        for (int k = 0; k < 6; ++k) require(values(k) > 0, names[k], values(k), "must be positive");
        require(std::isfinite(values.tail<3>().minCoeff()), "gj, ei2, ei3", rigid, "must not all be infinite");
    }
};

/// The stiffness of a planar beam: N = EA Gamma_1, Q = GA Gamma_2, M = EI kappa.
struct PlanarSection {
    static constexpr int n_forces = 2;  ///< N and Q, before the moment
    double ea;                          ///< of stretch
    double ga;                          ///< of shear
    double ei;                          ///< of bending

    Eigen::Vector3d stiffness() const { return {ea, ga, ei}; }  ///< in the order of the strains
    /// Throws InvalidArgument unless all are positive, and ei finite.
    void validate() const {
        require(ea > 0, "ea", ea, "must be positive");
        require(ga > 0, "ga", ga, "must be positive");
        require(ei > 0 && std::isfinite(ei), "ei", ei, "must be positive and finite");
    }
};

}  // namespace equilibria::fem
