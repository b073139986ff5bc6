/// \file
/// Chebyshev interpolation on [0, l]: quadrature, integrals and derivatives of functions given at points. Source:
/// Trefethen, Approximation Theory and Approximation Practice (2013), chapters 2, 3 and 19.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>

namespace equilibria::mechanisms::detail {

/// m Chebyshev-Lobatto points on [0, l], rising. Coefficients are by rows, of T_0, T_1, ...; a column is a function.
class ChebyshevIntegrals {
public:
    /// points: at least 2; length: positive.
    ChebyshevIntegrals(int points, double length);

    Eigen::VectorXd places;        ///< the points
    Eigen::MatrixXd coefficients;  ///< m x m: of the interpolant, from values at the points
    Eigen::VectorXd quadrature;  ///< Clenshaw and Curtis's weights: the integral over [0, l] from values at the points

    /// T_0 .. T_{m+3} at z.
    Eigen::RowVectorXd polynomials(double z) const;
    /// The coefficients of the integrals over z that vanish at the end 1 or -1: one row more.
    Eigen::MatrixXd integral(const Eigen::MatrixXd& c, int end) const;
    /// Those of the derivatives by z.
    Eigen::MatrixXd derivative(const Eigen::MatrixXd& c) const;

private:
    int m_;
    double length_;
};

}  // namespace equilibria::mechanisms::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/rotating_body_beam/detail/chebyshev_integrals_definitions.hpp>
#endif
