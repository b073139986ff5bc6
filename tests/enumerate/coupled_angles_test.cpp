// Models of coupled angles at run time have the numbers of equilibria that their graphs of couplings give.
#include <cstdint>
#include <string>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/prove.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;

namespace {

template <class T>
void check(const T& model, const RuntimeArray<double>& p, std::int64_t roots) {
    const auto set = enumerate(model, p, {.seed = 2});
    CHECK(set.paths.accounted_for());
    CHECK(set.paths.failed == 0);
    CHECK(static_cast<std::int64_t>(set.distinct()) == roots);
    CHECK(prove(model, set).distinct == set.distinct());
}

}  // namespace

TEST_CASE("loaded angles, each coupled with each or with the next, have as many equilibria as is known") {
    for (int n = 2; n <= 4; ++n) {
        const families::LoadedAngles all{n, families::complete(n)}, next{n, families::row(n)};
        check(all, families::generic(all.parameters(), 8), families::known_roots("loaded-" + std::to_string(n)));
        check(next, families::generic(next.parameters(), 9), families::known_roots("row-" + std::to_string(n)));
    }
}

TEST_CASE("oscillators on complete graphs and on cycles have as many states of rest as is known") {
    for (int n = 3; n <= 5; ++n) {
        const families::Oscillators all{n - 1, families::complete(n)}, ring{n - 1, families::cycle(n)};
        const auto name = [&](const char* family) { return family + std::to_string(n); };
        check(all, families::generic(all.parameters(), 3), families::known_roots(name("kuramoto-")));
        check(ring, families::generic(ring.parameters(), 4), families::known_roots(name("kuramoto-cycle-")));
        check(all, families::equal_couplings(all, 5), families::known_roots(name("kuramoto-equal-")));
    }
}
