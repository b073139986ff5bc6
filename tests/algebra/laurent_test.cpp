#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include <equilibria/algebra/laurent.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using mechanisms::RotatingChain;
using Z = std::complex<double>;

namespace {

template <class M>
Parameters<M> random_parameters(Generator& generator) {
    Parameters<M> p;
    for (double& value : p) value = uniform(generator, 0.3, 1.7);
    return p;
}

/// A torsion-free row of angles, each coupled to the next by the cosine of their difference: no loads.
template <int N>
struct Row {
    static constexpr int n_angles = N, n_parameters = N;
    constexpr auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        for (int i = 0; i + 1 < N; ++i) v -= p[i] * cos(theta[i] - theta[i + 1]);
        return v;
    }
};

/// At random points of the complex torus: the Laurent system, the polynomial system, and the former's other form.
template <class M>
void compare(Generator& generator) {
    const auto p = random_parameters<M>(generator);
    const auto polynomials = polynomial_system<M>(p);
    const auto symmetric = laurent_system<M>(p);
    const auto shifted = laurent_system<M>(p, LaurentForm::non_negative);
    for (int trial = 0; trial < 5; ++trial) {
        std::vector<Z> cs, z;
        for (int i = 0; i < n_angles<M>; ++i) {
            const Z theta(uniform(generator, -3, 3), uniform(generator, -0.5, 0.5));
            cs.push_back(std::cos(theta)), cs.push_back(std::sin(theta));
            z.push_back(std::exp(Z(0, 1) * theta));
        }
        for (int j = 0; j < n_coordinates<M>; ++j) {
            z.emplace_back(uniform(generator, -1, 1), uniform(generator, -1, 1));
            cs.push_back(z.back());
        }
        const auto expected = evaluate(polynomials, cs), f = evaluate(symmetric, z), g = evaluate(shifted, z);
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto k = static_cast<std::size_t>(i);
            CHECK(std::abs(f[k] - expected[k]) < 1e-12 * (1 + std::abs(expected[k])));
            Z monomial = 1;
            for (int u = 0; u < n_unknowns<M>; ++u)
                monomial *= std::pow(z[static_cast<std::size_t>(u)], -LaurentFormulation<M>::lowest[i][u]);
            CHECK(std::abs(g[k] - monomial * f[k]) < 1e-12 * (1 + std::abs(g[k])));
        }
    }
    for (const auto& equation : shifted.equations)
        for (std::size_t u = 0; u < shifted.variables.size(); ++u) {
            int least = 1;
            for (const auto& t : equation) least = std::min(least, t.exponents[u]);
            CHECK(least == 0);
        }
}

}  // namespace

TEST_CASE("the Laurent system is the polynomial system on the torus") {
    Generator generator(1);
    compare<mechanisms::TwoLinkChain>(generator);
    compare<RotatingChain<3>>(generator);
    compare<models::Pendulum>(generator);
    compare<models::ElasticPendulum>(generator);
    compare<models::CoupledAngles<4>>(generator);
    compare<models::Everything>(generator);
}

TEST_CASE("the cosine of a difference has two monomials") {
    // Equation i of the row: sin(theta_i - theta_(i-1)) and sin(theta_i - theta_(i+1)).
    STATIC_REQUIRE(LaurentFormulation<Row<2>>::terms == 2 * 2);
    STATIC_REQUIRE(LaurentFormulation<Row<4>>::terms == 2 + 4 + 4 + 2);
    STATIC_REQUIRE(Formulation<Row<2>>::terms == 2 * 2);  // products: s1 c2 and c1 s2
    // All-to-all: z_i and 1/z_i for the load, z_i/z_j and z_j/z_i for each other angle.
    STATIC_REQUIRE(LaurentFormulation<models::CoupledAngles<3>>::terms == 3 * (2 + 4));
    STATIC_REQUIRE(LaurentFormulation<models::CoupledAngles<5>>::terms == 5 * (2 + 8));
    // The chain: z_i^+-1 for the weight, z_i^+-2 for c_i s_i, z_i^+-1 z_j^+-1 for c_i s_j.
    STATIC_REQUIRE(LaurentFormulation<RotatingChain<2>>::terms == 2 * (2 + 2 + 4));
    STATIC_REQUIRE(LaurentFormulation<RotatingChain<4>>::terms == 4 * (2 + 2 + 3 * 4));
}

TEST_CASE("the support is sorted, and symmetric under z -> 1/z") {
    using L = LaurentFormulation<models::Everything>;
    const Parameters<models::Everything> p{{0.4, 0.9, 0.2}};
    const auto c = laurent_coefficients<models::Everything>(p);
    for (int k = 0; k < L::terms; ++k) {
        if (k > 0) CHECK(L::support[k - 1] < L::support[k]);
        auto mirror = L::support[k];
        for (int u = 0; u < n_angles<models::Everything>; ++u) mirror.exponents[u] *= -1;
        const auto at = std::lower_bound(L::support.begin(), L::support.end(), mirror);
        REQUIRE(at != L::support.end());
        REQUIRE(*at == mirror);
        // A real function of the angles: conjugate coefficients.
        CHECK(std::abs(c[at - L::support.begin()] - std::conj(c[k])) < 1e-15);
    }
    CHECK(L::first[0] == 0);
    CHECK(L::first[3] == L::terms);
}

TEST_CASE("coefficients of a Laurent system, by hand") {
    // sin(theta) - 1/2 = -i/2 z - 1/2 + i/2 z^-1
    const auto f = laurent_system<models::Pendulum>({{0.5}});
    REQUIRE(f.equations.size() == 1);
    REQUIRE(f.equations[0].size() == 3);
    CHECK(f.variables == std::vector<std::string>{"z1"});
    const std::vector<Z> expected{{0, 0.5}, {-0.5, 0}, {0, -0.5}};
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(f.equations[0][k].exponents == std::vector<int>{static_cast<int>(k) - 1});
        CHECK(f.equations[0][k].coefficient == expected[k]);
    }
    CHECK(degree(f.equations[0]) == 1);
    CHECK(degree(laurent_system<models::Pendulum>({{0.5}}, LaurentForm::non_negative).equations[0]) == 2);
}

TEST_CASE("a Laurent system with complex parameters") {
    using M = models::CoupledAngles<2>;
    Generator generator(5);
    const auto re = random_parameters<M>(generator), im = random_parameters<M>(generator);
    Parameters<M, Z> p;
    for (int k = 0; k < p.size(); ++k) p[k] = {re[k], im[k]};
    const auto c = laurent_coefficients<M, Z>(p), a = laurent_coefficients<M>(re), b = laurent_coefficients<M>(im);
    for (int k = 0; k < c.size(); ++k) CHECK(std::abs(c[k] - (a[k] + Z(0, 1) * b[k])) < 1e-15);

    const auto wide = laurent_coefficients<M, long double>({{0.1L, 0.2L, 0.3L, 0.4L, 0.5L, 0.6L, 0.7L, 0.8L}});
    STATIC_REQUIRE(std::is_same_v<std::decay_t<decltype(wide[0])>, std::complex<long double>>);
}
