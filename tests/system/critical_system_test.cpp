// The critical and the symmetric system, polynomials at run time, against the model's own function and its derivatives.
#include <cmath>
#include <complex>

#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/symmetric_system.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// The value of a polynomial at angles and coordinates.
double value(const RuntimePolynomial<>& f, const RuntimeSizes& sizes, const RuntimeArray<double>& q) {
    double sum = 0;
    for (const auto& t : f.terms()) {
        double term = t.coefficient;
        const auto codes = codes_of(t.monomial, sizes);
        for (int u = 0; u < sizes.unknowns; ++u) {
            const int code = codes[static_cast<std::size_t>(u)];
            if (u >= sizes.angles)
                term *= std::pow(q[u], code);
            else if (code != 0)
                term *= code > 0 ? std::cos(code * q[u]) : std::sin(-code * q[u]);
        }
        sum += term;
    }
    return sum;
}

Eigen::VectorXd combined(const RuntimeMatrix<double>& basis, const Array<double, 8>& w) {
    const int n = basis.size();
    Eigen::VectorXd v(n);
    for (int i = 0; i < n; ++i) {
        v(i) = basis[i][0];
        for (int k = 1; k < n; ++k) v(i) += basis[i][k] * w[k - 1];
    }
    return v;
}

}  // namespace

TEST_CASE("the equations of the critical system are F, J v and the last one, over what was divided out") {
    using M = mechanisms::TwoLinkChain;
    constexpr int n = 2;
    constexpr int active[] = {M::alpha, M::omega};
    const CriticalSystem critical(polynomials_of<M>(), active);
    CHECK(critical.grouping() == std::vector{0, 0, 1, 2, 3, 4});
    Generator generator(3);
    for (int round = 0; round < 5; ++round) {
        Parameters<M> p{0, uniform(generator, 1.1, 2), 0};
        const double alpha_scale = uniform(generator, 0.5, 2), omega_scale = uniform(generator, 0.5, 4);
        const std::vector<double> scales{alpha_scale, omega_scale};
        auto numbers = critical.numbers(runtime_array(p), scales, generator);
        for (double& s : numbers.slice) s = uniform(generator, -1, 1);
        for (double& e : numbers.extremal) e = uniform(generator, -1, 1);
        numbers.cusp = uniform(generator, -1, 1);

        RuntimeArray<double> q(critical.sizes().unknowns);
        Array<double, 8> w{uniform(generator, -1, 1)};
        Unknowns<M> theta{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        p[M::alpha] = uniform(generator, 0.1, 0.9);
        p[M::omega] = uniform(generator, 0.5, 4);
        const Array<double, 2> x{critical.unknown(0, p[M::alpha], scales[0]),
                                 critical.unknown(1, p[M::omega], scales[1])};
        CHECK(critical.parameter(1, x[1], scales[1]) == Approx(p[M::omega]));
        q[0] = theta[0], q[1] = theta[1], q[2] = w[0], q[3] = x[0], q[4] = x[1];
        double sines = 0;
        for (int i = 0; i < n; ++i) sines += numbers.sine[i] * std::sin(theta[i]);
        q[5] = 1 / sines;

        const auto f = equations<M, double>(theta, p);
        const Eigen::Matrix2d j = jacobian<M, double>(theta, p);
        const Eigen::VectorXd v = combined(numbers.basis, w), jv = j * v;
        Unknowns<M> along;
        for (int i = 0; i < n; ++i) along[i] = v(i);
        const Eigen::Matrix2d third = jacobian_derivative<M, double>(theta, along, p);
        double last =
            numbers.slice[2] + numbers.slice[0] * x[0] + numbers.slice[1] * x[1] + numbers.cusp * v.dot(third * v);
        for (int k = 0; k < 2; ++k) {
            // dp/dx: p = scale x, or scale sqrt(x)
            const double slope = critical.entry().power[k] == 1 ? scales[k] : scales[k] / (2 * std::sqrt(x[k]));
            const auto by = parameter_derivative<M, double>(theta, p, active[k]);
            for (int i = 0; i < n; ++i) last += numbers.extremal[k] * slope * by[i] * v(i);
        }
        const auto polynomials = critical.equations(numbers);
        REQUIRE(polynomials.size() == 6);
        const auto divisor = [&](int i) {
            double y = 1;
            for (int k = 0; k < 2; ++k) y *= std::pow(x[k], critical.entry().content[i][k]);
            return y;
        };
        for (std::size_t i = 0; i < 2; ++i) {
            const int row = static_cast<int>(i);
            CHECK(value(polynomials[i], critical.sizes(), q) * divisor(row) == Approx(f[row]).margin(1e-12));
            CHECK(value(polynomials[2 + i], critical.sizes(), q) * divisor(row) == Approx(jv(row)).margin(1e-12));
        }
        CHECK(value(polynomials[4], critical.sizes(), q) == Approx(last).margin(1e-11));
        CHECK(value(polynomials[5], critical.sizes(), q) == Approx(0).margin(1e-12));
    }
}

TEST_CASE("the symmetric system is J v on the branch, and the last one from differences") {
    using M = mechanisms::TwoLinkChain;
    constexpr int active[] = {M::alpha, M::omega};
    const CriticalSystem plane(polynomials_of<M>(), active);
    const SymmetricSystem symmetric(plane);
    Generator generator(4);
    for (const Unknowns<M>& branch :
         {Unknowns<M>{0, 0}, Unknowns<M>{std::numbers::pi, 0}, Unknowns<M>{0, std::numbers::pi}}) {
        Parameters<M> p{0, 1.5, 0};
        const std::vector<double> scales{1.3, 2.1};
        auto numbers = symmetric.numbers(runtime_array(p), scales, runtime_array(branch), generator);
        numbers.fourth = 0.7;
        const Array<double, 8> w{uniform(generator, -1, 1)};
        p[M::alpha] = uniform(generator, 0.1, 0.9);
        p[M::omega] = uniform(generator, 0.5, 3);
        const RuntimeArray<double> q{w[0], plane.unknown(0, p[M::alpha], scales[0]),
                                     plane.unknown(1, p[M::omega], scales[1])};
        const Eigen::VectorXd v = combined(numbers.plane.basis, w);
        const Eigen::VectorXd jv = jacobian<M, double>(branch, p) * v;
        const auto polynomials = symmetric.equations(numbers);
        for (std::size_t i = 0; i < 2; ++i) {
            double divisor = 1;
            for (int k = 0; k < 2; ++k)
                divisor *= std::pow(q[1 + k], plane.entry().content[i][static_cast<std::size_t>(k)]);
            CHECK(value(polynomials[i], symmetric.sizes(), q) * divisor ==
                  Approx(jv(static_cast<int>(i))).margin(1e-12));
        }
        // V''''[v, v, v, v] by the second difference of v . J v along v
        const auto curvature = [&](double h) {
            Unknowns<M> at = branch;
            for (int i = 0; i < 2; ++i) at[i] += h * v(i);
            return v.dot(jacobian<M, double>(at, p) * v);
        };
        const double h = 1e-3, fourth = (curvature(h) - 2 * curvature(0) + curvature(-h)) / (h * h);
        CHECK(value(polynomials[2], symmetric.sizes(), q) == Approx(0.7 * fourth).epsilon(1e-5));
    }
}
