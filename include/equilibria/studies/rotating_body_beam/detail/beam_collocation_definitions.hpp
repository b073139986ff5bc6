/// \file
/// See studies/rotating_body_beam/beam_collocation.hpp.
#pragma once

#include <Eigen/Core>

#include <equilibria/studies/rotating_body_beam/beam_collocation.hpp>

namespace equilibria::mechanisms::detail {

EQUILIBRIA_INLINE BeamCollocation::BeamCollocation(const Beam::Values& parameters, bool coupled, int m)
    : chebyshev(m, parameters[Beam::length]), p_(parameters), coupled_(coupled), m_(m) {
    third_ = chebyshev.integral(chebyshev.coefficients, 1);
    curvature_ = chebyshev.integral(third_, 1);
    slope_ = chebyshev.integral(curvature_, -1);
    deflection_ = chebyshev.integral(slope_, -1);
    stretch_ = chebyshev.integral(chebyshev.coefficients, -1);
    steepening_ = chebyshev.derivative(chebyshev.coefficients);
    Eigen::MatrixXd values(m_, m_ + 4);
    for (int j = 0; j < m_; ++j) values.row(j) = chebyshev.polynomials(chebyshev.places(j));
    const auto at_points = [&](const Eigen::MatrixXd& c) { return Eigen::MatrixXd(values.leftCols(c.rows()) * c); };
    tension_at = at_points(third_);
    curvature_at = at_points(curvature_);
    slope_at = at_points(slope_);
    deflection_at = at_points(deflection_);
    stretch_at = at_points(stretch_);
}

EQUILIBRIA_INLINE BeamCollocation::State BeamCollocation::state(const Eigen::Vector3d& n,
                                                                const Eigen::VectorXd& w) const {
    State y;
    y.n = n;
    y.w = w.reshaped(m_, 3);
    y.slope = slope_at * y.w.leftCols<2>();
    y.curvature = curvature_at * y.w.leftCols<2>();
    y.tension = tension_at * y.w.col(2);
    y.stretch = y.tension;
    if (coupled_) y.stretch -= 0.5 * y.slope.rowwise().squaredNorm();
    y.r.resize(m_, 3);
    y.r.leftCols<2>() = deflection_at * y.w.leftCols<2>();
    y.r.col(2) = chebyshev.places + stretch_at * y.stretch;
    place(y);
    return y;
}

EQUILIBRIA_INLINE void BeamCollocation::place(State& y) const {
    const Eigen::Vector3d c(p_[Beam::centre_1], p_[Beam::centre_2], p_[Beam::centre_3]);
    const double mass = p_[Beam::body_mass] + p_[Beam::length];
    y.centre = (p_[Beam::body_mass] * c + y.r.transpose() * chebyshev.quadrature) / mass;
    y.rho = y.r.rowwise() - y.centre.transpose();
    y.along = y.rho * y.n;
    // int r r^T - (m_b + l) C C^T
    Eigen::Matrix3d moments = y.r.transpose() * chebyshev.quadrature.asDiagonal() * y.r;
    moments -= mass * y.centre * y.centre.transpose();
    y.inertia = moments.trace() * Eigen::Matrix3d::Identity() - moments;
    for (int a = 0; a < 3; ++a) y.inertia(a, a) += p_[Beam::inertia_1 + a];
}

EQUILIBRIA_INLINE Eigen::MatrixXd BeamCollocation::load(const State& at) {
    return at.rho - at.along * at.n.transpose();
}

EQUILIBRIA_INLINE Array<Eigen::MatrixXd, 3> BeamCollocation::displacement_derivative(const State& at) const {
    Array<Eigen::MatrixXd, 3> y;
    for (auto& block : y) block = Eigen::MatrixXd::Zero(m_, 3 * m_);
    for (int a = 0; a < 2; ++a) {
        y[a].middleCols(a * m_, m_) = deflection_at;
        if (!coupled_) continue;
        const Eigen::MatrixXd shortening = at.slope.col(a).asDiagonal() * slope_at;
        y[2].middleCols(a * m_, m_) = -stretch_at * shortening;
    }
    y[2].middleCols(2 * m_, m_) = stretch_at * tension_at;
    return y;
}

EQUILIBRIA_INLINE BeamPlace BeamCollocation::shape(const State& at, double z) const {
    const Eigen::RowVectorXd t = chebyshev.polynomials(z);
    const auto value = [&](const Eigen::MatrixXd& c, const Eigen::VectorXd& by) {
        return (t.head(c.rows()) * c).dot(by);
    };
    BeamPlace y;
    for (int a = 0; a < 2; ++a) {
        y.u(a) = value(deflection_, at.w.col(a));
        y.first(a) = value(slope_, at.w.col(a));
        y.second(a) = value(curvature_, at.w.col(a));
    }
    y.u(2) = value(stretch_, at.stretch);
    y.first(2) = value(chebyshev.coefficients, at.stretch);
    y.second(2) = value(steepening_, at.stretch);
    return y;
}

}  // namespace equilibria::mechanisms::detail
