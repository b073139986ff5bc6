/// \file
/// States and results of the motion of a rotating body with a beam; see rotating_body_beam_motion.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/motion_status.hpp>

namespace equilibria::mechanisms {

/// Kelvin-Voigt damping, (2.1) of Baillieul: D = 1/2 int k_1 (u1'')_t^2 + k_2 (u2'')_t^2 + k_3 (u3')_t^2.
struct BeamDamping {
    double bending_1 = 0;   ///< k_1, along the axis 1
    double bending_2 = 0;   ///< k_2, along the axis 2
    double stretching = 0;  ///< k_3

    /// Throws InvalidArgument unless all are finite, 0 or more.
    void validate() const {
        const auto good = [](const char* name, double k) {
            require(std::isfinite(k) && k >= 0, name, k, "must be finite, 0 or more");
        };
        good("damping.bending_1", bending_1);
        good("damping.bending_2", bending_2);
        good("damping.stretching", stretching);
    }
};

/// Why a motion of a body with a beam ended.
enum class BodyBeamStatus {
    finished,        ///< came to the last time asked for
    settled,         ///< came to rest in the body frame
    time_over,       ///< did not settle in the longest time
    too_many_steps,  ///< most_steps steps were tried
    step_too_small,  ///< the tolerances ask for steps below rounding
    not_finite,      ///< a number of the state is none
};

/// In words.
inline const char* to_string(BodyBeamStatus status) {
    constexpr const char* names[] = {"finished",       "settled",        "time over",
                                     "too many steps", "step too small", "not finite"};
    return names[static_cast<int>(status)];
}

/// The integration's status as the motion's.
inline BodyBeamStatus body_beam_status(MotionStatus status) {
    switch (status) {
        case MotionStatus::finished: return BodyBeamStatus::finished;
        case MotionStatus::too_many_steps: return BodyBeamStatus::too_many_steps;
        case MotionStatus::step_too_small: return BodyBeamStatus::step_too_small;
        default: return BodyBeamStatus::not_finite;
    }
}

/// Body and beam in motion; K modes a direction, in the order of RotatingBodyBeamBase.
template <int K>
struct BodyBeamState {
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< Y: from the body frame to space
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< a: angular, about the centre of mass, in the body frame
    Eigen::Vector<double, 3 * K> modes = Eigen::Vector<double, 3 * K>::Zero();     ///< u
    Eigen::Vector<double, 3 * K> velocity = Eigen::Vector<double, 3 * K>::Zero();  ///< u'
};

/// A state of the motion at one time.
template <int K>
struct BodyBeamSample {
    double time = 0;                                             ///< since the start
    BodyBeamState<K> state;                                      ///< body and beam
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< W, in the body frame
    Eigen::Vector3d space_momentum = Eigen::Vector3d::Zero();    ///< Y a: constant
    double energy = 0;                                           ///< T + V
    double dissipated = 0;                                       ///< lost since the start, integrated along: int 2 D

    /// Between the momentum and the angular velocity, in radians.
    double wobble() const {
        return std::atan2(state.momentum.cross(angular_velocity).norm(), state.momentum.dot(angular_velocity));
    }
};

/// What integration leaves of the laws, over the ends of all steps.
struct BodyBeamEvidence {
    std::uint64_t steps = 0;        ///< that were tried
    std::uint64_t evaluations = 0;  ///< of the rates
    double momentum_drift = 0;      ///< the largest |Y a - its start| / |a|
    double energy_balance = 0;      ///< the largest |energy + dissipated - their start|, over the energy at the start
    double energy_increase = 0;     ///< the largest of a step, over the energy at the start
};

/// A motion at given times, with its evidence.
template <int K>
struct BodyBeamMotion {
    BodyBeamStatus status = BodyBeamStatus::finished;  ///< why it ended
    double time = 0;                                   ///< how far it came
    std::vector<BodyBeamSample<K>> samples;            ///< at the given times, as far as it came
    BodyBeamEvidence evidence;                         ///< over all steps
};

/// How far a state is from a relative equilibrium, without units.
struct BodyBeamResidual {
    double velocity = 0;      ///< |u'| over |W| l^(3/2)
    double deflection = 0;    ///< l^(-3/2) times the displacement by which the beam, at rest, would balance p'
    double misalignment = 0;  ///< the larger of |a x W| / (|a| |W|) and |J W - (n J n) W| / |J W|, n = W / |W|: (2.6)

    double largest() const { return std::max({velocity, deflection, misalignment}); }  ///< of the three
};

/// A motion that was followed until it was at rest in the body frame.
template <int K>
struct BodyBeamSettling {
    BodyBeamStatus status = BodyBeamStatus::settled;  ///< why it ended
    BodyBeamSample<K> last;                           ///< the state at its end
    BodyBeamResidual residual;                        ///< at `last`
    /// The largest |W - W at `last`| / |W| over the turn before, the axes those of the body; where settled.
    double velocity_change = 0;
    BodyBeamEvidence evidence;  ///< over all steps

    bool settled() const { return status == BodyBeamStatus::settled; }  ///< it came to rest in the body frame
};

}  // namespace equilibria::mechanisms
