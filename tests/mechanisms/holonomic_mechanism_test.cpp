// The holonomic mechanism against the printed equations (1.10), (1.14), (2.3) and Tables 1 and 2 of Vesovic and
// Radulovic, "Modelling and stability analysis of the nonlinear system" (2022), to more digits than they have, and
// against what a force triangle says without a force.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <equilibria/algebra/bounds.hpp>
#include <equilibria/certify/refine_root.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/torque_trace.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/model/torus.hpp>

#include "support/enumeration.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;
using std::numbers::pi;

namespace {

/// Tables 1 and 2 at 100 N: the equilibria in the paper's order, their Hessians, determinants and indices.
const struct {
    double q1, q2, c11, c12, c22, determinant;
    int index;
} printed[] = {
    {0.779776976161, -2.95917510938, 111.015023, -208.316925, -306.190210, -77387.6544, 1},
    {1.46544020854, -0.25630918245, 576.559034, 237.480771, 387.748384, 167162.717, 0},
    {-1.42175799139, -2.54488196512, -119.041762, 186.514422, 155.355659, -53281.4411, 1},
    {-2.356470734, 1.38609618224, -529.600658, -209.497384, -309.858695, 120212.215, 2},
};

Parameters<M> random_parameters(Generator& generator) {
    Parameters<M> p;
    for (double& value : p) value = uniform(generator, 0.5, 2);
    p[M::force] = uniform(generator, -2, 2);
    return p;
}

Unknowns<M> random_angles(Generator& generator) { return {uniform(generator, -pi, pi), uniform(generator, -pi, pi)}; }

/// The equilibrium of the set that is next to q.
Equilibrium<M> nearest(const RootSet<M>& set, const Unknowns<M>& q) {
    REQUIRE(set.real() > 0);
    return *std::min_element(set.equilibria.begin(), set.equilibria.end(),
                             [&](const auto& a, const auto& b) { return distance<M>(a.q, q) < distance<M>(b.q, q); });
}

void check_complete(const RootSet<M>& r) {
    tests::check_accounts(r);
    CHECK(r.paths.total == 16);
    CHECK(r.paths.finite == 6);
    CHECK(r.paths.at_infinity == 10);
    CHECK(r.distinct() == 6);
    CHECK(r.clean());
    CHECK(r.morse());
}

}  // namespace

TEST_CASE("the potential is (1.14) at the points (1.10), less F x2") {
    Generator generator(1);
    for (int k = 0; k < 50; ++k) {
        const auto p = random_parameters(generator);
        const auto q = random_angles(generator);
        const double l = p[M::length];
        const double x1 = l * std::cos(q[0]), y1 = l * std::sin(q[0]);
        const double x2 = x1 - l * std::sin(q[1]), y2 = y1 - l * std::cos(q[1]);
        const double energy = p[M::gravity] * (p[M::mass_1] * y1 + p[M::mass_2] * y2) +
                              p[M::stiffness_1] / 2 * (x2 * x2 + y2 * y2) +
                              p[M::stiffness_2] / 2 * (x1 * x1 + (l - y1) * (l - y1));
        CHECK(potential<M, double>(q, p) == Approx(energy - p[M::force] * x2).epsilon(1e-13).margin(1e-13));
        // both rods are of length l
        CHECK(std::hypot(x1, y1) == Approx(l));
        CHECK(std::hypot(x2 - x1, y2 - y1) == Approx(l));
    }
}

TEST_CASE("the gradient is the printed equilibrium conditions (2.3)") {
    Generator generator(2);
    for (int k = 0; k < 50; ++k) {
        const auto p = random_parameters(generator);
        const auto q = random_angles(generator);
        const double l = p[M::length], weight = p[M::mass_2] * p[M::gravity], c1 = p[M::stiffness_1], F = p[M::force];
        const double together = c1 * l * std::cos(q[0] + q[1]);
        const auto f = equations<M, double>(q, p);
        CHECK(-f[0] == Approx(l * ((p[M::stiffness_2] * l - p[M::mass_1] * p[M::gravity] - weight) * std::cos(q[0]) +
                                   together - F * std::sin(q[0])))
                           .margin(1e-13));
        CHECK(-f[1] == Approx(l * (-F * std::cos(q[1]) + together - weight * std::sin(q[1]))).margin(1e-13));
    }
}

