// The chain of section 3 of Baillieul, "Parametric dependence in the equilibrium dynamics of rotating structures",
// against the printed equations and independently computed counts.
#include <map>
#include <set>
#include <vector>

#include <equilibria/stability/inertia.hpp>

#include "support/enumeration.hpp"

using namespace equilibria;
using mechanisms::RotatingChain;
using mechanisms::TwoLinkChain;

namespace {

const std::map<std::uint64_t, std::vector<std::int64_t>> index_tables{
    {4, {1, 2, 1}}, {6, {2, 3, 1}}, {8, {2, 4, 2}}, {10, {2, 5, 3}}, {12, {2, 6, 4}}, {16, {4, 8, 4}}};

RootSet<TwoLinkChain> solve(double alpha, double ratio, double omega, std::uint64_t seed = 1) {
    return enumerate<TwoLinkChain>({alpha, ratio, omega}, {.seed = seed});
}

void check_table(const RootSet<TwoLinkChain>& r) {
    CHECK(r.clean());
    CHECK(r.morse());
    CHECK(r.paths.finite == 16);
    const auto table = index_tables.find(r.real());
    REQUIRE(table != index_tables.end());
    CHECK(r.by_index() == table->second);
}

}  // namespace

TEST_CASE("the potential's gradient is the printed equations (3.1)") {
    constexpr int n = 5;
    using M = RotatingChain<n>;
    Generator generator(1);
    for (int k = 0; k < 20; ++k) {
        const auto p = tests::random_chain<n>(generator);
        Unknowns<M> q;
        for (double& angle : q) angle = uniform(generator, -3, 3);
        const auto f = equations<M, double>(q, p);
        for (int i = 0; i < n; ++i) {
            // -l_i times: omega^2 cos theta_i sum_{k>=i} m_k X_k = g M_i sin theta_i
            double x = 0, pull = 0, below = 0;
            for (int j = 0; j < n; ++j) {
                x += p[M::length + j] * std::sin(q[j]);
                if (j >= i) pull += p[M::mass + j] * x, below += p[M::mass + j];
            }
            const double square = p[M::omega] * p[M::omega];
            const double expected =
                -p[M::length + i] * (square * std::cos(q[i]) * pull - p[M::gravity] * below * std::sin(q[i]));
            CHECK(f[i] == Approx(expected).epsilon(1e-12).margin(1e-12));
        }
    }
}

