// The systems whose solutions are singularities: their Jacobians against differences, at points of no kind, and their
// residuals at a singularity that is known; and reduced coefficients in closed form, with and without a potential.
#include <cmath>

#include <equilibria/core/random.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/singularity/refine_cusp_tangency.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/singularity/refine_umbilic.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Kind = SingularityKind;

namespace {

/// Two angles of no special kind, even in both together.
struct Even {
    static constexpr int n_angles = 2, n_parameters = 4;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto a = sin(theta[0]), b = sin(theta[1]);
        return p[0] * cos(theta[0]) + p[1] * a * b + p[2] * cos(theta[0] - 2 * theta[1]) + p[3] * pow(a, 4) +
               0.7 * b * b + 0.3 * p[0] * p[1] * cos(theta[1]) + 0.2 * p[3] * pow(b, 3) * a;
    }
};
/// The same with forces: no symmetry.
struct Uneven {
    static constexpr int n_angles = 2, n_parameters = 4;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return Even{}.potential(theta, p) + p[2] * sin(theta[0]) + 0.4 * p[1] * sin(theta[1] - theta[0]) +
               p[3] * sin(3 * theta[0]);
    }
};

/// The derivatives of system(y) by central differences against its own, with the same border: every evaluation on a
/// copy.
template <class System, class Vector>
void check_jacobian(const System& system, const Vector& y) {
    const int size = y.size();
    constexpr double h = 1e-6;
    Vector r = y, low = y, high = y;
    auto jacobian = detail::Rebound<Vector, double>::square(size), unused = jacobian;
    REQUIRE(System(system)(y, r, jacobian));
    double scale = 1;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) scale = std::max(scale, std::abs(jacobian[i][j]));
    for (int j = 0; j < size; ++j) {
        Vector below = y, above = y;
        below[j] -= h;
        above[j] += h;
        REQUIRE(System(system)(below, low, unused));
        REQUIRE(System(system)(above, high, unused));
        CAPTURE(j);
        for (int i = 0; i < size; ++i) CHECK(std::abs((high[i] - low[i]) / (2 * h) - jacobian[i][j]) < 1e-6 * scale);
    }
}

template <class M>
Parameters<M> random_parameters(Generator& generator) {
    Parameters<M> p;
    for (double& x : p) x = uniform(generator, 0.5, 1.5);
    return p;
}
Unknowns<Even> random_angles(Generator& generator) { return {uniform(generator, -1, 1), uniform(generator, -1, 1)}; }
Unknowns<Even> random_direction(Generator& generator) {
    const double turn = uniform(generator, 0, 3);
    return {std::cos(turn), std::sin(turn)};
}

template <class M, Kind K, int... Active>
void check_kind(Generator& generator) {
    CAPTURE(to_string(K));
    for (int trial = 0; trial < 10; ++trial) {
        Unknowns<M> q = random_angles(generator);
        if (class_of(K).symmetric) q = {};
        constexpr int active[] = {Active...};
        const detail::DefiningSystem<double> system(functions_of<M>(), K, active, runtime_array(q),
                                                    runtime_array(random_parameters<M>(generator)),
                                                    runtime_array(random_direction(generator)));
        check_jacobian(system, system.packed());
    }
}

/// (F_1, F_2) = (dV/dtheta, dV/dx) of V = a s^3 + b s^2 x + x^2 / 2, s = sin theta, turned by 0.7: no potential, and
/// x = -b s^2 makes the reduced potential a s^3 - b^2 s^4 / 2.
struct Turned {
    static constexpr int n_angles = 1, n_coordinates = 1, n_parameters = 2;
    constexpr auto equations(const auto& theta, const auto& x, const auto& p) const {
        const auto s = sin(theta[0]), c = cos(theta[0]);
        const auto first = c * (3 * p[0] * s * s + 2 * p[1] * s * x[0]), second = x[0] + p[1] * s * s;
        constexpr double co = 0.764842187284489, si = 0.644217687237691;
        return std::array{co * first - si * second, si * first + co * second};
    }
};
struct Straight {
    static constexpr int n_angles = 1, n_coordinates = 1, n_parameters = 2;
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        const auto s = sin(theta[0]);
        return p[0] * pow(s, 3) + p[1] * s * s * x[0] + 0.5 * x[0] * x[0];
    }
};

}  // namespace

