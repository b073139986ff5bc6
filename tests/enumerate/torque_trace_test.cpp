// The trace test, and the alarms that cost no path, on sets with a planted fault: a chain, whose bound is sharp, and
// coupled angles, whose bound (64) is not (20).
#include <algorithm>
#include <sstream>

#include <equilibria/enumerate/torque_trace.hpp>

#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

template <class M>
void remove(RootSet<M>& set, std::uint64_t path) {
    std::erase_if(set.roots, [&](const auto& r) { return r.path == path; });
    std::erase_if(set.equilibria, [&](const auto& e) { return e.path == path; });
}

template <class M>
void check_trace(const RootSet<M>& set, bool raised) {
    const Alarm trace = torque_trace(set);
    CAPTURE(trace.sentence);
    REQUIRE(trace.applied);
    CHECK(trace.raised() == raised);
    if (!raised) CHECK(trace.value < 1e-13);
    if (raised) CHECK(trace.value > 1e-7);
}

/// Poincare-Hopf, conjugates, mirror images, duplicates: which of them are raised.
using Cheap = std::array<bool, 4>;
template <class M>
Cheap cheap(const RootSet<M>& set) {
    const Alarms a = check_alarms(set, threads(2));
    return {a.poincare_hopf.raised(), a.conjugates.raised(), a.mirror.raised(), a.duplicates.raised()};
}

/// symmetric: theta -> -theta maps roots to roots.
template <class M>
void check_faults(const RootSet<M>& whole, bool symmetric) {
    REQUIRE(whole.clean());
    check_trace(whole, false);
    CHECK(cheap(whole) == Cheap{false, false, false, false});
    // a real equilibrium that is not its own mirror image, one of the other parity, and a root that is not real
    const auto tilted = [](const auto& e) { return std::abs(std::sin(e.q[0])) > 1e-3; };
    const auto first = std::find_if(whole.equilibria.begin(), whole.equilibria.end(), tilted);
    REQUIRE(first != whole.equilibria.end());
    const auto second = std::find_if(whole.equilibria.begin(), whole.equilibria.end(),
                                     [&](const auto& e) { return tilted(e) && (e.index - first->index) % 2 != 0; });
    REQUIRE(second != whole.equilibria.end());
    const auto complex = std::find_if(whole.roots.begin(), whole.roots.end(),
                                      [](const auto& r) { return std::abs(r.q[0].imag()) > 1e-3; });
    REQUIRE(complex != whole.roots.end());
    {
        INFO("a pair of opposite parity is lost: Poincare-Hopf and the conjugates see nothing");
        auto set = whole;
        remove(set, first->path);
        remove(set, second->path);
        check_trace(set, true);
        CHECK(cheap(set) == Cheap{false, false, symmetric, false});
    }
    {
        INFO("a real root is lost");
        auto set = whole;
        remove(set, first->path);
        check_trace(set, true);
        CHECK(cheap(set) == Cheap{true, false, symmetric, false});
    }
    {
        INFO("a root that is not real is lost");
        auto set = whole;
        remove(set, complex->path);
        check_trace(set, true);
        CHECK(cheap(set) == Cheap{false, true, symmetric, false});
    }
    {
        INFO("a conjugate pair is lost");
        auto set = whole;
        const auto q = complex->q;
        std::erase_if(set.roots, [&](const auto& r) {
            return std::equal(r.q.begin(), r.q.end(), q.begin(), [](const auto& a, const auto& b) {
                return std::min(std::abs(a - b), std::abs(a - std::conj(b))) < 1e-9;
            });
        });
        REQUIRE(set.distinct() + 2 == whole.distinct());
        check_trace(set, true);
        CHECK(cheap(set) == Cheap{false, false, symmetric, false});
    }
    {
        INFO("a root is there twice");
        auto set = whole;
        set.roots.push_back(*complex);
        check_trace(set, true);
        CHECK(cheap(set) == Cheap{false, false, false, true});
    }
    {
        INFO("an equilibrium is there twice, another one is lost: the number of roots is right");
        auto set = whole;
        const auto kept =
            std::find_if(set.roots.begin(), set.roots.end(), [&](const auto& r) { return r.path == first->path; });
        set.roots.push_back(*kept);
        remove(set, second->path);
        REQUIRE(set.distinct() == whole.distinct());
        check_trace(set, true);
        CHECK(cheap(set)[3]);
    }
    {
        INFO("a raised alarm is named, and the set is not clean");
        auto set = whole;
        set.roots.erase(set.roots.begin() + (complex - whole.roots.begin()));
        set.alarms.trace = torque_trace(set);
        set.paths.finite = set.paths.total = set.distinct();
        set.paths.at_infinity = 0;
        CHECK_FALSE(set.clean());
        std::ostringstream out;
        out << set;
        CHECK(out.str().find("ALARM: the sums of z and 1/z") != std::string::npos);
    }
}

}  // namespace

TEST_CASE("planted faults of a chain's roots") {
    check_faults(enumerate<tests::Chain<3>>(tests::benchmark_chain<3>()), true);
}

TEST_CASE("planted faults of the roots of three coupled angles") {
    Generator generator(53);
    Parameters<models::CoupledAngles<3>> p;
    for (double& x : p) x = uniform(generator, 0.3, 1.3);
    const auto whole = enumerate<models::CoupledAngles<3>>(p);
    REQUIRE(whole.distinct() == 20);
    check_faults(whole, false);
}

TEST_CASE("the trace test depends on the seed alone, and says where it does not apply") {
    auto set = enumerate<tests::Chain<3>>(tests::benchmark_chain<3>());
    const auto one = torque_trace(set, {.seed = 7, .executor = threads(1)}),
               two = torque_trace(set, {.seed = 7, .executor = threads(2)});
    CHECK(one.value == two.value);
    CHECK(one.applied);
    CHECK(set.alarms.trace.sentence == "the trace test was not done");
    CHECK_FALSE(set.alarms.trace.applied);
    set.paths.failed = 1;
    CHECK_FALSE(torque_trace(set).applied);
    CHECK_FALSE(torque_trace(set).raised());
    // at rest most paths end at infinity, and no torque brings those solutions back
    const auto at_rest = enumerate<tests::Chain<3>>(tests::benchmark_chain<3>(0));
    REQUIRE(at_rest.distinct() == 8);
    check_trace(at_rest, false);
}
