// Events of models whose numbers of unknowns are known at run time: those of the model as a type.
#include <cmath>
#include <map>

#include <equilibria/locus/line/line_events_at_run_time.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Pendulums in a row, coupled by springs of a table: a model with data, whose function is no constant expression.
struct Row {
    int n;
    std::map<int, double> stiffness;

    int angles() const { return n; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        for (int i = 0; i < n; ++i) v -= cos(theta[i]);
        for (int i = 1; i < n; ++i) v -= p[0] * stiffness.at(i) * cos(theta[i] - theta[i - 1]);
        return v;
    }
};

}  // namespace

TEST_CASE("a chain at run time has the events of the chain as a type") {
    using M = mechanisms::RotatingChain<2>;
    const RuntimeArray<double> p{1, 1.5, 0.6, 0.4, 0, 1};
    const mechanisms::RuntimeRotatingChain model{2};
    const auto found = find_events(model, p, M::omega, {0, 5});
    const auto typed = find_events<M, M::omega>({1, 1.5, 0.6, 0.4, 0, 1}, {0, 5});
    CHECK(found.complete());
    CHECK(found.argument() == typed.argument());
    REQUIRE(found.events.size() == typed.events.size());
    for (std::size_t k = 0; k < found.events.size(); ++k) {
        CHECK(found.events[k].kind == typed.events[k].kind);
        CHECK(found.events[k].value == Approx(typed.events[k].value).epsilon(1e-12));
        for (int u = 0; u < 2; ++u) CHECK(std::abs(found.events[k].q[u] - typed.events[k].q[u]) < 1e-9);
    }
    REQUIRE(found.intervals.size() == typed.intervals.size());
    for (std::size_t k = 0; k < found.intervals.size(); ++k)
        CHECK(found.intervals[k].by_index == typed.intervals[k].by_index);
}

// V = -cos a - cos b - k cos(b - a) at (0, pi) and (pi, 0): the Hessian is [1 - k, k; k, -1 - k], of determinant -1; at
// (0, 0) it is 1 + 2 k, at (pi, pi) 1 - 2 k: one event for k > 0, at k = 1/2.
TEST_CASE("two coupled pendulums, by a model with data, upright together change their index at k = 1 / 2") {
    const auto found = find_events(Row{2, {{1, 1.0}}}, {0}, 0, {0.1, 2});
    CHECK(found.complete());
    REQUIRE(found.events.size() == 1);
    CHECK(found.events[0].kind == CriticalKind::pitchfork);
    CHECK(found.events[0].value == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("what a search for events at run time refuses") {
    const mechanisms::RuntimeRotatingChain model{1};
    CHECK_THROWS_WITH(find_events(model, {1, 1, 0, 1}, 4, {0, 5}), "active = 4: must be the number of a parameter");
}
