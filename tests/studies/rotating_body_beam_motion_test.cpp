// The motion of a rigid body with a beam: its energy against quadrature, its equations against the energy, what the
// motion conserves, and where damping leads it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/random.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_motion.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using mechanisms::BeamDamping, mechanisms::BeamStrain, mechanisms::BodyBeamState, mechanisms::BodyBeamStatus,
    mechanisms::momentum_hessian, mechanisms::random_body_beam_state, mechanisms::RotatingBodyBeam,
    mechanisms::RotatingBodyBeamMotion;

namespace {

using OneLinear = RotatingBodyBeamMotion<1, BeamStrain::linear>;
using OneCoupled = RotatingBodyBeamMotion<1, BeamStrain::coupled>;
using TwoLinear = RotatingBodyBeamMotion<2, BeamStrain::linear>;
using TwoCoupled = RotatingBodyBeamMotion<2, BeamStrain::coupled>;

/// m_b, I, c, l, mu; the speed does not matter.
constexpr Parameters<OneLinear::Model> body() { return {2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, 0}; }

/// Any body that can be: centre of mass off the axis, another length.
Parameters<OneLinear::Model> any_body(Generator& generator) {
    Parameters<OneLinear::Model> p = body();
    for (int k = 0; k < 3; ++k) {
        p[OneLinear::Model::inertia_1 + k] = uniform(generator, 1, 1.5);
        p[OneLinear::Model::centre_1 + k] = uniform(generator, -0.3, 0.3);
    }
    p[OneLinear::Model::length] = uniform(generator, 0.7, 1.5);
    p[OneLinear::Model::stretching] = uniform(generator, 5, 50);
    return p;
}

std::vector<double> times(double end, int samples) {
    std::vector<double> y;
    for (int k = 1; k <= samples; ++k) y.push_back(end * k / samples);
    return y;
}

/// int f over [0, 1] by Simpson's rule.
template <class F>
auto integral(const F& f) {
    const int n = 400;
    auto sum = f(0.0);
    sum += f(1.0);
    for (int k = 1; k < n; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(static_cast<double>(k) / n);
    sum /= 3 * n;
    return sum;
}

/// A relative equilibrium near q, by Newton's method.
template <class M>
Unknowns<M> relative_equilibrium(Unknowns<M> q, const Parameters<M>& p) {
    for (int step = 0; step < 20; ++step) {
        const auto f = equations<M>(q, p);
        const Eigen::VectorXd shift =
            tests::solved(jacobian<M>(q, p), Eigen::Map<const Eigen::VectorXd>(f.begin(), f.size()));
        for (int i = 0; i < q.size(); ++i) q[i] -= shift(i);
        if (shift.norm() < 1e-14) break;
    }
    return q;
}

template <class Motion>
void check_derivatives(Generator& generator) {
    using Modes = typename Motion::Modes;
    using Base = typename Motion::Base;
    constexpr int size = Motion::n_modes, K = size / 3;
    const auto p = any_body(generator);
    const double l = p[Base::length], mass = p[Base::body_mass] + l;
    const BeamDamping damping{0.3, 0.7, 0.2};
    const Motion motion(p, damping), free(p, {});
    auto x = random_body_beam_state<K>(generator, 3, l, 0.4);

    // T from the velocities of all points, about the centre of mass
    const auto shape = [&](double s, int k) {
        const int d = k / K, i = k % K;
        const auto values = d < 2 ? Base::modes.bending(s) : Base::modes.stretching(s);
        return Eigen::Vector3d(values.value[i] / std::sqrt(l) * Eigen::Vector3d::Unit(d));
    };
    const auto displaced = [&](double s, const Modes& u) {
        Eigen::Vector3d y(0, 0, 0);
        for (int k = 0; k < size; ++k) y += u(k) * shape(s, k);
        return y;
    };
    const auto place = [&](double s) { return Eigen::Vector3d(displaced(s, x.modes) + Eigen::Vector3d(0, 0, s * l)); };
    const Eigen::Vector3d w = motion.angular_velocity(x), c(p[Base::centre_1], p[Base::centre_2], p[Base::centre_3]);
    const auto speed = [&](double s) { return Eigen::Vector3d(w.cross(place(s)) + displaced(s, x.velocity)); };
    const Eigen::Vector3d mean = (p[Base::body_mass] * w.cross(c) + l * integral(speed)) / mass,
                          centre = (p[Base::body_mass] * c + l * integral(place)) / mass;
    const double kinetic =
        0.5 * (w.dot(Eigen::Vector3d(p[Base::inertia_1], p[Base::inertia_2], p[Base::inertia_3]).cwiseProduct(w)) +
               l * integral([&](double s) { return speed(s).squaredNorm(); }) - mass * mean.squaredNorm());
    CHECK(motion.energy(x) - motion.strain_energy(x.modes) == Approx(kinetic).epsilon(1e-8));

    // P, M and the momentum, column by column
    const auto coupling = motion.coupling(x.modes);
    for (int k = 0; k < size; ++k) {
        const Eigen::Vector3d first = l * integral([&](double s) { return shape(s, k); }),
                              column =
                                  l * integral([&](double s) { return Eigen::Vector3d(place(s).cross(shape(s, k))); }) -
                                  centre.cross(first);
        CHECK((coupling.col(k) - column).norm() < 1e-8);
        const Modes row = motion.modal_inertia(Modes::Unit(k));
        for (int j = 0; j < size; ++j) {
            const Eigen::Vector3d other = l * integral([&](double s) { return shape(s, j); });
            CHECK(row(j) == Approx((j == k) - first.dot(other) / mass).margin(1e-8));
        }
    }
    Array<double, size> mode_values;
    std::copy(x.modes.begin(), x.modes.end(), mode_values.begin());
    const auto inertia_array = Base::inertia(mode_values, p);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            CHECK(motion.inertia(x.modes)(a, b) == Approx(inertia_array[a][b]).epsilon(1e-13).margin(1e-13));

    // Hamilton's equations by differences of H
    const Eigen::Vector3d a = x.momentum;
    const Modes u = x.modes, momentum = motion.modal_momentum(x);
    const auto rates = free.rates(a, u, momentum);
    CHECK((rates.angular_velocity - w).norm() < 1e-13);
    CHECK((rates.modes - x.velocity).norm() < 1e-13);
    CHECK((rates.momentum - a.cross(w)).norm() < 1e-13);
    const double h = 1e-4;
    // of fourth order
    const auto slope = [&](const auto& f) { return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h); };
    for (int k = 0; k < 3; ++k)
        CHECK(slope([&](double d) { return free.energy(a + d * Eigen::Vector3d::Unit(k), u, momentum); }) ==
              Approx(w(k)).margin(1e-9));
    for (int k = 0; k < size; ++k) {
        CHECK(slope([&](double d) { return free.energy(a, u, momentum + d * Modes::Unit(k)); }) ==
              Approx(x.velocity(k)).margin(1e-9));
        CHECK(slope([&](double d) { return free.energy(a, u + d * Modes::Unit(k), momentum); }) ==
              Approx(-rates.modal_momentum(k)).epsilon(1e-8).margin(1e-8));
    }

    // damping: dD/du', and 2 D
    const auto damped = motion.rates(a, u, momentum);
    const auto dissipation = [&](const Modes& v) {
        return 0.5 * l * integral([&](double s) {
                   Eigen::Vector3d rate(0, 0, 0);  // of u1'', u2'', u3'
                   for (int k = 0; k < size; ++k)
                       rate(k / K) += v(k) * (k / K < 2 ? Base::modes.bending(s).second[k % K] / (l * l * std::sqrt(l))
                                                        : Base::modes.stretching(s).first[k % K] / (l * std::sqrt(l)));
                   return damping.bending_1 * rate(0) * rate(0) + damping.bending_2 * rate(1) * rate(1) +
                          damping.stretching * rate(2) * rate(2);
               });
    };
    CHECK(damped.loss == Approx(2 * dissipation(x.velocity)).epsilon(1e-7));
    CHECK(free.rates(a, u, momentum).loss == 0);
    for (int k = 0; k < size; ++k)
        CHECK(slope([&](double d) { return dissipation(x.velocity + d * Modes::Unit(k)); }) ==
              Approx(rates.modal_momentum(k) - damped.modal_momentum(k)).epsilon(1e-7).margin(1e-7));
}

template <class Motion>
void check_laws(const BeamDamping& damping) {
    Generator generator(7);
    const auto p = any_body(generator);
    const Motion motion(p, damping);
    const auto start = random_body_beam_state<Motion::n_modes / 3>(generator, 5, p[Motion::Base::length]);
    const auto y = motion.integrate(start, times(20, 200));
    REQUIRE(y.status == BodyBeamStatus::finished);
    REQUIRE(y.samples.size() == 200);
    CHECK(y.time == 20);
    const Eigen::Vector3d space = start.orientation * start.momentum;
    const double energy = motion.energy(start);
    double before = energy, dissipated = 0;
    for (const auto& x : y.samples) {
        CHECK((x.space_momentum - space).norm() < 1e-9 * space.norm());
        CHECK((x.state.orientation * x.state.momentum - space).norm() < 1e-9 * space.norm());
        CHECK(x.energy + x.dissipated == Approx(energy).epsilon(1e-9));
        CHECK(x.energy == Approx(motion.energy(x.state)).epsilon(1e-12));
        CHECK((x.angular_velocity - motion.angular_velocity(x.state)).norm() < 1e-11);
        CHECK(x.energy <= before + 1e-12 * energy);
        CHECK(x.dissipated >= dissipated);
        before = x.energy, dissipated = x.dissipated;
    }
    CHECK(y.evidence.momentum_drift < 1e-11);
    CHECK(y.evidence.energy_balance < 1e-10);
    CHECK(y.evidence.energy_increase < 1e-11);
    if (damping.bending_1 > 0)
        CHECK(y.samples.back().energy < 0.99 * energy);
    else
        CHECK(y.samples.back().dissipated == 0);
    // samples do not matter, and neither does a stop; later some of these motions are chaotic
    const auto& middle = y.samples[99].state;
    const auto direct = motion.integrate(start, {10});
    CHECK((direct.samples[0].state.modes - middle.modes).norm() < 1e-9);
    CHECK((direct.samples[0].state.momentum - middle.momentum).norm() < 1e-9);
    const auto rest = motion.integrate(y.samples[49].state, {5});
    CHECK((rest.samples[0].state.momentum - middle.momentum).norm() < 1e-9);
}

/// A damped motion from a random start has come to a stable relative equilibrium.
template <class Motion>
void check_settled(const Motion& motion, const BodyBeamState<Motion::n_modes / 3>& start, double longest) {
    using M = typename Motion::Model;
    constexpr int K = Motion::n_modes / 3;
    const auto y = motion.settle(start, longest);
    REQUIRE(y.status == BodyBeamStatus::settled);
    CHECK(y.last.time < longest);
    CHECK(y.residual.largest() < 1e-9);
    CHECK(y.velocity_change < 1e-8);
    CHECK(y.evidence.momentum_drift < 1e-9);
    CHECK(y.evidence.energy_balance < 1e-9);
    CHECK(y.evidence.energy_increase < 1e-12);
    const double size = start.momentum.norm();
    CHECK((y.last.space_momentum - start.orientation * start.momentum).norm() < 1e-9 * size);
    // (2.6) by other means: the angular velocity is along an eigenvector of J, and along the momentum
    const auto axes = tests::symmetric_eigen(motion.inertia(y.last.state.modes));
    const Eigen::Vector3d n = y.last.angular_velocity.normalized();
    double sine = 1;
    for (int k = 0; k < 3; ++k) sine = std::min(sine, n.cross(Eigen::Vector3d(axes.vectors.col(k))).norm());
    CHECK(sine < 1e-8);
    CHECK(y.last.wobble() < 1e-8);
    // and the model's equations, whose derivatives are others, hold
    auto p = motion.parameters();
    p[M::speed] = y.last.angular_velocity.norm();
    const auto q = motion.relative_equilibrium(y.last.state);
    for (const double f : equations<M>(q, p)) CHECK(std::abs(f) < 1e-6);
    const auto index = inertia(momentum_hessian<K, Motion::strain>(q, size, p));
    CHECK(index.negative == 0);
    CHECK(index.zero == 0);
}

}  // namespace

