// Bounds, start, paths and proofs of solve.
#include "solve/solution.hpp"

#include <chrono>
#include <utility>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace solve {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

equilibria::EveryRoot solve(const Input& input, std::optional<equilibria::StartKind> asked, bool prove,
                            const equilibria::RunOptions& run,
                            const std::function<void(const equilibria::PredictedWork&)>& foretell) {
    const auto begin = Clock::now();
    auto bounds = equilibria::start_bounds(input.system, {}, true, run);
    if (!input.grouping.empty()) {
        const auto of_file = equilibria::multihomogeneous_number(input.system, input.grouping);
        if (of_file < bounds.multihomogeneous) bounds.multihomogeneous = of_file, bounds.grouping = input.grouping;
    }
    equilibria::EveryRoot y;
    y.start =
        prove ? equilibria::fewest_paths(std::move(bounds), asked) : equilibria::choose_start(std::move(bounds), asked);
    if (!run.cancelled_anywhere()) foretell(equilibria::predicted_work(input.system, y.start, run));
    if (prove || run.cancelled_anywhere()) {
        const auto start = std::move(y.start);
        y = equilibria::every_root(input.system, start, run);
    } else {
        const auto tracking = Clock::now();
        const auto units = equilibria::unit_scaling(input.system);
        y.found = equilibria::solve_from_start(scaled(input.system, units), y.start, run, {}, equilibria::more_digits);
        y.tracking_seconds = seconds_since(tracking);
        y.seems_real = equilibria::seem_real(y.found.roots, 0);
        for (auto& root : y.found.roots) units.undo({root.q.begin(), root.q.end()});
        y.confirmed.assign(y.found.roots.size(), 0);
        y.verdict.sentence = "nothing was proved: --no-proof was given";
    }
    y.seconds = seconds_since(begin);
    return y;
}

}  // namespace solve
