#include <cmath>
#include <complex>
#include <limits>

#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Polynomial = TrigonometricPolynomial<2, 1>;
using Basis = Polynomial::Basis;
using Point = Array<double, 3>;

double value(const Polynomial& f, const Point& q) {
    double sum = 0;
    for (const auto& t : f.terms()) {
        double product = t.coefficient;
        for (int u = 0; u < 3; ++u) {
            const int k = t.monomial.code(u);
            if (u == 2)
                product *= std::pow(q[u], k);
            else
                product *= k >= 0 ? std::cos(k * q[u]) : std::sin(-k * q[u]);
        }
        sum += product;
    }
    return sum;
}

/// Six random terms with multiples and powers up to 3.
Polynomial random_polynomial(Generator& generator) {
    Polynomial f;
    for (int k = 0; k < 6; ++k) {
        Basis m;
        for (int u = 0; u < 3; ++u) m.set_code(u, static_cast<int>(uniform(generator, u == 2 ? 0 : -3, 3.999)));
        f += Polynomial(m, uniform(generator, -1, 1));
    }
    return f;
}
Point random_point(Generator& generator) {
    return {{uniform(generator, -3, 3), uniform(generator, -3, 3), uniform(generator, -1.5, 1.5)}};
}

/// The largest difference of coefficients: products of cosines and sines are linearly independent.
double distance(const Polynomial& a, const Polynomial& b) { return (a - b).scale(); }

Polynomial harmonic(int unknown, int code) { return {Basis::single(unknown, code), 1.0}; }

}  // namespace

TEST_CASE("sums, differences and products are those of the functions") {
    Generator generator(1);
    for (int trial = 0; trial < 50; ++trial) {
        const auto a = random_polynomial(generator), b = random_polynomial(generator);
        const auto q = random_point(generator);
        CHECK(value(a + b, q) == Approx(value(a, q) + value(b, q)).margin(1e-13));
        CHECK(value(a - b, q) == Approx(value(a, q) - value(b, q)).margin(1e-13));
        CHECK(value(a * b, q) == Approx(value(a, q) * value(b, q)).margin(1e-12));
        CHECK(value(-a, q) == -value(a, q));
        CHECK(value(a / 4, q) == Approx(value(a, q) / 4).margin(1e-14));
        CHECK(value(3 * a + 0.5, q) == Approx(3 * value(a, q) + 0.5).margin(1e-13));
        CHECK(value(pow(a, 3), q) == Approx(std::pow(value(a, q), 3)).margin(1e-11));
    }
}

TEST_CASE("the laws of a commutative ring hold coefficient by coefficient") {
    Generator generator(2);
    for (int trial = 0; trial < 20; ++trial) {
        const auto a = random_polynomial(generator), b = random_polynomial(generator), c = random_polynomial(generator);
        CHECK(distance(a * b, b * a) < 1e-15);
        CHECK(distance((a * b) * c, a * (b * c)) < 1e-14);
        CHECK(distance(a * (b + c), a * b + a * c) < 1e-14);
        CHECK((a - a).terms().empty());
        CHECK((a * 0).terms().empty());
        CHECK(distance(a * 1, a) == 0);
        CHECK(distance(a + 0, a) == 0);
    }
}

TEST_CASE("one function has one form") {
    const auto c = harmonic(0, 1), s = harmonic(0, -1), c2 = harmonic(1, 1), s2 = harmonic(1, -1);
    CHECK(distance(c * c + s * s, 1) == 0);
    CHECK((c * c + s * s).is_constant());
    CHECK(distance(2 * s * c, harmonic(0, -2)) == 0);
    CHECK(distance(c * c - s * s, harmonic(0, 2)) == 0);
    CHECK(distance(4 * c * c * c - 3 * c, harmonic(0, 3)) == 0);
    CHECK(distance(3 * s - 4 * s * s * s, harmonic(0, -3)) < 1e-15);
    const auto cosine = c * c2 + s * s2, sine = s * c2 - c * s2;  // of theta_0 - theta_1
    CHECK(distance(cosine * cosine + sine * sine, 1) < 1e-15);
}

