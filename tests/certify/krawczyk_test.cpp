#include <array>
#include <cmath>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/certify/proved_index.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// (x - a)^2 = b.
struct Parabola {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { a, b, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{(x[0] - p[a]) * (x[0] - p[a]) - p[b]};
    }
};

Point<Parabola, double> at(double re, double im = 0) {
    Point<Parabola, double> q;
    q.x[0] = Complex<double>(re, im);
    return q;
}
BallSystem<double> parabola(double a, double b) {
    return BallSystem<double>(ExactSystem<Parabola>::at(Parameters<Parabola>{{a, b}}));
}
BallSystem<double> parabola(double a, double low, double high) {
    return BallSystem<double>(
        ExactSystem<Parabola>::at(Parameters<Parabola, ExactBall>{{ExactBall(a), ExactBall::between(low, high)}}));
}

}  // namespace

TEST_CASE("a root is proved, and lies within the radius") {
    const auto system = parabola(1, 2);
    for (const double start : {1 + std::sqrt(2), 2.41, 2.5, 2.3}) {
        const auto proof = krawczyk<Parabola, double>(system, at(start), true);
        REQUIRE(proof.proved);
        CHECK(std::abs(start - 1 - std::sqrt(2)) <= proof.radius[0]);
        CHECK(proof.radius[0] < 2 * std::abs(start - 1 - std::sqrt(2)) + 1e-14);
    }
    CHECK_FALSE(krawczyk<Parabola, double>(system, at(1), true).proved);
    CHECK_FALSE(krawczyk<Parabola, double>(system, at(7), true).proved);
    CHECK_FALSE(krawczyk<Parabola, double>(system, at(std::nan("")), true).proved);
    CHECK_FALSE(krawczyk<Parabola, double>(system, at(INFINITY), true).proved);
}

TEST_CASE("no root is proved where there is none, or a double one") {
    for (const double x : {1.0, 1 + 1e-8, 1 + 1e-15, 0.5}) {
        CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, 0), at(x), true).proved);
        CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, -1e-3), at(x), true).proved);
        CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, 0), at(x, 1e-12), false).proved);
    }
}

TEST_CASE("a non-real root is not proved around a real point") {
    CHECK(krawczyk<Parabola, double>(parabola(1, -1), at(1, 1), false).proved);
    CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, -1), at(1, 1), true).proved);
}

TEST_CASE("an interval of parameters: the radius covers the roots of all of them") {
    const auto proof = krawczyk<Parabola, double>(parabola(1, 2, 2.1), at(1 + std::sqrt(2.05)), true);
    REQUIRE(proof.proved);
    for (double b = 2; b <= 2.1; b += 0.01) CHECK(std::abs(std::sqrt(b) - std::sqrt(2.05)) <= proof.radius[0]);
    CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, 0, 0.1), at(1 + std::sqrt(0.05)), true).proved);
    CHECK_FALSE(krawczyk<Parabola, double>(parabola(1, -0.1, 0.1), at(1.1), true).proved);
}

TEST_CASE("a root in 68 digits confirms the radius in doubles") {
    using M = mechanisms::TwoLinkChain;
    using S = Multiprecision<68>;
    const Parameters<M> p{{.3, 1.5, 2.0}};
    const auto exact = ExactSystem<M>::at(p);
    const BallSystem<double> system(exact);
    const BallSystem<S> fine(exact);
    // 4 of the 12 equilibria, and 2 of the other roots near their README values or from Newton's method
    using Start = Array<std::complex<double>, 2>;
    for (const Start& start : {Start{{1.39806, 1.47023}}, Start{{1.23055, -2.58828}}, Start{{-0.68757, 1.26666}},
                               Start{{0.0, 0.0}}, Start{{{0.3, 1.2}, {1.4, 0.9}}}, Start{{{-1.0, 1.0}, {0.7, 1.3}}}}) {
        auto q = complex_unknowns<S>({start.begin(), start.end()});
        REQUIRE(newton(fine, q, 100) < S(1e-60));
        Point<M, double> rounded;
        const auto point = point_of<RuntimeUnknowns, S>(q, Sizes<M>());
        for (int i = 0; i < 2; ++i) {
            rounded.c[i] = Complex<double>(static_cast<double>(point.c[i].re), static_cast<double>(point.c[i].im));
            rounded.s[i] = Complex<double>(static_cast<double>(point.s[i].re), static_cast<double>(point.s[i].im));
        }
        const auto proof = krawczyk<M, double>(system, rounded, false);
        REQUIRE(proof.proved);
        for (int i = 0; i < 2; ++i) {
            CHECK(proof.radius[i] < 1e-13);
            const Complex<S> c = point.c[i] - Complex<S>(S(proof.center.c[i].re), S(proof.center.c[i].im));
            const Complex<S> s = point.s[i] - Complex<S>(S(proof.center.s[i].re), S(proof.center.s[i].im));
            CHECK(norm2(c) <= S(proof.off[i]) * S(proof.off[i]));
            CHECK(norm2(s) <= S(proof.off[i]) * S(proof.off[i]));
        }
    }
}

TEST_CASE("the index of the chain's equilibria with every angle 0 or pi, omega small: the number of angles pi") {
    using M = mechanisms::RotatingChain<3>;
    const Parameters<M> p{{1.387, 1.538, 1.087, .505, .364, .302, 0.1, 1}};
    const BallSystem<double> system(ExactSystem<M>::at(p));
    for (int pattern = 0; pattern < 8; ++pattern) {
        Point<M, double> q;
        int up = 0;
        for (int i = 0; i < 3; ++i) {
            const bool is_up = (pattern >> i & 1) != 0;
            up += is_up;
            q.c[i] = Complex<double>(is_up ? -1.0 : 1.0);
            q.s[i] = Complex<double>(0.0);
        }
        const auto proof = krawczyk<M, double>(system, q, true);
        REQUIRE(proof.proved);
        CHECK(proved_index(proof, 0) == up);
    }
}

TEST_CASE("bounds that are theorems") {
    using Chain = mechanisms::RotatingChain<3>;
    const auto chain = ExactSystem<Chain>::at(Parameters<Chain>{{1, 2, 3, 1, 1, 1, 2, 1}});
    CHECK(chain.within_support());
    CHECK(total_degree_bound<Chain>(chain)->value == 64);
    CHECK(smallest_proved_bound<Chain>(chain)->value == 64);
    // a massless end: its equation vanishes
    const auto loose = ExactSystem<Chain>::at(Parameters<Chain>{{1, 2, 3, 1, 1, 0, 2, 1}});
    CHECK_FALSE(total_degree_bound<Chain>(loose).has_value());
    // at rest the equations are linear in the sines
    const auto rest = ExactSystem<Chain>::at(Parameters<Chain>{{1, 2, 3, 1, 1, 1, 0, 1}});
    CHECK(total_degree_bound<Chain>(rest)->value == 8);
}
