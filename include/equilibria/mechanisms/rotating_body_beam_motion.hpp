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
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_body_beam.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria::mechanisms {

/// Kelvin-Voigt damping, the seed's (2.1): D = 1/2 int k_1 (u1'')_t^2 + k_2 (u2'')_t^2 + k_3 (u3')_t^2.
struct BeamDamping {
    double bending_1 = 0, bending_2 = 0, stretching = 0;  ///< k_1, k_2, k_3

    /// Throws InvalidArgument unless all are finite, 0 or more.
    void check() const {
        const auto good = [](const char* name, double k) {
            require(std::isfinite(k) && k >= 0, name, k, "must be finite, 0 or more");
        };
        good("damping.bending_1", bending_1);
        good("damping.bending_2", bending_2);
        good("damping.stretching", stretching);
    }
};

enum class BodyBeamStatus {
    finished,        ///< came to the last time asked for
    settled,         ///< came to rest in the body frame
    time_over,       ///< did not settle in the longest time
    too_many_steps,  ///< max_steps steps were tried
    step_too_small,  ///< the tolerances ask for steps below rounding
    not_finite,
};

inline const char* to_string(BodyBeamStatus status) {
    constexpr const char* names[] = {"finished",       "settled",        "time over",
                                     "too many steps", "step too small", "not finite"};
    return names[static_cast<int>(status)];
}

struct BodyBeamMotionOptions {
    double relative_tolerance = 1e-12, absolute_tolerance = 1e-13;  ///< of a step, for each number of the state
    std::uint64_t max_steps = 10'000'000;

    /// Throws InvalidArgument.
    void check() const {
        require(relative_tolerance >= 1e-15 && relative_tolerance < 1, "relative_tolerance", relative_tolerance,
                "must be from 1e-15 to 1");
        require(absolute_tolerance > 0 && std::isfinite(absolute_tolerance), "absolute_tolerance", absolute_tolerance,
                "must be positive");
        require(max_steps > 0, "max_steps", max_steps, "must be positive");
    }
};

/// Body and beam in motion; K modes a direction, in the order of RotatingBodyBeamBase.
template <int K>
struct BodyBeamState {
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< Y: from the body frame to space
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< a: angular, about the centre of mass, in the body frame
    Eigen::Vector<double, 3 * K> modes = Eigen::Vector<double, 3 * K>::Zero();     ///< u
    Eigen::Vector<double, 3 * K> velocity = Eigen::Vector<double, 3 * K>::Zero();  ///< u'
};

template <int K>
struct BodyBeamSample {
    double time = 0;
    BodyBeamState<K> state;
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
    std::uint64_t steps = 0, evaluations = 0;  ///< steps that were tried
    double momentum_drift = 0;                 ///< the largest |Y a - its start| / |a|
    double energy_balance = 0;   ///< the largest |energy + dissipated - their start|, over the energy at the start
    double energy_increase = 0;  ///< the largest of a step, over the energy at the start
};

template <int K>
struct BodyBeamMotion {
    BodyBeamStatus status = BodyBeamStatus::finished;
    double time = 0;                         ///< how far it came
    std::vector<BodyBeamSample<K>> samples;  ///< at the given times, as far as it came
    BodyBeamEvidence evidence;
};

/// How far a state is from a relative equilibrium, without units.
struct BodyBeamResidual {
    double velocity = 0;      ///< |u'| over |W| l^(3/2)
    double deflection = 0;    ///< l^(-3/2) times the displacement by which the beam, at rest, would balance p'
    double misalignment = 0;  ///< the larger of |a x W| / (|a| |W|) and |J W - (n J n) W| / |J W|, n = W / |W|: (2.6)

    double largest() const { return std::max({velocity, deflection, misalignment}); }
};

template <int K>
struct BodyBeamSettling {
    BodyBeamStatus status = BodyBeamStatus::settled;
    BodyBeamSample<K> last;
    BodyBeamResidual residual;  ///< at `last`
    /// The largest |W - W at `last`| / |W| over the turn before, the axes those of the body; where settled.
    double velocity_change = 0;
    BodyBeamEvidence evidence;

    bool settled() const { return status == BodyBeamStatus::settled; }
};

namespace detail {

inline constexpr int most_beam_modes = 8;
using BeamShapes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_beam_modes, 1>;
using BeamVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3 * most_beam_modes, 1>;
using BeamCoupling = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3 * most_beam_modes>;

/// A node of the quadrature: a particle of the beam, and the shapes there.
struct BeamNode {
    double weight = 0, place = 0;
    BeamShapes bending, stretching, bending_slope, stretching_slope;
};

/// The equations for a number of modes known at run time: compiled once, not once a model.
struct BeamMotion {
    int k = 0;  ///< modes a direction
    bool coupled = false;
    double length = 0, mass = 0, stretching = 0;
    Eigen::Matrix3d body_inertia;
    Eigen::Vector3d body_moment;                                 ///< mass times centre, of the body
    BeamVector mean;                                             ///< int dr_d/du_k
    std::vector<BeamNode> nodes;                                 ///< 2 k + 3
    std::array<Eigen::MatrixXd, 3> stiffness, loss, compliance;  ///< of the linear beam, a direction each

    struct Geometry {
        std::array<Eigen::Vector3d, 2 * most_beam_modes + 3> place;
        Eigen::Matrix3d inertia;
        BeamCoupling coupling;
    };
    struct Rates {
        Eigen::Vector3d angular_velocity, momentum;
        BeamVector modes, modal_momentum;
        double loss = 0;
    };

    Eigen::Vector3d displacement(const BeamNode& node, const BeamVector& u) const {
        Eigen::Vector3d y(0, 0, 0);
        for (int i = 0; i < k; ++i) {
            y(0) += node.bending(i) * u(i);
            y(1) += node.bending(i) * u(k + i);
            y(2) += node.stretching(i) * u(2 * k + i);
        }
        return y;
    }
    void add(BeamVector& force, const Eigen::Vector3d& f, const BeamShapes& bending, const BeamShapes& along) const {
        for (int i = 0; i < k; ++i) {
            force(i) += f(0) * bending(i);
            force(k + i) += f(1) * bending(i);
            force(2 * k + i) += f(2) * along(i);
        }
    }
    /// One form a direction, times u.
    BeamVector times(const std::array<Eigen::MatrixXd, 3>& forms, const BeamVector& u) const {
        BeamVector y = BeamVector::Zero(3 * k);
        for (int d = 0; d < 3; ++d)
            for (int j = 0; j < k; ++j)
                for (int i = 0; i < k; ++i) y(k * d + i) += forms[static_cast<std::size_t>(d)](i, j) * u(k * d + j);
        return y;
    }
    /// x + factor(mean . mean) mean (mean . x), a direction each.
    BeamVector with_mean(const BeamVector& x, const auto& factor) const {
        BeamVector y = x;
        for (int d = 0; d < 3; ++d) {
            double square = 0, along = 0;
            for (int i = k * d; i < k * (d + 1); ++i) square += mean(i) * mean(i), along += mean(i) * x(i);
            for (int i = k * d; i < k * (d + 1); ++i) y(i) += factor(square) * along * mean(i);
        }
        return y;
    }
    /// M x and M^-1 x.
    BeamVector modal_inertia(const BeamVector& x) const {
        return with_mean(x, [this](double) { return -1 / mass; });
    }
    BeamVector modal_mobility(const BeamVector& x) const {
        return with_mean(x, [this](double square) { return 1 / (mass - square); });
    }

    Geometry geometry(const BeamVector& u) const {
        Geometry y;
        Eigen::Vector3d centre = body_moment;
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            y.place[q] = displacement(nodes[q], u);
            y.place[q](2) += nodes[q].place;
            centre += nodes[q].weight * y.place[q];
        }
        centre /= mass;
        Eigen::Matrix3d second = -mass * centre * centre.transpose();
        y.coupling.setZero(3, 3 * k);
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            const Eigen::Vector3d& r = y.place[q];
            const double w = nodes[q].weight;
            second += w * r * r.transpose();
            // r x e_d for the directions d of the modes
            const Eigen::Vector3d arm = w * (r - centre);
            for (int i = 0; i < k; ++i) {
                const double phi = nodes[q].bending(i), psi = nodes[q].stretching(i);
                y.coupling(1, i) += phi * arm(2);
                y.coupling(2, i) -= phi * arm(1);
                y.coupling(0, k + i) -= phi * arm(2);
                y.coupling(2, k + i) += phi * arm(0);
                y.coupling(0, 2 * k + i) += psi * arm(1);
                y.coupling(1, 2 * k + i) -= psi * arm(0);
            }
        }
        y.inertia = body_inertia - second;
        y.inertia.diagonal().array() += second.trace();
        return y;
    }

    /// W and u' from the momenta: (J - P M^-1 P^T) W = a - P M^-1 p, u' = M^-1 (p - P^T W).
    void velocities(const Geometry& g, const Eigen::Vector3d& a, const BeamVector& p, Eigen::Vector3d& w,
                    BeamVector& v) const {
        BeamCoupling scaled(3, 3 * k);  // P M^-1
        for (int row = 0; row < 3; ++row) scaled.row(row) = modal_mobility(g.coupling.row(row).transpose()).transpose();
        Eigen::Matrix3d reduced = g.inertia;
        Eigen::Vector3d rest = a;
        for (int i = 0; i < 3 * k; ++i) {
            const Eigen::Vector3d left = scaled.col(i), right = g.coupling.col(i);
            reduced -= left * right.transpose();
            rest -= p(i) * left;
        }
        w = reduced.inverse() * rest;
        BeamVector beam = p;
        for (int i = 0; i < 3 * k; ++i) beam(i) -= g.coupling.col(i).dot(w);
        v = modal_mobility(beam);
    }

    double strain_energy(const BeamVector& u) const {
        double y = 0.5 * u.dot(times(stiffness, u));
        if (coupled)
            for (const BeamNode& node : nodes) {
                const auto [s1, s2, s3] = slopes(node, u);
                const double bend = 0.5 * (s1 * s1 + s2 * s2);
                y += 0.5 * stretching * node.weight * bend * (2 * s3 + bend);
            }
        return y;
    }
    std::array<double, 3> slopes(const BeamNode& node, const BeamVector& u) const {
        std::array<double, 3> y{};
        for (int i = 0; i < k; ++i) {
            y[0] += node.bending_slope(i) * u(i);
            y[1] += node.bending_slope(i) * u(k + i);
            y[2] += node.stretching_slope(i) * u(2 * k + i);
        }
        return y;
    }

    Rates rates(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const {
        const Geometry g = geometry(u);
        Rates y;
        velocities(g, a, p, y.angular_velocity, y.modes);
        const Eigen::Vector3d& w = y.angular_velocity;
        y.momentum = a.cross(w);
        const BeamVector damping = times(loss, y.modes);
        y.loss = damping.dot(y.modes);
        y.modal_momentum = -damping - times(stiffness, u);
        // dT/du at given velocities: the particles' velocities s, less their mean, times W
        std::array<Eigen::Vector3d, 2 * most_beam_modes + 3> speed;
        Eigen::Vector3d mean_speed = w.cross(body_moment);
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            speed[q] = w.cross(g.place[q]) + displacement(nodes[q], y.modes);
            mean_speed += nodes[q].weight * speed[q];
        }
        mean_speed /= mass;
        for (std::size_t q = 0; q < nodes.size(); ++q) {
            const Eigen::Vector3d f = nodes[q].weight * (speed[q] - mean_speed).cross(w);
            add(y.modal_momentum, f, nodes[q].bending, nodes[q].stretching);
        }
        if (coupled)
            // mu_3/2 (e^2 - u3'^2), e = u3' + bend
            for (const BeamNode& node : nodes) {
                const auto [s1, s2, s3] = slopes(node, u);
                const double bend = 0.5 * (s1 * s1 + s2 * s2), e = s3 + bend;
                const Eigen::Vector3d f = -stretching * node.weight * Eigen::Vector3d(e * s1, e * s2, bend);
                add(y.modal_momentum, f, node.bending_slope, node.stretching_slope);
            }
        return y;
    }

    double energy(const Eigen::Vector3d& a, const BeamVector& u, const BeamVector& p) const {
        Eigen::Vector3d w;
        BeamVector v;
        velocities(geometry(u), a, p, w, v);
        return 0.5 * (a.dot(w) + p.dot(v)) + strain_energy(u);
    }

    BodyBeamResidual residual(const Eigen::Vector3d& a, const BeamVector& u, const Rates& r) const {
        const double unit = length * std::sqrt(length);
        const Eigen::Vector3d& w = r.angular_velocity;
        const double turn = w.norm();
        const Eigen::Vector3d spin = geometry(u).inertia * w, n = w / turn;
        BodyBeamResidual y;
        y.velocity = r.modes.norm() / (turn * unit);
        y.deflection = times(compliance, r.modal_momentum).norm() / unit;
        y.misalignment = std::max(a.cross(w).norm() / (a.norm() * turn), (spin - n.dot(spin) * n).norm() / spin.norm());
        return y;
    }
};