TEST_CASE("P, M, T and D are the integrals, and the equations are Hamilton's, for any body") {
    Generator generator(3);
    for (int repeat = 0; repeat < 3; ++repeat) {
        check_derivatives<OneLinear>(generator);
        check_derivatives<TwoCoupled>(generator);
    }
}

TEST_CASE("The momentum in space is constant, and so is the energy with what damping has taken") {
    for (const auto& damping : {BeamDamping{}, BeamDamping{0.05, 0.03, 0.2}}) {
        check_laws<OneLinear>(damping);
        check_laws<OneCoupled>(damping);
        check_laws<TwoLinear>(damping);
        check_laws<TwoCoupled>(damping);
    }
}

TEST_CASE("A body that is symmetric about the beam moves alike when it is turned about it") {
    auto p = body();
    p[OneLinear::Model::inertia_2] = p[OneLinear::Model::inertia_1];
    p[OneLinear::Model::bending_2] = p[OneLinear::Model::bending_1];
    p[OneLinear::Model::centre_3] = 0.1;
    const TwoCoupled motion(p, {0.1, 0.1, 0.1});
    Generator generator(5);
    const auto start = random_body_beam_state<2>(generator, 6, 1);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const auto turned = [&](const BodyBeamState<2>& x) {
        BodyBeamState<2> y = x;
        y.orientation = x.orientation * Eigen::Quaterniond(turn.transpose());
        y.momentum = turn * x.momentum;
        for (int i = 0; i < 2; ++i)
            for (int d = 0; d < 3; ++d) {
                y.modes(2 * d + i) = y.velocity(2 * d + i) = 0;
                for (int e = 0; e < 3; ++e) {
                    y.modes(2 * d + i) += turn(d, e) * x.modes(2 * e + i);
                    y.velocity(2 * d + i) += turn(d, e) * x.velocity(2 * e + i);
                }
            }
        return y;
    };
    const auto one = motion.integrate(start, {10}).samples.at(0),
               other = motion.integrate(turned(start), {10}).samples.at(0);
    CHECK(other.energy == Approx(one.energy).epsilon(1e-11));
    CHECK((other.state.momentum - turn * one.state.momentum).norm() < 1e-9);
    CHECK((other.state.modes - turned(one.state).modes).norm() < 1e-9);
    CHECK(other.state.orientation.angularDistance(turned(one.state).orientation) < 1e-9);
}

