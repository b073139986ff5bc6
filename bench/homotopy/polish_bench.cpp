// Polishing of endpoints, three Newton steps on the model's own function and the condition number: in lanes and alone.
// Items are endpoints.
#include <benchmark/benchmark.h>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polish.hpp>

#include "../support.hpp"

using namespace equilibria;

namespace {

template <int N, class R>
void polish(benchmark::State& state) {
    using M = Chain<N>;
    constexpr int width = LaneTraits<R>::width;
    Generator generator(1);
    const ModelSystem<M> target(benchmark_chain<N>());
    const PolynomialHomotopy h = model_homotopy(target, Reflected<M>(target, generator));
    const detail::Polisher polisher(h);
    detail::Polisher<PolynomialHomotopy>::Workspace<R> with(h);
    auto straight = point_of_zeros<RuntimeUnknowns, R>(h.sizes());  // theta = 0, a little off
    for (int i = 0; i < N; ++i) {
        straight.c[i] = Complex<R>(std::cos(1e-7));
        straight.s[i] = Complex<R>(std::sin(1e-7));
    }
    PolishedEvidence evidence[width];
    for (auto _ : state) {
        auto q = straight;
        benchmark::DoNotOptimize(q);
        polisher.run(q, evidence, with);
        benchmark::DoNotOptimize(evidence);
    }
    state.SetItemsProcessed(state.iterations() * width);
}
template <int N>
void polish_lanes(benchmark::State& state) {
    polish<N, Lanes<native_lanes>>(state);
}
template <int N>
void polish_alone(benchmark::State& state) {
    polish<N, double>(state);
}

BENCHMARK_TEMPLATE(polish_lanes, 4);
BENCHMARK_TEMPLATE(polish_alone, 4);
BENCHMARK_TEMPLATE(polish_lanes, 8);
BENCHMARK_TEMPLATE(polish_alone, 8);

}  // namespace
