/// \file
/// The motion of a rigid body with an elastic, damped beam, free in space, by Boost.Odeint. Source: Baillieul,
/// "Parametric dependence in the equilibrium dynamics of rotating structures", section 2, (2.1) to (2.4), with Galerkin
/// modes for the beam.
///
/// About the common centre of mass, in the body frame, T = W^T J(u) W / 2 + W^T P(u) u' + u'^T M u' / 2 with the
/// angular velocity W, and with the momenta a = J W + P u' and p = P^T W + M u' the equations are a' = a x W, u' =
/// dH/dp, p' = -dH/du - dD/du'. Gauss's quadrature of the modes is exact here: the beam is 2 K + 3 particles, and dT/du
/// a sum over them.
///
/// Why momenta: a is constant in space whatever the step, and no acceleration has to be solved for. Why an explicit
/// pair of high order (Fehlberg's 7(8)): few steps at tolerances near rounding. Where it fails: the step is bounded by
/// the fastest mode's frequency and damping, which grow like K^4 and K^8 (four modes of a unit beam with k = 0.3: 8,000
/// steps a unit of time, one mode 30); some undamped motions are chaotic, and then the laws hold but no digit does.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/dynamics/motion_options.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_equations.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_state.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_stepper.hpp>

namespace equilibria::mechanisms {

/// The equations of motion of RotatingBodyBeam<K, Strain> with damping. K is at most 8.
template <int K, BeamStrain Strain = BeamStrain::linear>
class RotatingBodyBeamMotion {
public:
    static_assert(K <= detail::most_beam_modes, "equilibria: the motion is for 8 modes a direction or fewer");
    using Model = RotatingBodyBeam<K, Strain>;           ///< of the relative equilibria
    using Base = typename Model::Base;                   ///< names the parameters
    static constexpr int n_modes = 3 * K;                ///< shapes in all
    static constexpr BeamStrain strain = Strain;         ///< of the beam
    using State = BodyBeamState<K>;                      ///< body and beam in motion
    using Sample = BodyBeamSample<K>;                    ///< a state with what is derived of it
    using Modes = Eigen::Vector<double, n_modes>;        ///< u, or rates of it
    using Coupling = Eigen::Matrix<double, 3, n_modes>;  ///< P(u)

    /// p: the model's; its speed does not matter. Throws InvalidArgument where a parameter is none, where the damping
    /// is negative, or where the body's inertia about its own centre of mass is not positive definite.
    RotatingBodyBeamMotion(const Parameters<Model>& p, const BeamDamping& damping) : p_(p) {
        Base::validate(p);
        damping.validate();
        const Eigen::Vector3d c(p[Base::centre_1], p[Base::centre_2], p[Base::centre_3]);
        Eigen::Matrix3d own = p[Base::body_mass] * (c * c.transpose());
        for (int d = 0; d < 3; ++d) own(d, d) += p[Base::inertia_1 + d] - p[Base::body_mass] * c.squaredNorm();
        require(own(0, 0) > 0 && own(0, 0) * own(1, 1) > own(0, 1) * own(0, 1) && own.determinant() > 0, "centre",
                c.norm(), "must be where the inertia about it is positive definite");

        auto& m = motion_;
        const double l = p[Base::length], root = std::sqrt(l), l2 = l * l;
        m.k = K;
        m.coupled = Strain == BeamStrain::coupled;
        m.length = l;
        m.mass = p[Base::body_mass] + l;
        m.stretching = p[Base::stretching];
        m.body_moment = p[Base::body_mass] * c;
        m.body_inertia.setZero();
        for (int d = 0; d < 3; ++d) m.body_inertia(d, d) = p[Base::inertia_1 + d];
        Base::modes.for_each_node([&](double z, double w) {
            const auto phi = Base::modes.bending(z), psi = Base::modes.stretching(z);
            detail::BeamNode node;
            node.weight = w * l;
            node.place = z * l;
            for (auto* shapes : {&node.bending, &node.stretching, &node.bending_slope, &node.stretching_slope})
                shapes->resize(K);
            for (int i = 0; i < K; ++i) {
                node.bending(i) = phi.value[i] / root;
                node.stretching(i) = psi.value[i] / root;
                node.bending_slope(i) = phi.first[i] / (l * root);
                node.stretching_slope(i) = psi.first[i] / (l * root);
            }
            m.nodes.push_back(node);
        });
        const double stiffness[] = {p[Base::bending_1] / (l2 * l2), p[Base::bending_2] / (l2 * l2),
                                    p[Base::stretching] / l2};
        const double loss[] = {damping.bending_1 / (l2 * l2), damping.bending_2 / (l2 * l2), damping.stretching / l2};
        m.mean.resize(n_modes);
        for (int d = 0; d < 3; ++d) {
            const auto at = static_cast<std::size_t>(d);
            Eigen::MatrixXd form(K, K);
            for (int i = 0; i < K; ++i) {
                m.mean(K * d + i) = root * (d < 2 ? Base::modes.bending_mean[i] : Base::modes.stretching_mean[i]);
                for (int j = 0; j < K; ++j)
                    form(i, j) = d < 2 ? Base::modes.bending_stiffness[i][j] : Base::modes.stretching_stiffness[i][j];
            }
            m.stiffness[at] = stiffness[d] * form;
            m.loss[at] = loss[d] * form;
            m.compliance[at] = equilibria::detail::positive_inverse(m.stiffness[at]);
        }
    }

