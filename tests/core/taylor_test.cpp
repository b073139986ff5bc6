// Power series against Taylor's theorem: identities between functions hold coefficient by coefficient, and the
// coefficients are the derivatives that nested duals give.
#include <cmath>

#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/taylor.hpp>
#include <equilibria/model/derivatives.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

constexpr int order = 6;
using T = Taylor<double, order>;

T random_series(Generator& generator, double low = 0.3) {
    T y(uniform(generator, low, 1.5));
    for (int k = 1; k <= order; ++k) y.coefficient[k] = uniform(generator, -1, 1);
    return y;
}

void check_equal(const T& a, const T& b) {
    for (int k = 0; k <= order; ++k) {
        CAPTURE(k);
        CHECK(std::abs(a.coefficient[k] - b.coefficient[k]) < 1e-11 * (1 + std::abs(b.coefficient[k])));
    }
}

}  // namespace

TEST_CASE("the laws of the elementary functions hold for each coefficient") {
    Generator generator(1);
    for (int trial = 0; trial < 50; ++trial) {
        const T a = random_series(generator), b = random_series(generator), one(1);
        check_equal(a * b / b, a);
        check_equal((a + b) * (a - b), a * a - b * b);
        check_equal(sin(a) * sin(a) + cos(a) * cos(a), one);
        check_equal(sin(a + b), sin(a) * cos(b) + cos(a) * sin(b));
        check_equal(exp(a + b), exp(a) * exp(b));
        check_equal(log(exp(a)), a);
        check_equal(log(a * b), log(a) + log(b));
        check_equal(sqrt(a) * sqrt(a), a);
        check_equal(pow(a, 3), a * a * a);
        check_equal(pow(a, -2) * a * a, one);
        check_equal(pow(a, 0), one);
        check_equal(pow(a, 2u), a * a);
        check_equal(pow(a, 0.5), sqrt(a));
        check_equal(pow(a, 1.7), exp(1.7 * log(a)));
        check_equal(pow(a, 2.0f), a * a);
        check_equal(1 / a, pow(a, -1));
        check_equal(2 * a - a * 3 + a / 4, a * (2 - 3 + 0.25));
        check_equal(1 - a + 0.5f, -(a - 1.5));
        T c = a;
        c += b, c -= 1, c *= a, c /= b;
        check_equal(c, (a + b - 1) * a / b);
        CHECK(a == a);
        CHECK_FALSE(a == a + T::variable(0));
    }
}

TEST_CASE("coefficients are those of the known series") {
    const T t = T::variable(0.0);
    double factorial = 1;
    for (int k = 0; k <= order; ++k) {
        if (k > 0) factorial *= k;
        CHECK(exp(t).coefficient[k] == Approx(1 / factorial));
        const double sign = k / 2 % 2 == 0 ? 1 : -1;
        CHECK(sin(t).coefficient[k] == Approx(k % 2 == 1 ? sign / factorial : 0).margin(1e-18));
        CHECK(cos(t).coefficient[k] == Approx(k % 2 == 0 ? sign / factorial : 0).margin(1e-18));
        CHECK((1 / (1 - t)).coefficient[k] == Approx(1));
        CHECK(log(1 + 2 * t).coefficient[k] == Approx(k == 0 ? 0 : -std::pow(-2, k) / k).margin(1e-18));
    }
}

TEST_CASE("series in constant expressions") {
    constexpr Taylor<double, 3> f = [] {
        const auto t = Taylor<double, 3>::variable(2);
        return pow(t, 3) - 1 / (t - 1) + t / 2;
    }();
    STATIC_REQUIRE(f.coefficient[0] == 8);
    STATIC_REQUIRE(f.coefficient[1] == 13.5);
    STATIC_REQUIRE(f.coefficient[2] == 5);
    STATIC_REQUIRE(f.coefficient[3] == 2);
}

