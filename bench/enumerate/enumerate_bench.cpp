// The whole enumeration of the benchmark chain on one thread. Counters: all 4^n paths over the seconds of tracking and
// over all seconds (half of them are mirror images of others), steps a path.
#include <benchmark/benchmark.h>

#include <equilibria/enumerate/enumerate.hpp>

#include "../support.hpp"

namespace {

template <int N>
void chain(benchmark::State& state) {
    const auto p = benchmark_chain<N>();
    double paths = 0, tracking = 0, seconds = 0, steps = 0, tracked = 0;
    for (auto _ : state) {
        const auto r = equilibria::enumerate<Chain<N>>(p);
        if (!r.clean()) state.SkipWithError("not clean");
        paths += static_cast<double>(r.paths.total);
        tracked += static_cast<double>(r.paths.tracked);
        steps += static_cast<double>(r.paths.steps);
        tracking += r.tracking_seconds;
        seconds += r.seconds;
    }
    state.counters["paths/s_tracking"] = paths / tracking;
    state.counters["paths/s"] = paths / seconds;
    state.counters["steps/path"] = steps / tracked;
}

BENCHMARK_TEMPLATE(chain, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 4)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 5)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 6)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 7)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(chain, 8)->Unit(benchmark::kMillisecond);

}  // namespace