    const Parameters<Model>& parameters() const { return p_; }  ///< as they were given

    /// J(u), (2.5).
    Eigen::Matrix3d inertia(const Modes& u) const { return motion_.geometry(u).inertia; }
    /// P(u): column k is int r x dr/du_k dz, less the centre of mass times int dr/du_k dz.
    Coupling coupling(const Modes& u) const { return motion_.geometry(u).coupling; }
    /// M v.
    Modes modal_inertia(const Modes& v) const { return motion_.modal_inertia(v); }
    /// V(u).
    double strain_energy(const Modes& u) const {
        Array<double, n_modes> values;
        std::copy(u.begin(), u.end(), values.begin());
        return Base::strain_energy(values, p_);
    }

    /// W of a state, in the body frame.
    Eigen::Vector3d angular_velocity(const State& x) const {
        const auto g = motion_.geometry(x.modes);
        Eigen::Vector3d spin = x.momentum;
        for (int i = 0; i < n_modes; ++i) spin -= g.coupling.col(i) * x.velocity(i);
        return g.inertia.inverse() * spin;
    }
    /// p = P^T W + M u'.
    Modes modal_momentum(const State& x) const {
        const Eigen::Vector3d w = angular_velocity(x);
        const Coupling p = coupling(x.modes);
        Modes y = modal_inertia(x.velocity);
        for (int i = 0; i < n_modes; ++i) y(i) += p.col(i).dot(w);
        return y;
    }

    /// The equations of motion at momenta a, p and modes u.
    struct Rates {
        Eigen::Vector3d angular_velocity;  ///< W = dH/da
        Eigen::Vector3d momentum;          ///< a'
        Modes modes;                       ///< u' = dH/dp
        Modes modal_momentum;              ///< p'
        double loss;                       ///< 2 D: what damping takes a unit of time
    };
    /// At momenta a, p and modes u.
    Rates rates(const Eigen::Vector3d& a, const Modes& u, const Modes& p) const {
        const auto r = motion_.rates(a, u, p);
        return {r.angular_velocity, r.momentum, r.modes, r.modal_momentum, r.loss};
    }
    /// H = T + V at momenta a, p and modes u.
    /// \{
    double energy(const Eigen::Vector3d& a, const Modes& u, const Modes& p) const { return motion_.energy(a, u, p); }
    double energy(const State& x) const { return energy(x.momentum, x.modes, modal_momentum(x)); }
    /// \}

    /// How far the state is from a relative equilibrium.
    BodyBeamResidual residual(const State& x) const {
        return motion_.residual(x.momentum, x.modes, motion_.rates(x.momentum, x.modes, modal_momentum(x)));
    }

    /// The relative equilibrium that a state is, or is near: the unknowns n, u, lambda of the model at the speed |W|,
    /// which is not 0.
    Unknowns<Model> relative_equilibrium(const State& x) const {
        const Eigen::Vector3d n = angular_velocity(x).normalized();
        Unknowns<Model> q;
        for (int i = 0; i < 3; ++i) q[i] = n(i);
        for (int i = 0; i < n_modes; ++i) q[Model::first_mode + i] = x.modes(i);
        q[Model::multiplier] = n.dot(inertia(x.modes) * n);
        return q;
    }
    /// The other way: the state that turns with a speed in the relative equilibrium q.
    static State turning(const Unknowns<Model>& q, double speed) {
        State x;
        x.momentum = q[Model::multiplier] * speed * Eigen::Vector3d(q[0], q[1], q[2]);
        for (int i = 0; i < n_modes; ++i) x.modes(i) = q[Model::first_mode + i];
        return x;
    }