TEST_CASE("With a stiff beam the body nutates like a rigid one, the error falling like the compliance") {
    const double speed = 1;
    double before = 0;
    for (const double mu : {1e2, 1e3, 1e4}) {
        auto p = body();
        for (int k = 0; k < 3; ++k) p[OneLinear::Model::bending_1 + k] = mu;
        const OneLinear motion(p, {});
        const Eigen::Vector3d j = motion.inertia(OneLinear::Modes::Zero()).diagonal();
        const double expected = speed * std::sqrt((j(1) - j(0)) * (j(1) - j(2)) / (j(0) * j(2)));
        BodyBeamState<1> start;
        start.momentum = Eigen::Vector3d(1e-3 * j(0), j(1), 0) * speed;
        const auto y = motion.integrate(start, times(100, 2000));
        REQUIRE(y.status == BodyBeamStatus::finished);
        // between the first and the last time at which the momentum along axis 1 vanishes, half a period each
        std::vector<double> zeros;
        for (std::size_t k = 1; k < y.samples.size(); ++k) {
            const double a = y.samples[k - 1].state.momentum(0), b = y.samples[k].state.momentum(0);
            if (a * b < 0)
                zeros.push_back(y.samples[k - 1].time + (y.samples[k].time - y.samples[k - 1].time) * a / (a - b));
        }
        REQUIRE(zeros.size() > 3);
        const double found = std::numbers::pi * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
        const double error = std::abs(found / expected - 1);
        CHECK(error < 2 / mu);
        if (before > 0) CHECK(error < 0.15 * before);
        before = error;
    }
}

