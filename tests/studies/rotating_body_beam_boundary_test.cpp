// The continuous beam on a rotating body: closed forms, convergence in the points, the truncation's error, whirling
// branches by continuation.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_boundary.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Eigen::VectorXd;
using mechanisms::BeamControl, mechanisms::BeamSolution, mechanisms::BeamSolveStatus, mechanisms::BeamStrain,
    mechanisms::RotatingBodyBeam, mechanisms::whirl_speeds;
using Boundary = mechanisms::RotatingBodyBeamBoundary;
using Names = Boundary::Beam;

namespace {

static_assert(ContinuationProblem<Boundary> && !symmetric_tangent<Boundary>);

/// m_b, I, c, l, mu, omega (not used).
const Boundary::Values body{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, 0};
constexpr double whirling_speed = 8;
constexpr BeamStrain strains[] = {BeamStrain::linear, BeamStrain::coupled};

ContinuationOptions window(const Boundary& problem, double low, double high) {
    ContinuationOptions y;
    y.range = {low, high};
    y.branch.largest_step = 0.1;  // points to be looked at
    // the spin moves nothing: p in units of 10, of speed
    y.branch.parameter_weight = problem.control_by() == BeamControl::speed ? 0.1 : 0.1 / 0.8;
    return y;
}

/// The spin about the third axis, from the speed 1, and the branch that leaves its first pitchfork.
struct Whirl {
    Branch<Boundary> spin, whirl;
};
Whirl whirl_of(const Boundary& problem, double high) {
    const auto options = window(problem, 0.5, high);
    BranchStepper<Boundary> stepper(problem, options.branch);
    const auto start = stepper.start(problem.undeformed({0, 0, 1}), 1, 1);
    REQUIRE(start);
    Whirl y;
    y.spin = follow(stepper, *start, options);
    REQUIRE(!y.spin.events.empty());
    const auto& [step, point] = y.spin.events[0];
    const auto sides = switch_branch(stepper, point, y.spin.points[step].tangent, 0.05);
    REQUIRE(sides.size() == 2);
    // the one that bends towards the axis 1
    const auto tip = [&](const BranchPoint<Boundary>& at) { return problem.shape(at.q, 1).u(0); };
    y.whirl = follow(stepper, tip(sides[0]) > 0 ? sides[0] : sides[1], options);
    return y;
}
VectorXd whirling(const Boundary& problem) {
    const auto all = whirl_of(problem, whirling_speed);
    const BeamSolution y = problem.solve(all.whirl.points.back().q, whirling_speed);
    REQUIRE(y.converged());
    return y.q;
}

/// Largest defect on a grid finer than the points.
double largest_defect(const Boundary& problem, const VectorXd& q, double p) {
    double y = 0;
    for (int k = 0; k <= 60; ++k)
        y = std::max(y, problem.defect(q, p, problem.parameters()[Names::length] * k / 60).norm());
    return y;
}

/// Newton's method on a model's equations.
template <class M>
bool newton(Unknowns<M>& q, const Parameters<M>& p) {
    for (int step = 0; step < 30; ++step) {
        const auto f = equations<M>(q, p);
        const VectorXd g = Eigen::Map<const VectorXd>(f.begin(), f.size());
        const VectorXd d = tests::solved(jacobian<M>(q, p), g);
        for (int i = 0; i < q.size(); ++i) q[i] -= d(i);
        if (d.norm() < 1e-11) return true;
    }
    return false;
}

/// The equilibrium of the beam with K modes next to the continuous one, and what they differ by.
struct Truncation {
    double moment, tip, energy;
};
template <int K, BeamStrain Strain>
Truncation truncated(const Boundary& problem, const VectorXd& q, double speed) {
    using M = RotatingBodyBeam<K, Strain>;
    Parameters<M> p;
    std::copy(problem.parameters().begin(), problem.parameters().end(), p.begin());
    p[M::speed] = speed;
    REQUIRE(p[M::length] == 1);
    Unknowns<M> at{};
    for (int i = 0; i < 3; ++i) at[i] = q(i);
    at[M::multiplier] = problem.moment(q);
    M::modes.for_each_node([&](double z, double w) {
        const auto phi = M::modes.bending(z), psi = M::modes.stretching(z);
        const Eigen::Vector3d u = problem.shape(q, z).u;
        for (int i = 0; i < K; ++i) {
            for (int a = 0; a < 2; ++a) at[3 + a * K + i] += w * phi.value[i] * u(a);
            at[3 + 2 * K + i] += w * psi.value[i] * u(2);
        }
    });
    CAPTURE(K);
    REQUIRE(newton<M>(at, p));
    // and back to the continuous one
    const BeamSolution back = problem.solve(problem.start_from(at, speed), speed);
    CHECK(back.converged());
    CHECK((back.q - q).norm() < 1e-11 * q.norm());
    Array<double, 3 * K> u;
    double tip = -problem.shape(q, 1).u(0);
    for (int i = 0; i < 3 * K; ++i) {
        u[i] = at[3 + i];
        if (i < K) tip += u[i] * M::modes.bending(1).value[i];
    }
    const double moment = at[M::multiplier] - problem.moment(q);
    return {moment, tip, M::Base::strain_energy(u, p) - problem.strain_energy(q) - 0.5 * speed * speed * moment};
}

}  // namespace