TEST_CASE("the reflection leaves the potential as it is") {
    Generator generator(3);
    for (int k = 0; k < 50; ++k) {
        auto p = random_parameters(generator);
        const auto q = random_angles(generator);
        const double before = potential<M, double>(q, p);
        p[M::force] = -p[M::force];
        CHECK(potential<M, double>({pi - q[0], -q[1]}, p) == Approx(before).margin(1e-13));
    }
}

TEST_CASE("the paper's data, and the path counts of its formulations") {
    const auto p = M::paper_parameters(100);
    for (const int mass : {M::mass_1, M::mass_2, M::mass_3}) CHECK(p[mass] == 10);
    CHECK(p[M::length] == 1.25);
    CHECK(p[M::stiffness_1] == 162.5);
    CHECK(p[M::stiffness_2] == Approx(366.67).margin(0.005));
    CHECK(p[M::force] == 100);
    STATIC_REQUIRE(total_degree<M>() == 16);
    CHECK(smallest_multihomogeneous_number<M>().number.value == 8);
}

TEST_CASE("Tables 1 and 2 at 100 N: four equilibria of six roots, with their Hessians") {
    const auto p = M::paper_parameters(100);
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto r = enumerate<M>(p, {.seed = seed});
        check_complete(r);
        REQUIRE(r.real() == 4);
        CHECK(r.by_index() == std::vector<std::int64_t>{1, 2, 1});
        for (const auto& row : printed) {
            const auto e = nearest(r, {row.q1, row.q2});
            CAPTURE(row.q1, row.q2);
            CHECK(std::abs(e.q[0] - row.q1) < 6e-12);  // twelve digits of each
            CHECK(std::abs(e.q[1] - row.q2) < 6e-12);
            CHECK(e.index == row.index);
            CHECK(e.stable() == (row.index == 0));
            const UnknownMatrix<M> c = jacobian<M>(e.q, p);
            CHECK(c(0, 0) == Approx(row.c11).epsilon(5e-9));  // nine digits of each
            CHECK(c(0, 1) == Approx(row.c12).epsilon(5e-9));
            CHECK(c(1, 0) == c(0, 1));
            CHECK(c(1, 1) == Approx(row.c22).epsilon(5e-9));
            CHECK(c(0, 0) * c(1, 1) - c(0, 1) * c(1, 0) == Approx(row.determinant).epsilon(5e-9));
        }
    }
}

TEST_CASE("the six roots at 100 N are proved, the four real ones to 30 digits, and the trace test raises nothing") {
    const auto p = M::paper_parameters(100);
    const auto r = enumerate<M>(p);
    const auto proof = prove(r);
    CAPTURE(proof.reason);
    CHECK(proof.distinct == 6);
    CHECK(proof.real == 4);
    CHECK(proof.non_real == 2);
    CHECK(proof.contradictions == 0);
    CHECK(proof.complete);  // by Bernstein's theorem
    CHECK(proof.by_index == std::vector<std::int64_t>{1, 2, 1});
    for (const auto& row : printed) {
        const auto root = refine<M>({row.q1, row.q2}, p, 30);
        CHECK(root.proved_real);
        CHECK(std::abs(std::stod(root.real[0]) - row.q1) < 6e-12);
        CHECK(std::abs(std::stod(root.real[1]) - row.q2) < 6e-12);
    }
    const Alarm trace = torque_trace(r);
    CHECK(trace.applied);
    CHECK_FALSE(trace.raised());
}

TEST_CASE("along F, the equilibria move by -H^-1 dF/dp and their energies by -x2") {
    const double step = 1e-3;
    const auto p = M::paper_parameters(100);
    const auto less = enumerate<M>(M::paper_parameters(100 - step)),
               more = enumerate<M>(M::paper_parameters(100 + step));
    REQUIRE(less.real() == 4);
    REQUIRE(more.real() == 4);
    for (const auto& e : enumerate<M>(p).equilibria) {
        const auto a = nearest(less, e.q), b = nearest(more, e.q);
        const double x2 = p[M::length] * (std::cos(e.q[0]) - std::sin(e.q[1]));
        CHECK((b.energy - a.energy) / (2 * step) == Approx(-x2).epsilon(1e-8));
        const UnknownMatrix<M> h = jacobian<M>(e.q, p);
        const auto g = parameter_derivative<M>(e.q, p, M::force);
        const double determinant = h(0, 0) * h(1, 1) - h(0, 1) * h(1, 0);
        CHECK((b.q[0] - a.q[0]) / (2 * step) ==
              Approx(-(h(1, 1) * g[0] - h(0, 1) * g[1]) / determinant).epsilon(1e-7).margin(1e-10));
        CHECK((b.q[1] - a.q[1]) / (2 * step) ==
              Approx(-(h(0, 0) * g[1] - h(1, 0) * g[0]) / determinant).epsilon(1e-7).margin(1e-10));
    }
}