    /// A motion at rest in the body frame has zeros in its state.
    static constexpr MotionOptions fine{.absolute_tolerance = 1e-13};

    /// The motion from `start` at time 0, at `times`: none below 0, none below the one before it. Throws
    /// InvalidArgument where these, the start or an option are none; all else that may happen is a status.
    BodyBeamMotion<K> integrate(const State& start, const std::vector<double>& times,
                                const MotionOptions& options = fine) const {
        equilibria::detail::require_rising_times(times, 0);
        detail::BeamStepper stepper(motion_, numbers(start), options);
        BodyBeamMotion<K> y;
        for (const double t : times) {
            while (stepper.time() < t && stepper.step(t)) {
            }
            if (stepper.time() < t) break;
            y.samples.push_back(sample(stepper));
        }
        y.status = stepper.status();
        y.time = stepper.time();
        y.evidence = stepper.evidence();
        return y;
    }

    /// The motion from `start` until it is at rest in the body frame: until the residual has been below `tolerance` for
    /// a whole turn. The motion itself has to come there; nothing is corrected. Throws InvalidArgument where the start
    /// has no momentum, or an argument is none; all else is a status.
    BodyBeamSettling<K> settle(const State& start, double longest_time, double tolerance = 1e-9,
                               const MotionOptions& options = fine) const {
        require(std::isfinite(longest_time) && longest_time > 0, "longest_time", longest_time, "must be positive");
        require(tolerance > 0 && tolerance < 1, "tolerance", tolerance, "must be between 0 and 1");
        require(start.momentum.norm() > 0, "start.momentum", start.momentum.norm(), "must not be zero");
        detail::BeamStepper stepper(motion_, numbers(start), options);
        BodyBeamSettling<K> y;
        y.status = stepper.settle(longest_time, tolerance, y.residual, y.velocity_change);
        y.last = sample(stepper);
        y.evidence = stepper.evidence();
        return y;
    }

private:
    std::vector<double> numbers(const State& start) const {
        require_finite(start.momentum, "start.momentum");
        require_finite(start.modes, "start.modes");
        require_finite(start.velocity, "start.velocity");
        const double norm = start.orientation.norm();
        require(std::abs(norm - 1) < 1e-6, "start.orientation", norm, "must be a quaternion of norm 1");
        std::vector<double> y(start.momentum.begin(), start.momentum.end());
        const Modes p = modal_momentum(start);
        y.insert(y.end(), start.modes.begin(), start.modes.end());
        y.insert(y.end(), p.begin(), p.end());
        for (const double x : start.orientation.coeffs()) y.push_back(x / norm);
        y.push_back(0);
        return y;
    }
    static Sample sample(const detail::BeamStepper& stepper) {
        const auto r = stepper.rates();
        Sample x;
        x.time = stepper.time();
        x.state = {stepper.orientation(), stepper.momentum(), stepper.modes(), r.modes};
        x.angular_velocity = r.angular_velocity;
        x.space_momentum = stepper.space_momentum();
        x.energy = stepper.energy();
        x.dissipated = stepper.dissipated();
        return x;
    }

    Parameters<Model> p_;
    detail::BeamMotion motion_;
};

/// A state with a momentum of given size in a random direction, a random orientation, and modes of which the lowest is
/// uniform in +-deflection l^(3/2), the next ones by their stiffness smaller, with velocities to match.
template <int K>
BodyBeamState<K> random_body_beam_state(Generator& generator, double momentum, double length, double deflection = 0.1) {
    const auto direction = [&](auto vector) {
        do
            for (double& x : vector) x = uniform(generator, -1, 1);
        while (vector.norm() > 1 || vector.norm() < 0.1);
        return vector;
    };
    BodyBeamState<K> x;
    x.orientation = Eigen::Quaterniond(direction(Eigen::Vector4d()).normalized());
    x.momentum = momentum * direction(Eigen::Vector3d()).normalized();
    for (int k = 0; k < 3 * K; ++k) {
        const int order = k % K + 1;
        const double size = deflection * length * std::sqrt(length) / std::pow(order, 4) * (k < 2 * K ? 1 : 0.1);
        x.modes(k) = uniform(generator, -size, size);
        x.velocity(k) = uniform(generator, -size, size);
    }
    return x;
}

}  // namespace equilibria::mechanisms
