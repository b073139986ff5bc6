// Singularities located from starts a few percent off, on normal forms in other coordinates: a random local change of
// variables by sines and cosines, whose coefficients are parameters, puts the singular point where it is known.
#include <cmath>

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/singularity/refine_cusp_tangency.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/singularity/refine_umbilic.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Two angles and a coordinate become u, w and t, all 0 at the angles p[first], p[first + 1] and the coordinate 0.
template <int First>
struct Chart {
    static constexpr int phase = First, mixing = First + 2, n_parameters = First + 10;
    static constexpr auto u(const auto& theta, const auto& p) {
        const auto a = theta[0] - p[phase], b = theta[1] - p[phase + 1];
        return sin(a) + p[mixing] * sin(b) + p[mixing + 1] * (1 - cos(a)) + p[mixing + 2] * sin(a) * sin(b);
    }
    static constexpr auto w(const auto& theta, const auto& p) {
        const auto a = theta[0] - p[phase], b = theta[1] - p[phase + 1];
        return sin(b) + p[mixing + 3] * sin(a) + p[mixing + 4] * (1 - cos(b)) + p[mixing + 5] * sin(2 * a + b) * sin(a);
    }
    static constexpr auto t(const auto& theta, const auto& x, const auto& p) {
        const auto a = theta[0] - p[phase], b = theta[1] - p[phase + 1];
        return x[0] + p[mixing + 6] * sin(a) + p[mixing + 7] * x[0] * (1 - cos(b));
    }
};

struct Fold {
    static constexpr int n_angles = 2, n_parameters = Chart<1>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = Chart<1>::u(theta, p), w = Chart<1>::w(theta, p);
        return pow(u, 3) / 3 + (p[0] - 0.3) * u + 0.5 * w * w;
    }
};
struct Swallowtail {
    static constexpr int n_angles = 2, n_parameters = Chart<3>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = Chart<3>::u(theta, p), w = Chart<3>::w(theta, p);
        return pow(u, 5) / 5 + (p[0] - 0.3) * pow(u, 3) / 3 + (p[1] - 0.7) * u * u / 2 + (p[2] + 0.4) * u - 0.5 * w * w;
    }
};
struct Butterfly {
    static constexpr int n_angles = 2, n_parameters = Chart<4>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = Chart<4>::u(theta, p), w = Chart<4>::w(theta, p);
        return pow(u, 6) / 6 + (p[0] - 0.3) * pow(u, 4) / 4 + (p[1] - 0.7) * pow(u, 3) / 3 + p[2] * u * u / 2 +
               p[3] * u + 0.5 * w * w;
    }
};
/// Sign 1: hyperbolic, u^3 + w^3; -1: elliptic, u^3 - 3 u w^2.
template <int Sign>
struct Umbilic {
    static constexpr int n_angles = 2, n_coordinates = 1, n_parameters = Chart<3>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        const auto u = Chart<3>::u(theta, p), w = Chart<3>::w(theta, p), t = Chart<3>::t(theta, x, p);
        const auto unfolding = (p[1] - 0.3) * u + (p[2] + 0.2) * w + 0.5 * t * t;
        if constexpr (Sign > 0)
            return pow(u, 3) + pow(w, 3) + (p[0] - 0.5) * u * w + unfolding;
        else
            return pow(u, 3) - 3 * u * w * w + (p[0] - 0.5) * (u * u + w * w) + unfolding;
    }
};
/// A cubic with a double root line: D5 where the quartic term is there, never D4.
struct Parabolic {
    static constexpr int n_angles = 2, n_parameters = Chart<3>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = Chart<3>::u(theta, p), w = Chart<3>::w(theta, p);
        return u * u * w + pow(w, 4) + p[0] * w * w + p[1] * u + p[2] * w;
    }
};
/// Sign 1: lips, z -> y^2 + z; -1: beak-to-beak, z - y^2. At x = 0, y = 0.2, z = 0.3.
template <int Sign>
struct Meeting {
    static constexpr int n_angles = 2, n_parameters = Chart<3>::n_parameters;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = Chart<3>::u(theta, p), w = Chart<3>::w(theta, p);
        const auto y = p[1] - 0.2, z = p[2] - 0.3;
        return pow(u, 4) / 4 + (z + Sign * y * y) * u * u / 2 + (p[0] + 0.1 * y) * u + 0.5 * w * w;
    }
};
/// Even in both angles together: u -> -u, w -> -w. The pitchforks of u^8.
struct Symmetric {
    static constexpr int n_angles = 2, n_parameters = 5;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = sin(theta[0]) + p[3] * sin(theta[1]) + p[4] * sin(2 * theta[0] + theta[1]);
        const auto w = sin(theta[1]) + p[4] * sin(theta[0]);
        return pow(u, 8) / 8 + (p[0] - 0.2) * pow(u, 6) / 6 + (p[1] + 0.3) * pow(u, 4) / 4 + (p[2] - 0.1) * u * u / 2 -
               0.5 * w * w;
    }
};

