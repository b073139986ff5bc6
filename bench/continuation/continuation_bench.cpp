// Branches and fold curves followed with all their events; items are points of the branch. The arguments of the chain
// of springs are links.
#include <benchmark/benchmark.h>

#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "../../programs/support/structures.hpp"

using namespace equilibria;
using support::VectorXd;

namespace {

/// Tolerance and lengths of steps as in AUTO-07p's runs of many short steps (bench/peers/continuation): as many points,
/// each to 1e-7.
void many_short_steps(ContinuationOptions& options, double largest_step) {
    options.branch.tolerance = 1e-7;
    options.branch.first_step = 1e-3;
    options.branch.largest_step = largest_step;
}

/// The star dome of bench/peers/continuation, from the unloaded state through its fold; largest_step: 0 for the usual
/// one.
void follow_star_dome(benchmark::State& state, double largest_step) {
    const auto dome = support::star_dome(0.5, 1);
    ContinuationOptions options;
    options.range.low = -1e-3;
    options.range.high = 2e-3;
    if (largest_step > 0) many_short_steps(options, largest_step);
    std::size_t points = 0, events = 0;
    for (auto _ : state) {
        const auto branch = continue_branch(dome, dome.unloaded(), 0, 1, options);
        points += branch.points.size();
        events = branch.events.size();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(points));
    state.counters["events"] = static_cast<double>(events);
}
void star_dome(benchmark::State& state) { follow_star_dome(state, 0); }
void star_dome_short_steps(benchmark::State& state) { follow_star_dome(state, 0.033); }

/// The fold curve of the two-link chain, both ways from a fold at alpha = 0.33, with its cusp.
void follow_fold_curve(benchmark::State& state, double largest_step) {
    using Chain = mechanisms::TwoLinkChain;
    const ModelProblems<Chain, Chain::omega, Chain::alpha> family{{.33, 1.5, 2}};
    ContinuationOptions options;
    options.range.low = 0.01;
    options.range.high = 0.55;
    options.branch.first_step = 1e-3;
    if (largest_step > 0) many_short_steps(options, largest_step);
    const auto member = family(0.33);
    CriticalPointSolver<ModelProblem<Chain, Chain::omega>> solver(member);
    const auto fold = solver.solve(VectorXd(Eigen::Vector2d(1.1, -1.04)), 2.06);
    if (!fold || fold->kind != CriticalKind::fold) return state.SkipWithError("no fold at alpha = 0.33");
    std::size_t points = 0, special = 0;
    for (auto _ : state)
        for (const int direction : {1, -1}) {
            const auto trace = continue_folds(family, *fold, 0.33, direction, options);
            points += trace.branch.points.size();
            special = std::max(special, trace.special.size());
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(points));
    state.counters["special"] = static_cast<double>(special);
}
void chain_fold_curve(benchmark::State& state) { follow_fold_curve(state, 0); }
void chain_fold_curve_short_steps(benchmark::State& state) { follow_fold_curve(state, 0.012); }

/// 200 steps of a straight chain of springs, through its first buckling loads.
void spring_elastica(benchmark::State& state) {
    const support::SpringElastica chain{static_cast<int>(state.range(0))};
    const double critical = chain.buckling_load();
    ContinuationOptions options;
    options.branch.parameter_weight = 1 / critical;
    options.most_steps = 200;
    std::size_t points = 0;
    for (auto _ : state) {
        const auto branch = continue_branch(chain, VectorXd(VectorXd::Zero(chain.links)), 0, 1, options);
        points += branch.points.size();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(points));
}

BENCHMARK(star_dome)->Unit(benchmark::kMillisecond);
BENCHMARK(star_dome_short_steps)->Unit(benchmark::kMillisecond);
BENCHMARK(chain_fold_curve)->Unit(benchmark::kMillisecond);
BENCHMARK(chain_fold_curve_short_steps)->Unit(benchmark::kMillisecond);
BENCHMARK(spring_elastica)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