TEST_CASE("Jacobians of the systems of the kinds A and B and of extremal points agree with differences") {
    Generator generator(1);
    check_kind<Uneven, Kind::fold, 1>(generator);
    check_kind<Uneven, Kind::cusp, 0, 2>(generator);
    check_kind<Uneven, Kind::swallowtail, 3, 0, 1>(generator);
    check_kind<Uneven, Kind::butterfly, 0, 1, 2, 3>(generator);
    check_kind<Uneven, Kind::extremal_fold, 2, 1>(generator);
    check_kind<Even, Kind::pitchfork, 0>(generator);
    check_kind<Even, Kind::tricritical_pitchfork, 0, 3>(generator);
    check_kind<Even, Kind::tetracritical_pitchfork, 0, 1, 3>(generator);
}

TEST_CASE("Jacobians of the systems of umbilics and of lips agree with differences") {
    Generator generator(2);
    for (int trial = 0; trial < 5; ++trial) {
        const auto q = random_angles(generator);
        const auto p = random_parameters<Uneven>(generator);
        const detail::UmbilicSystem<Uneven, double, 0, 1, 2> umbilic(p, {{{0.8, 0.6}, {-0.6, 0.8}}});
        check_jacobian(umbilic, umbilic.packed(q));
        const detail::CuspTangencySystem<Uneven, double, 3, 1, 2> tangency(p);
        check_jacobian(tangency, tangency.start(q, random_direction(generator)));
    }
}

TEST_CASE("where Newton's method ends F, J v and the derivatives that name the kind vanish, by other code") {
    Generator generator(3);
    int found = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const auto at = refine_singularity<Uneven, Kind::cusp, 0, 1>(random_angles(generator),
                                                                     random_parameters<Uneven>(generator));
        if (at.kind != Kind::cusp) continue;
        ++found;
        CHECK(at.active == std::array{0, 1, -1, -1});
        CHECK(at.x() == at.p[0]);
        CHECK(at.y() == at.p[1]);
        const double size = 1 + detail::largest(at.p);
        CHECK(detail::largest(equations<Uneven>(at.q, at.p)) < 1e-12 * size);
        CHECK(detail::largest(directional_derivative<1, Uneven>(at.q, at.v, at.p)) < 1e-12 * size);
        CHECK(std::abs(third_derivative<Uneven>(at.q, at.v, at.p)) < 1e-11 * size);
        // V''''[v^4] - 3 <V'''[v,v,.], J^+ V'''[v,v,.]>, across v in the plane
        const auto second = directional_derivative<2, Uneven>(at.q, at.v, at.p);
        const Unknowns<Uneven> across{-at.v[1], at.v[0]};
        const auto stiffness = detail::dot(across, directional_derivative<1, Uneven>(at.q, across, at.p));
        const double push = detail::dot(across, second);
        const double fourth = fourth_derivative<Uneven>(at.q, at.v, at.p) - 3 * push * push / stiffness;
        CHECK(at.derivative(4) == Approx(fourth).epsilon(1e-8));
        CHECK(reduced_coefficients<Uneven>(at.q, at.v, at.p).fourth == Approx(fourth).epsilon(1e-8));
    }
    CHECK(found >= 5);
}

TEST_CASE("reduced coefficients are those of the closed form, with a potential and with its equations turned") {
    Generator generator(4);
    for (int trial = 0; trial < 20; ++trial) {
        const double a = uniform(generator, -1, 1), b = uniform(generator, -1, 1);
        const auto straight = reduced_coefficients<Straight>({0, 0}, {1, 0}, {a, b});
        CHECK(straight.third == Approx(6 * a).margin(1e-14));
        CHECK(straight.fourth == Approx(-12 * b * b).margin(1e-13));
        const auto turned = reduced_coefficients<Turned>({0, 0}, {1, 0}, {a, b});
        CHECK(turned.third == Approx(6 * a).margin(1e-13));
        CHECK(turned.fourth == Approx(-12 * b * b).margin(1e-12));
        // the other sign of the null vector
        const auto back = reduced_coefficients<Turned>({0, 0}, {-1, 0}, {a, b});
        CHECK(back.third == Approx(-6 * a).margin(1e-13));
        CHECK(back.fourth == Approx(-12 * b * b).margin(1e-12));
    }
}
