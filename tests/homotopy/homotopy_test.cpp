// Evaluation of the homotopies: against the model's own function, finite differences, and Taylor's theorem.
#include <complex>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/moving.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/random_parameters.hpp"

using namespace equilibria;
using tests::random_parameters;

namespace {

using Z = Complex<double>;

template <class M>
Point<M, double> random_point(Generator& generator) {
    Point<M, double> q;
    for (int i = 0; i < n_angles<M>; ++i) {
        const std::complex<double> theta(uniform(generator, -3, 3), uniform(generator, -0.5, 0.5));
        set_lane(q.c[i], 0, std::cos(theta));
        set_lane(q.s[i], 0, std::sin(theta));
    }
    for (int j = 0; j < n_coordinates<M>; ++j) q.x[j] = {uniform(generator, -1, 1), uniform(generator, -1, 1)};
    return q;
}

/// Two equations with all terms up to a degree.
struct Dense {
    static constexpr int degree = 11, terms = (degree + 1) * (degree + 2) / 2;
    static constexpr int n_angles = 0, n_coordinates = 2, n_parameters = 2 * terms;
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        std::array<S, 2> f{};
        int k = 0;
        for (S& sum : f) {
            S power(1.0);
            for (int a = 0; a <= degree; ++a, power *= x[0]) {
                S product = power;
                for (int b = 0; a + b <= degree; ++b, product *= x[1]) sum += p[k++] * product;
            }
        }
        return f;
    }
};

double size(const Z& z) { return std::sqrt(norm2(z)); }

/// A homotopy of each kind at random parameters.
template <class M, class StartSystem>
PolynomialHomotopy random_homotopy(Generator& generator, const Parameters<M>& p) {
    const ModelSystem<M> target(p);
    if constexpr (StartSystem::moving) {
        const auto from = coefficients<M, double>(random_parameters<M>(generator));
        return model_homotopy(target, StartSystem(from, unit_complex(generator), {}));
    } else {
        return model_homotopy(target, StartSystem(target, generator));
    }
}

template <class M, class StartSystem>
struct Case {
    using H = PolynomialHomotopy;
    static constexpr int n = n_unknowns<M>;
    Generator generator{static_cast<std::uint64_t>(n) + 10};
    Parameters<M> p = random_parameters<M>(generator);
    H h = random_homotopy<M, StartSystem>(generator, p);
    H::Evaluation<double, double> evaluation{h};

    RuntimePoint<double> point() { return runtime_point(random_point<M>(generator)); }
    void at_the_target_it_is_the_model() {
        for (int k = 0; k < 20; ++k) {
            const auto q = point();
            Z f[n];
            evaluation.value(q, 1.0, f);
            detail::AnglesOf<M, Z> theta;
            detail::CoordinatesOf<M, Z> x;
            for (int i = 0; i < n_angles<M>; ++i) theta[i] = {q.c[i], q.s[i]};
            for (int j = 0; j < n_coordinates<M>; ++j) x[j] = q.x[j];
            const auto own = detail::equations_at<M, Z>(theta, x, p);
            for (int i = 0; i < n; ++i) CHECK(size(f[i] - own[i]) < 1e-12 * (1 + size(own[i])));
        }
    }
    void the_jacobian_is_the_derivative() {
        for (int k = 0; k < 20; ++k) {
            const auto q = point();
            const double t = uniform(generator), e = 1e-5;
            Z f[n], j[n][n];
            evaluation.jacobian(q, t, f, j);
            for (int c = 0; c < n; ++c) {
                Z step[n], up[n], down[n];
                for (Z& z : step) z = {0, 0};
                step[c] = {e, 0};
                evaluation.value(moved(q, step), t, up);
                step[c] = {-e, 0};
                evaluation.value(moved(q, step), t, down);
                for (int r = 0; r < n; ++r) {
                    // with a potential only the upper triangle is given
                    const Z& entry = Formulation<M>::has_potential && r > c ? j[c][r] : j[r][c];
                    if (Formulation<M>::has_potential && r > c) continue;
                    CHECK(size((up[r] - down[r]) * (0.5 / e) - entry) < 2e-7 * (1 + size(entry)));
                }
            }
        }
    }
    /// -[t^k] H with the coefficients q_1, q_2 given and q_3 = 0: against the third difference of H along that path.
    void taylor_coefficients_are_those_of_the_path() {
        const auto q = point();
        const double t = 0.4;
        Z f[n], j[n][n], given[2][n], right[3][n];
        for (auto& d : given)
            for (Z& z : d) z = {uniform(generator, -1, 1), uniform(generator, -1, 1)};
        evaluation.jacobian(q, t, f, j);
        for (int k = 1; k <= 3; ++k) {
            evaluation.taylor_right_side(k, right[k - 1]);
            if (k < 3) evaluation.set_coefficient(k, given[k - 1]);
        }
        // H(q + q_1 h + q_2 h^2, t + h), h = -2e .. 2e
        constexpr double e = 1e-2;
        const auto along = [&](double by, Z(&value)[n]) {
            Z step[n];
            for (int u = 0; u < n; ++u) step[u] = by * (given[0][u] + by * given[1][u]);
            H::Evaluation<double, double>(h).value(moved(q, step), t + by, value);
        };
        Z minus2[n], minus1[n], plus1[n], plus2[n];
        along(-2 * e, minus2), along(-e, minus1), along(e, plus1), along(2 * e, plus2);
        for (int i = 0; i < n; ++i) {
            const Z third = (plus2[i] - 2.0 * plus1[i] + 2.0 * minus1[i] - minus2[i]) * (1 / (12 * e * e * e));
            CHECK(size(third + right[2][i]) < 0.02 * (1 + size(third)));
        }
    }
    void all() {
        at_the_target_it_is_the_model();
        the_jacobian_is_the_derivative();
        taylor_coefficients_are_those_of_the_path();
    }
};

}  // namespace