TEST_CASE("the two-link form is the printed equations (3.2), and the chain of two links divided by its mass") {
    Generator generator(2);
    for (int k = 0; k < 20; ++k) {
        const double alpha = uniform(generator), ratio = uniform(generator, 0.5, 2), omega = uniform(generator, 0, 4);
        const Parameters<TwoLinkChain> p{alpha, ratio, omega};
        const Unknowns<TwoLinkChain> q{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        const auto f = equations<TwoLinkChain, double>(q, p);
        const double s1 = std::sin(q[0]), s2 = std::sin(q[1]), square = omega * omega;
        CHECK(-f[0] == Approx((s1 + alpha * ratio * s2) * std::cos(q[0]) * square - s1).margin(1e-12));
        CHECK(-f[1] == Approx(alpha * ratio * ((s1 + ratio * s2) * std::cos(q[1]) * square - s2)).margin(1e-12));

        const double mass = uniform(generator, 0.5, 3);
        const auto same = tests::chain<2>({1, ratio}, {mass * (1 - alpha), mass * alpha}, omega);
        using Chain = RotatingChain<2>;
        CHECK(potential<Chain, double>({q[0], q[1]}, same) ==
              Approx(mass * potential<TwoLinkChain, double>(q, p)).epsilon(1e-12).margin(1e-12));
    }
}

TEST_CASE("Hessian of the straight positions: at rest, 0 has index 0 and each inverted link adds one") {
    constexpr int n = 3;
    const auto p = tests::benchmark_chain<n>(0);
    for (int inverted = 0; inverted < 1 << n; ++inverted) {
        Unknowns<RotatingChain<n>> q;
        int count = 0;
        for (int i = 0; i < n; ++i)
            if (inverted >> i & 1) q[i] = std::numbers::pi, ++count;
        CHECK(inertia(jacobian<RotatingChain<n>, double>(q, p)).negative == count);
    }
}

TEST_CASE("r = 1.5: counts at points that interval branch and bound has confirmed") {
    const struct {
        double alpha, omega;
        std::uint64_t count;
    } points[] = {{.05, .55, 4},    {.05, .805, 6},    {.05, .915, 8},  {.05, 1.041, 10}, {.05, 1.577, 12},
                  {.05, 3.497, 16}, {.4, .487, 4},     {.4, .792, 6},   {.4, 1.027, 8},   {.4, 1.331, 10},
                  {.4, 1.918, 12},  {.4, 3.644, 16},   {.7, .461, 4},   {.7, .819, 6},    {.7, 1.221, 8},
                  {.7, 1.821, 10},  {.7, 3.395, 12},   {.9, .448, 4},   {.9, 2.963, 10},  {.9, 6.048, 12},
                  {.331, 1.93, 12}, {.331, 1.947, 16}, {.331, 2.0, 12}, {.331, 2.1, 16}};
    for (const auto& [alpha, omega, count] : points) {
        CAPTURE(alpha, omega);
        const auto r = solve(alpha, 1.5, omega);
        check_table(r);
        CHECK(r.real() == count);
    }
}

TEST_CASE("r = 1.5: the count changes by two across each pitchfork and by four across the fold") {
    const struct {
        double alpha, forks[4], fold;
    } rows[] = {{.1, {.76450069744675, .83377163246986, 1.0322526364616, 1.1257844089591}, 2.3179684357649},
                {.4, {.6960675016716, .90127739195077, 1.1695539717333, 1.5143539252415}, 2.4293853881739},
                {.6, {.66948880558549, .96948528423161, 1.3316287206556, 1.9283286560808}, 7.4951235452437},
                {.7, {.65870047908076, 1.0175035388023, 1.4650681085145, 2.2631105219176}, 0}};
    for (const auto& row : rows) {
        std::uint64_t count = 4;
        for (const double omega : row.forks) {
            CAPTURE(row.alpha, omega);
            CHECK(solve(row.alpha, 1.5, omega - 1e-6).real() == count);
            count += 2;
            CHECK(solve(row.alpha, 1.5, omega + 1e-6).real() == count);
        }
        if (row.fold > 0) {
            CHECK(solve(row.alpha, 1.5, row.fold - 1e-6).real() == 12);
            CHECK(solve(row.alpha, 1.5, row.fold + 1e-6).real() == 16);
        } else {
            CHECK(solve(row.alpha, 1.5, 50).real() == 12);
        }
    }
}

TEST_CASE("r = 1.5: all over the plane, one of the tables 3.3, and each of them somewhere") {
    std::map<std::uint64_t, int> seen;
    int points = 0;
    Generator generator(3);
    for (int i = 1; i <= 12; ++i)
        for (int j = 1; j <= 12; ++j) {
            const double alpha = (i - uniform(generator, 0.1, 0.9)) / 12,
                         omega = 5 * (j - uniform(generator, 0.1, 0.9)) / 12;
            CAPTURE(alpha, omega);
            const auto r = solve(alpha, 1.5, omega, static_cast<std::uint64_t>(100 * i + j));
            check_table(r);
            if (alpha * 1.5 > 1) CHECK(r.real() <= 12);  // Theorem 3.3
            ++seen[r.real()];
            ++points;
        }
    CHECK(points >= 60);
    CHECK(seen.size() == index_tables.size());
}

TEST_CASE("Theorem 3.3: alpha r > 1 makes the count grow with omega, alpha r < 1 need not") {
    for (const double ratio : {1.2, 1.5, 3.0})
        for (const double alpha : {1.05 / ratio, 0.5 + 0.5 / ratio, 0.95}) {
            std::uint64_t before = 4;
            for (double omega = 0.1; omega < 8; omega *= 1.13) {
                const auto r = solve(alpha, ratio, omega);
                CAPTURE(alpha, ratio, omega);
                REQUIRE(r.clean());
                CHECK(r.real() >= before);
                before = r.real();
            }
            CHECK(before <= 12);
        }
    // near the cusp of Figure 3.2 the count goes 12, 16, 12, 16
    std::vector<std::uint64_t> counts;
    for (const double omega : {1.93, 1.947, 2.0, 2.1}) counts.push_back(solve(.331, 1.5, omega).real());
    CHECK(counts == std::vector<std::uint64_t>{12, 16, 12, 16});
}
