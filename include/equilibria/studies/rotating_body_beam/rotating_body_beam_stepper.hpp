/// \file
/// One motion of a rotating body with a beam, a step at a time, with its evidence: what is conserved and what is lost.
/// See rotating_body_beam_motion.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/dynamics/adaptive_integrator.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_equations.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_state.hpp>

namespace equilibria::mechanisms::detail {

/// One motion, a step at a time: a, u, p, the quaternion (x, y, z, w), what damping has taken.
class BeamStepper {
public:
    using Numbers = AdaptiveIntegrator::State;

    /// The motion's equations must outlive the stepper.
    BeamStepper(const BeamMotion& motion, Numbers start, const MotionOptions& options)
        : motion_(motion), integrator_(equations(motion), start, first_step(motion, start), options) {
        space_momentum_ = space_momentum();
        start_energy_ = energy_ = energy();
    }

    double time() const { return integrator_.time(); }
    BodyBeamStatus status() const { return body_beam_status(integrator_.status()); }
    const BodyBeamEvidence& evidence() const { return evidence_; }
    BeamMotion::Rates rates() const { return rates(motion_, y()); }
    double energy() const { return motion_.energy(momentum(), modes(), modal_momentum(motion_, y())); }
    double dissipated() const { return y().back(); }
    Eigen::Vector3d momentum() const { return momentum(y()); }
    BeamVector modes() const { return modes(motion_, y()); }
    Eigen::Quaterniond orientation() const { return orientation(y()).normalized(); }
    Eigen::Vector3d space_momentum() const { return orientation() * momentum(); }

    /// One step that ends at `until` or before. False where there is none: `status` says why.
    bool step(double until) {
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

    /// Steps until the motion is at rest in the body frame for a whole turn, or longest_time.
    BodyBeamStatus settle(double longest_time, double tolerance, BodyBeamResidual& residual, double& velocity_change) {
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
                for (const auto& before : turn)
                    velocity_change = std::max(velocity_change, (before - w).norm() / w.norm());
                return BodyBeamStatus::settled;
            }
        } while (time() < longest_time && step(longest_time));
        return status() == BodyBeamStatus::finished ? BodyBeamStatus::time_over : status();
    }

private:
    static AdaptiveIntegrator::Rates equations(const BeamMotion& motion) {
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
    /// A hundredth of the time of a radian, or of that in which the modes change by their own size.
    static double first_step(const BeamMotion& motion, const Numbers& y) {
        const auto r = rates(motion, y);
        return 0.01 /
               std::max({r.angular_velocity.norm(), r.modes.norm() / std::max(modes(motion, y).norm(), 1e-3), 1.0});
    }
    static BeamMotion::Rates rates(const BeamMotion& motion, const Numbers& y) {
        return motion.rates(momentum(y), modes(motion, y), modal_momentum(motion, y));
    }
    static Eigen::Vector3d momentum(const Numbers& y) { return {y[0], y[1], y[2]}; }
    static BeamVector modes(const BeamMotion& motion, const Numbers& y) {
        return Eigen::Map<const BeamVector>(y.data() + 3, 3 * motion.k);
    }
    static BeamVector modal_momentum(const BeamMotion& motion, const Numbers& y) {
        return Eigen::Map<const BeamVector>(y.data() + 3 + 3 * motion.k, 3 * motion.k);
    }
    static Eigen::Quaterniond orientation(const Numbers& y) {
        const double* const c = y.data() + y.size() - 5;
        return {c[3], c[0], c[1], c[2]};
    }
    const Numbers& y() const { return integrator_.state(); }

    const BeamMotion& motion_;
    AdaptiveIntegrator integrator_;
    double energy_ = 0, start_energy_ = 0;
    Eigen::Vector3d space_momentum_;
    BodyBeamEvidence evidence_;
};

}  // namespace equilibria::mechanisms::detail