namespace {

template <class Motion>
void check_stays(double speed) {
    using M = typename Motion::Model;
    auto p = body();
    p[M::speed] = speed;
    Unknowns<M> guess{};
    guess[1] = 1;
    guess[M::multiplier] = 1.5;
    const auto q = relative_equilibrium<M>(guess, p);
    double residual = 0;
    for (const double f : equations<M>(q, p)) residual = std::max(residual, std::abs(f));
    REQUIRE(residual < 1e-11);
    REQUIRE(q[M::first_mode + M::n_modes - M::n_modes / 3] > 0.001);  // stretched
    for (const double k : {0.0, 0.2}) {
        const Motion motion(p, {k, k, k});
        const auto start = Motion::turning(q, speed);
        CHECK(motion.residual(start).largest() < 1e-12);
        const auto y = motion.integrate(start, times(20, 40));
        REQUIRE(y.status == BodyBeamStatus::finished);
        for (const auto& x : y.samples) {
            CHECK((x.angular_velocity - speed * Eigen::Vector3d(q[0], q[1], q[2])).norm() < 1e-10);
            CHECK((x.state.modes - start.modes).norm() < 1e-11);
            CHECK(x.state.velocity.norm() < 1e-10);
            const Eigen::Quaterniond turned(
                Eigen::AngleAxisd(speed * x.time, Eigen::Vector3d(q[0], q[1], q[2]).normalized()));
            CHECK(x.state.orientation.angularDistance(turned) < 1e-9);
        }
        const auto back = motion.relative_equilibrium(y.samples.back().state);
        for (int i = 0; i < back.size(); ++i) CHECK(back[i] == Approx(q[i]).margin(1e-10));
    }
}

}  // namespace

