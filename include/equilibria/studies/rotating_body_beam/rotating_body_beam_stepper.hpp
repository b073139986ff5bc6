/// \file
/// One motion of a rotating body with a beam, a step at a time, with its evidence: what is conserved and what is lost.
/// See rotating_body_beam_motion.hpp.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/compiled.hpp>
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
    BeamStepper(const BeamMotion& motion, Numbers start, const MotionOptions& options);

    double time() const { return integrator_.time(); }
    BodyBeamStatus status() const { return body_beam_status(integrator_.status()); }
    const BodyBeamEvidence& evidence() const { return evidence_; }
    BeamMotion::Rates rates() const;
    double energy() const;
    double dissipated() const { return y().back(); }
    Eigen::Vector3d momentum() const { return momentum(y()); }
    BeamVector modes() const;
    Eigen::Quaterniond orientation() const;
    Eigen::Vector3d space_momentum() const;

    /// One step that ends at `until` or before. False where there is none: `status` says why.
    bool step(double until);

    /// Steps until the motion is at rest in the body frame for a whole turn, or longest_time.
    BodyBeamStatus settle(double longest_time, double tolerance, BodyBeamResidual& residual, double& velocity_change);

private:
    static AdaptiveIntegrator::Rates equations(const BeamMotion& motion);
    /// A hundredth of the time of a radian, or of that in which the modes change by their own size.
    static double first_step(const BeamMotion& motion, const Numbers& y);
    static BeamMotion::Rates rates(const BeamMotion& motion, const Numbers& y) {
        return motion.rates(momentum(y), modes(motion, y), modal_momentum(motion, y));
    }
    static Eigen::Vector3d momentum(const Numbers& y) { return {y[0], y[1], y[2]}; }
    static BeamVector modes(const BeamMotion& motion, const Numbers& y) {
        return Eigen::Map<const BeamVector>(y.data() + 3, 3 * motion.k);
    }
    static BeamVector modal_momentum(const BeamMotion& motion, const Numbers& y);
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

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_stepper_definitions.hpp>
#endif
