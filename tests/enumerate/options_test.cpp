// What enumerate refuses, and what it tells while it works.
#include <mutex>
#include <vector>

#include "support/enumeration.hpp"

using namespace equilibria;
using mechanisms::TwoLinkChain;

TEST_CASE("parameters and options out of range are refused with a sentence") {
    const Parameters<TwoLinkChain> p{.3, 1.5, 2};
    const auto solve = [](const Parameters<TwoLinkChain>& q, const TrackerOptions& o = {}) {
        return tests::refusal([&] { enumerate<TwoLinkChain>(q, {}, o); });
    };
    CHECK(solve(p) == "nothing was refused");
    CHECK(solve({.3, std::nan(""), 2}) == "parameters[1] = nan: must be finite");
    CHECK(solve({.3, 1.5, -INFINITY}) == "parameters[2] = -inf: must be finite");
    CHECK(tests::refusal([] { threads(2000); }) == "threads = 2000: must be 0 (all) to 1024");

    const auto tracker = [&](auto change) {
        TrackerOptions o;
        change(o);
        return solve(p, o);
    };
    CHECK(tracker([](auto& t) { t.contraction = 0; }) == "contraction = 0: must be in (0, 0.05]");
    CHECK(tracker([](auto& t) { t.largest_contraction = 1e-4; }).starts_with("largest_contraction = "));
    CHECK(tracker([](auto& t) { t.largest_turn = 1; }) == "largest_turn = 1: must be in (0, 0.5]");
    CHECK(tracker([](auto& t) { t.pole_fraction = 1; }) == "pole_fraction = 1: must be in (0, 1)");
    CHECK(tracker([](auto& t) { t.smallest_step = 0; }) == "smallest_step = 0: must be in (0, 1e-3)");
    CHECK(tracker([](auto& t) { t.endgame_start = 0.5; }) == "endgame_start = 0.5: must be in (0, 0.1)");
    CHECK(tracker([](auto& t) { t.most_steps = 0; }) == "most_steps = 0: must be positive");
    CHECK(tracker([](auto& t) { t.contraction = std::nan(""); }) == "contraction = nan: must be in (0, 0.05]");
}

TEST_CASE("progress is told in order, up to the end") {
    std::vector<std::uint64_t> told;
    std::uint64_t all = 0;
    RunOptions options;
    options.executor = threads(2);
    options.progress = [&](std::uint64_t done, std::uint64_t of) { told.push_back(done), all = of; };
    const auto r = enumerate<TwoLinkChain>({.3, 1.5, 2}, options);
    REQUIRE(told.size() >= 2);
    CHECK(told.front() == 0);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.back() == all);
    CHECK(all == r.paths.tracked);
}

TEST_CASE("the result remembers the seed and the parameters") {
    const auto r = enumerate<TwoLinkChain>({.3, 1.5, 2}, {.seed = 12345});
    CHECK(r.seed == 12345);
    CHECK(r.parameters[TwoLinkChain::ratio] == 1.5);
    CHECK(r.seconds >= r.tracking_seconds);
    CHECK(r.tracking_seconds > 0);
}

TEST_CASE("a path that may take few steps fails, is counted and says why") {
    TrackerOptions options;
    options.most_steps = 3;
    const auto r = enumerate<TwoLinkChain>({.3, 1.5, 2}, {}, options);
    tests::check_accounts(r);
    CHECK(r.paths.failed == 12);  // the four that rest need no step
    CHECK_FALSE(r.clean());
    for (const auto& f : r.failures) CHECK(f.reason == FailureReason::too_many_steps);
    std::ostringstream out;
    out << r;
    CHECK(out.str().find("12 failed") != std::string::npos);
}
