// Equilibria that come from infinity: where a leading coefficient vanishes, known by the laws of polynomials.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/line/infinity_search.hpp>
#include <equilibria/locus/line/line_events_at_run_time.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Number = std::int64_t;

/// A potential with one parameter, of so many angles and coordinates.
template <class Function>
struct ByPotential {
    int n_angles, n_coordinates;
    Function function;
    int angles() const { return n_angles; }
    int coordinates() const { return n_coordinates; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto& x, const auto& p) const { return function(theta, x, p[0]); }
};
template <class Function>
ByPotential<Function> by_potential(int angles, int coordinates, Function f) {
    return {angles, coordinates, f};
}

/// (a - r_0) (a - r_1) x^3 + c_2 x^2 + c_1 x + c_0 = 0.
struct Cubic {
    std::array<double, 3> c;
    std::array<double, 2> r;
    int angles() const { return 0; }
    int coordinates() const { return 1; }
    int parameters() const { return 1; }
    auto equations(const auto&, const auto& x, const auto& a) const {
        return std::array{(a[0] - r[0]) * (a[0] - r[1]) * x[0] * x[0] * x[0] + c[2] * x[0] * x[0] + c[1] * x[0] + c[0]};
    }
};

template <class T>
BifurcationDiagram<RuntimeUnknowns> diagram_of(const T& model, const Interval& range) {
    const RuntimeModelFunctions<T> functions(model);
    const RuntimeModelPolynomials<T> polynomials(model);
    const SearchedModel searched{&functions, &polynomials, [&](const RuntimeArray<double>& at, const RunOptions& how) {
                                     return count_of(enumerate(model, at, how));
                                 }};
    const auto equilibria = [&](const RuntimeArray<double>& at, const RunOptions& how) {
        return enumerate(model, at, how).equilibria;
    };
    return trace_diagram(searched, equilibria, {1.0}, 0, range);
}

}  // namespace

TEST_CASE("a x^4 - x^2: two minima come from infinity at a = 0") {
    const auto model = by_potential(
        0, 1, [](const auto&, const auto& x, const auto& a) { return a * x[0] * x[0] * x[0] * x[0] - x[0] * x[0]; });
    const auto found = find_events(model, {1.0}, 0, {-1, 3});
    CHECK(found.complete());
    REQUIRE(found.events.size() == 1);
    CHECK(found.events[0].kind == CriticalKind::from_infinity);
    CHECK(std::abs(found.events[0].value) < 1e-15);
    CHECK(found.events[0].at_infinity == std::array<std::uint64_t, 2>{0, 2});
    CHECK(found.events[0].change == std::vector<Number>{2, 0});
    REQUIRE(found.intervals.size() == 2);
    CHECK(found.intervals[0].by_index == std::vector<Number>{0, 1});
    CHECK(found.intervals[1].by_index == std::vector<Number>{2, 1});
    for (const auto& interval : found.intervals) CHECK(interval.confirmed);

    const auto diagram = diagram_of(model, {-1, 3});
    CHECK(diagram.complete());
    CHECK(diagram.pieces.size() == 4);
    int out = 0;
    for (const auto& piece : diagram.pieces) out += piece.ends[0] == PieceEnd::infinity;
    CHECK(out == 2);
}

TEST_CASE("an angle and a coordinate: four equilibria come from infinity, and two folds follow") {
    const auto model = by_potential(1, 1, [](const auto& theta, const auto& x, const auto& a) {
        return 0.25 * a * x[0] * x[0] * x[0] * x[0] - 0.5 * x[0] * x[0] + 0.3 * x[0] * cos(theta[0]);
    });
    const auto found = find_events(model, {1.0}, 0, {-1, 3});
    CHECK(found.complete());
    REQUIRE(found.events.size() == 3);
    CHECK(found.events[0].kind == CriticalKind::from_infinity);
    CHECK(std::abs(found.events[0].value) < 1e-12);
    CHECK(found.events[0].change == std::vector<Number>{2, 2, 0});
    // a x^3 - x +- b = 0 has a double root at 27 a b^2 = 4
    for (const std::size_t k : {1u, 2u}) CHECK(found.events[k].value == Approx(4 / (27 * 0.09)).epsilon(1e-12));
}

TEST_CASE("where a leading coefficient of degree 3 has a simple root one equilibrium goes and one comes") {
    Generator generator(7);
    for (int trial = 0; trial < 10; ++trial) {
        Cubic model{};
        for (double& c : model.c) c = uniform(generator, 0.5, 2) * (trial % 2 == 0 ? 1 : -1);
        model.r = {uniform(generator, -0.8, -0.2), uniform(generator, 0.2, 0.8)};
        const auto found = find_events(model, {0.0}, 0, {-1, 1});
        CHECK(found.complete());
        std::vector<double> values;
        for (const auto& event : found.events) {
            if (event.kind != CriticalKind::from_infinity) continue;
            values.push_back(event.value);
            CHECK(event.at_infinity == std::array<std::uint64_t, 2>{1, 1});
        }
        REQUIRE(values.size() == 2);
        for (const std::size_t k : {0u, 1u}) CHECK(values[k] == Approx(model.r[k]).epsilon(1e-12));
    }
}

