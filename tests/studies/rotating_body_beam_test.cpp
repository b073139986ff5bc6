// A rigid body with a beam: its modes, its inertia against quadrature, whirling speeds, and all relative equilibria
// with one mode a direction, with their index at fixed momentum.
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using mechanisms::BeamModes, mechanisms::BeamSlopeIntegrals, mechanisms::BeamStrain, mechanisms::momentum_hessian,
    mechanisms::RotatingBodyBeam, mechanisms::whirl_speeds;

namespace {

template <int K, BeamStrain Strain>
using Beam = RotatingBodyBeam<K, Strain>;
using One = Beam<1, BeamStrain::linear>;

/// m_b, I, c, l, mu, omega.
constexpr Parameters<One> body(double speed) { return {2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, speed}; }

/// int f over [0, 1] by Simpson's rule.
double integral(const auto& f) {
    const int n = 2000;
    double sum = f(0.0) + f(1.0);
    for (int k = 1; k < n; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(static_cast<double>(k) / n);
    return sum / (3 * n);
}

Eigen::Matrix3d matrix(const auto& j) {
    Eigen::Matrix3d y;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) y(a, b) = j[a][b];
    return y;
}

/// The real solutions of a set, each as the unknowns of the model, improved by a step of Newton's method.
template <class M>
std::vector<Unknowns<M>> real_solutions(const auto& set, const Parameters<M>& p) {
    std::vector<Unknowns<M>> y;
    for (const auto& root : set.roots) {
        double imaginary = 0;
        Eigen::Vector<double, n_unknowns<M>> q;
        for (int i = 0; i < q.size(); ++i) {
            q(i) = root.q[i].real();
            imaginary = std::max(imaginary, std::abs(root.q[i].imag()));
        }
        if (imaginary > 1e-7) continue;
        Unknowns<M> at;
        std::copy(q.begin(), q.end(), at.begin());
        const auto f = equations<M>(at, p);
        q -= tests::solved(jacobian<M>(at, p), Eigen::Map<const Eigen::VectorXd>(f.begin(), f.size()));
        std::copy(q.begin(), q.end(), at.begin());
        y.push_back(at);
    }
    return y;
}

}  // namespace

TEST_CASE("The shapes are orthonormal, clamped at 0, and their integrals are right") {
    constexpr int K = 5;
    static constexpr BeamModes<K> modes;
    constexpr BeamSlopeIntegrals<K> slopes(modes);
    CHECK(std::abs(modes.bending(0).value[3]) < 1e-14);
    CHECK(std::abs(modes.bending(0).first[3]) < 1e-12);
    CHECK(std::abs(modes.stretching(0).value[2]) < 1e-14);
    for (int i = 0; i < K; ++i) {
        CHECK(modes.bending_mean[i] ==
              Approx(integral([&](double z) { return modes.bending(z).value[i]; })).margin(1e-10));
        CHECK(modes.bending_moment[i] ==
              Approx(integral([&](double z) { return z * modes.bending(z).value[i]; })).margin(1e-10));
        CHECK(modes.stretching_moment[i] ==
              Approx(integral([&](double z) { return z * modes.stretching(z).value[i]; })).margin(1e-10));
        for (int j = 0; j < K; ++j) {
            const double same = i == j;
            CHECK(integral([&](double z) { return modes.bending(z).value[i] * modes.bending(z).value[j]; }) ==
                  Approx(same).margin(1e-8));
            CHECK(integral([&](double z) { return modes.stretching(z).value[i] * modes.stretching(z).value[j]; }) ==
                  Approx(same).margin(1e-8));
            CHECK(modes.product[i][j] == Approx(integral([&](double z) {
                                             return modes.bending(z).value[i] * modes.stretching(z).value[j];
                                         })).margin(1e-8));
            CHECK(modes.bending_stiffness[i][j] ==
                  Approx(integral([&](double z) { return modes.bending(z).second[i] * modes.bending(z).second[j]; }))
                      .epsilon(1e-6)
                      .margin(1e-5));
        }
    }
    CHECK(slopes.coupling[1][0][2] == Approx(integral([&](double z) {
                                          return modes.stretching(z).first[1] * modes.bending(z).first[0] *
                                                 modes.bending(z).first[2];
                                      })).epsilon(1e-8));
    CHECK(slopes.quartic[0][1][1][2] == Approx(integral([&](double z) {
                                            const auto d = modes.bending(z).first;
                                            return d[0] * d[1] * d[1] * d[2];
                                        })).epsilon(1e-7));
    // derivatives are those of the values
    const double h = 1e-5, z = 0.37;
    for (int i = 0; i < K; ++i) {
        CHECK(modes.bending(z).first[i] ==
              Approx((modes.bending(z + h).value[i] - modes.bending(z - h).value[i]) / (2 * h))
                  .epsilon(1e-6)
                  .margin(1e-6));
        CHECK(modes.bending(z).second[i] ==
              Approx((modes.bending(z + h).first[i] - modes.bending(z - h).first[i]) / (2 * h))
                  .epsilon(1e-6)
                  .margin(1e-5));
    }
}

