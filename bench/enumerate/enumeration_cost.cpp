// What an enumeration of the benchmark chain takes beside tracking: the time of each of its phases over that of the
// trackers, and of a proof. One thread, the shortest of several runs.
//
//   enumeration_cost LINKS ..
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/paths/merge.hpp>

#include "../chain_parameters.hpp"

using namespace equilibria;

namespace {

enum Phase { set_up, tracking, ending, counting, merging, splitting, classifying, alarming, proving, n_phases };
using Seconds = std::array<double, n_phases>;

/// What `enumerate` does, phase by phase.
Seconds run(int n) {
    Seconds y{};
    detail::Stopwatch clock;
    const auto took = [&](Phase phase) {
        y[phase] = clock.seconds();
        clock = detail::Stopwatch();
    };
    const mechanisms::RuntimeRotatingChain model{n};
    const auto p = chain_parameters(n);
    const RunOptions options;
    const RuntimeFormulation formulation(model);
    const RuntimeModelSystem target(formulation, model, p);
    Generator generator(options.seed);
    const TotalDegreeStart start(TotalDegreeKind::reflected, formulation.sizes(), formulation.degrees(), target.scale,
                                 generator);
    const PolynomialHomotopy homotopy = model_homotopy(model, target, start);
    took(set_up);
    auto paths = detail::track_paths(homotopy, {.start = StartPoints(start)}, options, TrackerOptions{}, nullptr);
    took(ending);
    y[tracking] = paths.effort.tracking_seconds;
    y[ending] -= y[tracking];
    auto [counts, failures] = account_for(paths);
    took(counting);
    std::vector<Root<RuntimeUnknowns>> roots;
    {
        PathSet done = std::move(paths);
        roots = merge(done);
    }
    took(merging);
    auto [isolated, families, regular] = detail::split_families(std::move(roots), homotopy, options.executor);
    took(splitting);
    const detail::RealRuntimeEquations<mechanisms::RuntimeRotatingChain> equations(model, p);
    auto real = detail::classify(isolated, equations, true, options.executor);
    took(classifying);
    RootSet<RuntimeUnknowns> set{.parameters = p,
                                 .seed = options.seed,
                                 .paths = counts,
                                 .roots = std::move(isolated),
                                 .equilibria = std::move(real.equilibria),
                                 .families = {},
                                 .failures = {},
                                 .alarms = {},
                                 .tracking_seconds = y[tracking],
                                 .seconds = 0,
                                 .model = {formulation.sizes(), true, true}};
    set.alarms = check_alarms(set, options.executor);
    took(alarming);
    const auto proof = prove(model, set);
    took(proving);
    if (!proof.complete) std::printf("not proved: %s\n", proof.reason.c_str());
    return y;
}

}  // namespace

int main(int argc, char** argv) {
    std::printf(
        "links  tracking/ms  polish+ends  account  merge  families  classify  alarms  set-up  all but tracking  "
        "prove\n");
    for (int k = 1; k < argc; ++k) {
        const std::string_view text = argv[k];
        int n = 0;
        std::from_chars(text.data(), text.data() + text.size(), n);
        if (n < 2 || n > 12) {
            std::fprintf(stderr, "usage: enumeration_cost LINKS ..  (2 to 12)\n");
            return 2;
        }
        Seconds best = run(n);
        for (int more = n >= 10 ? 0 : n == 9 ? 2 : n == 8 ? 5 : 20; more > 0; --more) {
            const Seconds now = run(n);
            for (std::size_t phase = 0; phase < n_phases; ++phase) best[phase] = std::min(best[phase], now[phase]);
        }
        const double beside = std::accumulate(best.begin(), best.end(), 0.0) - best[tracking] - best[proving];
        const auto share = [&](double seconds) { return 100 * seconds / best[tracking]; };
        std::printf("%5d %12.2f %11.1f%% %7.1f%% %5.1f%% %8.1f%% %8.1f%% %6.1f%% %6.1f%% %16.1f%% %5.0f%%\n", n,
                    1e3 * best[tracking], share(best[ending]), share(best[counting]), share(best[merging]),
                    share(best[splitting]), share(best[classifying]), share(best[alarming]), share(best[set_up]),
                    share(beside), share(best[proving]));
    }
}
