// One step of the tracker: the order of its predictor, the law of its step control, what it refuses.
#include <cmath>
#include <limits>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/homotopy/tracker.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using M = mechanisms::RotatingChain<3>;
using H = PolynomialHomotopy;
using Z = Complex<double>;

/// A path of a chain, followed with small steps to t = 0.3.
struct OnAPath {
    ModelSystem<M> target{{1.1, 1.2, 1.3, 1.05, 1.2, 1.45, 1.7, 1}};
    Generator generator{3};
    TotalDegree<M> start{target, generator};
    H h = model_homotopy(target, start);
    TrackerOptions options;
    detail::Stepper<H, double> stepper{h, options};
    RuntimePoint<double> q = point_of_zeros<RuntimeUnknowns, double>(h.sizes());
    double t = 0;

    OnAPath() {
        for (int i = 0; i < 3; ++i) {
            set_lane(q.c[i], 0, start.system().points(i)[2].c);
            set_lane(q.s[i], 0, start.system().points(i)[2].s);
        }
        while (t < 0.3) advance(std::min(0.01, 0.3 - t));
        stepper.expand(q, t);
    }
    void advance(double by) {
        stepper.expand(q, t);
        const auto outcome = stepper.step(q, t, by);
        REQUIRE(outcome.accepted);
        q = outcome.q;
        t += outcome.step;
        if (std::abs(t - 0.3) < 1e-12) t = 0.3;
    }
};

double residual(const OnAPath& path, const RuntimePoint<double>& q, double t) {
    Z f[3];
    H::Evaluation<double, double>(path.h).value(q, t, f);
    double sum = 0;
    for (const Z& z : f) sum += std::sqrt(norm2(z));
    return sum;
}

}  // namespace

TEST_CASE("Taylor coefficients: cutting after the k-th leaves a residual of order k + 1") {
    OnAPath path;
    const auto cut = [&](int k, double h) {
        Z d[3];
        for (int u = 0; u < 3; ++u) {
            d[u] = {0, 0};
            for (int m = k; m >= 1; --m) d[u] = h * (path.stepper.coefficient(m, u) + d[u]);
        }
        return residual(path, moved(path.q, d), path.t + h);
    };
    for (int k = 1; k <= 3; ++k)
        for (const double h : {2e-3, 1e-3}) CHECK(std::log2(cut(k, h) / cut(k, h / 2)) == Approx(k + 1).margin(0.1));
    CHECK(residual(path, path.q, path.t) < 1e-12);
}

TEST_CASE("the predictor's local order is 4: the step that the control proposes does not depend on the step tried") {
    // Theta is proportional to the error of the prediction, so h (target / Theta)^(1/4) is, as h goes to 0, the same
    // for all h; what is left is of first order in h and falls out of 2 P(h/2) - P(h)
    OnAPath path;
    const auto proposed = [&](double h) {
        const auto outcome = path.stepper.step(path.q, path.t, h);
        REQUIRE(outcome.step == h);
        REQUIRE(outcome.next_step < 3.9 * h);  // not cut off
        return outcome.next_step;
    };
    const double limit = 2 * proposed(0.05) - proposed(0.1);
    for (const double h : {0.08, 0.07, 0.06}) CHECK(2 * proposed(h / 2) - proposed(h) == Approx(limit).epsilon(0.01));
}

TEST_CASE("an accepted step is on the path") {
    OnAPath path;
    for (const double h : {1e-6, 1e-4, 1e-2}) {
        const auto outcome = path.stepper.step(path.q, path.t, h);
        REQUIRE(outcome.accepted);
        CHECK(residual(path, outcome.q, path.t + outcome.step) < 1e-10);
        CHECK(outcome.step <= h);
    }
}

TEST_CASE("a step is cut to a part of the distance to the nearest pole") {
    OnAPath path;
    const auto outcome = path.stepper.step(path.q, path.t, 10);
    CHECK(outcome.step < 1);
    CHECK(outcome.next_step > 0);
    TrackerOptions half = path.options;
    half.pole_fraction /= 2;
    detail::Stepper<H, double> stepper(path.h, half);
    stepper.expand(path.q, path.t);
    CHECK(stepper.step(path.q, path.t, 10).step == Approx(outcome.step / 2).epsilon(1e-6));
}

TEST_CASE("a step that predicts badly is refused, and the next one is shorter") {
    // contractions as small as rounding are asked for: no step of this length has one
    OnAPath path;
    TrackerOptions strict = path.options;
    strict.contraction = strict.largest_contraction = 1e-9;
    detail::Stepper<H, double> stepper(path.h, strict);
    stepper.expand(path.q, path.t);
    const auto refused = stepper.step(path.q, path.t, 0.1);
    CHECK_FALSE(refused.accepted);
    CHECK(refused.next_step <= 0.5 * refused.step);
    // and one that turns an angle too far
    TrackerOptions still = path.options;
    still.largest_turn = 1e-4;
    detail::Stepper<H, double> slow(path.h, still);
    slow.expand(path.q, path.t);
    const auto turned = slow.step(path.q, path.t, 0.1);
    CHECK_FALSE(turned.accepted);
    CHECK(turned.next_step <= 0.5 * turned.step);
}

TEST_CASE("numbers that are not numbers are refused, and the step shrinks") {
    OnAPath path;
    auto q = path.q;
    q.c[1].re = std::numeric_limits<double>::quiet_NaN();
    path.stepper.expand(q, path.t);
    const auto outcome = path.stepper.step(q, path.t, 0.01);
    CHECK_FALSE(outcome.accepted);
    CHECK(outcome.next_step > 0);
    CHECK(outcome.next_step < 0.01);
}

TEST_CASE("a segment of the complex t-plane: there and back") {
    OnAPath path;
    detail::Stepper<H, double, Z, true> stepper(path.h, path.options);
    const auto follow = [&](RuntimePoint<double>& q, Z from, Z by) {
        stepper.set_segment(from, by);
        for (double tau = 0, h = 0.02; tau < 1;) {
            stepper.expand(q, tau);
            const auto outcome = stepper.step(q, tau, std::min(h, 1 - tau));
            h = outcome.next_step;
            REQUIRE(h > 1e-6);
            if (outcome.accepted) q = outcome.q, tau += outcome.step;
            if (tau > 1 - 1e-14) break;
        }
    };
    auto q = path.q;
    follow(q, {0.3, 0}, {0.1, 0.05});
    follow(q, {0.4, 0.05}, {-0.1, -0.05});
    for (int i = 0; i < 3; ++i) {
        CHECK(std::sqrt(norm2(q.c[i] - path.q.c[i])) < 1e-9);
        CHECK(std::sqrt(norm2(q.s[i] - path.q.s[i])) < 1e-9);
    }
}

TEST_CASE("tightened options are valid, and tighter") {
    TrackerOptions o;
    for (int k = 0; k < 5; ++k) {
        const TrackerOptions t = o.tightened();
        CHECK_NOTHROW(t.validate());
        CHECK(t.contraction < o.contraction);
        CHECK(t.pole_fraction < o.pole_fraction);
        CHECK(t.largest_turn < o.largest_turn);
        o = t;
    }
}
