// The kinetic energy's matrix and its derivatives, damping, forces and constraints of a model, against closed forms.
#include <array>
#include <cmath>
#include <string>

#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/kinetics.hpp>
#include <equilibria/model/torus.hpp>

#include "support/catch.hpp"
#include "support/moving_models.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;
using C = mechanisms::HolonomicMechanismPoints;

namespace {

Unknowns<M> random_pair(Generator& generator) { return {uniform(generator, -3, 3), uniform(generator, -3, 3)}; }

Parameters<M> random_parameters(Generator& generator) {
    Parameters<M> p;
    for (double& value : p) value = uniform(generator, 0.5, 2);
    return p;
}

}  // namespace

static_assert(DynamicModel<M> && DynamicModel<C> && DynamicModel<models::ElasticPendulumInMotion>);
static_assert(!DynamicModel<mechanisms::TwoLinkChain>);
static_assert(n_constraints<C> == 4 && n_constraints<M> == 0);

TEST_CASE("The mass matrix of the mechanism is (4.1), for masses of their own") {
    Generator generator(1);
    for (int k = 0; k < 50; ++k) {
        const auto p = random_parameters(generator);
        const auto q = random_pair(generator);
        const double l = p[M::length], s = std::sin(q[0]), c = std::cos(q[0]), slope = 1 + c / std::sqrt(3 + c * c);
        const UnknownMatrix<M> a = mass_matrix<M>(q, p);
        CHECK(a(0, 0) == Approx(l * l * (p[M::mass_1] + p[M::mass_2] + p[M::mass_3] * s * s * slope * slope)));
        CHECK(a(0, 1) == Approx(p[M::mass_2] * l * l * std::sin(q[0] + q[1])).margin(1e-14));
        CHECK(a(1, 0) == a(0, 1));
        CHECK(a(1, 1) == Approx(p[M::mass_2] * l * l));
    }
}

TEST_CASE("Energies, dissipation and forces of the mechanism are those of its points") {
    Generator generator(2);
    for (int k = 0; k < 50; ++k) {
        auto p = random_parameters(generator);
        const auto q = random_pair(generator), v = random_pair(generator);
        const auto points = mechanisms::points_of({q, v}, p);
        CHECK(potential<C>(points.q, p) == Approx(potential<M>(q, p)).margin(1e-12));
        CHECK(kinetic_energy<C>(points.q, points.velocity, p) == Approx(kinetic_energy<M>(q, v, p)).margin(1e-12));
        CHECK(dissipation<C>(points.q, points.velocity, p) == Approx(dissipation<M>(q, v, p)).margin(1e-12));
        const double t = uniform(generator, 0, 3);
        const auto forces = generalised_forces<M>(t, q, v, p);
        const auto on_points = generalised_forces<C>(t, points.q, points.velocity, p);
        double power = 0, power_on_points = 0;
        for (int i = 0; i < 2; ++i) power += forces[i] * v[i];
        for (int i = 0; i < 6; ++i) power_on_points += on_points[i] * points.velocity[i];
        CHECK(power == Approx(power_on_points).margin(1e-13));
        // and back
        const auto angles = mechanisms::angles_of(points);
        for (int i = 0; i < 2; ++i) {
            CHECK(std::abs(wrap(angles.q[i] - q[i])) < 1e-13);
            CHECK(angles.velocity[i] == Approx(v[i]).margin(1e-12));
        }
        for (const double f : constraints<C>(points.q, p)) CHECK(std::abs(f) < 1e-13);
        const Eigen::Map<const Eigen::Vector<double, 6>> velocity(points.velocity.begin());
        const Eigen::Vector4d rates = constraint_jacobian<C>(points.q, p) * velocity;
        CHECK(rates.cwiseAbs().maxCoeff() < 1e-12);
    }
}

TEST_CASE("Derivatives of the mass matrix, of the constraints and of the dissipation against differences") {
    Generator generator(3);
    const double h = 1e-5;
    for (int k = 0; k < 20; ++k) {
        const auto p = random_parameters(generator);
        const auto q = random_pair(generator), v = random_pair(generator);
        const auto d = mass_matrix_derivatives<M>(q, p);
        for (int i = 0; i < 2; ++i) {
            auto ahead = q, behind = q;
            ahead[i] += h, behind[i] -= h;
            const UnknownMatrix<M> difference = (mass_matrix<M>(ahead, p) - mass_matrix<M>(behind, p)) / (2 * h);
            CHECK((d[i] - difference).cwiseAbs().maxCoeff() < 1e-7);
            auto faster = v, slower = v;
            faster[i] += h, slower[i] -= h;
            CHECK(dissipation_gradient<M>(q, v, p)[i] ==
                  Approx((dissipation<M>(q, faster, p) - dissipation<M>(q, slower, p)) / (2 * h)).margin(1e-8));
            CHECK(momenta<M>(q, v, p)[i] ==
                  Approx((kinetic_energy<M>(q, faster, p) - kinetic_energy<M>(q, slower, p)) / (2 * h)).margin(1e-8));
        }
        // f'' v v of quadratic constraints: f(x + v) + f(x - v) - 2 f(x), exactly
        const auto x = mechanisms::points_of({q, v}, p);
        auto ahead = x.q, behind = x.q;
        for (int i = 0; i < 6; ++i) ahead[i] += x.velocity[i], behind[i] -= x.velocity[i];
        const auto curvature = constraint_curvature<C>(x.q, x.velocity, p);
        const auto a = constraints<C>(ahead, p), b = constraints<C>(behind, p), c = constraints<C>(x.q, p);
        for (int i = 0; i < 4; ++i) CHECK(curvature[i] == Approx(a[i] + b[i] - 2 * c[i]).margin(1e-11));
    }
}

TEST_CASE("Models without damping, forces and constraints have none, and coordinates come after angles") {
    using E = models::ElasticPendulumInMotion;
    const Parameters<E> p{2.0, 30.0, 9.81};
    const Unknowns<E> q{0.4, 1.3}, v{-0.7, 0.2};
    CHECK(dissipation<E>(q, v, p) == 0);
    for (int i = 0; i < 2; ++i) {
        CHECK(dissipation_gradient<E>(q, v, p)[i] == 0);
        CHECK(generalised_forces<E>(1, q, v, p)[i] == 0);
    }
    const UnknownMatrix<E> mass = mass_matrix<E>(q, p);
    CHECK(mass(0, 0) == Approx(2 * 1.3 * 1.3));
    CHECK(mass(0, 1) == 0);
    CHECK(mass(1, 1) == 2);
    CHECK(mass_matrix_derivatives<E>(q, p)[1](0, 0) == Approx(4 * 1.3));
}

TEST_CASE("A kinetic energy that is not quadratic is refused") {
    std::string message;
    try {
        require_quadratic_kinetic_energy<models::NotQuadratic>({0.1}, {1.0});
    } catch (const InvalidArgument& error) {
        message = error.what();
    }
    CHECK(message.starts_with("kinetic_energy = "));
    CHECK(message.find("must be a quadratic form in the velocities") != message.npos);
    CHECK_NOTHROW(require_quadratic_kinetic_energy<M>({0.1, 0.2}, M::paper_parameters(0)));
}
