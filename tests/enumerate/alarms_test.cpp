// The alarms that cost no path, on hand-made sets.
#include <numbers>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/run/threads.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::EqualAngles<3>;  // odd under theta -> -theta
using Complex = std::complex<double>;

Root<M> root(Complex a, Complex b, Complex c, double condition = 10) {
    Root<M> y;
    y.q = {{a, b, c}};
    y.condition = condition;
    return y;
}

/// A random root with its conjugate and the mirror images of both, many times.
RootSet<M> symmetric_set(int orbits) {
    RootSet<M> set;
    Generator generator(9);
    for (int k = 0; k < orbits; ++k) {
        Root<M> r = root(0, 0, 0);
        for (auto& q : r.q) {
            const double re = uniform(generator, -std::numbers::pi, std::numbers::pi);
            q = {re, uniform(generator, -3, 3)};
        }
        for (const double sign : {1.0, -1.0})
            for (const bool conjugated : {false, true}) {
                Root<M> image = r;
                for (auto& q : image.q) q = sign * (conjugated ? std::conj(q) : q);
                set.roots.push_back(image);
            }
    }
    set.paths.total = set.paths.finite = set.roots.size();
    return set;
}

}  // namespace

TEST_CASE("no alarm over a symmetric set, for any number of threads") {
    const auto set = symmetric_set(3000);
    for (const unsigned count : {1u, 3u}) {
        const Alarms a = check_alarms(set, threads(count));
        CHECK_FALSE(a.raised());
        CHECK(a.sentences().empty());
        CHECK((a.conjugates.applied && a.mirror.applied && a.duplicates.applied && a.poincare_hopf.applied));
        CHECK_FALSE(a.trace.applied);
    }
    CHECK(set.clean() == false);  // Morse: no equilibria at all
}

TEST_CASE("each lost root is counted by the symmetries that miss it") {
    auto set = symmetric_set(500);
    set.roots.erase(set.roots.begin() + 777);
    const Alarms a = check_alarms(set);
    CHECK(a.conjugates.value == 1);
    CHECK(a.mirror.value == 1);
    CHECK(a.duplicates.value == 0);
    CHECK(a.conjugates.raised());
    CHECK(a.sentences() == "1 roots lack their complex conjugate; 1 roots lack their image under theta -> -theta");
}

TEST_CASE("an image is as near in each unknown as roots are exact, not only in sums") {
    auto set = symmetric_set(100);
    set.roots[40].q[1] += 3e-9;  // roots are exact to 1e-9 and 1e-13 times their condition
    const Alarms a = check_alarms(set);
    CHECK(a.conjugates.value == 2);
    CHECK(a.mirror.value == 2);
}

TEST_CASE("angles are compared modulo 2 pi") {
    constexpr double pi = std::numbers::pi;
    RootSet<M> set;
    set.roots = {root(pi, 0, pi), root({pi - 1e-13, 1}, 0, 0), root({-pi, -1}, 0, 0)};
    const Alarms a = check_alarms(set);
    CHECK(a.conjugates.value == 0);
    CHECK(a.mirror.value == 0);
}

TEST_CASE("duplicates are closer than their condition allows") {
    auto set = symmetric_set(50);
    Root<M> twin = set.roots[10];
    twin.q[1] += 1e-8;
    set.roots.push_back(twin);
    CHECK(check_alarms(set).duplicates.value == 2);
    // close to a fold two regular roots are about 1 / condition apart
    RootSet<M> fold;
    fold.roots = {root(0.1, 0.2, 0.3, 1e7), root(0.1 + 1e-7, 0.2, 0.3, 1e7)};
    CHECK(check_alarms(fold).duplicates.value == 0);
    fold.roots[1].q[0] = 0.1 + 1e-11;
    CHECK(check_alarms(fold).duplicates.value == 2);
    for (auto& r : fold.roots) r.status = PathStatus::singular;
    CHECK(check_alarms(fold).duplicates.value == 0);
}

TEST_CASE("Poincare-Hopf counts the equilibria, where it applies") {
    RootSet<M> set;
    set.equilibria.resize(3);
    set.equilibria[1].index = 1;
    const Alarms odd = check_alarms(set);
    CHECK(odd.poincare_hopf.raised());
    CHECK(odd.poincare_hopf.value == 1);
    CHECK(odd.sentences() == "the sum of (-1)^index is 1, on a torus it is 0");
    set.equilibria[2].index = 3;
    CHECK(check_alarms(set).poincare_hopf.value == -1);
    set.equilibria[2].nullity = 1;
    CHECK_FALSE(check_alarms(set).poincare_hopf.applied);
    RootSet<models::ElasticPendulum> with_coordinate;
    CHECK_FALSE(check_alarms(with_coordinate).poincare_hopf.applied);
    CHECK_FALSE(check_alarms(with_coordinate).mirror.applied);
    // a value that is no number raises an alarm
    Alarm nan{true, std::nan(""), 1, {}};
    CHECK(nan.raised());
}