TEST_CASE("A spin across the beam stretches it as in closed form") {
    // mu_3 y'' = -omega^2 y for y = z + u_3 - C_3, y'(l) = 1, y(0) = -C_3, and m_b (C_3 - c_3) = int y
    Boundary::Values p{2, 1.2, 1.3, 0.8, 0, 0, 0.3, 1.5, 1, 1.2, 20, 0};
    const double omega = 2.5, l = p[Names::length], k = omega / std::sqrt(p[Names::stretching]);
    const double s = std::sin(k * l), c = std::cos(k * l), mass = p[Names::body_mass];
    const double centre = (mass * p[Names::centre_3] + (1 - c) / (k * k * c)) / (mass + s / k + (1 - c) * s / (k * c));
    const double b = (1 / k - centre * s) / c;
    const auto y = [&](double z) { return b * std::sin(k * z) - centre * std::cos(k * z); };
    // J_11 = I_1 + int (y + C_3)^2 - (m_b + l) C_3^2
    const double yy =
        b * b * (l / 2 - s * c / (2 * k)) + centre * centre * (l / 2 + s * c / (2 * k)) - b * centre * s * s / k;
    const double first = b * (1 - c) / k - centre * s / k;
    const double moment =
        p[Names::inertia_1] + yy + 2 * centre * first + l * centre * centre - (mass + l) * centre * centre;
    for (const BeamStrain strain : strains)
        for (const BeamControl control : {BeamControl::speed, BeamControl::momentum}) {
            const Boundary problem(p, strain, 16, control);
            const double at = control == BeamControl::speed ? omega : omega * moment;
            const auto solution = problem.solve(problem.undeformed({1, 0, 0}), at);
            REQUIRE(solution.converged());
            CHECK(solution.residual < 1e-13);
            CHECK(problem.moment(solution.q) == Approx(moment).epsilon(1e-13));
            CHECK(problem.speed(solution.q, at) == Approx(omega).epsilon(1e-13));
            CHECK(problem.momentum(solution.q, at) == Approx(omega * moment).epsilon(1e-13));
            CHECK((problem.axis(solution.q) - Eigen::Vector3d(1, 0, 0)).norm() < 1e-14);
            for (const double z : {0.0, 0.2, 0.77, 1.5}) {
                const auto shape = problem.shape(solution.q, z);
                CHECK(shape.u.head<2>().norm() < 1e-15);
                CHECK(shape.u(2) == Approx(y(z) + centre - z).epsilon(1e-12).margin(1e-14));
                CHECK(shape.first(2) ==
                      Approx(k * (b * std::cos(k * z) + centre * std::sin(k * z)) - 1).epsilon(1e-12).margin(1e-13));
                CHECK(shape.second(2) == Approx(-k * k * y(z)).epsilon(1e-11));
            }
        }
}

