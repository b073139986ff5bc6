/// \file
/// One motion of a rotating body with a beam by Boost.Odeint, a step at a time. See rotating_body_beam_motion.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_equations.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_state.hpp>

namespace equilibria::mechanisms::detail {

/// One motion, a step at a time: a, u, p, the quaternion (x, y, z, w), what damping has taken.
class BeamStepper {
public:
    using Numbers = std::vector<double>;

    BeamStepper(const BeamMotion& motion, Numbers start, const MotionOptions& options)
        : motion_(motion),
          options_(options),
          pair_(
              boost::numeric::odeint::make_controlled(options.absolute_tolerance, options.relative_tolerance, Pair())),
          y_(std::move(start)) {
        options.validate();
        space_momentum_ = space_momentum();
        start_energy_ = energy_ = energy();
        const auto r = rates();
        step_ = 0.01 / std::max({r.angular_velocity.norm(), r.modes.norm() / std::max(modes(y_).norm(), 1e-3), 1.0});
    }

    double time() const { return time_; }
    BodyBeamStatus status() const { return status_; }
    const BodyBeamEvidence& evidence() const { return evidence_; }
    BeamMotion::Rates rates() const { return motion_.rates(momentum(), modes(y_), modal_momentum(y_)); }
    double energy() const { return motion_.energy(momentum(), modes(y_), modal_momentum(y_)); }
    double dissipated() const { return y_.back(); }
    Eigen::Vector3d momentum() const { return momentum(y_); }
    BeamVector modes() const { return modes(y_); }
    Eigen::Quaterniond orientation() const { return orientation(y_).normalized(); }
    Eigen::Vector3d space_momentum() const { return orientation() * momentum(); }

    /// One step that ends at `until` or before. False where there is none: `status` says why.
    bool step(double until) {
        const Rates system = [this](const Numbers& y, Numbers& rate, double) {
            ++evidence_.evaluations;
            const auto r = motion_.rates(momentum(y), modes(y), modal_momentum(y));
            const Eigen::Vector3d& w = r.angular_velocity;
            const Eigen::Quaterniond turning = orientation(y) * Eigen::Quaterniond(0, w(0), w(1), w(2));
            auto at = std::copy(r.momentum.begin(), r.momentum.end(), rate.begin());
            at = std::copy(r.modes.begin(), r.modes.end(), at);
            at = std::copy(r.modal_momentum.begin(), r.modal_momentum.end(), at);
            for (const double x : turning.coeffs()) *at++ = 0.5 * x;
            *at = r.loss;
        };
        for (;;) {
            if (evidence_.steps >= options_.most_steps) return end(BodyBeamStatus::too_many_steps);
            ++evidence_.steps;
            if (options_.largest_step > 0) step_ = std::min(step_, options_.largest_step);
            const bool last = time_ + step_ >= until;
            double dt = last ? until - time_ : step_, t = time_;
            const bool done = pair_.try_step(std::cref(system), y_, t, dt) == boost::numeric::odeint::success;
            if (!std::all_of(y_.begin(), y_.end(), [](double x) { return std::isfinite(x); }))
                return end(BodyBeamStatus::not_finite);
            if (done) {
                time_ = last ? until : t;
                step_ = last ? std::max(step_, dt) : dt;
                break;
            }
            step_ = dt;
            if (!(dt > 1e-14 * std::max(1.0, time_))) return end(BodyBeamStatus::step_too_small);
        }
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
            if (turn.empty()) since = time_;
            const Eigen::Vector3d& w = r.angular_velocity;
            turn.push_back(w);
            if (time_ - since >= 2 * std::numbers::pi / w.norm()) {
                for (const auto& before : turn)
                    velocity_change = std::max(velocity_change, (before - w).norm() / w.norm());
                return BodyBeamStatus::settled;
            }
        } while (time_ < longest_time && step(longest_time));
        return status_ == BodyBeamStatus::finished ? BodyBeamStatus::time_over : status_;
    }

private:
    using Pair = boost::numeric::odeint::runge_kutta_fehlberg78<Numbers>;
    using Controlled = boost::numeric::odeint::result_of::make_controlled<Pair>::type;
    using Rates = std::function<void(const Numbers&, Numbers&, double)>;

    static Eigen::Vector3d momentum(const Numbers& y) { return {y[0], y[1], y[2]}; }
    BeamVector modes(const Numbers& y) const { return Eigen::Map<const BeamVector>(y.data() + 3, 3 * motion_.k); }
    BeamVector modal_momentum(const Numbers& y) const {
        return Eigen::Map<const BeamVector>(y.data() + 3 + 3 * motion_.k, 3 * motion_.k);
    }
    static Eigen::Quaterniond orientation(const Numbers& y) {
        const double* const c = y.data() + y.size() - 5;
        return {c[3], c[0], c[1], c[2]};
    }
    bool end(BodyBeamStatus status) {
        status_ = status;
        return false;
    }

    const BeamMotion& motion_;
    MotionOptions options_;
    Controlled pair_;
    Numbers y_;
    double time_ = 0, step_ = 0, energy_ = 0, start_energy_ = 0;
    Eigen::Vector3d space_momentum_;
    BodyBeamStatus status_ = BodyBeamStatus::finished;
    BodyBeamEvidence evidence_;
};

}  // namespace equilibria::mechanisms::detail
