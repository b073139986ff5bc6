#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using mechanisms::RotatingChain;
using mechanisms::TwoLinkChain;

namespace {

struct FunctionsOfParameters {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return sqrt(p[0]) * cos(2 * theta[0] + p[0]) + pow(p[0], 1.5) * sin(theta[0]);
    }
};

template <class M>
Parameters<M> random_parameters(Generator& generator) {
    Parameters<M> p;
    for (double& value : p) value = uniform(generator, 0.3, 1.7);
    return p;
}

/// The polynomials at random complex points of the torus are the model's own equations there.
template <class M>
double largest_difference(Generator& generator) {
    const auto p = random_parameters<M>(generator);
    const auto system = polynomial_system<M>(p);
    double largest = 0;
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<std::complex<double>> point;
        detail::AnglesOf<M, Complex<double>> theta;
        detail::CoordinatesOf<M, Complex<double>> x;
        for (auto& t : theta) {
            const std::complex<double> angle(uniform(generator, -3, 3), uniform(generator, -1, 1));
            point.push_back(std::cos(angle)), point.push_back(std::sin(angle));
            t = {{std::cos(angle).real(), std::cos(angle).imag()}, {std::sin(angle).real(), std::sin(angle).imag()}};
        }
        for (auto& value : x) {
            point.emplace_back(uniform(generator, -2, 2), uniform(generator, -2, 2));
            value = {point.back().real(), point.back().imag()};
        }
        const auto polynomials = evaluate(system, point);
        const auto own = detail::equations_at<M, Complex<double>>(theta, x, p);
        for (std::size_t i = 0; i < polynomials.size(); ++i) {
            const int k = static_cast<int>(i);
            const std::complex<double> expected =
                k < n_unknowns<M> ? std::complex<double>(own[k].re, own[k].im) : std::complex<double>(0.0);
            largest = std::max(largest, std::abs(polynomials[i] - expected) / (1 + std::abs(expected)));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("the polynomials are the model's equations on the complex torus") {
    Generator generator(1);
    CHECK(largest_difference<TwoLinkChain>(generator) < 1e-13);
    CHECK(largest_difference<RotatingChain<4>>(generator) < 1e-13);
    CHECK(largest_difference<models::Pendulum>(generator) < 1e-13);
    CHECK(largest_difference<models::ElasticPendulum>(generator) < 1e-13);
    CHECK(largest_difference<models::CoupledAngles<3>>(generator) < 1e-13);
    CHECK(largest_difference<models::TwoAngleMechanism>(generator) < 1e-13);
    CHECK(largest_difference<models::Everything>(generator) < 1e-11);  // terms cancel off the real torus
}

TEST_CASE("the polynomials have the formulation's degrees, and a circle an angle") {
    Generator generator(2);
    const auto check = [&]<class M>(M) {
        const auto system = polynomial_system<M>(random_parameters<M>(generator));
        REQUIRE(system.variables.size() == static_cast<std::size_t>(2 * n_angles<M> + n_coordinates<M>));
        REQUIRE(system.equations.size() == system.variables.size());
        for (std::size_t i = 0; i < system.equations.size(); ++i)
            CHECK(degree(system.equations[i]) ==
                  (static_cast<int>(i) < n_unknowns<M> ? Formulation<M>::degrees[i] : 2));
    };
    check(RotatingChain<3>{});
    check(models::ElasticPendulum{});
    check(models::CoupledAngles<4>{});
    check(models::Everything{});
    CHECK(polynomial_system<models::Everything>({{1, 1, 1}}).variables ==
          std::vector<std::string>{"c1", "s1", "c2", "s2", "x1"});
}

TEST_CASE("the chain's polynomials are Baillieul's equations (3.2)") {
    // (3.2): (sin t1 + alpha r sin t2) cos t1 w^2 - sin t1 = 0, (sin t1 + r sin t2) cos t2 w^2 - sin t2 = 0; the
    // gradient is the first times -1, the second times -alpha r.
    const double alpha = 0.3, r = 1.5, w = 2.0;
    const auto system = polynomial_system<TwoLinkChain>({{alpha, r, w}});
    Generator generator(3);
    for (int trial = 0; trial < 10; ++trial) {
        const double t1 = uniform(generator, -3, 3), t2 = uniform(generator, -3, 3);
        const auto f = evaluate(system, std::vector{std::cos(t1), std::sin(t1), std::cos(t2), std::sin(t2)});
        const double first = (std::sin(t1) + alpha * r * std::sin(t2)) * std::cos(t1) * w * w - std::sin(t1);
        const double second = (std::sin(t1) + r * std::sin(t2)) * std::cos(t2) * w * w - std::sin(t2);
        CHECK(std::abs(f[0] + first) < 1e-14);
        CHECK(std::abs(f[1] + alpha * r * second) < 1e-14);
    }
}

TEST_CASE("the system vanishes at known roots") {
    SECTION("a chain that hangs or stands in all its links") {
        Generator generator(4);
        const auto system = polynomial_system<RotatingChain<3>>(random_parameters<RotatingChain<3>>(generator));
        for (int signs = 0; signs < 8; ++signs) {
            std::vector<double> point;
            for (int i = 0; i < 3; ++i) point.push_back(signs >> i & 1 ? -1 : 1), point.push_back(0);
            for (double f : evaluate(system, point)) CHECK(f == 0);
        }
    }
    SECTION("an elastic pendulum, at the four solutions of its quadratic equations") {
        const double k = 1.4, g = 2.1, c = -k / g;  // x = 0 there, and c = -k / g
        const auto system = polynomial_system<models::ElasticPendulum>({{k, g}});
        for (const auto& point : {std::vector{1.0, 0.0, 1 + g / k},
                                  {-1.0, 0.0, 1 - g / k},
                                  {c, std::sqrt(1 - c * c), 0.0},
                                  {c, -std::sqrt(1 - c * c), 0.0}})
            for (double f : evaluate(system, point)) CHECK(std::abs(f) < 1e-14);
    }
    SECTION("the holonomic mechanism at F = 100 N, the four real equilibria as given to 12 digits") {
        const auto system =
            polynomial_system<models::TwoAngleMechanism>(models::TwoAngleMechanism::paper_parameters(100));
        const double q[4][2] = {{0.779776976161, -2.95917510938},
                                {1.46544020854, -0.25630918245},
                                {-1.42175799139, -2.54488196512},
                                {-2.356470734, 1.38609618224}};
        for (const auto& e : q)
            for (double f :
                 evaluate(system, std::vector{std::cos(e[0]), std::sin(e[0]), std::cos(e[1]), std::sin(e[1])}))
                CHECK(std::abs(f) < 1e-7);  // stiffnesses of 1e3 times 1e-11 of an angle
    }
}

TEST_CASE("other coefficients: long double and complex") {
    using Wide = long double;
    const auto wide = polynomial_system<TwoLinkChain, Wide>({{0.3L, 1.5L, 2.0L}});
    const Wide t1 = 0.4L, t2 = -1.1L;
    const auto f = evaluate(wide, std::vector{std::cos(t1), std::sin(t1), std::cos(t2), std::sin(t2)});
    const auto own = equations<TwoLinkChain, Wide>({{t1, t2}}, {{0.3L, 1.5L, 2.0L}});
    CHECK(std::abs(f[0] - own[0]) < 1e-18L);
    CHECK(std::abs(f[1] - own[1]) < 1e-18L);

    // Where the parameters enter linearly, so do their imaginary parts.
    using M = models::CoupledAngles<2>;
    using Z = std::complex<double>;
    Generator generator(5);
    const auto re = random_parameters<M>(generator), im = random_parameters<M>(generator);
    Parameters<M, Z> p;
    for (int k = 0; k < p.size(); ++k) p[k] = {re[k], im[k]};
    const std::vector<double> point{0.3, -0.8, 1.2, 0.5};
    const auto all = evaluate(polynomial_system<M, Z>(p), point);
    const auto real = evaluate(polynomial_system<M>(re), point), imaginary = evaluate(polynomial_system<M>(im), point);
    for (std::size_t i = 0; i < 2; ++i) CHECK(std::abs(all[i] - Z(real[i], imaginary[i])) < 1e-15);
}

TEST_CASE("fifty digits of the parameters' functions reach the coefficients") {
    using Big = boost::multiprecision::cpp_bin_float_50;
    const auto system = polynomial_system<FunctionsOfParameters, Big>({{Big(2)}});
    // -2 sqrt(p) (2 c s cos(p) + (2 c^2 - 1) sin(p)) + p^1.5 c
    REQUIRE(system.equations[0].size() == 4);
    const Big expected[4] = {-4 * sqrt(Big(2)) * cos(Big(2)), -4 * sqrt(Big(2)) * sin(Big(2)), 2 * sqrt(Big(2)),
                             2 * sqrt(Big(2)) * sin(Big(2))};
    const int exponents[4][2] = {{1, 1}, {2, 0}, {1, 0}, {0, 0}};
    for (const auto& t : system.equations[0]) {
        bool known = false;
        for (int k = 0; k < 4; ++k)
            if (t.exponents == std::vector<int>(exponents[k], exponents[k] + 2))
                known = abs(t.coefficient - expected[k]) < 1e-48;
        CHECK(known);
    }
}

TEST_CASE("Chebyshev polynomials") {
    for (int k = 0; k < 12; ++k) {
        const auto first = detail::chebyshev(k, true), second = detail::chebyshev(k, false);
        CHECK(first.size() == static_cast<std::size_t>(k) + 1);
        const double theta = 0.7, c = std::cos(theta);
        double t = 0, u = 0;
        for (std::size_t d = first.size(); d-- > 0;) t = t * c + first[d], u = u * c + second[d];
        CHECK(std::abs(t - std::cos(k * theta)) < 1e-12);
        CHECK(std::abs(u * std::sin(theta) - std::sin((k + 1) * theta)) < 1e-12);
    }
}

TEST_CASE("a point has one value a variable") {
    const auto system = polynomial_system<models::Pendulum>({{0.5}});
    CHECK_THROWS_AS(evaluate(system, std::vector{1.0}), InvalidArgument);
}
