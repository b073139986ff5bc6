// The predictor and the step control of a homotopy, exchanged: other steps, the same roots.
#include <cmath>
#include <complex>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/homotopy/tracking.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using M = mechanisms::TwoLinkChain;
using H = ModelHomotopy<M, TotalDegree<M>>;

/// Along the tangent.
template <class R, int n>
struct Euler {
    static constexpr int order = 1;
    static constexpr int local_order = 2;
    static Complex<R> change(const Complex<R> (&taylor)[order][n], int u, const R& h) { return h * taylor[0][u]; }
    static R pole(const Complex<R> (&)[order][n]) { return broadcast<R>(1.0); }
};
struct EulerTracking : PadeTracking {
    template <class R, int n>
    using Predictor = Euler<R, n>;
};

/// Steps of half the length that the control of contractions proposes.
template <class R, int local_order>
struct HalfSteps : ContractionControl<R, local_order> {
    using ContractionControl<R, local_order>::ContractionControl;
    R longest(const R& pole) const { return 0.5 * ContractionControl<R, local_order>::longest(pole); }
    Verdict<R> judge(const Trial<R>& trial) const {
        Verdict<R> y = ContractionControl<R, local_order>::judge(trial);
        y.next_step = 0.5 * y.next_step;
        return y;
    }
};
struct HalfTracking : PadeTracking {
    template <class R, int local_order>
    using StepControl = HalfSteps<R, local_order>;
};

struct Chain {
    Generator generator{1};
    ModelSystem<M> target{Parameters<M>{.3, 1.5, 2}};
    TotalDegree<M> start{target, generator};
    H h{target, start};
};

/// What a predictor makes of q(h) = 1 / (2 - h), which has its pole at 2.
template <template <class, int> class Predictor>
double error_at(double h) {
    using P = Predictor<double, 1>;
    Complex<double> taylor[P::order][1];
    for (int k = 0; k < P::order; ++k) taylor[k][0] = {std::pow(0.5, k + 2), 0};
    return std::abs(P::change(taylor, 0, h).re - (1 / (2 - h) - 0.5));
}

/// That q is the sum of two poles: a Pade approximant has one.
template <template <class, int> class Predictor>
double error_of_two_poles(double h) {
    using P = Predictor<double, 1>;
    Complex<double> taylor[P::order][1];
    for (int k = 0; k < P::order; ++k) taylor[k][0] = {std::pow(0.5, k + 2) + std::pow(1 / 3.0, k + 2), 0};
    return std::abs(P::change(taylor, 0, h).re - (1 / (2 - h) - 1 / 2.0 + 1 / (3 - h) - 1 / 3.0));
}

}  // namespace

TEST_CASE("a predictor's error grows with its local order of the step") {
    const auto order = [](double at_h, double at_half) { return std::log2(at_h / at_half); };
    CHECK(order(error_of_two_poles<PadePredictor>(0.02), error_of_two_poles<PadePredictor>(0.01)) ==
          Approx(PadePredictor<double, 1>::local_order).margin(0.1));
    CHECK(order(error_at<Euler>(0.02), error_at<Euler>(0.01)) == Approx(Euler<double, 1>::local_order).margin(0.1));
    // one pole: exact, and found
    CHECK(error_at<PadePredictor>(1) < 1e-15);
    Complex<double> taylor[3][1]{{{0.25, 0}}, {{0.125, 0}}, {{0.0625, 0}}};
    CHECK(PadePredictor<double, 1>::pole(taylor) == Approx(2));
}

TEST_CASE("a step control: the next step makes Theta its target") {
    const TrackerOptions options;
    const auto judge = [&]<int local_order>(std::integral_constant<int, local_order>, double theta, double turn = 0) {
        return ContractionControl<double, local_order>(options).judge({.step = 0.1,
                                                                       .asked = 0.1,
                                                                       .turn2 = turn * turn,
                                                                       .first2 = 1e-6,
                                                                       .second2 = 1e-6 * theta * theta,
                                                                       .noise2 = 0});
    };
    const auto check = [&]<int local_order>(std::integral_constant<int, local_order> order) {
        for (const double by : {0.5, 1.0, 1.9}) {
            const auto verdict = judge(order, options.contraction * std::pow(by, local_order));
            CHECK(verdict.accepted);
            CHECK(verdict.next_step == Approx(0.1 / by));
        }
    };
    check(std::integral_constant<int, 1>());
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
    check(std::integral_constant<int, 4>());
    const std::integral_constant<int, 4> fourth;
    CHECK_FALSE(judge(fourth, 1.1 * options.largest_contraction).accepted);
    CHECK_FALSE(judge(fourth, 0, 1.1 * options.largest_turn).accepted);
    const auto not_a_number = judge(fourth, std::nan(""));
    CHECK_FALSE(not_a_number.accepted);
    CHECK(not_a_number.next_step == Approx(0.025));
    CHECK(ContractionControl<double, 4>(options).longest(2) == options.pole_fraction * 2);
}

TEST_CASE("a homotopy that names another predictor or step control is tracked by it, to the same roots") {
    const Chain chain;
    const auto pade = complex_roots(chain.h, chain.start);
    const auto check = [&](const auto& others) {
        CHECK(others.paths.finite == pade.paths.finite);
        CHECK(others.paths.failed == 0);
        REQUIRE(others.roots.size() == pade.roots.size());
        for (std::size_t k = 0; k < pade.roots.size(); ++k)
            for (int u = 0; u < 2; ++u) {
                const std::complex<double> d = others.roots[k].q[u] - pade.roots[k].q[u];
                CHECK(std::abs(std::complex<double>(wrap(d.real()), d.imag())) < 1e-10);
            }
    };
    const auto euler = complex_roots(TrackedBy<EulerTracking, H>(chain.h), chain.start);
    check(euler);
    CHECK(euler.paths.steps > 2 * pade.paths.steps);  // of lower order
    const auto half = complex_roots(TrackedBy<HalfTracking, H>(chain.h), chain.start);
    check(half);
    CHECK(half.paths.steps > pade.paths.steps);
}
