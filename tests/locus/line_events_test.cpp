// All events on a line: random chains against enumerations elsewhere, and models whose events are known in closed form.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/stability/morse.hpp>

#include "support/catch.hpp"
#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;
using models::TorquePendulum;
using tests::refusal;

namespace {

/// The two-link chain, its angles measured from other directions: its pitchforks break no symmetry theta -> -theta.
struct TurnedChain {
    static constexpr int n_angles = 2;
    enum Parameter { alpha, ratio, omega, n_parameters };
    static constexpr double from[] = {0.3, -1.1};
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto a = theta[0] - from[0], b = theta[1] - from[1];
        const auto x1 = sin(a), x2 = x1 + p[ratio] * sin(b);
        return -0.5 * p[omega] * p[omega] * ((1 - p[alpha]) * x1 * x1 + p[alpha] * x2 * x2) - cos(a) -
               p[alpha] * p[ratio] * cos(b);
    }
};

/// sin theta (p - sin theta): theta = 0 and pi for all p, crossed at p = 0 by the branch sin theta = p, which folds at
/// +-1.
struct Crossing {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto equations(const auto& theta, const auto& p) const {
        return std::array{sin(theta[0]) * (p[0] - sin(theta[0]))};
    }
};

/// With a potential: theta = 0 for all loads, dF/dtheta = load + a and V''' = -3 b there.
struct CrossingWithPotential {
    static constexpr int n_angles = 1;
    enum Parameter { load, a, b, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        return -p[load] * cos(theta[0]) + 0.5 * p[a] * sin(theta[0]) * sin(theta[0]) +
               p[b] * (0.5 * sin(2 * theta[0]) - sin(theta[0]));
    }
};

/// Symmetric under theta -> pi - theta alone. F = cos theta (k sin theta - load + 3 c (1 - 4 sin^2 theta)).
struct Sideways {
    static constexpr int n_angles = 1;
    enum Parameter { load, k, c, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        return -p[load] * sin(theta[0]) + 0.5 * p[k] * sin(theta[0]) * sin(theta[0]) + p[c] * sin(3 * theta[0]);
    }
};

/// Two equal coupled angles: pitchforks break their exchange, on the branch of equal angles, which moves with the load.
struct Twins {
    static constexpr int n_angles = 2;
    enum Parameter { load, coupling, second, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        return -cos(theta[0]) - cos(theta[1]) - p[load] * (sin(theta[0]) + sin(theta[1])) +
               p[second] * (cos(2 * theta[0]) + cos(2 * theta[1])) - p[coupling] * cos(theta[0] - theta[1]);
    }
};

/// How many events of a kind there are.
template <Model M>
int number(const LineEvents<M>& found, CriticalKind kind) {
    return static_cast<int>(
        std::count_if(found.events.begin(), found.events.end(), [&](const auto& e) { return e.kind == kind; }));
}

/// What holds of every complete result.
template <Model M>
void check_accounts(const LineEvents<M>& found) {
    CAPTURE(found.argument());
    CHECK(found.complete());
    CHECK(found.paths.accounted_for());
    REQUIRE(!found.intervals.empty());
    CHECK(found.intervals.front().low == found.range.low);
    CHECK(found.intervals.back().high == found.range.high);
    for (std::size_t k = 1; k < found.intervals.size(); ++k)
        CHECK(std::abs(found.intervals[k].low - found.intervals[k - 1].high) <= 1e-8);
    double before = found.range.low;
    for (const auto& e : found.events) {
        CHECK(e.value >= before);
        before = e.value;
        CHECK(e.residual < 1e-12);
        REQUIRE((e.interval > 0 && e.interval < found.intervals.size()));
        CHECK(std::abs(e.value - found.intervals[e.interval].low) <= 1e-8);
        double norm2 = 0;
        for (const double x : e.v) norm2 += x * x;
        CHECK(norm2 == Approx(1).epsilon(1e-12));
        for (int i = 0; i < n_angles<M>; ++i) CHECK((e.q[i] > -std::numbers::pi && e.q[i] <= std::numbers::pi));
    }
}

}  // namespace

