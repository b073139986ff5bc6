// Homotopies of systems that are data: they are what those of the same model are, and their Jacobians and Taylor
// coefficients are the derivatives of their values, whatever the start adds.
#include <complex>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/linear_product.hpp>
#include <equilibria/start/moving.hpp>
#include <equilibria/start/solved_instance.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/random_parameters.hpp"

using namespace equilibria;
using tests::random_parameters;

namespace {

using Z = Complex<double>;

double size(const Z& z) { return std::sqrt(norm2(z)); }

template <class M>
Point<M, double> random_point(Generator& generator, const Sizes<M>& sizes = {}) {
    auto q = unknown_array<M, std::complex<double>>(sizes);
    for (int u = 0; u < q.size(); ++u) {
        const double re = uniform(generator, -3, 3);
        q[u] = {re, uniform(generator, -0.5, 0.5)};
    }
    return point_of<M>(q, sizes);
}

/// The Jacobian against differences of the values; the Taylor coefficients against each other: with q(t) of the given
/// coefficients, H(q(t), t) cut after order k leaves a rest of order k + 1.
template <int n>
void check_derivatives(const PolynomialHomotopy& h, Generator& generator) {
    PolynomialHomotopy::Evaluation<double, double> evaluation(h);
    const auto q = random_point<RuntimeUnknowns>(generator, h.sizes());
    const double t = 0.4, e = 1e-5;
    Z f[n], j[n][n], d[3][n], right[3][n];
    evaluation.jacobian(q, t, f, j);
    for (int c = 0; c < n; ++c) {
        Z step[n], up[n], down[n];
        for (Z& z : step) z = {0, 0};
        step[c] = {e, 0};
        evaluation.value(moved(q, step), t, up);
        step[c] = {-e, 0};
        evaluation.value(moved(q, step), t, down);
        for (int r = 0; r < n; ++r) CHECK(size((up[r] - down[r]) * (0.5 / e) - j[r][c]) < 1e-6 * (1 + size(j[r][c])));
    }
    for (auto& order : d)
        for (Z& z : order) z = {uniform(generator, -1, 1), uniform(generator, -1, 1)};
    evaluation.jacobian(q, t, f, j);
    Z series[4][n];
    for (int i = 0; i < n; ++i) series[0][i] = f[i];
    for (int k = 1; k <= 3; ++k) {
        evaluation.taylor_right_side(k, right[k - 1]);
        for (int i = 0; i < n; ++i) {
            series[k][i] = -right[k - 1][i];
            for (int u = 0; u < n; ++u) series[k][i] += j[i][u] * d[k - 1][u];
        }
        if (k < 3) evaluation.set_coefficient(k, d[k - 1]);
    }
    const auto rest = [&](double by) {
        Z step[n], value[n];
        for (int u = 0; u < n; ++u) step[u] = by * (d[0][u] + by * (d[1][u] + by * d[2][u]));
        evaluation.value(moved(q, step), t + by, value);
        double y = 0;
        for (int i = 0; i < n; ++i)
            y += size(value[i] - (series[0][i] + by * (series[1][i] + by * (series[2][i] + by * series[3][i]))));
        return y;
    };
    CHECK(std::log2(rest(4e-3) / rest(2e-3)) == Approx(4).margin(0.3));
}

template <class M>
void check_instance() {
    constexpr int n = n_unknowns<M>;
    Generator generator(11);
    const auto from = random_parameters<M>(generator), to = random_parameters<M>(generator);
    const std::complex<double> gamma = unit_complex(generator);
    const auto target = sparse_system<M>(to);
    const SolvedInstance start(sparse_system<M>(from), target, gamma, {});
    const PolynomialHomotopy data(target, start);
    const auto same = model_homotopy(ModelSystem<M>(to), Moving<M>(coefficients<M, double>(from), gamma, {}));
    PolynomialHomotopy::Evaluation<double, double> a(data), b(same);
    for (const double t : {0.0, 0.3, 1.0}) {
        const auto q = random_point<M>(generator);
        Z f[n], g[n];
        a.value(runtime_point(q), t, f);
        b.value(runtime_point(q), t, g);
        for (int i = 0; i < n; ++i) CHECK(size(f[i] - g[i]) < 1e-12 * (1 + size(f[i])));
    }
    check_derivatives<n>(data, generator);
}

template <class M>
void check_linear_product(const Array<int, n_unknowns<M>>& grouping) {
    Generator generator(12);
    const SparseSystem target = sparse_system<M>(random_parameters<M>(generator));
    const LinearProduct start(target, grouping, unit_complex(generator), generator);
    check_derivatives<n_unknowns<M>>(PolynomialHomotopy(target, start), generator);
}

}  // namespace

TEST_CASE(
    "a parameter homotopy of a model and of its system are the same, and its derivatives are those of its values") {
    check_instance<mechanisms::RotatingChain<3>>();
    check_instance<models::CoupledAngles<3>>();
    check_instance<models::ElasticPendulum>();
    check_instance<models::Everything>();
}

TEST_CASE("a linear product in its own form: the derivatives are those of the values") {
    check_linear_product<mechanisms::RotatingChain<3>>({0, 0, 1});
    check_linear_product<models::ElasticPendulum>({0, 1});
    check_linear_product<models::Everything>(one_group_each<models::Everything>());
}

TEST_CASE("systems that share no term have a homotopy too: the terms of both") {
    using Polynomial = TrigonometricPolynomial<0, 1>;
    using Polynomials = std::vector<Polynomial>;
    const auto power = [](int k) { return Polynomial(Polynomial::Basis::single(0, k), 1.0); };
    const SparseSystem from(Polynomials{power(2) - Polynomial(1)}), to(Polynomials{power(3)});
    const SolvedInstance start(from, to, 1.0, {});
    const PolynomialHomotopy h(to, start);
    PolynomialHomotopy::Evaluation<double, double> evaluation(h);
    auto q = point_of_zeros<RuntimeUnknowns, double>(h.sizes());
    q.x[0] = {2, 0};
    Z f[1];
    evaluation.value(q, 0.25, f);
    CHECK(f[0].re == Approx(0.75 * 3 + 0.25 * 8));
}

TEST_CASE("what is no square system is refused") {
    using System = SparseSystem;
    using Polynomial = TrigonometricPolynomial<0, 2>;
    using Polynomials = std::vector<Polynomial>;
    const Polynomial x(Polynomial::Basis::single(0, 1), 1.0);
    CHECK_THROWS_WITH(System(Polynomials{x}), "equations = 1: must be as many as there are unknowns");
    CHECK_THROWS_WITH(System(Polynomials{x, Polynomial()}), "equations = equation 2: must not be 0");
    CHECK_THROWS_WITH(System(Polynomials{x, Polynomial(std::numeric_limits<double>::infinity())}),
                      "equations = equation 2: has a coefficient that is not finite");
}