TEST_CASE("homotopy of the chain, reflected start") {
    Case<mechanisms::RotatingChain<3>, Reflected<mechanisms::RotatingChain<3>>>().all();
}
TEST_CASE("homotopy of the chain, general start") {
    Case<mechanisms::RotatingChain<3>, TotalDegree<mechanisms::RotatingChain<3>>>().all();
}
TEST_CASE("homotopy of the chain, from other parameters") {
    Case<mechanisms::RotatingChain<3>, Moving<mechanisms::RotatingChain<3>>>().all();
}
TEST_CASE("homotopy of equations without a potential") {
    Case<models::CoupledAngles<3>, TotalDegree<models::CoupledAngles<3>>>().all();
}
TEST_CASE("homotopy with a coordinate") { Case<models::ElasticPendulum, TotalDegree<models::ElasticPendulum>>().all(); }
TEST_CASE("homotopy with multiples, powers and phases") {
    Case<models::Everything, TotalDegree<models::Everything>>().all();
}
TEST_CASE("homotopy with multiples, powers and phases, from other parameters") {
    Case<models::Everything, Moving<models::Everything>>().all();
}

TEST_CASE("homotopy of many terms, from other parameters") { Case<Dense, Moving<Dense>>().all(); }

TEST_CASE("a total-degree homotopy is its start system at t = 0, and linear in t") {
    using M = mechanisms::RotatingChain<3>;
    Case<M, TotalDegree<M>> c;
    Generator generator(10 + 3);
    const auto p = random_parameters<M>(generator);
    const TotalDegree<M> start(ModelSystem<M>(p), generator);
    auto q = point_of_zeros<RuntimeUnknowns, double>(c.h.sizes());
    for (int i = 0; i < 3; ++i) {
        set_lane(q.c[i], 0, start.system().points(i)[1].c);
        set_lane(q.s[i], 0, start.system().points(i)[1].s);
    }
    Z zero[3], one[3], third[3];
    c.evaluation.value(q, 0.0, zero);
    c.evaluation.value(q, 1.0, one);
    c.evaluation.value(q, 1.0 / 3, third);
    for (int i = 0; i < 3; ++i) {
        CHECK(size(zero[i]) < 1e-13);
        CHECK(size(third[i] - (zero[i] * (2.0 / 3) + one[i] * (1.0 / 3))) < 1e-13);
    }
}

TEST_CASE("all lanes evaluate alike, and so do complex times") {
    using M = mechanisms::RotatingChain<3>;
    using R = Lanes<native_lanes>;
    Generator generator(5);
    const auto h = random_homotopy<M, Reflected<M>>(generator, random_parameters<M>(generator));
    using H = PolynomialHomotopy;
    H::Evaluation<R, R> lanes(h);
    H::Evaluation<double, double> scalar(h);
    H::Evaluation<double, Z> complex_time(h);
    auto pack = point_of_zeros<RuntimeUnknowns, R>(h.sizes());
    RuntimePoint<double> q[native_lanes];
    R t = broadcast<R>(0.0);
    for (int k = 0; k < native_lanes; ++k) {
        q[k] = runtime_point(random_point<M>(generator));
        copy_lane(q[k], 0, pack, k);
        set_lane(t, k, 0.2 * k);
    }
    Complex<R> f[3];
    lanes.value(pack, t, f);
    for (int k = 0; k < native_lanes; ++k) {
        Z g[3], z[3];
        scalar.value(q[k], 0.2 * k, g);
        complex_time.value(q[k], {0.2 * k, 0}, z);
        for (int i = 0; i < 3; ++i) {
            CHECK(std::abs(lane(f[i], k) - lane(g[i], 0)) < 1e-14);
            CHECK(size(g[i] - z[i]) < 1e-14);
        }
    }
}