TEST_CASE("Random three-link chains: every event, the tables those of other enumerations elsewhere") {
    using Chain = mechanisms::RotatingChain<3>;
    for (int set = 0; set < tests::thoroughness; ++set) {
        Generator generator(static_cast<std::uint64_t>(3000 + set));
        Parameters<Chain> p;
        for (int i = 0; i < 3; ++i) p[Chain::length + i] = uniform(generator, 0.5, 2);
        for (int i = 0; i < 3; ++i) p[Chain::mass + i] = uniform(generator, 0.2, 2);
        p[Chain::gravity] = 1;
        const auto found = find_events<Chain, Chain::omega>(p, {0, 10}, {.seed = static_cast<std::uint64_t>(set + 1)});
        CAPTURE(set, found.events.size());
        check_accounts(found);

        // the linear problem of a branch has as many speeds as it has links that hang: 3 2^2 of them, below 10 here
        CHECK(number(found, CriticalKind::pitchfork) == 12);
        CHECK(number(found, CriticalKind::fold) + 12 == static_cast<int>(found.events.size()));
        for (const auto& e : found.events) {
            auto image = e.q;
            for (double& angle : image) angle = -angle;
            CHECK(std::any_of(found.events.begin(), found.events.end(), [&](const auto& other) {
                return other.kind == e.kind && other.change == e.change &&
                       std::abs(other.value - e.value) < 1e-10 * (1 + e.value) &&
                       same_unknowns<Chain>(other.q, image, 1e-8);
            }));
        }

        CHECK(found.intervals.front().by_index == std::vector<std::int64_t>{1, 3, 3, 1});  // of a chain at rest
        for (const auto& i : found.intervals) {
            CAPTURE(i.low, i.high);
            CHECK(i.clean);
            CHECK(morse_relations(i.by_index).all());
            for (int k = 0; k < 2; ++k) {
                p[Chain::omega] = uniform(generator, i.low, i.high);
                const auto other = enumerate<Chain>(p, {.seed = static_cast<std::uint64_t>(777 + set)});
                CAPTURE(p[Chain::omega]);
                CHECK(other.clean());
                CHECK(other.by_index() == i.by_index);
            }
        }
    }
}

TEST_CASE("A pendulum under a torque: two folds, without a symmetry") {
    constexpr int torque = TorquePendulum::torque;
    for (const double stiffness : {0.3, 1.0, 2.5}) {
        const auto found = find_events<TorquePendulum, torque>({0, stiffness}, {-4, 3});
        check_accounts(found);
        REQUIRE(found.events.size() == 2);
        for (int k = 0; k < 2; ++k) {
            const auto& e = found.events[static_cast<std::size_t>(k)];
            const double sign = k == 0 ? -1 : 1;
            CHECK(e.kind == CriticalKind::fold);
            CHECK(e.value == Approx(sign * stiffness).margin(1e-12));
            CHECK(e.q[0] == Approx(sign * std::numbers::pi / 2).margin(1e-12));
            CHECK(e.correction < 1e-14);
            CHECK(e.reduced.third == Approx(-sign * stiffness).margin(1e-12));
            CHECK(e.slope == Approx(-1).margin(1e-12));
        }
        REQUIRE(found.intervals.size() == 3);
        for (std::size_t k = 0; k < 3; ++k) CHECK(found.intervals[k].count == (k == 1 ? 2 : 0));
    }
    const auto none = find_events<TorquePendulum, torque>({0, 1}, {2, 3});
    check_accounts(none);
    CHECK(none.events.empty());
    CHECK(none.intervals.size() == 1);
}

