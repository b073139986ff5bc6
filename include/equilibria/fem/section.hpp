/// \file
/// Cross-sections of beams. Stiffnesses may be infinite, one of bending or torsion apart: the beam is inextensible, or
/// its cross-sections stay normal to the axis (Kirchhoff).
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>

namespace equilibria::fem {

/// An infinite stiffness.
inline constexpr double rigid = std::numeric_limits<double>::infinity();

/// A beam that is twisted about another line than that of its nodes, and whose fibres are stretched by the twist: what
/// thin-walled open sections need. The nodes' line goes through the centroid C, the line of twist through the shear
/// centre S. With the twist a = kappa_1 the strains that the stiffnesses multiply are
///
///     Gamma_1 + r^2 a^2 / 2,   Gamma_2 - s_3 a,       Gamma_3 + s_2 a,
///     a,                       kappa_2 + w_2 a^2 / 2, kappa_3 + w_3 a^2 / 2
///
/// so that Q_2 and Q_3 act at S and M_1 is the moment about S. Twist stretches a fibre by half the square of its
/// distance from S times a^2 (Wagner). r^2 is the mean of that square over the section; w_2 and w_3 are the same square
/// averaged with the weights of bending. Stretches that sum up to no force and no moment, of order a^4 in the energy,
/// are left out, and warping is free. Sources: Wagner, Verdrehung und Knickung von offenen Profilen, 25th anniversary
/// number of the Technische Hochschule Danzig (1929); Trahair, Flexural-torsional buckling of structures (1993),
/// chapters 2 and 5.
struct ShearCentre {
    std::array<double, 2> place = {0, 0};   ///< s_2 and s_3: of S, from C, in axes 2 and 3
    double polar_radius = 0;                ///< r: r^2 = (I_2 + I_3) / A + s_2^2 + s_3^2
    std::array<double, 2> wagner = {0, 0};  ///< w_2 = (integral of z (y^2 + z^2) dA) / I_2 - 2 s_3, where y and z are
                                            ///< along axes 2 and 3; w_3 = 2 s_2 - (integral of y (y^2 + z^2) dA) / I_3

    /// Whether S is C, and twist stretches nothing.
    bool none() const { return *this == ShearCentre{}; }
    /// Throws InvalidArgument unless all are finite, and polar_radius at least the distance from C to S.
    void validate() const {
        for (const double s : place) require(std::isfinite(s), "shear_centre", s, "must be finite");
        for (const double w : wagner) require(std::isfinite(w), "wagner", w, "must be finite");
        const double distance = std::hypot(place[0], place[1]);
        require(polar_radius >= distance && std::isfinite(polar_radius), "polar_radius", polar_radius,
                "must be finite and at least the shear centre's distance from the centroid, " + streamed(distance));
    }
    bool operator==(const ShearCentre&) const = default;  ///< whether all numbers are the same
};

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
    ShearCentre shear_centre = {};      ///< where it is not the centroid, or twist stretches fibres

    /// In the order of the strains.
    Eigen::Matrix<double, 6, 1> stiffness() const { return {ea, ga2, ga3, gj, ei2, ei3}; }
    /// Throws InvalidArgument unless all are positive, and one of gj, ei2 and ei3 finite; or as ShearCentre does.
    void validate() const {
        constexpr const char* names[] = {"ea", "ga2", "ga3", "gj", "ei2", "ei3"};
        const auto values = stiffness();
        for (int k = 0; k < 6; ++k) require(values(k) > 0, names[k], values(k), "must be positive");
        require(std::isfinite(values.tail<3>().minCoeff()), "gj, ei2, ei3", rigid, "must not all be infinite");
        shear_centre.validate();
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
