#include <algorithm>
#include <complex>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/point.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::ElasticPendulum;  // an angle, a coordinate
using Z = std::complex<double>;

Point<M, double> point(Z theta, Z x) {
    Point<M, double> q;
    set_lane(q.c[0], 0, std::cos(theta));
    set_lane(q.s[0], 0, std::sin(theta));
    set_lane(q.x[0], 0, x);
    return q;
}

Z random(Generator& generator, double re, double im) {
    return {uniform(generator, -re, re), uniform(generator, -im, im)};
}

/// The error of the moved angle, relative to its (c, s), which grow like exp |Im theta|.
double error(const Point<M, double>& q, Z theta) {
    const double size = std::abs(std::cos(theta)) + std::abs(std::sin(theta));
    return (std::abs(lane(q.c[0], 0) - std::cos(theta)) + std::abs(lane(q.s[0], 0) - std::sin(theta))) / size;
}

double off_circle(const Point<M, double>& q) {
    const Z c = lane(q.c[0], 0), s = lane(q.s[0], 0);
    return std::abs(c * c + s * s - 1.0) / (std::norm(c) + std::norm(s));
}

template <class Move>
void check(Move move, double largest, double tolerance) {
    Generator generator(1);
    double worst_angle = 0, worst_circle = 0, worst_coordinate = 0;
    for (int k = 0; k < 1000; ++k) {
        const Z theta = random(generator, 3, 4), x = random(generator, 5, 5);
        const Z d = uniform(generator, 0, largest) * unit_complex(generator), dx = random(generator, 1, 1);
        const Complex<double> step[2] = {{d.real(), d.imag()}, {dx.real(), dx.imag()}};
        const auto q = move(point(theta, x), step);
        worst_angle = std::max(worst_angle, error(q, theta + d));
        worst_circle = std::max(worst_circle, off_circle(q));
        worst_coordinate = std::max(worst_coordinate, std::abs(lane(q.x[0], 0) - (x + dx)));
    }
    CHECK(worst_angle * 1e15 < tolerance * 1e15);  // in units that the report can show
    CHECK(worst_circle * 1e15 < 2);
    CHECK(worst_coordinate * 1e15 < 10);
}

}  // namespace

TEST_CASE("moved turns by the angle and keeps the circle") {
    check([](const auto& q, const auto& d) { return moved<M, double>(q, d); }, 0.5, 1e-9);
    // (c, s) are up to 38 in size here, and c^2 + s^2 - 1 is that much rounding
    check([](const auto& q, const auto& d) { return moved<M, double>(q, d); }, 0.1, 1e-12);
}

TEST_CASE("corrected does so for tiny steps") {
    check([](const auto& q, const auto& d) { return corrected<M, double>(q, d); }, 0.01, 2e-12);
    check([](const auto& q, const auto& d) { return corrected<M, double>(q, d); }, 1e-4, 1e-12);
}

TEST_CASE("corrected roughly, an angle is wrong by the third power of its step, and on the circle") {
    const auto roughly = [](const auto& q, const auto& d) {
        auto moving = runtime_point(q);
        correct_roughly(moving, d);
        Point<M, double> y;
        copy_lane(moving, 0, y, 0);
        return y;
    };
    for (const double largest : {1e-2, 1e-3, 1e-4}) check(roughly, largest, 1.1 * std::pow(largest, 3) / 6 + 1e-12);
}

TEST_CASE("a thousand turns do not leave the circle") {
    Generator generator(2);
    auto q = point({0.3, 0.5}, 0.0);
    Z theta(0.3, 0.5);
    for (int k = 0; k < 1000; ++k) {
        const Z d = random(generator, 0.1, 0.1) - 0.01 * Z(0, theta.imag());
        const Complex<double> step[2] = {{d.real(), d.imag()}, {0, 0}};
        q = moved<M, double>(q, step);
        theta += d;
    }
    CHECK(off_circle(q) < 1e-14);
    CHECK(error(q, theta) < 1e-12);
}

TEST_CASE("a point that is far away is turned without a correction that would be all rounding") {
    const Z theta(1, 12);
    const Complex<double> step[2] = {{1e-3, 2e-3}, {0, 0}};
    const auto q = moved<M, double>(point(theta, 0.0), step);
    CHECK(error(q, theta + Z(1e-3, 2e-3)) < 1e-14);
}

TEST_CASE("no step, no change, and the size of a step") {
    const auto q = point({0.3, 0.5}, 3.0);
    const Complex<double> none[2] = {{0, 0}, {0, 0}}, some[2] = {{0.03, 0.04}, {0.1, 0}};
    CHECK(error(moved<M, double>(q, none), {0.3, 0.5}) * 1e15 < 1);
    CHECK(correction_size(q, none) == 0);
    CHECK(correction_size(q, some) == Approx(0.05 * 0.05));  // of x, 0.1 against 1 + |x|
}

TEST_CASE("lanes are moved each for itself") {
    using R = Lanes<native_lanes>;
    Generator generator(3);
    Point<M, R> pack{};
    Complex<R> steps[2];
    Point<M, double> single[native_lanes];
    for (int k = 0; k < native_lanes; ++k) {
        const Z d = random(generator, 0.2, 0.2), dx = random(generator, 1, 1);
        single[k] = point(random(generator, 3, 3), random(generator, 1, 1));
        copy_lane(single[k], 0, pack, k);
        set_lane(steps[0], k, d);
        set_lane(steps[1], k, dx);
        const Complex<double> step[2] = {{d.real(), d.imag()}, {dx.real(), dx.imag()}};
        single[k] = moved<M, double>(single[k], step);
    }
    pack = moved<M, R>(pack, steps);
    for (int k = 0; k < native_lanes; ++k) {
        CHECK(std::abs(lane(pack.c[0], k) - lane(single[k].c[0], 0)) < 1e-14);
        CHECK(std::abs(lane(pack.s[0], k) - lane(single[k].s[0], 0)) < 1e-14);
        CHECK(std::abs(lane(pack.x[0], k) - lane(single[k].x[0], 0)) < 1e-14);
    }
}