TEST_CASE("A chain measured from other directions has the same events") {
    using Chain = mechanisms::TwoLinkChain;
    const Parameters<Chain> p{0.4, 1.5, 0};
    const auto straight = find_events<Chain, Chain::omega>(p, {0, 5});
    const auto turned =
        find_events<TurnedChain, TurnedChain::omega>({p[0], p[1], p[2]}, {0, 5}, {.seed = 5, .executor = threads(2)});
    check_accounts(straight);
    check_accounts(turned);
    // alpha = .4, computed independently: interval branch and bound, multiprecision
    const double known[] = {.6960675016716,  .90127739195077, 1.1695539717333,
                            1.5143539252415, 2.4293853881739, 2.4293853881739};
    REQUIRE(straight.events.size() == 6);
    REQUIRE(turned.events.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
        const auto& e = straight.events[k];
        CHECK(e.kind == (k < 4 ? CriticalKind::pitchfork : CriticalKind::fold));
        CHECK(e.value == Approx(known[k]).epsilon(1e-12));
        CHECK(turned.events[k].value == Approx(known[k]).epsilon(1e-12));
        CHECK(std::any_of(turned.events.begin(), turned.events.end(), [&](const auto& other) {
            const Unknowns<TurnedChain> q{e.q[0] + TurnedChain::from[0], e.q[1] + TurnedChain::from[1]};
            return std::abs(other.value - e.value) < 1e-10 && same_unknowns<TurnedChain>(other.q, q, 1e-6) &&
                   std::abs(other.reduced.fourth - e.reduced.fourth) < 1e-6;
        }));
    }
    REQUIRE(straight.intervals.size() == 6);
    REQUIRE(turned.intervals.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) CHECK(turned.intervals[k].by_index == straight.intervals[k].by_index);
}

TEST_CASE("Trans-critical points have their name, and leave the tables as they are") {
    const auto found = find_events<Crossing, 0>({0}, {-2, 2.5});
    check_accounts(found);
    REQUIRE(found.events.size() == 4);
    CHECK(number(found, CriticalKind::transcritical) == 2);
    CHECK(number(found, CriticalKind::fold) == 2);
    for (std::size_t k : {1, 2}) {
        CHECK(found.events[k].kind == CriticalKind::transcritical);
        CHECK(found.events[k].value == Approx(0).margin(1e-12));
        CHECK(std::abs(std::sin(found.events[k].q[0])) < 1e-12);
    }
    REQUIRE(found.intervals.size() == 4);
    CHECK(found.intervals[1].by_index == found.intervals[2].by_index);

    const auto other = find_events<CrossingWithPotential, CrossingWithPotential::load>({0, 0.7, 0.3}, {-2, 2.5});
    check_accounts(other);
    REQUIRE(other.events.size() == 3);
    CHECK(number(other, CriticalKind::fold) == 2);
    const auto& e = other.events[1];
    CHECK(e.kind == CriticalKind::transcritical);
    CHECK(e.value == Approx(-0.7).margin(1e-12));
    CHECK(e.q[0] == Approx(0).margin(1e-12));
    CHECK(e.reduced.third == Approx(-0.9).margin(1e-12));
    CHECK(e.slope == Approx(1).margin(1e-12));
    CHECK(e.change == std::vector<std::int64_t>{0, 0});
    REQUIRE(other.intervals.size() == 4);
    CHECK(other.intervals[1].by_index == other.intervals[2].by_index);
}