constexpr int trials = 10;

/// Random coefficients of the chart, near the identity; the active parameters exact.
template <class M, int First>
Parameters<M> random_chart(Generator& generator, const Array<double, First>& active) {
    Parameters<M> p;
    for (int k = 0; k < First; ++k) p[k] = active[k];
    for (int k = First; k < p.size(); ++k) p[k] = uniform(generator, -0.4, 0.4);
    return p;
}
template <class M, int First>
Unknowns<M> singular_point(const Parameters<M>& p) {
    Unknowns<M> q;
    for (int i = 0; i < 2; ++i) q[i] = p[First + i];
    return q;
}

/// A start a few percent off.
template <class M, int First>
std::pair<Unknowns<M>, Parameters<M>> disturbed(Generator& generator, Unknowns<M> q, Parameters<M> p) {
    for (double& x : q) x += uniform(generator, -0.03, 0.03);
    for (int k = 0; k < First; ++k) p[k] += uniform(generator, -0.03, 0.03);
    return {q, p};
}

template <class M, class S>
double error(const Singularity<M, S>& at, const Unknowns<M>& q, const Parameters<M>& p) {
    double y = 0;
    for (int i = 0; i < q.size(); ++i) y = std::max(y, std::abs(static_cast<double>(at.q[i]) - q[i]));
    for (int k = 0; k < p.size(); ++k) y = std::max(y, std::abs(static_cast<double>(at.p[k]) - p[k]));
    return y;
}

template <class M>
void check_found(const Singularity<M>& at, SingularityKind kind, int nullity) {
    CHECK(at.converged);
    CHECK(to_string(at.kind) == std::string(to_string(kind)));
    CHECK(at.nullity == nullity);
    CHECK(at.residual < 1e-14);
    CHECK(at.correction < 1e-12);
    CHECK(at.steps <= 10);
    const UnknownMatrix<M> j = jacobian<M, double>(at.q, at.p);
    const Eigen::Map<const Eigen::Matrix<double, n_unknowns<M>, 1>> v(at.v.elements), w(at.w.elements);
    CHECK(v.norm() == Approx(1).epsilon(1e-14));
    CHECK((j * v).norm() < 1e-12);
    CHECK((j * w).norm() < 1e-12);
}

}  // namespace

TEST_CASE("a fold and its versality: how the parameter pushes along the null vector") {
    Generator generator(1);
    for (int trial = 0; trial < trials; ++trial) {
        const auto p = random_chart<Fold, 1>(generator, {0.3});
        const auto q = singular_point<Fold, 1>(p);
        const auto [near, parameters] = disturbed<Fold, 1>(generator, q, p);
        const auto at = refine_singularity<Fold, SingularityKind::fold, 0>(near, parameters);
        check_found(at, SingularityKind::fold, 1);
        CHECK(error(at, q, p) < 1e-12);
        CHECK(at.versal());
        const auto push = parameter_derivative<Fold>(at.q, at.p, 0);
        CHECK(std::abs(at.v[0] * push[0] + at.v[1] * push[1]) > 0.1);
        // what bends the coordinates moves no equilibrium at the singular point: no unfolding
        CHECK_FALSE(refine_singularity<Fold, SingularityKind::fold, Chart<1>::mixing + 1>(q, p).versal());
    }
}

TEST_CASE("a swallowtail") {
    using M = Swallowtail;
    Generator generator(2);
    for (int trial = 0; trial < trials; ++trial) {
        const auto p = random_chart<M, 3>(generator, {0.3, 0.7, -0.4});
        const auto q = singular_point<M, 3>(p);
        const auto [near, parameters] = disturbed<M, 3>(generator, q, p);
        const auto at = refine_singularity<M, SingularityKind::swallowtail, 0, 1, 2>(near, parameters);
        check_found(at, SingularityKind::swallowtail, 1);
        CHECK(error(at, q, p) < 1e-12);
        CHECK(at.versal());
        CHECK(std::abs(at.derivative(3)) < 1e-12);
        CHECK(std::abs(at.derivative(4)) < 1e-12);
        // phi = u^5 / 5, u = slope xi + ..
        const double slope = at.v[0] + p[Chart<3>::mixing] * at.v[1];
        CHECK(at.derivative(5) == Approx(24 * std::pow(slope, 5)).epsilon(1e-9));
        // the same with the null vector given, of any length and sign
        const auto again = refine_singularity<M, SingularityKind::swallowtail, 0, 1, 2>(
            near, parameters, Unknowns<M>{-3 * at.v[0], -3 * at.v[1]});
        check_found(again, SingularityKind::swallowtail, 1);
        CHECK(again.v[0] == Approx(-at.v[0]).margin(1e-10));
    }
}

