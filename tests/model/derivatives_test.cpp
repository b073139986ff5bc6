#include <cmath>
#include <complex>

#include <Eigen/Core>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/random_parameters.hpp"

using namespace equilibria;
using tests::random_parameters;
using mechanisms::RotatingChain;

namespace {

template <class M>
Unknowns<M> random_unknowns(Generator& generator) {
    Unknowns<M> q;
    for (double& value : q) value = uniform(generator, -3, 3);
    return q;
}
template <class Values>
Values moved(const Values& q, const Values& v, double h) {
    Values y = q;
    for (int i = 0; i < y.size(); ++i) y[i] += h * v[i];
    return y;
}
template <class A>
double distance(const A& a, const A& b) {
    double largest = 0;
    for (int i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}
template <class A>
double distance(const A& difference, const A& right, const A& left, double h) {
    double largest = 0;
    for (int i = 0; i < difference.size(); ++i)
        largest = std::max(largest, std::abs(difference[i] - (right[i] - left[i]) / (2 * h)));
    return largest;
}
template <class M>
Unknowns<M> product(const UnknownMatrix<M>& a, const Unknowns<M>& v) {
    Unknowns<M> y{};
    for (int r = 0; r < y.size(); ++r)
        for (int c = 0; c < y.size(); ++c) y[r] += a(r, c) * v[c];
    return y;
}
template <class M>
double dot(const Unknowns<M>& a, const Unknowns<M>& b) {
    double sum = 0;
    for (int i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Central differences with h = 1e-5: their error is about 1e-10 of the third derivatives.
constexpr double h = 1e-5, small = 2e-7;

template <class M>
void check_differences() {
    Generator generator(1);
    for (int trial = 0; trial < 5; ++trial) {
        const auto q = random_unknowns<M>(generator), v = random_unknowns<M>(generator);
        const auto p = random_parameters<M>(generator);
        Parameters<M> w;
        for (double& value : w) value = uniform(generator, -1, 1);

        if constexpr (PotentialModel<M>)
            for (int i = 0; i < q.size(); ++i) {
                Unknowns<M> e{};
                e[i] = 1;
                const double slope = (potential<M>(moved(q, e, h), p) - potential<M>(moved(q, e, -h), p)) / (2 * h);
                CHECK(equations<M>(q, p)[i] == Approx(slope).margin(small));
            }
        const auto along = [&](double e) { return equations<M>(moved(q, v, e), moved(p, w, e)); };
        CHECK(distance(directional_derivative<1, M>(q, v, p, w), along(h), along(-h), h) < small);
        const auto first = [&](double e) { return directional_derivative<1, M>(moved(q, v, e), v, moved(p, w, e), w); };
        CHECK(distance(directional_derivative<2, M>(q, v, p, w), first(h), first(-h), h) < 20 * small);
        const auto second = [&](double e) {
            return directional_derivative<2, M>(moved(q, v, e), v, moved(p, w, e), w);
        };
        CHECK(distance(directional_derivative<3, M>(q, v, p, w), second(h), second(-h), h) < 400 * small);
    }
}

/// Identities that hold to rounding.
template <class M>
void check_identities() {
    Generator generator(2);
    for (int trial = 0; trial < 5; ++trial) {
        const auto q = random_unknowns<M>(generator), v = random_unknowns<M>(generator);
        const auto p = random_parameters<M>(generator);
        const UnknownMatrix<M> j = jacobian<M>(q, p), jv = jacobian_derivative<M>(q, v, p);
        if constexpr (PotentialModel<M>) {
            CHECK((j - j.transpose()).cwiseAbs().maxCoeff() < 1e-13 * j.cwiseAbs().maxCoeff());
            CHECK((jv - jv.transpose()).cwiseAbs().maxCoeff() < 1e-12 * (1 + jv.cwiseAbs().maxCoeff()));
            CHECK(third_derivative<M>(q, v, p) == Approx(dot<M>(product<M>(jv, v), v)).margin(1e-11));
            CHECK(fourth_derivative<M>(q, v, p) ==
                  Approx(dot<M>(directional_derivative<3, M>(q, v, p), v)).margin(1e-11));
        }
        CHECK(distance(directional_derivative<0, M>(q, v, p), equations<M>(q, p)) == 0);
        CHECK(distance(directional_derivative<1, M>(q, v, p), product<M>(j, v)) < 1e-12);
        CHECK(distance(directional_derivative<2, M>(q, v, p), product<M>(jv, v)) < 1e-11);
        for (int k = 0; k < p.size(); ++k) {
            Parameters<M> e{};
            e[k] = 1;
            CHECK(distance(parameter_derivative<M>(q, p, k), directional_derivative<1, M>(q, Unknowns<M>{}, p, e)) <
                  1e-13);
            // mixed second derivatives: d/dp_k (J v) = 1/2 (D2[v, e_k] + ...), by polarisation
            const auto both = directional_derivative<2, M>(q, v, p, e);
            const auto only_q = directional_derivative<2, M>(q, v, p);
            const auto only_p = directional_derivative<2, M>(q, Unknowns<M>{}, p, e);
            const auto mixed = product<M>(jacobian_parameter_derivative<M>(q, p, k), v);
            for (int i = 0; i < q.size(); ++i)
                CHECK(both[i] - only_q[i] - only_p[i] == Approx(2 * mixed[i]).margin(1e-11));
        }
    }
}

}  // namespace

TEMPLATE_TEST_CASE("derivatives agree with finite differences and with each other", "", mechanisms::TwoLinkChain,
                   RotatingChain<3>, models::Pendulum, models::ElasticPendulum, models::CoupledAngles<3>,
                   models::TwoAngleMechanism, models::Everything) {
    check_differences<TestType>();
    check_identities<TestType>();
}

TEST_CASE("the chain's equations are Baillieul's (3.1), in any number of links") {
    // (3.1), from the first link on: sum_j m_(max(i,j)).. l_j s_j c_i w^2 - M_i g s_i = 0; the gradient of V is -l_i
    // times that.
    constexpr int n = 4;
    using M = RotatingChain<n>;
    Generator generator(3);
    for (int trial = 0; trial < 10; ++trial) {
        const auto p = random_parameters<M>(generator);
        const auto q = random_unknowns<M>(generator);
        const auto f = equations<M>(q, p);
        for (int i = 0; i < n; ++i) {
            const auto mass_from = [&](int k) {
                double sum = 0;
                for (int j = k; j < n; ++j) sum += p[M::mass + j];
                return sum;
            };
            double moment = 0;
            for (int j = 0; j < n; ++j) moment += mass_from(std::max(i, j)) * p[M::length + j] * std::sin(q[j]);
            const double w = p[M::omega];
            const double seed = moment * std::cos(q[i]) * w * w - mass_from(i) * std::sin(q[i]) * p[M::gravity];
            CHECK(f[i] == Approx(-p[M::length + i] * seed).margin(1e-13));
        }
    }
}

TEST_CASE("two links in normal form are the chain of two, divided by the mass and in units of l_1 and g") {
    Generator generator(4);
    for (int trial = 0; trial < 10; ++trial) {
        const double alpha = uniform(generator), r = uniform(generator, 0.5, 2), w = uniform(generator, 0.2, 3);
        const Unknowns<mechanisms::TwoLinkChain> q{{uniform(generator, -3, 3), uniform(generator, -3, 3)}};
        const double mass = 2.7;
        const double v = potential<mechanisms::TwoLinkChain>(q, {{alpha, r, w}});
        const double full = potential<RotatingChain<2>>(q, {{1, r, (1 - alpha) * mass, alpha * mass, w, 1}});
        CHECK(full == Approx(mass * v));
    }
}

TEST_CASE("a chain at rest that hangs or stands: the Hessian is diagonal, and its index counts the links that stand") {
    using M = RotatingChain<3>;
    const Parameters<M> p{{1.2, 0.7, 1.9, 0.4, 0.8, 0.3, 0.0, 1.0}};
    for (int signs = 0; signs < 8; ++signs) {
        Unknowns<M> q;
        for (int i = 0; i < 3; ++i) q[i] = signs >> i & 1 ? std::acos(-1.0) : 0;
        const UnknownMatrix<M> hessian = jacobian<M>(q, p);
        const double mass[3] = {1.5, 1.1, 0.3};
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
                const double expected = r == c ? (signs >> r & 1 ? -1 : 1) * mass[r] * p[M::length + r] : 0;
                CHECK(hessian(r, c) == Approx(expected).margin(1e-15));
            }
    }
}

TEST_CASE("closed forms: pendulum and elastic pendulum") {
    using M = models::Pendulum;
    const Unknowns<M> q{{0.6}}, v{{1.0}};
    const Parameters<M> p{{0.25}};
    CHECK(equations<M>(q, p)[0] == std::sin(0.6) - 0.25);
    CHECK(jacobian<M>(q, p)(0, 0) == Approx(std::cos(0.6)));
    CHECK(parameter_derivative<M>(q, p, 0)[0] == -1);
    CHECK(jacobian_derivative<M>(q, v, p)(0, 0) == Approx(-std::sin(0.6)));
    CHECK(directional_derivative<3, M>(q, v, p)[0] == Approx(-std::cos(0.6)));

    using E = models::ElasticPendulum;
    const double k = 1.3, g = 0.9, t = 0.4, x = 1.7;
    const UnknownMatrix<E> hessian = jacobian<E>({{t, x}}, {{k, g}});
    CHECK(hessian(0, 0) == Approx(g * x * std::cos(t)));
    CHECK(hessian(0, 1) == Approx(g * std::sin(t)));
    CHECK(hessian(1, 1) == Approx(k));
}

TEST_CASE("the holonomic mechanism's Hessians at F = 100 N") {
    using M = models::TwoAngleMechanism;
    const auto p = M::paper_parameters(100);
    const double q[4][2] = {{0.779776976161, -2.95917510938},
                            {1.46544020854, -0.25630918245},
                            {-1.42175799139, -2.54488196512},
                            {-2.356470734, 1.38609618224}};
    const double hessian[4][3] = {{111.015023, -208.316925, -306.190210},
                                  {576.559034, 237.480771, 387.748384},
                                  {-119.041762, 186.514422, 155.355659},
                                  {-529.600658, -209.497384, -309.858695}};
    for (int e = 0; e < 4; ++e) {
        const Unknowns<M> at{{q[e][0], q[e][1]}};
        for (double f : equations<M>(at, p)) CHECK(std::abs(f) < 1e-7);
        const UnknownMatrix<M> j = jacobian<M>(at, p);
        CHECK(j(0, 0) == Approx(hessian[e][0]).epsilon(1e-8));
        CHECK(j(0, 1) == Approx(hessian[e][1]).epsilon(1e-8));
        CHECK(j(1, 1) == Approx(hessian[e][2]).epsilon(1e-8));
    }
}

TEST_CASE("other scalars: long double, complex, lanes") {
    using M = RotatingChain<3>;
    Generator generator(5);
    const auto p = random_parameters<M>(generator);
    const auto q = random_unknowns<M>(generator);
    SECTION("long double keeps its digits") {
        Unknowns<M, long double> wide_q;
        Parameters<M, long double> wide_p;
        for (int i = 0; i < 3; ++i) wide_q[i] = q[i];
        for (int k = 0; k < p.size(); ++k) wide_p[k] = std::sqrt(static_cast<long double>(p[k]));
        const auto f = equations<M, long double>(wide_q, wide_p);
        for (int i = 0; i < 3; ++i) {
            long double moment = 0, mass = 0;
            for (int j = i; j < 3; ++j) mass += wide_p[M::mass + j];
            for (int j = 0; j < 3; ++j) {
                long double from = 0;
                for (int k = std::max(i, j); k < 3; ++k) from += wide_p[M::mass + k];
                moment += from * wide_p[M::length + j] * std::sin(wide_q[j]);
            }
            const long double w = wide_p[M::omega];
            const long double expected = wide_p[M::length + i] * (wide_p[M::gravity] * mass * std::sin(wide_q[i]) -
                                                                  w * w * std::cos(wide_q[i]) * moment);
            CHECK(std::abs(f[i] - expected) < 1e-17L);
        }
    }
    SECTION("complex unknowns: Cauchy-Riemann, the derivative along i v is i times that along v") {
        using Z = std::complex<double>;
        Unknowns<M, Z> zq, v, iv;
        Parameters<M, Z> zp;
        for (int i = 0; i < 3; ++i) zq[i] = {q[i], 0.3 * i}, v[i] = {1.0 + i, -0.5}, iv[i] = Z(0, 1) * v[i];
        for (int k = 0; k < p.size(); ++k) zp[k] = p[k];
        const auto along = directional_derivative<1, M, Z>(zq, v, zp),
                   across = directional_derivative<1, M, Z>(zq, iv, zp);
        for (int i = 0; i < 3; ++i) CHECK(std::abs(across[i] - Z(0, 1) * along[i]) < 1e-12);
    }
    SECTION("one lane is what one scalar gives, constants and phases of the model included") {
        using E = models::Everything;
        using R = Lanes<native_lanes>;
        const Parameters<E> ep{{0.7, 0.4, 1.1}};
        detail::AnglesOf<E, Complex<R>> theta;
        detail::CoordinatesOf<E, Complex<R>> x;
        Unknowns<E> at[native_lanes];
        for (int k = 0; k < native_lanes; ++k) {
            at[k] = random_unknowns<E>(generator);
            for (int i = 0; i < 2; ++i) {
                set_lane(theta[i].c, k, std::cos(at[k][i]));
                set_lane(theta[i].s, k, std::sin(at[k][i]));
            }
            set_lane(x[0], k, at[k][2]);
        }
        const auto f = detail::equations_at<E, Complex<R>>(theta, x, ep);
        for (int k = 0; k < native_lanes; ++k) {
            const auto expected = equations<E>(at[k], ep);
            for (int i = 0; i < 3; ++i)
                CHECK(std::abs(lane(f[i], k) - expected[i]) < 1e-12 * (1 + std::abs(expected[i])));
        }
    }
}
