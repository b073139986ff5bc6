// The reduced potential as a power series: the equations that define it, the closed formulas of the third and fourth
// derivative, and normal forms in other coordinates.
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/symmetric_eigen.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/singularity/reduced_series.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

constexpr int order = 6;

/// Two angles and a coordinate, of no special kind; `balance` are forces and `stiffness` the entries of a symmetric
/// matrix by which 0 is made a degenerate equilibrium.
struct Generic {
    static constexpr int n_angles = 2, n_coordinates = 1;
    static constexpr int balance = 0, stiffness = 3, other = 9, n_parameters = 15;
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        const auto a = sin(theta[0]), b = sin(theta[1]);
        const auto linear = p[balance] * a + p[balance + 1] * b + p[balance + 2] * x[0];
        const auto square = p[stiffness] * a * a + p[stiffness + 1] * b * b + p[stiffness + 2] * x[0] * x[0] +
                            2 * (p[stiffness + 3] * a * b + p[stiffness + 4] * a * x[0] + p[stiffness + 5] * b * x[0]);
        return linear + 0.5 * square + p[other] * cos(theta[0] + 2 * theta[1]) + p[other + 1] * sin(3 * theta[0]) +
               p[other + 2] * x[0] * x[0] * sin(theta[0] - theta[1]) + p[other + 3] * pow(x[0], 3) +
               p[other + 4] * a * b * x[0] + p[other + 5] * pow(x[0], 4) * cos(theta[1]);
    }
};

/// A polynomial in u plus w^2 / 2, u and w being functions of the angles with a regular Jacobian at 0.
struct PulledBack {
    static constexpr int n_angles = 2;
    enum Parameter { power_3, power_4, power_5, power_6, power_7, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = sin(theta[0]) - 0.3 * sin(theta[1]) + 0.4 * (1 - cos(theta[0]));
        const auto w = 0.8 * sin(theta[1]) + 0.5 * sin(theta[0]) * sin(theta[0]) - 0.2 * u * u * u;
        return p[power_3] * pow(u, 3) + p[power_4] * pow(u, 4) + p[power_5] * pow(u, 5) + p[power_6] * pow(u, 6) +
               p[power_7] * pow(u, 7) + 0.5 * w * w;
    }
};

/// The unit eigenvector of the eigenvalue of least size.
template <class M>
Unknowns<M> weakest(const Unknowns<M>& q, const Parameters<M>& p) {
    const SymmetricEigen<UnknownMatrix<M>> eigen(jacobian<M, double>(q, p));
    Eigen::Index least = 0;
    eigen.values.cwiseAbs().minCoeff(&least);
    Unknowns<M> v;
    for (int i = 0; i < v.size(); ++i) v[i] = eigen.vectors(i, least);
    return v;
}

}  // namespace

TEST_CASE("F along the series is g l, to the order of the series") {
    Generator generator(1);
    for (int trial = 0; trial < 20; ++trial) {
        Unknowns<Generic> q, l;
        Parameters<Generic> p;
        double square = 0;
        for (double& x : q) x = uniform(generator, -1, 1);
        for (double& x : l) x = uniform(generator, -1, 1), square += x * x;
        for (double& x : l) x /= std::sqrt(square);
        for (double& x : p) x = uniform(generator, -1, 1);
        const auto series = reduced_series<Generic, order>(q, l, p);
        REQUIRE(series.regular);
        using T = Taylor<double, order>;
        Unknowns<Generic, T> curve;
        Parameters<Generic, T> constant;
        for (int k = 0; k < p.size(); ++k) constant[k] = p[k];
        double size = 1;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k <= order; ++k)
                size = std::max(size, std::abs(curve[i].coefficient[k] = series.curve[k][i]));
        const auto f = equations<Generic, T>(curve, constant);
        const T v = potential<Generic, T>(curve, constant);
        for (int k = 0; k <= order; ++k) {
            double along = 0, across = 0;
            for (int i = 0; i < 3; ++i) {
                along += l[i] * series.curve[k][i];
                across = std::max(across, std::abs(f[i].coefficient[k] - series.gradient[k] * l[i]));
            }
            if (k == 0) continue;
            CHECK(std::abs(along - (k == 1)) < 1e-12 * size);
            CHECK(across < 1e-12 * std::pow(size, 4) * (1 + std::abs(series.gradient[k])));
        }
        // g = d phi / d xi, of the potential without the constant force across l
        T rest = v;
        for (int i = 0; i < 3; ++i) rest -= (series.force[i] - series.gradient[0] * l[i]) * curve[i];
        for (int k = 1; k <= order; ++k)
            CHECK(std::abs(k * rest.coefficient[k] - series.gradient[k - 1]) < 1e-12 * std::pow(size, 4));
    }
}

