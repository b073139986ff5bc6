// What a step of the tracker is made of, in lanes: the Jacobian of the homotopy, linear systems, and a whole
// predictor-corrector step. Items are paths.
#include <benchmark/benchmark.h>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/homotopy/tracker.hpp>
#include <equilibria/start/total_degree.hpp>

#include "../support.hpp"

using namespace equilibria;

namespace {

using R = Lanes<native_lanes>;
using H = PolynomialHomotopy;

template <int N>
struct Setting {
    using M = Chain<N>;
    Generator generator{1};
    ModelSystem<M> target{benchmark_chain<N>()};
    H h = model_homotopy(target, Reflected<M>(target, generator));
    RuntimePoint<R> q = point_of_zeros<RuntimeUnknowns, R>(h.sizes());

    Setting() {
        for (int k = 0; k < native_lanes; ++k)
            for (int i = 0; i < N; ++i) {
                const std::complex<double> theta(uniform(generator, -3, 3), uniform(generator, -0.5, 0.5));
                set_lane(q.c[i], k, std::cos(theta));
                set_lane(q.s[i], k, std::sin(theta));
            }
    }
};

void count(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * native_lanes); }

template <int N>
void jacobian(benchmark::State& state) {
    Setting<N> s;
    H::Evaluation<R, R> evaluation(s.h);
    Complex<R> f[N], j[N][N];
    const R t = broadcast<R>(0.3);
    for (auto _ : state) {
        benchmark::DoNotOptimize(s.q);
        evaluation.jacobian(s.q, t, f, j);
        benchmark::DoNotOptimize(j);
    }
    count(state);
}

template <int N, class Factorization>
void solve(benchmark::State& state) {
    Generator generator(2);
    Complex<R> a[N][N], b[N];
    for (int r = 0; r < N; ++r)
        for (int c = r; c < N; ++c)
            for (int k = 0; k < native_lanes; ++k) {
                set_lane(a[r][c], k, {uniform(generator, -1, 1), uniform(generator, -1, 1)});
                set_lane(a[c][r], k, lane(a[r][c], k));
            }
    Factorization lu(N);
    for (auto _ : state) {
        benchmark::DoNotOptimize(a);
        lu.factor(a);
        for (int i = 0; i < N; ++i) b[i] = a[0][i];
        lu.solve(b);
        benchmark::DoNotOptimize(b);
    }
    count(state);
}
template <int N>
void solve_symmetric(benchmark::State& state) {
    solve<N, SymmetricFactorization<R>>(state);
}
template <int N>
void solve_pivoted(benchmark::State& state) {
    solve<N, PivotedFactorization<R>>(state);
}

template <int N>
void step(benchmark::State& state) {
    Setting<N> s;
    detail::Stepper<H, R> stepper(s.h, TrackerOptions{});
    const R t = broadcast<R>(0.3), by = broadcast<R>(1e-6);
    for (auto _ : state) {
        auto q = s.q;
        benchmark::DoNotOptimize(q);
        stepper.expand(q, t);
        auto outcome = stepper.step(q, t, by);
        benchmark::DoNotOptimize(outcome);
    }
    count(state);
}

BENCHMARK_TEMPLATE(jacobian, 4);
BENCHMARK_TEMPLATE(jacobian, 8);
BENCHMARK_TEMPLATE(solve_symmetric, 4);
BENCHMARK_TEMPLATE(solve_pivoted, 4);
BENCHMARK_TEMPLATE(solve_symmetric, 8);
BENCHMARK_TEMPLATE(solve_pivoted, 8);
BENCHMARK_TEMPLATE(step, 4);
BENCHMARK_TEMPLATE(step, 8);

}  // namespace