TEST_CASE("Pitchforks of other symmetries than theta to -theta have their name") {
    const auto sideways = find_events<Sideways, Sideways::load>({0, 1, 0.05}, {-2, 2.5});
    check_accounts(sideways);
    REQUIRE(sideways.events.size() == 4);
    CHECK(number(sideways, CriticalKind::pitchfork) == 2);
    // load = k s + 3 c (1 - 4 s^2) at s = -1 and 1; folds where that is largest, s = k / (24 c)
    const double values[] = {-1.45, 0.55, 0.15 + 5 / 12.0, 0.15 + 5 / 12.0}, slopes[] = {-1, 1};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& e = sideways.events[k];
        CHECK(e.kind == (k < 2 ? CriticalKind::pitchfork : CriticalKind::fold));
        CHECK(e.value == Approx(values[k]).margin(1e-12));
        if (k < 2) CHECK(e.slope == Approx(slopes[k]).margin(1e-9));
    }
    // supercritical and subcritical
    CHECK(sideways.events[0].reduced.fourth == Approx(6.6).margin(1e-9));
    CHECK(sideways.events[1].reduced.fourth == Approx(-0.6).margin(1e-9));

    const auto twins = find_events<Twins, Twins::load>({0, -0.75, 0.1}, {-2, 2.5});
    check_accounts(twins);
    REQUIRE(twins.events.size() == 2);
    for (std::size_t k : {0, 1}) {
        const auto& e = twins.events[k];
        CHECK(e.kind == CriticalKind::pitchfork);
        CHECK(e.q[0] == Approx(e.q[1]).margin(1e-9));
        // the eigenvalue of exchange, cos + load sin - 4 second cos 2 theta + 2 coupling, is 0
        const double a = e.q[0];
        CHECK(std::cos(a) + e.value * std::sin(a) - 0.4 * std::cos(2 * a) - 1.5 == Approx(0).margin(1e-12));
        // along the branch, by central differences of its solutions
        CHECK(e.slope == Approx(k == 0 ? -1.028942969 : 1.028942969).epsilon(1e-8));
    }
}

TEST_CASE(
    "An event at an end of the segment has no interval beyond it, and both signs of a squared parameter are searched") {
    using Chain = mechanisms::TwoLinkChain;
    const Parameters<Chain> p{0.4, 1.5, 0};
    const auto whole = find_events<Chain, Chain::omega>(p, {-3, 3});
    check_accounts(whole);
    REQUIRE(whole.events.size() == 12);
    for (std::size_t k = 0; k < 12; ++k)
        CHECK(whole.events[k].value == Approx(-whole.events[11 - k].value).epsilon(1e-12));
    const double fold = whole.events.back().value;
    const auto below = find_events<Chain, Chain::omega>(p, {0, fold}),
               above = find_events<Chain, Chain::omega>(p, {fold, 3});
    CHECK(below.complete());
    CHECK(above.complete());
    CHECK(below.intervals.size() == 5);
    CHECK(above.intervals.size() == 1);
}

TEST_CASE("A wide segment has the events of a narrow one") {
    using Chain = mechanisms::TwoLinkChain;
    const auto narrow = find_events<Chain, Chain::omega>({0.4, 1.5, 0}, {0, 5});
    const auto wide = find_events<Chain, Chain::omega>({0.4, 1.5, 0}, {0, 500});
    check_accounts(wide);
    REQUIRE(wide.events.size() == narrow.events.size());
    for (std::size_t k = 0; k < wide.events.size(); ++k)
        CHECK(wide.events[k].value == Approx(narrow.events[k].value).epsilon(1e-12));
}

TEST_CASE("A search for events refuses what it cannot do") {
    constexpr int torque = TorquePendulum::torque;
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const auto on = [](double low, double high, const RunOptions& options = {}) {
        return refusal([&] { find_events<TorquePendulum, torque>({0, 1}, {low, high}, options); });
    };
    const std::string range = ": must be finite and run from the smaller to the larger value";
    CHECK(on(1, 1) == "interval = 1:1" + range);
    CHECK(on(2, -1) == "interval = 2:-1" + range);
    CHECK(on(nan, 1) == "interval = nan:1" + range);
    CHECK(on(0, infinity) == "interval = 0:inf" + range);
    std::atomic<bool> cancel = false;
    CHECK(on(0, 1, {.checkpoint = "here"}) == "checkpoint = here: must be empty: it keeps a single enumeration");
    CHECK(on(0, 1, {.cancel = &cancel}) == "cancel = given: must be empty: a search for events cannot be cancelled");
    CHECK(refusal([] { find_events<TorquePendulum, torque>({0, nan}, {0, 1}); }) ==
          "parameters[1] = nan: must be finite");
}
