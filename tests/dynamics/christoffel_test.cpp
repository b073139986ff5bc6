// Christoffel symbols against the metric's derivatives and the mechanism's closed forms.
#include <cmath>

#include <equilibria/core/random.hpp>
#include <equilibria/dynamics/christoffel.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "support/catch.hpp"
#include "support/moving_models.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;

TEST_CASE(
    "The symbols of the first kind make the metric constant along itself, and those of the second kind raise them") {
    Generator generator(1);
    for (int repeat = 0; repeat < 20; ++repeat) {
        Parameters<M> p;
        for (double& value : p) value = uniform(generator, 0.5, 2);
        const Unknowns<M> q{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        const auto first = christoffel_first_kind<M>(q, p), second = christoffel_second_kind<M>(q, p);
        const auto d = mass_matrix_derivatives<M>(q, p);
        const UnknownMatrix<M> mass = mass_matrix<M>(q, p);
        for (int k = 0; k < 2; ++k) {
            CHECK((first[k] - first[k].transpose()).norm() < 1e-13);
            UnknownMatrix<M> lowered = UnknownMatrix<M>::Zero();
            for (int l = 0; l < 2; ++l) lowered += mass(k, l) * second[l];
            CHECK((lowered - first[k]).norm() < 1e-11);
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) CHECK(d[k](i, j) == Approx(first[j](k, i) + first[i](k, j)).margin(1e-12));
        }
    }
}

TEST_CASE("The mechanism's symbols are those printed, with Gamma_11,1 put right") {
    Generator generator(2);
    const auto p = M::paper_parameters(0);
    const double scale = p[M::mass_1] * p[M::length] * p[M::length];
    for (int repeat = 0; repeat < 20; ++repeat) {
        const Unknowns<M> q{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        const double s = std::sin(q[0]), c = std::cos(q[0]), r = std::sqrt(3 + c * c), slope = 1 + c / r;
        const auto g = christoffel_first_kind<M>(q, p);
        CHECK(g[0](0, 0) ==
              Approx(scale * (s * c * slope * slope - 3 * s * s * s * slope / (r * r * r))).margin(1e-11));
        CHECK(std::abs(g[0](0, 1)) < 1e-12);
        CHECK(g[0](1, 1) == Approx(scale * std::cos(q[0] + q[1])).margin(1e-12));
        CHECK(g[1](0, 0) == Approx(scale * std::cos(q[0] + q[1])).margin(1e-12));
        CHECK(std::abs(g[1](0, 1)) < 1e-12);
        CHECK(std::abs(g[1](1, 1)) < 1e-12);
    }
}

TEST_CASE("Polar coordinates have the symbols of the plane") {
    using E = models::ElasticPendulumInMotion;
    const auto second = christoffel_second_kind<E>({0.3, 1.7}, {2, 1, 1});
    CHECK(second[0](0, 1) == Approx(1 / 1.7));
    CHECK(second[1](0, 0) == Approx(-1.7));
    CHECK(second[0](0, 0) == 0);
    CHECK(second[1](1, 1) == 0);
}