TEST_CASE("The derivatives of the boundary value problem are those of its residual") {
    for (const BeamStrain strain : strains)
        for (const BeamControl control : {BeamControl::speed, BeamControl::momentum}) {
            const Boundary problem(body, strain, 12, control);
            VectorXd q = problem.undeformed({0.3, 0.5, 0.7});
            for (int i = 3; i < 39; ++i) q(i) += std::sin(3.0 * i);
            const auto errors = check_derivatives(problem, q, 3.0);
            CHECK(errors.tangent < 1e-8);
            CHECK(errors.parameter_derivative < 1e-8);
            CHECK(errors.parameter_derivative_along < 1e-8);
            CHECK(errors.second_parameter_derivative < 1e-8);
        }
}

TEST_CASE("The collocation of a whirling beam converges exponentially, between its points as well") {
    for (const BeamStrain strain : strains) {
        const Boundary fine(body, strain, 32);
        const VectorXd q = whirling(fine);
        const auto tip = fine.shape(q, 1);
        CHECK(std::abs(tip.u(0)) > 1);
        CHECK(std::abs(tip.u(1)) < 1e-12);
        // conditions at the ends
        const auto foot = fine.shape(q, 0);
        CHECK(foot.u.norm() < 1e-13);
        CHECK(foot.first.head<2>().norm() < 1e-13);
        CHECK(tip.second.head<2>().norm() < 1e-12);
        const double on = strain == BeamStrain::coupled ? 0.5 : 0;
        CHECK(std::abs(tip.first(2) + on * tip.first.head<2>().squaredNorm()) < 1e-13);
        CHECK(largest_defect(fine, q, whirling_speed) < 1e-8);
        double before = 1;
        for (const int points : {8, 12, 16, 20, 24}) {
            CAPTURE(points);
            const Boundary problem(body, strain, points);
            const VectorXd at = whirling(problem);
            const double error =
                std::max({std::abs(problem.moment(at) - fine.moment(q)), (problem.shape(at, 1).u - tip.u).norm(),
                          (problem.shape(at, 0.3).u - fine.shape(q, 0.3).u).norm()});
            CHECK(error < std::max(0.05 * before, 2e-13));
            before = error;
            if (points == 16) CHECK(error < (strain == BeamStrain::linear ? 1e-12 : 1e-10));
            if (points == 24) CHECK(largest_defect(problem, at, whirling_speed) < 1e-8);
        }
    }
}

TEST_CASE("Equilibria of the truncated beam converge to the continuous one, from above in energy") {
    const auto check = [](const std::vector<Truncation>& errors, double factor) {
        for (std::size_t k = 0; k < errors.size(); ++k) {
            CAPTURE(k, errors[k].moment, errors[k].tip, errors[k].energy);
            // critical values: the error is a form of the shape's error, whose high modes make it positive
            CHECK(errors[k].energy > 0);
            if (k == 0) continue;
            CHECK(errors[k].energy < 0.5 * errors[k - 1].energy);
            CHECK(std::abs(errors[k].moment) < factor * std::abs(errors[k - 1].moment));
        }
    };
    const Boundary linear(body, BeamStrain::linear, 24);
    const VectorXd q = whirling(linear);
    constexpr auto L = BeamStrain::linear, C = BeamStrain::coupled;
    const double w = whirling_speed;
    const std::vector<Truncation> plain{truncated<1, L>(linear, q, w), truncated<2, L>(linear, q, w),
                                        truncated<3, L>(linear, q, w), truncated<4, L>(linear, q, w),
                                        truncated<6, L>(linear, q, w)};
    check(plain, 0.4);
    CHECK(std::abs(plain[0].tip) > 0.2);
    CHECK(std::abs(plain[4].moment) < 1e-9);
    CHECK(std::abs(plain[4].tip) < 1e-8);
    // a bent beam without stretch needs u_3 of twice the degree: with few modes the coupled one locks
    const Boundary coupled(body, BeamStrain::coupled, 28);
    const VectorXd r = whirling(coupled);
    const std::vector<Truncation> stiff{truncated<3, C>(coupled, r, w), truncated<4, C>(coupled, r, w),
                                        truncated<6, C>(coupled, r, w), truncated<7, C>(coupled, r, w)};
    check(stiff, 0.4);
    CHECK(std::abs(stiff[3].moment) < 1e-5);
    CHECK(std::abs(stiff[3].tip) < 1e-5);
}