TEST_CASE("A relative equilibrium stays where it is") {
    check_stays<OneLinear>(2);
    check_stays<OneCoupled>(3);
    check_stays<TwoLinear>(3);
    check_stays<TwoCoupled>(2);
}

TEST_CASE("Near a saddle the motion leaves it, and damping leads to the axis of the largest moment") {
    auto p = body();
    using M = OneLinear::Model;
    p[M::speed] = 3;
    Unknowns<M> guess{};
    guess[0] = 1;
    guess[M::multiplier] = 1.4;
    const auto saddle = relative_equilibrium<M>(guess, p);
    const double size = saddle[M::multiplier] * 3;
    CHECK(inertia(momentum_hessian<1, BeamStrain::linear>(saddle, size, p)).negative > 0);
    const OneLinear motion(p, {1, 1, 1});
    auto start = OneLinear::turning(saddle, 3);
    // a speck of momentum across, the size kept
    start.momentum = size * (start.momentum / size + 1e-6 * Eigen::Vector3d(0, 1, 0.5)).normalized();
    CHECK(motion.residual(start).largest() < 1e-4);
    const auto y = motion.settle(start, 5000);
    REQUIRE(y.settled());
    CHECK(std::abs(y.last.angular_velocity(0)) < 0.9 * y.last.angular_velocity.norm());
    CHECK(y.last.energy < motion.energy(start));
    CHECK(
        inertia(momentum_hessian<1, BeamStrain::linear>(motion.relative_equilibrium(y.last.state), size, p)).negative ==
        0);
}

TEST_CASE("200 damped motions from random starts end in stable relative equilibria, the linear strain") {
    const OneLinear motion(body(), {0.3, 0.3, 0.3});
    Generator generator(11);
    for (int run = 0; run < 200; ++run) {
        CAPTURE(run);
        check_settled(motion, random_body_beam_state<1>(generator, 10, 1), 500);
    }
}