TEST_CASE("derivatives") {
    Generator generator(3);
    for (int trial = 0; trial < 20; ++trial) {
        const auto a = random_polynomial(generator), b = random_polynomial(generator);
        const auto q = random_point(generator);
        for (int u = 0; u < 3; ++u) {
            const auto d = derivative(a, u);
            Point right = q, left = q;
            const double h = 1e-5;
            right[u] += h, left[u] -= h;
            CHECK(value(d, q) == Approx((value(a, right) - value(a, left)) / (2 * h)).margin(1e-7));
            CHECK(distance(derivative(a + b, u), d + derivative(b, u)) < 1e-14);
            CHECK(distance(derivative(a * b, u), d * b + a * derivative(b, u)) < 1e-13);
            for (int v = 0; v < u; ++v) CHECK(distance(derivative(d, v), derivative(derivative(a, v), u)) < 1e-14);
        }
    }
    CHECK(derivative(Polynomial(2.5), 0).terms().empty());
}

TEST_CASE("functions of constants are constants, of anything else not polynomials") {
    const Polynomial constant(0.7), x = harmonic(2, 1), s = harmonic(0, -1);
    CHECK(sqrt(constant).constant() == std::sqrt(0.7));
    CHECK(exp(constant).constant() == std::exp(0.7));
    CHECK(log(constant).constant() == std::log(0.7));
    CHECK(sin(constant).constant() == std::sin(0.7));
    CHECK(cos(constant).constant() == std::cos(0.7));
    CHECK(pow(constant, 1.5).constant() == std::pow(0.7, 1.5));
    CHECK(pow(constant, -2).constant() == Approx(1 / 0.49));
    CHECK(distance(pow(x, 2.0), x * x) == 0);

    CHECK(sqrt(x).fault() == NotPolynomial::function_of_angle);
    CHECK(sin(s).fault() == NotPolynomial::function_of_angle);
    CHECK(pow(s, 0.5).fault() == NotPolynomial::function_of_angle);  // and not pow(s, 0)
    CHECK((1 / x).fault() == NotPolynomial::divisor_not_constant);
    CHECK(pow(x, -1).fault() == NotPolynomial::divisor_not_constant);
    CHECK((x / x).fault() == NotPolynomial::divisor_not_constant);
    CHECK((x / constant).fault() == NotPolynomial::no);
}

TEST_CASE("a fault stays") {
    const Polynomial x = harmonic(2, 1), bad = sqrt(x);
    for (const auto& f :
         {bad + x, x - bad, bad * x, bad * 0, bad / 2, -bad, pow(bad, 2), derivative(bad, 0), cos(bad), bad.pruned()})
        CHECK(f.fault() == NotPolynomial::function_of_angle);
    CHECK((bad + 1 / x).fault() == NotPolynomial::divisor_not_constant);
}

TEST_CASE("multiples and powers above 1000 do not wrap around") {
    CHECK(pow(harmonic(2, 1), 1000).fault() == NotPolynomial::no);
    CHECK(pow(harmonic(2, 1), 1001).fault() == NotPolynomial::degree_too_high);
    CHECK((harmonic(0, 900) * harmonic(0, 100)).fault() == NotPolynomial::no);
    CHECK((harmonic(0, 900) * harmonic(0, -101)).fault() == NotPolynomial::degree_too_high);
}

TEST_CASE("a coefficient that is not a number is kept, to be seen") {
    const Polynomial x = harmonic(2, 1), s = harmonic(0, -1);
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (const auto& f :
             {bad * x + x, bad * x - bad * x, (bad * x + s) * (x + s), (bad * x).pruned(), bad * x * x}) {
            int seen = 0;
            for (const auto& t : f.terms()) seen += !std::isfinite(t.coefficient);
            CHECK(seen > 0);
        }
}

TEST_CASE("wide coefficients keep small differences that doubles lose") {
    using Wide = TrigonometricPolynomial<1, 0, long double>;
    const Wide s(Wide::Basis::single(0, -1), 1.0L);
    const long double tiny = 1e-18L;
    const Wide difference = s * Wide(1 + tiny) - s;
    REQUIRE(difference.terms().size() == 1);
    CHECK(std::abs(difference.terms()[0].coefficient - tiny) < 1e-19L);
    CHECK(std::abs(sqrt(Wide(2.0L)).constant() - std::sqrt(2.0L)) == 0);
    CHECK(std::abs(sin(Wide(0.3L)).constant() - std::sin(0.3L)) == 0);

    using Complexes = TrigonometricPolynomial<1, 0, std::complex<double>>;
    const std::complex<double> z(0.3, -1.1);
    CHECK(std::abs(sqrt(Complexes(z)).constant() - std::sqrt(z)) < 1e-15);
}