TEST_CASE("Followed in the speed the spin begins to whirl where the Galerkin modes say, and the branches hold") {
    for (const BeamStrain strain : strains)
        for (const BeamControl control : {BeamControl::speed, BeamControl::momentum}) {
            const bool by_speed = control == BeamControl::speed;
            const Boundary problem(body, strain, 24, control);
            const auto [spin, whirl] = whirl_of(problem, by_speed ? 9 : 6.4);
            CHECK(spin.end == BranchEnd::window);
            CHECK(spin.unexplained.empty());
            REQUIRE(spin.events.size() == 2);
            for (int k = 0; k < 2; ++k) {
                const auto& point = spin.events[static_cast<std::size_t>(k)].point;
                CHECK(point.kind == CriticalKind::pitchfork);
                CHECK(problem.speed(point.q, point.p) == Approx(whirl_speeds<14>(body, 1 + k)[0]).epsilon(1e-11));
                // the linear beam's branch leads to higher speeds, the coupled one's to lower ones at first
                CHECK((point.curvature > 0) == (strain == BeamStrain::linear));
            }
            CHECK(whirl.end == BranchEnd::window);
            CHECK(whirl.unexplained.empty());
            CHECK(whirl.points.size() > 10);
            for (const auto& point : whirl.points) {
                CHECK(point.residual < 1e-11);
                CHECK(largest_defect(problem, point.q, point.p) < 1e-7);
                CHECK(problem.axis(point.q).norm() == Approx(1).epsilon(1e-13));
                const Eigen::Vector3d n = problem.axis(point.q);
                CHECK((problem.inertia(point.q) * n - problem.moment(point.q) * n).norm() < 1e-11);
            }
            if (strain == BeamStrain::coupled) {
                REQUIRE(whirl.events.size() == 1);
                CHECK(whirl.events[0].point.kind == CriticalKind::fold);
                CHECK(whirl.events[0].point.p < spin.events[0].point.p);
            }
        }
}

TEST_CASE("Along a whirling branch the energy changes by the speed times the momentum's change") {
    // critical values: d(V - omega^2 lambda / 2) = -A d omega, d(V + A^2 / (2 lambda)) = omega dA
    for (const BeamStrain strain : strains) {
        const Boundary by_speed(body, strain, 24), by_momentum(body, strain, 24, BeamControl::momentum);
        const VectorXd q = whirling(by_speed);
        const double momentum = by_speed.momentum(q, whirling_speed), h = 1e-4;
        const auto same = by_momentum.solve(q, momentum);
        REQUIRE(same.converged());
        CHECK((same.q - q).norm() < 1e-11 * q.norm());
        const auto energy = [&](const Boundary& problem, double p) {
            const auto y = problem.solve(q, p);
            REQUIRE(y.converged());
            const double sign = problem.control_by() == BeamControl::speed ? -1 : 1;
            return problem.strain_energy(y.q) + sign * 0.5 * problem.speed(y.q, p) * problem.momentum(y.q, p);
        };
        const double w = whirling_speed;
        CHECK((energy(by_speed, w + h) - energy(by_speed, w - h)) / (2 * h) == Approx(-momentum).epsilon(1e-6));
        CHECK((energy(by_momentum, momentum + h) - energy(by_momentum, momentum - h)) / (2 * h) ==
              Approx(w).epsilon(1e-6));
    }
}