TEST_CASE("Damped motions from random starts end in stable relative equilibria, the coupled strain") {
    auto p = body();
    p[OneCoupled::Model::inertia_1] = 0.3;
    p[OneCoupled::Model::inertia_2] = p[OneCoupled::Model::inertia_3] = 1;
    const OneCoupled motion(p, {1, 1, 1});
    Generator generator(12);
    for (int run = 0; run < 40; ++run) {
        CAPTURE(run);
        check_settled(motion, random_body_beam_state<1>(generator, 12, 1), 1000);
    }
}

TEST_CASE("What goes wrong on the way is a status") {
    Generator generator(1);
    const auto start = random_body_beam_state<1>(generator, 5, 1);
    const OneLinear free(body(), {});
    CHECK(free.settle(start, 3).status == BodyBeamStatus::time_over);
    CHECK(free.settle(start, 3).last.time == 3);
    MotionOptions few;
    few.most_steps = 10;
    const auto y = free.integrate(start, times(20, 1000), few);
    CHECK(y.status == BodyBeamStatus::too_many_steps);
    CHECK(y.time < 20);
    CHECK(y.samples.size() < 1000);
    CHECK(free.settle(start, 20, 1e-9, few).status == BodyBeamStatus::too_many_steps);
    auto far = start;
    far.modes(0) = 1e200;
    const auto lost = free.integrate(far, {1});
    CHECK((lost.status == BodyBeamStatus::not_finite || lost.status == BodyBeamStatus::step_too_small));
    CHECK(lost.samples.empty());
    CHECK(free.integrate(start, {}).status == BodyBeamStatus::finished);
    // without momentum it vibrates
    auto still = start;
    still.momentum.setZero();
    const auto vibration = OneLinear(body(), {0.1, 0.1, 0.1}).integrate(still, {5});
    CHECK(vibration.status == BodyBeamStatus::finished);
    CHECK(vibration.evidence.momentum_drift == 0);
    CHECK(vibration.evidence.energy_balance < 1e-10);
}

TEST_CASE("Bad input is refused by name") {
    using Catch::Matchers::Contains;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto p = body();
    CHECK_THROWS_WITH(OneLinear(p, {-1, 0, 0}), Contains("damping.bending_1 = -1: must be finite, 0 or more"));
    CHECK_THROWS_WITH(OneLinear(p, {0, nan, 0}), Contains("damping.bending_2"));
    CHECK_THROWS_WITH(OneLinear(p, {0, 0, -2}), Contains("damping.stretching"));
    auto bad = p;
    bad[OneLinear::Model::length] = 0;
    CHECK_THROWS_WITH(OneLinear(bad, {}), Contains("length = 0: must be positive"));
    bad = p;
    bad[OneLinear::Model::centre_1] = 1;  // its share of the inertia is 2
    CHECK_THROWS_WITH(OneLinear(bad, {}), Contains("centre = 1"));

    const OneLinear motion(p, {});
    BodyBeamState<1> good;
    good.momentum = {0, 1, 0};
    CHECK_THROWS_WITH(motion.integrate(good, {1, 0.5}), Contains("times[1] = 0.5: must be finite, 1 or more"));
    CHECK_THROWS_WITH(motion.integrate(good, {-1}), Contains("times[0]"));
    CHECK_THROWS_WITH(motion.integrate(good, {nan}), Contains("times[0]"));
    CHECK_THROWS_WITH(motion.settle(good, 0), Contains("longest_time = 0"));
    CHECK_THROWS_WITH(motion.settle(good, 1, 0), Contains("tolerance = 0"));
    CHECK_THROWS_WITH(motion.settle({}, 1), Contains("start.momentum = 0: must not be zero"));
    auto state = good;
    state.modes(1) = nan;
    CHECK_THROWS_WITH(motion.integrate(state, {1}), Contains("start.modes[1]"));
    state = good;
    state.orientation.w() = 2;
    CHECK_THROWS_WITH(motion.integrate(state, {1}), Contains("start.orientation = 2"));
    for (const auto& options : {MotionOptions{.relative_tolerance = 0}, MotionOptions{.absolute_tolerance = 0},
                                MotionOptions{.largest_step = -1}, MotionOptions{.most_steps = 0}})
        CHECK_THROWS_AS(motion.integrate(good, {1}, options), InvalidArgument);
}
