// The control of contractions: what it accepts, and how the next step follows from the last one.
#include <cmath>
#include <limits>
#include <type_traits>

#include <equilibria/core/lanes.hpp>
#include <equilibria/homotopy/step_control.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

constexpr TrackerOptions options;

/// A step of 0.1 whose second correction is theta times the first one, of 1e-4.
Trial<double> trial(double theta) {
    const double first = 1e-4;
    return {0.1, 0.1, 1e-8, first * first, theta * theta * first * first, 0};
}

}  // namespace

TEST_CASE("A step is accepted where the correction contracts enough") {
    const ContractionControl<double, 4> control(options);
    CHECK(control.judge(trial(0.5 * options.largest_contraction)).accepted);
    CHECK_FALSE(control.judge(trial(2 * options.largest_contraction)).accepted);
    auto turned = trial(1e-3);
    turned.turn2 = 1.1 * options.largest_turn * options.largest_turn;
    CHECK_FALSE(control.judge(turned).accepted);
    auto far = trial(1e-3);
    far.first2 = 0.02, far.second2 = 0;
    CHECK_FALSE(control.judge(far).accepted);
    auto noise = trial(1);  // both corrections are rounding
    noise.noise2 = 1e10 * noise.second2;
    CHECK(control.judge(noise).accepted);
}

TEST_CASE("A step without a second correction makes the next one four times as long, however tight the target") {
    TrackerOptions tight = options;
    for (int round = 0; round < 4; ++round, tight = tight.tightened()) {
        CHECK(ContractionControl<double, 4>(tight).judge(trial(0)).next_step == Approx(0.4));
        // floats as well, without numbers below their range
        const auto first = FloatLanes<4>{} + 1e-9;
        const Trial<FloatLanes<4>> single{first + 0.1, first + 0.1, first, first, FloatLanes<4>{}, FloatLanes<4>{}};
        const auto verdict = ContractionControl<FloatLanes<4>, 4>(tight).judge(single);
        CHECK(lane(verdict.next_step, 2) == Approx(0.4));
    }
}

TEST_CASE("The next step brings the contraction to its target") {
    // with Theta by^order times the target it is 1 / by times as long
    const auto check = [&]<int local_order>(std::integral_constant<int, local_order>) {
        const ContractionControl<double, local_order> control(options);
        for (const double by : {0.5, 1.0, 1.9}) {
            const auto verdict = control.judge(trial(options.contraction * std::pow(by, local_order)));
            CHECK(verdict.accepted);
            CHECK(verdict.next_step == Approx(0.1 / by));
        }
    };
    check(std::integral_constant<int, 1>());
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
    check(std::integral_constant<int, 4>());
    const ContractionControl<double, 4> fourth(options);
    // never beyond four times or, where it was refused, a half; at least a quarter
    CHECK(fourth.judge(trial(0)).next_step == Approx(0.4));
    CHECK(fourth.judge(trial(options.largest_contraction * 1.01)).next_step <= 0.05);
    CHECK(fourth.judge(trial(1e9)).next_step == Approx(0.025));
}

TEST_CASE("Large turns and poles bound a step") {
    const ContractionControl<double, 4> control(options);
    auto turned = trial(0);
    turned.turn2 = std::pow(0.8 * options.largest_turn, 2);
    CHECK(control.judge(turned).next_step == Approx(0.1));
    CHECK(control.longest(0.01) == Approx(options.pole_fraction * 0.01));
    CHECK(control.first(10.0) == Approx(0.4));
    CHECK(control.first(0.01) == Approx(options.pole_fraction * 0.01));
}

TEST_CASE("What is not finite is refused and the step shortened") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ContractionControl<double, 4> control(options);
    for (double Trial<double>::* part : {&Trial<double>::turn2, &Trial<double>::first2, &Trial<double>::second2}) {
        auto broken = trial(1e-3);
        broken.*part = nan;
        const auto verdict = control.judge(broken);
        CHECK_FALSE(verdict.accepted);
        CHECK(verdict.next_step > 0);
        CHECK(verdict.next_step <= 0.05);
    }
}

TEST_CASE("Each lane is judged as it would be alone") {
    using R = Lanes<2>;
    const ContractionControl<R, 4> control(options);
    const ContractionControl<double, 4> alone(options);
    const auto a = trial(1e-4), b = trial(0.5);
    const auto both = [](double x, double y) { return R{x, y}; };
    const auto verdict = control.judge({both(a.step, b.step), both(a.asked, b.asked), both(a.turn2, b.turn2),
                                        both(a.first2, b.first2), both(a.second2, b.second2), both(0, 0)});
    CHECK(mask_lane(verdict.accepted, 0) == alone.judge(a).accepted);
    CHECK(mask_lane(verdict.accepted, 1) == alone.judge(b).accepted);
    CHECK(lane(verdict.next_step, 0) == alone.judge(a).next_step);
    CHECK(lane(verdict.next_step, 1) == alone.judge(b).next_step);
}