/// One motion, a step at a time: a, u, p, the quaternion (x, y, z, w), what damping has taken.
class BeamStepper {
public:
    using Numbers = std::vector<double>;

    BeamStepper(const BeamMotion& motion, Numbers start, const BodyBeamMotionOptions& options)
        : motion_(motion),
          options_(options),
          pair_(
              boost::numeric::odeint::make_controlled(options.absolute_tolerance, options.relative_tolerance, Pair())),
          y_(std::move(start)) {
        options.check();
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
            if (evidence_.steps >= options_.max_steps) return end(BodyBeamStatus::too_many_steps);
            ++evidence_.steps;
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
    BodyBeamMotionOptions options_;
    Controlled pair_;
    Numbers y_;
    double time_ = 0, step_ = 0, energy_ = 0, start_energy_ = 0;
    Eigen::Vector3d space_momentum_;
    BodyBeamStatus status_ = BodyBeamStatus::finished;
    BodyBeamEvidence evidence_;
};

}  // namespace detail

/// The equations of motion of RotatingBodyBeam<K, Strain> with damping. K is at most 8.
template <int K, BeamStrain Strain = BeamStrain::linear>
class RotatingBodyBeamMotion {
public:
    static_assert(K <= detail::most_beam_modes, "equilibria: the motion is for 8 modes a direction or fewer");
    using Model = RotatingBodyBeam<K, Strain>;
    using Base = typename Model::Base;
    static constexpr int n_modes = 3 * K;
    static constexpr BeamStrain strain = Strain;
    using State = BodyBeamState<K>;
    using Sample = BodyBeamSample<K>;
    using Modes = Eigen::Vector<double, n_modes>;
    using Coupling = Eigen::Matrix<double, 3, n_modes>;