TEST_CASE("a double root of a leading coefficient is one event, to ten digits") {
    const auto model = by_potential(0, 1, [](const auto&, const auto& x, const auto& a) {
        return 0.25 * (a - 0.5) * (a - 0.5) * x[0] * x[0] * x[0] * x[0] - 0.5 * x[0] * x[0] + 0.2 * x[0];
    });
    const auto found = find_events(model, {1.0}, 0, {-1, 1.5});
    CHECK(found.complete());
    REQUIRE(found.events.size() == 1);
    CHECK(found.events[0].value == Approx(0.5).epsilon(1e-10));
    CHECK(found.events[0].at_infinity == std::array<std::uint64_t, 2>{2, 2});
}

TEST_CASE("a coordinate that is 0 but for rounding at all equilibria that are counted has the equations' own size") {
    // x = 0 at a = +-.58, where sizes are asked; x^2 (cos t + 4 a^2) sends two equilibria to infinity at a = +-.5
    const auto model = by_potential(1, 1, [](const auto& theta, const auto& x, const auto& a) {
        return 9 * sin(2 * theta[0]) * a * a + (cos(theta[0]) + 4 * a * a) * x[0] * x[0];
    });
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto found = find_events(model, {1.0}, 0, {-1, 1}, {.seed = seed});
        CHECK(found.complete());
        std::vector<double> values;
        for (const auto& event : found.events)
            if (event.kind == CriticalKind::from_infinity) {
                values.push_back(event.value);
                CHECK(event.at_infinity[0] + event.at_infinity[1] == 2);
            }
        REQUIRE(values.size() == 2);
        CHECK(values[0] == Approx(-0.5).epsilon(1e-12));
        CHECK(values[1] == Approx(0.5).epsilon(1e-12));
        CHECK(found.intervals.back().by_index == std::vector<Number>{2, 2, 0});
    }
}

TEST_CASE("a diagram whose middle loses its equation has both halves") {
    const auto model =
        by_potential(0, 1, [](const auto&, const auto& x, const auto& a) { return a * (0.5 * x[0] * x[0] - x[0]); });
    const auto diagram = diagram_of(model, {-1, 1});
    REQUIRE(diagram.pieces.size() == 2);
    for (const auto& piece : diagram.pieces)
        for (const auto& point : piece.points) CHECK(point.q[0] == Approx(1).epsilon(1e-12));
}

TEST_CASE("a Hessian with a zero diagonal: the branch of a saddle is followed from end to end") {
    const auto model =
        by_potential(0, 2, [](const auto&, const auto& x, const auto& a) { return x[0] * x[1] + a * x[0]; });
    const auto diagram = diagram_of(model, {-0.9, 0.7});
    CHECK(diagram.complete());
    REQUIRE(diagram.pieces.size() == 1);
    const auto& piece = diagram.pieces[0];
    CHECK(piece.ends == std::array{PieceEnd::range, PieceEnd::range});
    CHECK(piece.points.front().parameter == -0.9);
    CHECK(piece.points.back().parameter == 0.7);
    for (const auto& point : piece.points) CHECK(std::abs(point.q[1] + point.parameter) < 1e-12);
}

TEST_CASE("where every state is an equilibrium there is an event, and the branches on both sides are there") {
    const auto model = by_potential(1, 0, [](const auto& theta, const auto&, const auto& a) {
        return a * cos(theta[0]) + a * a * sin(2 * theta[0]);
    });
    const auto diagram = diagram_of(model, {-0.3, 0.3});
    CHECK(diagram.complete());
    REQUIRE(diagram.events.size() == 1);
    CHECK(diagram.events[0].kind == CriticalKind::continuum);
    CHECK(diagram.events[0].value == 0);
    REQUIRE(diagram.pieces.size() == 4);
    for (const auto& piece : diagram.pieces) CHECK(piece.points.size() > 10);
}

TEST_CASE("a root far out that a path of the total degree loses is counted by the polyhedral start") {
    const auto model = by_potential(0, 2, [](const auto&, const auto& x, const auto& a) {
        return -8.0 * x[0] * x[0] * x[0] * x[0] + 0.25 * x[0] * x[0] * x[1] + 11.0 * x[0] * x[1] - 5.0 * x[1] * a;
    });
    // dV/dy: x^2 / 4 + 11 x = 5 a, whose roots are real for a > -24.2; y follows from dV/dx
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        INFO("seed = " << seed);
        const auto found = find_events(model, {1.0}, 0, {-3, -2}, {.seed = seed});
        REQUIRE(found.intervals.size() == 1);
        CHECK(found.intervals[0].count == 2);
    }
}