TEST_CASE("Energy and inertia of a deformed beam are the integrals of (2.5) and of the strain, for any length") {
    Generator generator(1);
    constexpr int K = 2;
    using Coupled = Beam<K, BeamStrain::coupled>;
    using Linear = Beam<K, BeamStrain::linear>;
    for (int repeat = 0; repeat < 5; ++repeat) {
        Parameters<Coupled> p;
        for (double& value : p) value = uniform(generator, 0.5, 2);
        for (int k = 0; k < 3; ++k) p[Coupled::centre_1 + k] = uniform(generator, -1, 1);
        const double l = p[Coupled::length];
        Array<double, 3 * K> u;
        for (double& value : u) value = uniform(generator, -0.5, 0.5);
        const auto& modes = Coupled::modes;
        const auto displaced = [&](double s) {  // s = z / l
            Eigen::Vector3d y(0, 0, 0);
            for (int i = 0; i < K; ++i) {
                y(0) += u[i] * modes.bending(s).value[i];
                y(1) += u[K + i] * modes.bending(s).value[i];
                y(2) += u[2 * K + i] * modes.stretching(s).value[i];
            }
            return Eigen::Vector3d(y / std::sqrt(l) + Eigen::Vector3d(0, 0, s * l));
        };
        Eigen::Vector3d first = Eigen::Vector3d::Zero();
        Eigen::Matrix3d inertia =
            Eigen::Vector3d(p[Coupled::inertia_1], p[Coupled::inertia_2], p[Coupled::inertia_3]).asDiagonal();
        for (int a = 0; a < 3; ++a) {
            first(a) = p[Coupled::body_mass] * p[Coupled::centre_1 + a] +
                       l * integral([&](double s) { return displaced(s)(a); });
            for (int b = 0; b < 3; ++b)
                inertia(a, b) += l * integral([&](double s) {
                                     const Eigen::Vector3d r = displaced(s);
                                     return (a == b ? r.squaredNorm() : 0) - r(a) * r(b);
                                 });
        }
        const double mass = p[Coupled::body_mass] + l;
        inertia -= (first.squaredNorm() * Eigen::Matrix3d::Identity() - first * first.transpose()) / mass;
        CHECK((matrix(Coupled::inertia(u, p)) - inertia).norm() < 1e-8);

        const auto strain = [&](bool coupled) {
            return l * integral([&](double s) {
                       Eigen::Vector3d slope(0, 0, 0), curvature(0, 0, 0);
                       for (int i = 0; i < K; ++i)
                           for (int a = 0; a < 3; ++a) {
                               const auto shape = a < 2 ? modes.bending(s) : modes.stretching(s);
                               slope(a) += u[K * a + i] * shape.first[i] / (l * std::sqrt(l));
                               curvature(a) += u[K * a + i] * shape.second[i] / (l * l * std::sqrt(l));
                           }
                       const double stretch = slope(2) + (coupled ? 0.5 * slope.head<2>().squaredNorm() : 0);
                       return 0.5 * (p[Coupled::bending_1] * curvature(0) * curvature(0) +
                                     p[Coupled::bending_2] * curvature(1) * curvature(1) +
                                     p[Coupled::stretching] * stretch * stretch);
                   });
        };
        CHECK(Linear::strain_energy(u, p) == Approx(strain(false)).epsilon(1e-8));
        CHECK(Coupled::strain_energy(u, p) == Approx(strain(true)).epsilon(1e-8));
    }
}

TEST_CASE("Whirling speeds converge to the cantilever's frequencies, and to those of a light body") {
    // a very heavy body: the roots of cos x cosh x = -1, squared
    const auto root = [](double x) {
        for (int k = 0; k < 50; ++k)
            x -= (std::cos(x) * std::cosh(x) + 1) / (std::cos(x) * std::sinh(x) - std::sin(x) * std::cosh(x));
        return x * x;
    };
    const Parameters<One> heavy{1e16, 1e16, 1e16, 1.5e16, 0, 0, 0, 1, 1, 1, 100, 1};
    const auto fixed = whirl_speeds<14>(heavy, 1);
    REQUIRE(fixed.size() == 14);
    const double starts[] = {1.875, 4.694, 7.855};
    for (std::size_t k = 0; k < 3; ++k) CHECK(fixed[k] == Approx(root(starts[k])).epsilon(1e-12));
    // by Ritz's method with 14 polynomials, computed elsewhere
    const Parameters<One> light{2, 1.2, 1.2, 0.8, 0, 0, 0, 1, 1, 1, 100, 1};
    const double expected[] = {4.9678031494911, 23.173658926327, 62.711005469785};
    const auto free = whirl_speeds<14>(light, 1);
    for (std::size_t k = 0; k < 3; ++k) CHECK(free[k] == Approx(expected[k]).epsilon(1e-13));
    CHECK(whirl_speeds<14>(light, 2)[0] == Approx(free[0]).epsilon(1e-14));
    // fewer modes: from above, and quickly
    double before = 1;
    for (const double error : {whirl_speeds<1>(light, 1)[0] - free[0], whirl_speeds<2>(light, 1)[0] - free[0],
                               whirl_speeds<4>(light, 1)[0] - free[0], whirl_speeds<6>(light, 1)[0] - free[0]}) {
        CHECK(error > 0);
        if (before < 1) CHECK(error < 0.02 * before);
        before = error;
    }
    // a longer beam, in its own units: mu / l^4 and I / l^3
    Parameters<One> longer{6, 32.4, 32.4, 21.6, 0, 0, 0, 3, 81, 81, 100, 1};
    CHECK(whirl_speeds<8>(longer, 1)[0] == Approx(whirl_speeds<8>(light, 1)[0]).epsilon(1e-12));
}

