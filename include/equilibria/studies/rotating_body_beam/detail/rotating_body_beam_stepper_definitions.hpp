/// \file
/// See studies/rotating_body_beam/rotating_body_beam_stepper.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/studies/rotating_body_beam/rotating_body_beam_stepper.hpp>

namespace equilibria::mechanisms::detail {

EQUILIBRIA_INLINE BeamStepper::BeamStepper(const BeamMotion& motion, Numbers start, const MotionOptions& options)
    : motion_(motion), integrator_(equations(motion), start, first_step(motion, start), options) {
    space_momentum_ = space_momentum();
    start_energy_ = energy_ = energy();
}

EQUILIBRIA_INLINE double BeamStepper::energy() const {
    return motion_.energy(momentum(), modes(), modal_momentum(motion_, y()));
}

EQUILIBRIA_INLINE Eigen::Quaterniond BeamStepper::orientation() const { return orientation(y()).normalized(); }

EQUILIBRIA_INLINE bool BeamStepper::step(double until) {
    const bool done = integrator_.step(until);
    evidence_.steps = integrator_.steps();
    evidence_.evaluations = integrator_.evaluations();
    if (!done) return false;
    constexpr double least = std::numeric_limits<double>::min();
    const double scale = std::max(std::abs(start_energy_), least), size = std::max(space_momentum_.norm(), least),
                 now = energy();
    const auto raise = [](double& most, double value) { most = std::max(most, value); };
    raise(evidence_.energy_increase, (now - energy_) / scale);
    raise(evidence_.energy_balance, std::abs(now + dissipated() - start_energy_) / scale);
    raise(evidence_.momentum_drift, (space_momentum() - space_momentum_).norm() / size);
    energy_ = now;
    return true;
}

EQUILIBRIA_INLINE BodyBeamStatus BeamStepper::settle(double longest_time, double tolerance, BodyBeamResidual& residual,
                                                     double& velocity_change) {
    std::vector<Eigen::Vector3d> turn;  // the angular velocities since the residual is small
    double since = 0;
    do {
        const auto r = rates();
        residual = motion_.residual(momentum(), modes(), r);
        if (!(residual.largest() < tolerance)) {
            turn.clear();
            continue;
        }
        if (turn.empty()) since = time();
        const Eigen::Vector3d& w = r.angular_velocity;
        turn.push_back(w);
        if (time() - since >= 2 * std::numbers::pi / w.norm()) {
            for (const auto& before : turn) velocity_change = std::max(velocity_change, (before - w).norm() / w.norm());
            return BodyBeamStatus::settled;
        }
    } while (time() < longest_time && step(longest_time));
    return status() == BodyBeamStatus::finished ? BodyBeamStatus::time_over : status();
}

EQUILIBRIA_INLINE AdaptiveIntegrator::Rates BeamStepper::equations(const BeamMotion& motion) {
    return [&motion](const Numbers& y, Numbers& rate, double) {
        const auto r = rates(motion, y);
        const Eigen::Vector3d& w = r.angular_velocity;
        const Eigen::Quaterniond turning = orientation(y) * Eigen::Quaterniond(0, w(0), w(1), w(2));
        auto at = std::copy(r.momentum.begin(), r.momentum.end(), rate.begin());
        at = std::copy(r.modes.begin(), r.modes.end(), at);
        at = std::copy(r.modal_momentum.begin(), r.modal_momentum.end(), at);
        for (const double x : turning.coeffs()) *at++ = 0.5 * x;
        *at = r.loss;
    };
}

EQUILIBRIA_INLINE double BeamStepper::first_step(const BeamMotion& motion, const Numbers& y) {
    const auto r = rates(motion, y);
    return 0.01 / std::max({r.angular_velocity.norm(), r.modes.norm() / std::max(modes(motion, y).norm(), 1e-3), 1.0});
}

EQUILIBRIA_INLINE BeamMotion::Rates BeamStepper::rates() const { return rates(motion_, y()); }

EQUILIBRIA_INLINE BeamVector BeamStepper::modes() const { return modes(motion_, y()); }

EQUILIBRIA_INLINE BeamVector BeamStepper::modal_momentum(const BeamMotion& motion, const Numbers& y) {
    return Eigen::Map<const BeamVector>(y.data() + 3 + 3 * motion.k, 3 * motion.k);
}

EQUILIBRIA_INLINE Eigen::Vector3d BeamStepper::space_momentum() const { return orientation() * momentum(); }

}  // namespace equilibria::mechanisms::detail
