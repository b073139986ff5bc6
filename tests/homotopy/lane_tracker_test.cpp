// Lanes: each path for itself, whatever the width of the pack, its neighbours and the real type.
#include <array>
#include <numeric>
#include <vector>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree.hpp>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using M = mechanisms::TwoLinkChain;
using Pack = Lanes<native_lanes>;

struct Paths {
    Generator generator{1};
    ModelSystem<M> target{Parameters<M>{.3, 1.5, 2}};
    TotalDegree<M> start{target, generator};
    PolynomialHomotopy h = model_homotopy(target, start);

    template <class R, bool Pivoted = false>
    std::vector<Endpoint> track(const std::vector<std::uint64_t>& paths) const {
        std::vector<Endpoint> ends(paths.size());
        const auto point = [&](std::uint64_t k) { return runtime_point(start.point(k)); };
        track_lanes<R, Pivoted>(h, TrackerOptions{}, std::span(paths), point, std::span(ends));
        return ends;
    }
};

std::vector<std::uint64_t> all_paths() {
    std::vector<std::uint64_t> y(16);
    std::iota(y.begin(), y.end(), 0);
    return y;
}

double distance(const Endpoint& a, const Endpoint& b) {
    double sum = 0;
    for (int i = 0; i < 2; ++i) sum += norm2(a.q.c[i] - b.q.c[i]) + norm2(a.q.s[i] - b.q.s[i]);
    return std::sqrt(sum);
}

bool identical(const Endpoint& a, const Endpoint& b) {
    return distance(a, b) == 0 && a.t == b.t && a.steps == b.steps && a.arrival == b.arrival;
}

}  // namespace

TEST_CASE("every path arrives: in lanes, alone, with either factorisation, in long double") {
    const Paths paths;
    const auto ends = paths.track<Pack>(all_paths());
    const auto check = [&](const std::vector<Endpoint>& others) {
        for (std::size_t k = 0; k < 16; ++k) {
            CHECK(others[k].arrival == Arrival::end);
            CHECK(others[k].t == 1);
            CHECK(distance(ends[k], others[k]) < 1e-10);
        }
    };
    check(ends);
    check(paths.track<double>(all_paths()));
    check(paths.track<Pack, true>(all_paths()));
    check(paths.track<long double, true>(all_paths()));
}

TEST_CASE("a path does not depend on its neighbours: the same bits") {
    const Paths paths;
    const auto together = paths.track<Pack>(all_paths());
    for (std::uint64_t k = 0; k < 16; ++k) CHECK(identical(paths.track<Pack>({k})[0], together[k]));
    auto backwards = all_paths();
    std::reverse(backwards.begin(), backwards.end());
    const auto reversed = paths.track<Pack>(backwards);
    for (std::size_t k = 0; k < 16; ++k) CHECK(identical(reversed[k], together[15 - k]));
}

TEST_CASE("fewer paths than lanes, and none") {
    const Paths paths;
    CHECK(paths.track<Pack>({}).empty());
    CHECK(paths.track<Pack>({5})[0].arrival == Arrival::end);
    CHECK(paths.track<Pack>({3, 5, 7})[2].arrival == Arrival::end);
}

#ifdef __SSE__
TEST_CASE("lanes without a path meet no denormal numbers") {
    constexpr unsigned denormal_operand = 2;  // of MXCSR, which keeps it until it is cleared
    const Paths paths;
    for (std::uint64_t k = 0; k < 16; ++k) {
        _mm_setcsr(_mm_getcsr() & ~denormal_operand);
        const auto ends = paths.track<Pack>({k, (k + 1) % 16, (k + 2) % 16});
        CHECK(ends.size() == 3);
        CHECK((_mm_getcsr() & denormal_operand) == 0);
    }
}
#endif
