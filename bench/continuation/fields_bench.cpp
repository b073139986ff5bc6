// Branches of discretised differential equations with all their events, items are points of the branch; and what sparse
// derivatives by coloured duals take, items are unknowns.
#include <benchmark/benchmark.h>

#include <limits>

#include <equilibria/continuation/branch.hpp>

#include "../../programs/support/fields.hpp"

using namespace equilibria;
using Eigen::VectorXd;

namespace {

/// From the small solution through the fold to the large one, both at the parameter `low`.
template <class M>
void follow_field(benchmark::State& state, const M& model, double low,
                  double iterate_from = BranchOptions{}.iterate_from) {
    const auto problem = support::sparse(model);
    const VectorXd zero = VectorXd::Zero(problem.unknowns());
    ContinuationOptions options;
    options.range = {low, 20};
    options.branch.largest_step = 0.5;
    options.branch.iterate_from = iterate_from;
    Branch<std::remove_cv_t<decltype(problem)>> branch;
    for (auto _ : state) branch = continue_branch(problem, zero, low, 1, options);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(branch.points.size()));
    state.counters["events"] = static_cast<double>(branch.events.size());
    state.counters["points"] = static_cast<double>(branch.points.size());
}

/// The grid and the branch of AUTO-07p's demonstration; see bench/peers/continuation.
void bratu_elements(benchmark::State& state) { follow_field(state, support::BratuElements(10, 4), 0.149); }
/// Arguments: dimension, intervals.
void bratu(benchmark::State& state) {
    follow_field(state, support::Bratu(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))),
                 state.range(0) == 1 ? 0.149 : 1);
}

/// The cube with a factorisation for each correction.
void bratu_factored(benchmark::State& state) {
    follow_field(state, support::Bratu(3, static_cast<int>(state.range(0))), 1,
                 std::numeric_limits<double>::infinity());
}

/// The derivatives of Bratu's problem, as `bratu`.
template <class F>
void derivative(benchmark::State& state, const F& f) {
    const auto problem =
        support::sparse(support::Bratu(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
    const VectorXd u = VectorXd::LinSpaced(problem.unknowns(), 0, 1);
    for (auto _ : state) benchmark::DoNotOptimize(f(problem, u));
    state.SetItemsProcessed(state.iterations() * problem.unknowns());
    state.counters["colours"] = problem.colours();
}
void residual(benchmark::State& state) {
    derivative(state, [](const auto& problem, const VectorXd& u) { return problem.residual(u, 1); });
}
void tangent(benchmark::State& state) {
    derivative(state, [](const auto& problem, const VectorXd& u) { return problem.tangent(u, 1); });
}
void tangent_derivative(benchmark::State& state) {
    derivative(state, [](const auto& problem, const VectorXd& u) { return problem.tangent_derivative(u, 1, u); });
}
/// Pattern, colours and all.
void pattern(benchmark::State& state) {
    const support::Bratu model(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    for (auto _ : state) benchmark::DoNotOptimize(support::sparse(model).colours());
    state.SetItemsProcessed(state.iterations() * model.size());
}

}  // namespace

BENCHMARK(bratu_elements)->Unit(benchmark::kMillisecond);
BENCHMARK(bratu)->Args({1, 1000})->Args({2, 32})->Args({2, 64})->Args({3, 10})->Args({3, 24})->Args({3, 32})->Unit(
    benchmark::kMillisecond);
BENCHMARK(bratu_factored)->Arg(24)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(residual)->Args({1, 1000})->Args({2, 100})->Unit(benchmark::kMicrosecond);
BENCHMARK(tangent)->Args({1, 1000})->Args({2, 100})->Unit(benchmark::kMicrosecond);
BENCHMARK(tangent_derivative)->Args({1, 1000})->Args({2, 100})->Unit(benchmark::kMicrosecond);
BENCHMARK(pattern)->Args({1, 1000})->Args({2, 100})->Unit(benchmark::kMicrosecond);