TEST_CASE("third and fourth derivatives are those of the closed formulas, at random degenerate equilibria") {
    Generator generator(2);
    for (int trial = 0; trial < 30; ++trial) {
        Parameters<Generic> p;
        for (double& x : p) x = uniform(generator, -1, 1);
        const Unknowns<Generic> q{0, 0, 0};
        const auto f = equations<Generic>(q, p);
        for (int i = 0; i < 3; ++i) p[Generic::balance + i] -= f[i];
        const SymmetricEigen<UnknownMatrix<Generic>> eigen(jacobian<Generic, double>(q, p));
        // takes the eigenvalue number 0 off
        const auto v = eigen.vectors.col(0);
        const double value = eigen.values(0);
        for (int i = 0; i < 3; ++i) p[Generic::stiffness + i] -= value * v(i) * v(i);
        p[Generic::stiffness + 3] -= value * v(0) * v(1);
        p[Generic::stiffness + 4] -= value * v(0) * v(2);
        p[Generic::stiffness + 5] -= value * v(1) * v(2);
        const Unknowns<Generic> null{v(0), v(1), v(2)};

        const auto series = reduced_series<Generic, order>(q, null, p);
        const auto formula = reduced_coefficients<Generic>(q, null, p);
        REQUIRE(series.regular);
        CHECK(std::abs(series.gradient[0]) < 1e-14);
        CHECK(std::abs(series.gradient[1]) < 1e-13);
        CHECK(series.derivative(3) == Approx(formula.third).epsilon(1e-10).margin(1e-12));
        CHECK(series.derivative(4) == Approx(formula.fourth).epsilon(1e-8).margin(1e-12));
        // the other sign of the null vector: xi -> -xi
        const auto back = reduced_series<Generic, order>(q, {-v(0), -v(1), -v(2)}, p);
        for (int k = 1; k <= order + 1; ++k) {
            const double mirrored = (k % 2 == 0 ? 1 : -1) * series.derivative(k);
            CHECK(back.derivative(k) == Approx(mirrored).epsilon(1e-9).margin(1e-12));
        }
    }
}

TEST_CASE("the first derivative that is not 0 is that of the normal form, in any coordinates and with any border") {
    using M = PulledBack;
    Generator generator(3);
    const Unknowns<M> q{0, 0};
    for (int first = 3; first <= 7; ++first)
        for (int trial = 0; trial < 5; ++trial) {
            Parameters<M> p;
            for (int k = first; k <= 7; ++k) p[k - 3] = uniform(generator, 0.5, 1.5);
            const auto v = weakest<M>(q, p);
            const auto series = reduced_series<M, order>(q, v, p);
            REQUIRE(series.regular);
            CAPTURE(first);
            for (int k = 1; k < first; ++k) CHECK(std::abs(series.derivative(k)) < 1e-12);
            // u = c xi + ... along the null vector
            const double slope = v[0] - 0.3 * v[1];
            double factorial = 1;
            for (int k = 2; k <= first; ++k) factorial *= k;
            CHECK(series.derivative(first) == Approx(factorial * p[first - 3] * std::pow(slope, first)).epsilon(1e-11));
            // another border: xi measured along l, which the null vector has l . v of
            const double turn = uniform(generator, -0.8, 0.8);
            const Unknowns<M> l{v[0] * std::cos(turn) - v[1] * std::sin(turn),
                                v[0] * std::sin(turn) + v[1] * std::cos(turn)};
            const auto other = reduced_series<M, order>(q, l, p);
            for (int k = 1; k < first; ++k) CHECK(std::abs(other.derivative(k)) < 1e-10);
            CHECK(other.derivative(first) ==
                  Approx(series.derivative(first) / std::pow(std::cos(turn), first)).epsilon(1e-9));
            for (int i = 0; i < 2; ++i) CHECK(other.curve[1][i] == Approx(v[i] / std::cos(turn)).margin(1e-12));
        }
}

TEST_CASE("series over duals have the derivatives of the coefficients, and multiprecision all its digits") {
    using M = PulledBack;
    using D = Dual<double, Jet<double>::directions>;
    const Unknowns<M> q{0.2, -0.1}, l{0.8, 0.6};
    const Parameters<M> p{0.3, 0.5, -0.4, 0.2, 0.7};
    const auto at = [&](double q0, double q1, double p0) {
        Unknowns<M> moved{q0, q1};
        Parameters<M> other = p;
        other[0] = p0;
        return reduced_series<M, 4>(moved, l, other);
    };
    RuntimeArray<D> lifted(2), border(2), parameters(p.size());
    for (int i = 0; i < 2; ++i) lifted[i] = D::variable(q[i], i), border[i] = l[i];
    for (int k = 0; k < p.size(); ++k) parameters[k] = p[k];
    parameters[0].derivative[2] = 1;
    const auto series = reduced_series(functions_of<M>(), 4, lifted, border, border, parameters);
    const double h = 1e-5;
    for (int k = 0; k <= 4; ++k) {
        CAPTURE(k);
        const double size = 1 + std::abs(series.gradient[k].value);
        CHECK(series.gradient[k].value == Approx(at(q[0], q[1], p[0]).gradient[k]).margin(1e-12));
        const double by_q0 = (at(q[0] + h, q[1], p[0]).gradient[k] - at(q[0] - h, q[1], p[0]).gradient[k]) / (2 * h);
        const double by_q1 = (at(q[0], q[1] + h, p[0]).gradient[k] - at(q[0], q[1] - h, p[0]).gradient[k]) / (2 * h);
        const double by_p0 = (at(q[0], q[1], p[0] + h).gradient[k] - at(q[0], q[1], p[0] - h).gradient[k]) / (2 * h);
        CHECK(series.gradient[k].derivative[0] == Approx(by_q0).epsilon(1e-5).margin(1e-5 * size));
        CHECK(series.gradient[k].derivative[1] == Approx(by_q1).epsilon(1e-5).margin(1e-5 * size));
        CHECK(series.gradient[k].derivative[2] == Approx(by_p0).epsilon(1e-5).margin(1e-5 * size));
    }

    using F = Multiprecision<40>;
    const Parameters<M, F> butterfly{F(0), F(0), F(0), F(1), F(1)};
    const F root = sqrt(F(0.3) * F(0.3) + 1);
    const auto precise = reduced_series<M, order, F>({F(0), F(0)}, {1 / root, F(0)}, butterfly);
    for (int k = 0; k <= 4; ++k) CHECK(abs(precise.gradient[k]) < F(1e-38));
}

TEST_CASE("two null vectors: the border is singular, and it is said") {
    const auto series = reduced_series<Generic, 3>({0, 0, 0}, {1, 0, 0}, {});
    CHECK_FALSE(series.regular);
}
