/// \file
/// See studies/rotating_body_beam/chebyshev_integrals.hpp.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include <equilibria/studies/rotating_body_beam/chebyshev_integrals.hpp>

namespace equilibria::mechanisms::detail {

EQUILIBRIA_INLINE ChebyshevIntegrals::ChebyshevIntegrals(int points, double length) : m_(points), length_(length) {
    const double pi = std::numbers::pi;
    places.resize(m_);
    coefficients.resize(m_, m_);
    Eigen::RowVectorXd means = Eigen::RowVectorXd::Zero(m_);
    for (int k = 0; k < m_; ++k) {
        places(k) = length * std::pow(std::sin(0.5 * pi * k / (m_ - 1)), 2);
        if (k % 2 == 0) means(k) = length / (1.0 - k * k);
        for (int j = 0; j < m_; ++j) {
            const double ends = (j % (m_ - 1) == 0 ? 0.5 : 1) * (k % (m_ - 1) == 0 ? 0.5 : 1);
            // T_k at x = -cos(pi j / (m - 1)); the angle reduced exactly
            const int turns = (k * (m_ - 1 - j)) % (2 * (m_ - 1));
            coefficients(k, j) = 2 * ends / (m_ - 1) * std::cos(pi * turns / (m_ - 1));
        }
    }
    quadrature = (means * coefficients).transpose();
}

EQUILIBRIA_INLINE Eigen::RowVectorXd ChebyshevIntegrals::polynomials(double z) const {
    const double x = 2 * z / length_ - 1;
    Eigen::RowVectorXd y(m_ + 4);
    y(0) = 1;
    y(1) = x;
    for (int k = 2; k < y.size(); ++k) y(k) = 2 * x * y(k - 1) - y(k - 2);
    return y;
}

EQUILIBRIA_INLINE Eigen::MatrixXd ChebyshevIntegrals::integral(const Eigen::MatrixXd& c, int end) const {
    const Eigen::Index rows = c.rows();
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(rows + 1, c.cols());
    for (Eigen::Index k = 1; k <= rows; ++k) {
        y.row(k) = c.row(k - 1) * (k == 1 ? 2.0 : 1.0);
        if (k + 1 < rows) y.row(k) -= c.row(k + 1);
        y.row(k) *= 0.25 * length_ / static_cast<double>(k);
        y.row(0) -= (end < 0 && k % 2 == 1 ? -1.0 : 1.0) * y.row(k);
    }
    return y;
}

EQUILIBRIA_INLINE Eigen::MatrixXd ChebyshevIntegrals::derivative(const Eigen::MatrixXd& c) const {
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(c.rows(), c.cols());
    for (Eigen::Index k = c.rows() - 1; k >= 1; --k) {
        y.row(k - 1) = 4 * static_cast<double>(k) / length_ * c.row(k);
        if (k + 1 < c.rows()) y.row(k - 1) += y.row(k + 1);
    }
    y.row(0) *= 0.5;
    return y;
}

}  // namespace equilibria::mechanisms::detail