    /// p: the model's; its speed does not matter. Throws InvalidArgument where a parameter is none, where the damping
    /// is negative, or where the body's inertia about its own centre of mass is not positive definite.
    RotatingBodyBeamMotion(const Parameters<Model>& p, const BeamDamping& damping) : p_(p) {
        Base::check(p);
        damping.check();
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
            m.compliance[at] = m.stiffness[at].llt().solve(Eigen::MatrixXd::Identity(K, K));
        }
    }

    const Parameters<Model>& parameters() const { return p_; }

    /// J(u), (2.5).
    Eigen::Matrix3d inertia(const Modes& u) const { return motion_.geometry(u).inertia; }
    /// P(u): column k is int r x dr/du_k dz, less the centre of mass times int dr/du_k dz.
    Coupling coupling(const Modes& u) const { return motion_.geometry(u).coupling; }
    /// M v.
    Modes modal_inertia(const Modes& v) const { return motion_.modal_inertia(v); }
    double strain_energy(const Modes& u) const {
        Array<double, n_modes> values;
        std::copy(u.begin(), u.end(), values.begin());
        return Base::strain_energy(values, p_);
    }

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
        Modes modes, modal_momentum;       ///< u' = dH/dp, p'
        double loss;                       ///< 2 D: what damping takes a unit of time
    };
    Rates rates(const Eigen::Vector3d& a, const Modes& u, const Modes& p) const {
        const auto r = motion_.rates(a, u, p);
        return {r.angular_velocity, r.momentum, r.modes, r.modal_momentum, r.loss};
    }
    /// H = T + V at momenta a, p and modes u.
    double energy(const Eigen::Vector3d& a, const Modes& u, const Modes& p) const { return motion_.energy(a, u, p); }
    double energy(const State& x) const { return energy(x.momentum, x.modes, modal_momentum(x)); }

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

    /// The motion from `start` at time 0, at `times`: none below 0, none below the one before it. Throws
    /// InvalidArgument where these, the start or an option are none; all else that may happen is a status.
    BodyBeamMotion<K> integrate(const State& start, const std::vector<double>& times,
                                const BodyBeamMotionOptions& options = {}) const {
        double before = 0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            require(std::isfinite(times[k]) && times[k] >= before, "times[" + std::to_string(k) + "]", times[k],
                    "must be finite, " + to_text(before) + " or more");
            before = times[k];
        }
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
                               const BodyBeamMotionOptions& options = {}) const {
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