TEST_CASE("a butterfly, in double and to 40 digits") {
    using M = Butterfly;
    using F = Multiprecision<40>;
    Generator generator(3);
    for (int trial = 0; trial < trials; ++trial) {
        const auto p = random_chart<M, 4>(generator, {0.3, 0.7, 0, 0});
        const auto q = singular_point<M, 4>(p);
        const auto [near, parameters] = disturbed<M, 4>(generator, q, p);
        const auto at = refine_singularity<M, SingularityKind::butterfly, 0, 1, 2, 3>(near, parameters);
        check_found(at, SingularityKind::butterfly, 1);
        CHECK(error(at, q, p) < 1e-11);
        CHECK(at.versal());
        const double slope = at.v[0] + p[Chart<4>::mixing] * at.v[1];
        CHECK(at.derivative(6) == Approx(120 * std::pow(slope, 6)).epsilon(1e-8));
        // a swallowtail in three of the parameters is not there to be found: the fourth keeps the butterfly
        const auto higher = refine_singularity<M, SingularityKind::swallowtail, 1, 2, 3>(q, p);
        CHECK(higher.kind == SingularityKind::undecided);
        if (trial > 2) continue;
        Parameters<M, F> wide;
        for (int k = 0; k < p.size(); ++k) wide[k] = F(parameters[k]);
        const auto precise = refine_singularity<M, SingularityKind::butterfly, 0, 1, 2, 3>(near, wide);
        CHECK(precise.kind == SingularityKind::butterfly);
        CHECK(precise.residual < F(1e-38));
        CHECK(precise.correction < F(1e-36));
        CHECK(precise.steps <= at.steps + 3);          // quadratic
        CHECK(abs(precise.p[1] - F(0.7)) < F(1e-36));  // the model's own constant
    }
}

TEST_CASE("umbilics of two angles and a coordinate, told apart by the real root lines of their cubic") {
    Generator generator(4);
    for (int trial = 0; trial < trials; ++trial) {
        using H = Umbilic<1>;
        using E = Umbilic<-1>;
        const auto p = random_chart<H, 3>(generator, {0.5, 0.3, -0.2});
        const auto q = singular_point<H, 3>(p);
        const auto [near, parameters] = disturbed<H, 3>(generator, q, p);
        const auto hyperbolic = refine_umbilic<H, 0, 1, 2>(near, parameters);
        check_found(hyperbolic, SingularityKind::hyperbolic_umbilic, 2);
        CHECK(error(hyperbolic, q, p) < 1e-12);
        CHECK(hyperbolic.discriminant < -1e-3);
        CHECK(hyperbolic.versal());
        const auto elliptic = refine_umbilic<E, 0, 1, 2>(near, parameters);
        check_found(elliptic, SingularityKind::elliptic_umbilic, 2);
        CHECK(error(elliptic, q, p) < 1e-12);
        CHECK(elliptic.discriminant > 1e-3);
        CHECK(elliptic.versal());
        using F = Multiprecision<40>;
        if (trial == 0) {
            Parameters<E, F> wide;
            for (int k = 0; k < p.size(); ++k) wide[k] = F(parameters[k]);
            const auto precise = refine_umbilic<E, 0, 1, 2>(near, wide);
            CHECK(precise.kind == SingularityKind::elliptic_umbilic);
            CHECK(precise.residual < F(1e-38));
            CHECK(precise.steps <= elliptic.steps + 3);  // quadratic
            CHECK(abs(precise.p[1] - F(0.3)) < F(1e-37));
        }
        // of corank 1 there is nothing here
        CHECK(refine_singularity<H, SingularityKind::swallowtail, 0, 1, 2>(q, p).kind == SingularityKind::undecided);
    }
}

TEST_CASE("a cubic with a double root line is not named") {
    using M = Parabolic;
    Generator generator(5);
    const auto p = random_chart<M, 3>(generator, {0, 0, 0});
    const auto q = singular_point<M, 3>(p);
    const auto at = refine_umbilic<M, 0, 1, 2>(q, p);
    CHECK(at.nullity == 2);
    CHECK(std::abs(at.discriminant) < 1e-8);
    CHECK(at.kind == SingularityKind::undecided);
}

