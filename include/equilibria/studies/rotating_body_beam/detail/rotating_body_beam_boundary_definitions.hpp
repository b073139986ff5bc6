/// \file
/// See studies/rotating_body_beam/rotating_body_beam_boundary.hpp.
#pragma once

#include <cmath>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_boundary.hpp>

namespace equilibria::mechanisms {

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::undeformed(const Eigen::Vector3d& axis) const {
    const double size = axis.norm();
    require(std::isfinite(size) && size > 0, "axis", size, "must be finite and not 0");
    Eigen::VectorXd q = Eigen::VectorXd::Zero(n_unknowns());
    const Eigen::Vector3d n = axis / size;
    q.head<3>() = n;
    q(3 * m_ + 3) = n.dot(state(q).inertia * n);
    return q;
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::residual(const Eigen::VectorXd& q, double p) const {
    const State at = state(q);
    const double square = square_of_speed(moment(q), p);
    const Eigen::MatrixXd f = scaled_load(at);
    Eigen::VectorXd y(n_unknowns());
    for (int a = 0; a < 3; ++a) {
        y.segment(3 + a * m_, m_) = at.w.col(a) + square * f.col(a);
        if (a < 2) y.segment(3 + a * m_, m_) -= stiffening(at, a) / bending(a);
    }
    y.head<3>() = at.inertia * at.n - moment(q) * at.n;
    y(3 * m_ + 3) = 0.5 * (at.n.squaredNorm() - 1);
    return y;
}

EQUILIBRIA_INLINE Eigen::MatrixXd RotatingBodyBeamBoundary::tangent(const Eigen::VectorXd& q, double p) const {
    const State at = state(q);
    const double lambda = moment(q), square = square_of_speed(lambda, p), mu3 = p_[Beam::stretching];
    const Eigen::Index last = 3 * m_ + 3;
    const auto r_w = beam_.displacement_derivative(at);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n_unknowns(), n_unknowns());
    k.middleRows(3, 3 * m_) = square * load_derivative(at, r_w);
    k.block(3, 3, 3 * m_, 3 * m_).diagonal().array() += 1;
    if (control_ == BeamControl::momentum) {
        const Eigen::MatrixXd f = scaled_load(at);
        for (int a = 0; a < 3; ++a) k.block(3 + a * m_, last, m_, 1) = -2 * square / lambda * f.col(a);
    }
    if (coupled_)
        for (int a = 0; a < 2; ++a) {
            const double c = mu3 / bending(a);
            auto own = k.block(3 + a * m_, 3 + a * m_, m_, m_);
            own -= c * at.w.col(2).asDiagonal() * beam_.slope_at;
            own -= c * at.tension.asDiagonal() * beam_.curvature_at;
            auto other = k.block(3 + a * m_, 3 + 2 * m_, m_, m_);
            other -= c * at.curvature.col(a).asDiagonal() * beam_.tension_at;
            other.diagonal() -= c * at.slope.col(a);
        }
    // J n - lambda n: with rho = r - C, dP = int rho dr^T + dr rho^T and dJ = tr(dP) - dP
    Eigen::MatrixXd along = Eigen::MatrixXd::Zero(m_, 3 * m_);
    Eigen::RowVectorXd trace = Eigen::RowVectorXd::Zero(3 * m_);
    for (int b = 0; b < 3; ++b) {
        along += at.n(b) * r_w[b];
        trace += 2 * at.rho.col(b).cwiseProduct(beam_.chebyshev.quadrature).transpose() * r_w[b];
    }
    for (int a = 0; a < 3; ++a) {
        k.block(a, 3, 1, 3 * m_) = at.n(a) * trace;
        k.block(a, 3, 1, 3 * m_) -= at.rho.col(a).cwiseProduct(beam_.chebyshev.quadrature).transpose() * along;
        k.block(a, 3, 1, 3 * m_) -= at.along.cwiseProduct(beam_.chebyshev.quadrature).transpose() * r_w[a];
    }
    k.topLeftCorner<3, 3>() = at.inertia - lambda * Eigen::Matrix3d::Identity();
    k.block(0, last, 3, 1) = -at.n;
    k.block(last, 0, 1, 3) = at.n.transpose();
    return k;
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::parameter_derivative(const Eigen::VectorXd& q,
                                                                                 double p) const {
    return 2 * p * second_share(q) * load_vector(state(q));
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::second_parameter_derivative(const Eigen::VectorXd& q,
                                                                                        double) const {
    return 2 * second_share(q) * load_vector(state(q));
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::parameter_derivative_along(const Eigen::VectorXd& q,
                                                                                       double p,
                                                                                       const Eigen::VectorXd& v) const {
    const State at = state(q);
    const double slope = 2 * p * second_share(q);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n_unknowns());
    y.segment(3, 3 * m_) = slope * load_derivative(at, beam_.displacement_derivative(at)) * v;
    if (control_ == BeamControl::momentum) y -= 2 * slope / moment(q) * v(3 * m_ + 3) * load_vector(at);
    return y;
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::weights(const Eigen::VectorXd&) const {
    const double l = p_[Beam::length], bend = l * l * l / 8, stretch = l / 2;
    const double moments = p_[Beam::inertia_1] + p_[Beam::inertia_2] + p_[Beam::inertia_3] + l * l * l / 3;
    Eigen::VectorXd y = Eigen::VectorXd::Ones(n_unknowns());
    for (int a = 0; a < 3; ++a)
        y.segment(3 + a * m_, m_) = (a < 2 ? bend * bend : stretch * stretch) / l * beam_.chebyshev.quadrature;
    y(3 * m_ + 3) = 1 / (moments * moments);
    return y;
}

EQUILIBRIA_INLINE BeamSolution RotatingBodyBeamBoundary::solve(Eigen::VectorXd q, double p, int most_steps) const {
    require_finite(sized(q), "q");
    require(std::isfinite(p), "p", p, "must be finite");
    const double length = std::sqrt(q.dot(weights(q).cwiseProduct(q)));
    const auto correction =
        correct_at(*this, q, p, {.most_steps = most_steps, .tolerance = 1e-13 * (1 + length), .rounding = 1e4});
    BeamSolution y;
    y.status = correction.status;
    y.steps = correction.steps;
    y.p = p;
    y.residual = residual(q, p).lpNorm<Eigen::Infinity>();
    y.q = std::move(q);
    return y;
}

EQUILIBRIA_INLINE BeamPlace RotatingBodyBeamBoundary::shape(const Eigen::VectorXd& q, double z) const {
    require(z >= 0 && z <= p_[Beam::length], "z", z, "must lie on the beam: in [0, length]");
    return beam_.shape(state(q), z);
}

EQUILIBRIA_INLINE Eigen::Vector3d RotatingBodyBeamBoundary::defect(const Eigen::VectorXd& q, double p, double z) const {
    const BeamPlace at = shape(q, z);
    const State all = state(q);
    const Eigen::RowVectorXd t = beam_.chebyshev.polynomials(z).head(m_) * beam_.chebyshev.coefficients;
    const Eigen::Vector3d rho = at.u + Eigen::Vector3d(0, 0, z) - all.centre,
                          f = square_of_speed(moment(q), p) * (rho - all.n * all.n.dot(rho));
    const double mu3 = p_[Beam::stretching], on = coupled_ ? 1 : 0;
    const Eigen::Vector2d slope = at.first.head<2>(), curvature = at.second.head<2>();
    const double n = mu3 * (at.first(2) + on * 0.5 * slope.squaredNorm()),
                 n_z = mu3 * (at.second(2) + on * slope.dot(curvature));
    Eigen::Vector3d y;
    for (int a = 0; a < 2; ++a)
        y(a) = bending(a) * t.dot(all.w.col(a)) - on * (n_z * slope(a) + n * curvature(a)) - f(a);
    y(2) = -n_z - f(2);
    return y;
}

EQUILIBRIA_INLINE double RotatingBodyBeamBoundary::strain_energy(const Eigen::VectorXd& q) const {
    const State at = state(q);
    return 0.5 * (bending(0) * beam_.chebyshev.quadrature.dot(at.curvature.col(0).cwiseAbs2()) +
                  bending(1) * beam_.chebyshev.quadrature.dot(at.curvature.col(1).cwiseAbs2()) +
                  p_[Beam::stretching] * beam_.chebyshev.quadrature.dot(at.tension.cwiseAbs2()));
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::bent(State at, double lambda, double p) const {
    beam_.place(at);
    const double square = square_of_speed(lambda, p);
    const Eigen::MatrixXd f = square * BeamCollocation::load(at);
    Eigen::VectorXd y(n_unknowns());
    y.head<3>() = at.n;
    at.w = Eigen::MatrixXd(m_, 3);
    at.w.col(2) = -f.col(2) / p_[Beam::stretching];
    at.tension = beam_.tension_at * at.w.col(2);
    for (int a = 0; a < 2; ++a) at.w.col(a) = (f.col(a) + stiffening(at, a)) / bending(a);
    for (int a = 0; a < 3; ++a) y.segment(3 + a * m_, m_) = at.w.col(a);
    y(3 * m_ + 3) = lambda;
    return y;
}

EQUILIBRIA_INLINE Eigen::MatrixXd RotatingBodyBeamBoundary::scaled_load(const State& at) const {
    Eigen::MatrixXd y = BeamCollocation::load(at);
    for (int a = 0; a < 3; ++a) y.col(a) *= load_factor(a);
    return y;
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::load_vector(const State& at) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n_unknowns());
    y.segment(3, 3 * m_) = scaled_load(at).reshaped();
    return y;
}

EQUILIBRIA_INLINE Eigen::VectorXd RotatingBodyBeamBoundary::stiffening(const State& at, int a) const {
    if (!coupled_) return Eigen::VectorXd::Zero(m_);
    return p_[Beam::stretching] *
           (at.w.col(2).cwiseProduct(at.slope.col(a)) + at.tension.cwiseProduct(at.curvature.col(a)));
}

EQUILIBRIA_INLINE Eigen::MatrixXd RotatingBodyBeamBoundary::load_derivative(
    const State& at, const Array<Eigen::MatrixXd, 3>& r_w) const {
    const double mass = p_[Beam::body_mass] + p_[Beam::length];
    Array<Eigen::MatrixXd, 3> rho_w = r_w;
    Eigen::MatrixXd along = Eigen::MatrixXd::Zero(m_, 3 * m_), y = Eigen::MatrixXd::Zero(3 * m_, n_unknowns());
    for (int a = 0; a < 3; ++a) {
        const Eigen::RowVectorXd centre = beam_.chebyshev.quadrature.transpose() * r_w[a] / mass;
        rho_w[a].rowwise() -= centre;
        along += at.n(a) * rho_w[a];
    }
    for (int a = 0; a < 3; ++a) {
        const double c = load_factor(a);
        y.block(a * m_, 3, m_, 3 * m_) = c * (rho_w[a] - at.n(a) * along);
        y.block(a * m_, 0, m_, 3) = -c * at.n(a) * at.rho;
        y.block(a * m_, a, m_, 1) -= c * at.along;
    }
    return y;
}

}  // namespace equilibria::mechanisms
