// The time of whole loci and of all events on a line, with what was found; `complete` is 1 where nothing is left open.
// Planes of three links: mass 3 and omega, off the borders where the model degenerates and up to them.
#include <cstdint>
#include <iostream>

#include <benchmark/benchmark.h>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

using namespace equilibria;

namespace {

using Two = mechanisms::TwoLinkChain;
using Three = mechanisms::RotatingChain<3>;
using Four = mechanisms::RotatingChain<4>;
using Mechanism = mechanisms::HolonomicMechanism;

/// Lengths, masses, omega, gravity.
constexpr Parameters<Three> three_links{1, 1.1, 1.2, 1, 1.05, 1.2, 1, 1};
constexpr Parameters<Four> four_links{1, 1.1, 1.2, 0.9, 1, 1.05, 1.2, 0.8, 1, 1};
constexpr int mass_3 = Three::mass + 2;

template <Model M, int X, int Y>
void plane(benchmark::State& state, const Parameters<M>& p, const Window& window, MoreDigits<> digits = nullptr) {
    Locus<M> locus;
    for (auto _ : state) locus = trace_locus<M, X, Y>(p, window, {.executor = threads(0)}, {}, digits);
    const auto& e = locus.evidence;
    std::uint64_t paths = 0;
    for (const auto& [kind, counts] : e.solved) paths += counts.paths.total;
    using Kind = SingularityKind;
    state.counters["paths"] = static_cast<double>(paths);
    state.counters["curves"] = static_cast<double>(locus.curves.size());
    state.counters["cusps"] = static_cast<double>(locus.of(Kind::cusp).size());
    state.counters["extremal"] = static_cast<double>(locus.of(Kind::extremal_fold, Kind::extremal_pitchfork).size());
    state.counters["degenerate_pitchforks"] = static_cast<double>(locus.of(Kind::tricritical_pitchfork).size());
    state.counters["regions"] = static_cast<double>(locus.regions.size());
    state.counters["complete"] = e.complete();
    std::cerr << locus.argument() << '\n';
}

template <Model M, int X>
void line(benchmark::State& state, const Parameters<M>& p, double low, double high) {
    LineEvents<M> found;
    for (auto _ : state) found = find_events<M, X>(p, {low, high}, {.executor = threads(0)});
    state.counters["events"] = static_cast<double>(found.events.size());
    state.counters["complete"] = found.complete();
}

void events_two_links(benchmark::State& state) { line<Two, Two::omega>(state, {0.33, 1.5, 1}, 0, 10); }
void events_three_links(benchmark::State& state) { line<Three, Three::omega>(state, three_links, 0, 10); }
void events_four_links(benchmark::State& state) { line<Four, Four::omega>(state, four_links, 0, 10); }
void plane_two_links(benchmark::State& state) {
    plane<Two, Two::alpha, Two::omega>(state, {0.5, 1.5, 1}, {0, 1, 0, 5});
}
void plane_mechanism(benchmark::State& state) {
    plane<Mechanism, Mechanism::stiffness_2, Mechanism::force>(state, Mechanism::paper_parameters(0),
                                                               {{0, 600}, {-300, 300}});
}
void plane_three_links(benchmark::State& state) {
    plane<Three, mass_3, Three::omega>(state, three_links, {0.1, 2, 0.5, 5}, more_digits);
}
void plane_three_links_up_to_the_borders(benchmark::State& state) {
    plane<Three, mass_3, Three::omega>(state, three_links, {0, 2, 0, 5}, more_digits);
}

}  // namespace

BENCHMARK(events_two_links)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(events_three_links)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(events_four_links)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(plane_two_links)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(plane_mechanism)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(plane_three_links)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(plane_three_links_up_to_the_borders)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