TEST_CASE("lips and beak-to-beak, told apart by the second-order form") {
    Generator generator(6);
    for (int trial = 0; trial < trials; ++trial) {
        using L = Meeting<1>;
        using B = Meeting<-1>;
        const auto p = random_chart<L, 3>(generator, {0, 0.2, 0.3});
        const auto q = singular_point<L, 3>(p);
        const auto [near, parameters] = disturbed<L, 3>(generator, q, p);
        const auto lips = refine_cusp_tangency<L, 0, 1, 2>(near, parameters);
        check_found(lips, SingularityKind::lips, 1);
        CHECK(error(lips, q, p) < 1e-12);
        CHECK(lips.form[0] < -0.1);
        CHECK(lips.form[1] < -0.1);
        CHECK(std::abs(lips.derivative(3)) < 1e-12);
        CHECK(lips.derivative(4) > 1);
        const auto beak = refine_cusp_tangency<B, 0, 1, 2>(near, parameters);
        check_found(beak, SingularityKind::beak_to_beak, 1);
        CHECK(error(beak, q, p) < 1e-12);
        CHECK(beak.form[0] < -0.1);
        CHECK(beak.form[1] > 0.1);
        if (trial == 0) {
            using F = Multiprecision<40>;
            Parameters<B, F> wide;
            for (int k = 0; k < p.size(); ++k) wide[k] = F(parameters[k]);
            const auto precise = refine_cusp_tangency<B, 0, 1, 2>(near, wide);
            CHECK(precise.kind == SingularityKind::beak_to_beak);
            CHECK(precise.residual < F(1e-38));
            CHECK(precise.steps <= beak.steps + 3);  // quadratic
            CHECK(abs(precise.p[2] - F(0.3)) < F(1e-37));
        }
        // there x and y do not unfold the cusp
        const auto cusp = refine_singularity<B, SingularityKind::cusp, 0, 1>(q, p);
        CHECK_FALSE(cusp.versal());
    }
}

TEST_CASE("pitchforks of a symmetric branch, by the even derivatives that vanish") {
    using M = Symmetric;
    Generator generator(7);
    for (int trial = 0; trial < trials; ++trial) {
        Parameters<M> p{0.2, -0.3, 0.1, uniform(generator, -0.2, 0.2), uniform(generator, -0.2, 0.2)};
        const auto [near, parameters] = disturbed<M, 3>(generator, {}, p);
        const auto at = refine_singularity<M, SingularityKind::tetracritical_pitchfork, 0, 1, 2>(near, parameters);
        check_found(at, SingularityKind::tetracritical_pitchfork, 1);
        CHECK(error(at, {}, p) < 1e-12);
        CHECK(at.versal());
        for (int k = 3; k < 8; ++k) CHECK(std::abs(at.derivative(k)) < 1e-10);
        p[0] = 0.5;
        CHECK(refine_singularity<M, SingularityKind::tricritical_pitchfork, 1, 2>(near, {p[0], -0.29, 0.12, p[3], p[4]})
                  .kind == SingularityKind::tricritical_pitchfork);
        p[1] = 0.5;
        const auto pitchfork =
            refine_singularity<M, SingularityKind::pitchfork, 2>(near, {p[0], p[1], 0.12, p[3], p[4]});
        CHECK(pitchfork.kind == SingularityKind::pitchfork);
        CHECK(std::abs(pitchfork.p[2] - 0.1) < 1e-12);
    }
    // no symmetry, and it is said
    const auto q = singular_point<Swallowtail, 3>({0.3, 0.7, -0.4, 0, 0, 0.1, 0.2, 0.1, 0.3, -0.1, 0.2});
    CHECK(refine_singularity<Swallowtail, SingularityKind::pitchfork, 1>(
              q, {0.3, 0.7, -0.4, 0, 0, 0.1, 0.2, 0.1, 0.3, -0.1, 0.2})
              .kind == SingularityKind::undecided);
}

TEST_CASE("far from anything Newton's method fails with a status, and bad arguments throw") {
    const auto at = refine_singularity<Swallowtail, SingularityKind::swallowtail, 0, 1, 2>(
        {2.5, -2}, Parameters<Swallowtail>{9, -8, 7});
    CHECK((at.kind == SingularityKind::undecided || at.converged));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(
        (refine_singularity<Swallowtail, SingularityKind::swallowtail, 0, 1, 2>({nan, 0}, Parameters<Swallowtail>{})),
        InvalidArgument);
    CHECK_THROWS_AS((refine_umbilic<Umbilic<1>, 0, 1, 2>({0, 0, 0}, Parameters<Umbilic<1>>{nan})), InvalidArgument);
    using L = Meeting<1>;
    CHECK_THROWS_AS((refine_cusp_tangency<L, 0, 1, 2>({0, 0}, Parameters<L>{}, Unknowns<L>{0, 0})), InvalidArgument);
    CHECK(std::string(to_string(SingularityKind::beak_to_beak)) == "beak-to-beak");
}