TEST_CASE("a model's equations along a line: the series has the nested duals' derivatives") {
    using M = models::Everything;
    using S = Taylor<double, 3>;
    Generator generator(2);
    for (int trial = 0; trial < 10; ++trial) {
        Unknowns<M> q, v;
        Parameters<M> p, w;
        for (int i = 0; i < 3; ++i) {
            q[i] = uniform(generator, -1, 1), v[i] = uniform(generator, -1, 1);
            p[i] = uniform(generator, 0.5, 1.5), w[i] = uniform(generator, -1, 1);
        }
        Unknowns<M, S> line;
        Parameters<M, S> parameters;
        for (int i = 0; i < 3; ++i) line[i] = S::variable(q[i], v[i]), parameters[i] = S::variable(p[i], w[i]);
        const auto f = equations<M, S>(line, parameters);
        const auto first = directional_derivative<1, M>(q, v, p, w);
        const auto second = directional_derivative<2, M>(q, v, p, w);
        const auto third = directional_derivative<3, M>(q, v, p, w);
        for (int i = 0; i < 3; ++i) {
            CHECK(f[i].coefficient[0] == Approx(equations<M>(q, p)[i]).epsilon(1e-12));
            CHECK(f[i].coefficient[1] == Approx(first[i]).epsilon(1e-11).margin(1e-12));
            CHECK(2 * f[i].coefficient[2] == Approx(second[i]).epsilon(1e-11).margin(1e-12));
            CHECK(6 * f[i].coefficient[3] == Approx(third[i]).epsilon(1e-11).margin(1e-12));
        }
    }
}

TEST_CASE("series over duals have the derivatives of the coefficients") {
    using D = Dual<double, 2>;
    using S = Taylor<D, 4>;
    const auto f = [](const auto& t, const auto& a, const auto& b) {
        return sin(a * t) / (b + t) + sqrt(b + exp(t)) - 2 * pow(t, 2) * log(a + 3);
    };
    const double a = 0.8, b = 1.3, h = 1e-6;
    const S series = f(S::variable(D(0.2)), D::variable(a, 0), S(D::variable(b, 1)));
    const auto plain = [&](double x, double y) {
        return f(Taylor<double, 4>::variable(0.2), Taylor<double, 4>(x), Taylor<double, 4>(y));
    };
    for (int k = 0; k <= 4; ++k) {
        CHECK(series.coefficient[k].value == Approx(plain(a, b).coefficient[k]).epsilon(1e-13));
        CHECK(series.coefficient[k].derivative[0] ==
              Approx((plain(a + h, b).coefficient[k] - plain(a - h, b).coefficient[k]) / (2 * h)).margin(1e-8));
        CHECK(series.coefficient[k].derivative[1] ==
              Approx((plain(a, b + h).coefficient[k] - plain(a, b - h).coefficient[k]) / (2 * h)).margin(1e-8));
    }
}

TEST_CASE("series of multiprecision floats have all their digits") {
    using F = Multiprecision<40>;
    using S = Taylor<F, 4>;
    const S a = S::variable(F(1) / 3, F(2) / 7);
    const S zero = sin(a) * sin(a) + cos(a) * cos(a) - 1, same = log(exp(a) * sqrt(a * a)) - log(a) - a;
    for (int k = 0; k <= 4; ++k) {
        CHECK(abs(zero.coefficient[k]) < F(1e-38));
        CHECK(abs(same.coefficient[k]) < F(1e-37));
    }
    // and over duals
    using D = Dual<F, 1>;
    const auto wide = Taylor<D, 4>::variable(D::variable(F(1) / 3, 0), D(F(2) / 7));
    const auto f = sin(wide) / 3, g = log(wide), h = pow(wide, 3) / 7;
    const S f0 = sin(a) / 3, g0 = log(a), h0 = pow(a, 3) / 7;
    for (int k = 0; k <= 4; ++k) {
        CHECK(abs(f.coefficient[k].value - f0.coefficient[k]) < F(1e-37));
        CHECK(abs(g.coefficient[k].value - g0.coefficient[k]) < F(1e-37));
        CHECK(abs(h.coefficient[k].value - h0.coefficient[k]) < F(1e-37));
    }
}