TEST_CASE("Where the undeformed spin begins to whirl, the Hessian of its energy is singular") {
    using M = Beam<2, BeamStrain::coupled>;
    for (const int plane : {1, 2}) {
        const double speed = whirl_speeds<2>(body(1), plane)[0];
        Unknowns<M> q;
        q[2] = 1;
        q[M::multiplier] = 0.8;
        const auto hessian = [&](double w) { return momentum_hessian<2, BeamStrain::coupled>(q, 0.8 * w, body(w)); };
        CHECK(std::abs(equations<M>(q, body(speed))[0]) < 1e-14);
        const double here = tests::determinant(hessian(speed));
        CHECK(std::abs(here) < 1e-9 * std::abs(tests::determinant(hessian(0.9 * speed))));
        CHECK(tests::determinant(hessian(0.999 * speed)) * tests::determinant(hessian(1.001 * speed)) < 0);
    }
}

TEST_CASE("All relative equilibria with one mode a direction: 78 complex ones, three axes, then whirling pairs") {
    // 438 paths, of which 360 go to infinity; from these 78 roots those at other speeds. (Next to 7.006, 20 and 30 some
    // of them run away to infinity: there the linear beam breaks down.)
    const auto slow = solve_multihomogeneous<One>(body(1));
    CHECK(slow.paths.total == 438);
    CHECK(slow.paths.accounted_for());
    CHECK(slow.paths.failed == 0);
    CHECK(slow.roots.size() == 78);
    struct Expected {
        double speed;
        std::size_t real;
    };
    for (const auto& [speed, real] :
         {Expected{1, 6}, Expected{4, 6}, Expected{6, 14}, Expected{8, 18}, Expected{10, 14}}) {
        CAPTURE(speed);
        auto to = body(1);
        to[One::speed] = speed;
        const auto set = solve_from(slow.roots, sparse_system<One>(body(1)), sparse_system<One>(to));
        CHECK(set.paths.total == 78);
        CHECK(set.paths.accounted_for());
        CHECK(set.paths.failed == 0);
        const auto p = body(speed);
        const auto found = real_solutions<One>(set, p);
        CHECK(found.size() == real);
        for (const auto& q : found) {
            // (2.6): the axis is a principal one of the deformed inertia, lambda its moment
            Array<double, 3> u{q[3], q[4], q[5]};
            const Eigen::Matrix3d j = matrix(One::inertia(u, p));
            const Eigen::Vector3d n(q[0], q[1], q[2]);
            CHECK(n.norm() == Approx(1).epsilon(1e-12));
            CHECK((j * n - q[One::multiplier] * n).norm() < 1e-9);
            // n -> -n, and the reflections of the axes 1 and 2 with their modes, are equilibria as well
            for (const auto& sign :
                 {Array<double, 3>{-1, -1, -1}, Array<double, 3>{-1, 1, 1}, Array<double, 3>{1, -1, 1}}) {
                const bool turned = sign[2] < 0;
                CHECK(std::any_of(found.begin(), found.end(), [&](const auto& other) {
                    double difference = 0;
                    for (int i = 0; i < 3; ++i)
                        difference += std::abs(other[i] - sign[i] * q[i]) +
                                      std::abs(other[3 + i] - (turned ? 1 : sign[i]) * q[3 + i]);
                    return difference < 1e-6;
                }));
            }
        }
        if (speed == 1) {
            // about the axis of the largest moment stable, the middle one a saddle, the smallest one a maximum: on the
            // sphere the indices 0, 1, 2 twice, alternating sum 2
            int by_index[6] = {};
            for (const auto& q : found)
                ++by_index[inertia(momentum_hessian<1, BeamStrain::linear>(q, q[One::multiplier] * speed, p)).negative];
            CHECK(by_index[0] == 2);
            CHECK(by_index[1] == 2);
            CHECK(by_index[2] == 2);
        }
    }
}