TEST_CASE("A beam of another length, in its own units, has the scaled shape") {
    // lengths by 3, masses by 3
    Boundary::Values p = body, scaled;
    p[Names::centre_1] = 0.1, p[Names::centre_2] = -0.07, p[Names::centre_3] = 0.2;
    const double by[] = {3, 27, 27, 27, 3, 3, 3, 3, 81, 81, 9};
    for (int k = 0; k <= Names::stretching; ++k) scaled[k] = p[k] * by[k];
    for (const BeamStrain strain : strains) {
        const Boundary small(p, strain, 24), large(scaled, strain, 24);
        const auto a = small.solve(small.undeformed({0.1, 0.2, 1}), 3);
        const auto b = large.solve(large.undeformed({0.1, 0.2, 1}), 3);
        REQUIRE(a.converged());
        REQUIRE(b.converged());
        CHECK(a.steps == b.steps);
        CHECK((small.axis(a.q) - large.axis(b.q)).norm() < 1e-12);
        CHECK(large.moment(b.q) == Approx(27 * small.moment(a.q)).epsilon(1e-12));
        // mass by 3, squared speeds by 9
        CHECK(large.strain_energy(b.q) == Approx(27 * small.strain_energy(a.q)).epsilon(1e-11));
        for (const double z : {0.3, 0.8, 1.0}) {
            const auto u = small.shape(a.q, z), v = large.shape(b.q, 3 * z);
            CHECK(u.u.norm() > 1e-4);
            CHECK((v.u - 3 * u.u).norm() < 1e-12);
            CHECK((v.first - u.first).norm() < 1e-12);
            CHECK((v.second - u.second / 3).norm() < 1e-11);
        }
        const auto wa = small.weights(a.q), wb = large.weights(b.q);
        CHECK(a.q.dot(wa.cwiseProduct(a.q)) == Approx(b.q.dot(wb.cwiseProduct(b.q))).epsilon(1e-11));
    }
}

TEST_CASE("The boundary value problem refuses what it cannot take, and says when it does not converge") {
    using Catch::Matchers::Contains;
    Boundary::Values p = body;
    p[Names::stretching] = -1;
    CHECK_THROWS_WITH(Boundary(p, BeamStrain::linear), Contains("stretching = -1"));
    CHECK_THROWS_WITH(Boundary(body, BeamStrain::linear, 3), Contains("points = 3: must be from 4 to 256"));
    const Boundary problem(body, BeamStrain::coupled, 8, BeamControl::momentum);
    CHECK_THROWS_WITH(problem.undeformed({0, 0, 0}), Contains("axis = 0"));
    const VectorXd q = problem.undeformed({0, 0, 1});
    CHECK_THROWS_WITH(problem.shape(q, 1.5), Contains("z = 1.5"));
    CHECK_THROWS_WITH(problem.shape(VectorXd::Zero(7), 0.5), Contains("size = 7"));
    CHECK_THROWS_WITH(problem.solve(VectorXd::Zero(7), 1), Contains("size = 7"));
    CHECK_THROWS_WITH(problem.solve(q, NAN), Contains("p = nan"));
    CHECK_THROWS_WITH(problem.solve(q, 1, 0), Contains("most_steps = 0"));
    CHECK_THROWS_WITH(problem.start_from(Array<double, 7>{0, 0, 1, 0, 0, 0, 0}, 1), Contains("lambda = 0"));
    CHECK_THROWS_WITH(problem.start_from(Array<double, 7>{0, 0, NAN, 0, 0, 0, 1}, 1), Contains("q[2]"));

    const auto short_of = problem.solve(problem.undeformed({0.3, 0, 1}), 3, 1);
    CHECK(short_of.status == BeamSolveStatus::steps);
    CHECK(short_of.steps == 1);
    CHECK(short_of.residual > 1e-6);
    VectorXd without = q;
    without(27) = 0;  // lambda
    const auto lost = problem.solve(without, 1);
    CHECK(lost.status == BeamSolveStatus::not_finite);
    CHECK(std::string(to_string(lost.status)) == "not finite");
    CHECK(!lost.converged());
}