TEST_CASE("with the force reversed, every equilibrium is the reflected one") {
    Generator generator(4);
    for (int k = 0; k < 20; ++k) {
        auto p = random_parameters(generator);
        const auto r = enumerate<M>(p);
        check_complete(r);
        p[M::force] = -p[M::force];
        const auto reflected = enumerate<M>(p, {.seed = 2});
        REQUIRE(reflected.real() == r.real());
        for (const auto& e : r.equilibria) {
            const auto f = nearest(reflected, {pi - e.q[0], -e.q[1]});
            CHECK(distance<M>(f.q, {pi - e.q[0], -e.q[1]}) < 1e-10);
            CHECK(f.index == e.index);
        }
    }
}

// Without a force (2.3) reads a cos q1 = b sin q2 = c cos(q1 + q2), with a = (2 m g - c2 l) l, b = m g l, c = c1 l^2:
// four solutions have all three 0, the other two are the angles of a triangle with sides 1/|a|, 1/|b|, 1/|c|.
TEST_CASE("without a force: q1 = +-pi/2 with q2 = 0 or pi, and a pair more where the triangle closes") {
    Generator generator(5);
    int pairs = 0;
    for (int k = 0; k < 60; ++k) {
        auto p = random_parameters(generator);
        p[M::force] = 0;
        const double l = p[M::length], weight = p[M::mass_2] * p[M::gravity];
        const double a = (p[M::mass_1] * p[M::gravity] + weight - p[M::stiffness_2] * l) * l, b = weight * l,
                     c = p[M::stiffness_1] * l * l;
        double sides[] = {1 / std::abs(a), 1 / b, 1 / c};
        std::sort(std::begin(sides), std::end(sides));
        const double slack = (sides[0] + sides[1]) / sides[2] - 1;
        if (std::abs(slack) < 1e-3 || sides[2] > 1e3) continue;
        CAPTURE(a, b, c);
        const auto r = enumerate<M>(p, {.seed = static_cast<std::uint64_t>(k)});
        check_complete(r);
        CHECK(r.real() == (slack > 0 ? 6 : 4));
        pairs += slack > 0;
        for (const double up : {1, -1})
            for (const double down : {1, -1}) {
                const Unknowns<M> q{up * pi / 2, down > 0 ? 0 : pi};
                const auto e = nearest(r, q);
                CHECK(distance<M>(e.q, q) < 1e-10);
                // Hess V = -a up, b down and c up down on and off the diagonal
                const double determinant = -a * b * up * down - a * c * down + b * c * up;
                CHECK((e.index == 1) == (determinant < 0));
                CHECK(e.energy ==
                      Approx(a * up - b * down - c * up * down + (p[M::stiffness_1] + p[M::stiffness_2]) * l * l)
                          .margin(1e-12));
            }
    }
    CHECK(pairs >= 10);
    CHECK(pairs <= 40);
    // Figure 7: the paper's data, where 1/b is longer than the others together
    const auto r = enumerate<M>(M::paper_parameters(0));
    check_complete(r);
    CHECK(r.real() == 4);
    CHECK(r.equilibria[0].q[0] == Approx(pi / 2));
    CHECK(std::abs(r.equilibria[0].q[1]) < 1e-12);
}

TEST_CASE("without a force, the pair comes and goes at four pitchforks with c2 in closed form") {
    // at q1 = up pi/2, cos q2 = down: det Hess V = 0 where a = b c up down / (b up + c)
    auto p = M::paper_parameters(0);
    const double l = p[M::length], weight = p[M::mass_2] * p[M::gravity];
    const double b = weight * l, c = p[M::stiffness_1] * l * l;
    for (const double up : {1, -1})
        for (const double down : {1, -1}) {
            const double a = b * c * up * down / (b * up + c), stiffness = (2 * weight - a / l) / l;
            CAPTURE(stiffness);
            std::vector<std::uint64_t> counts;
            for (const double side : {-1e-3, 1e-3}) {
                p[M::stiffness_2] = stiffness + side;
                const auto r = enumerate<M>(p);
                check_complete(r);
                counts.push_back(r.real());
            }
            std::sort(counts.begin(), counts.end());
            CHECK(counts == std::vector<std::uint64_t>{4, 6});
        }
}
