// Bounds, start, paths and proofs of solve.
#include "solve/solution.hpp"

#include <chrono>
#include <utility>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace solve {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

Solution solve(const Input& input, std::optional<equilibria::StartKind> asked, bool prove,
               const equilibria::RunOptions& run) {
    const auto begin = Clock::now();
    auto bounds = equilibria::start_bounds(input.system, {}, true, run);
    if (!input.grouping.empty()) {
        const auto of_file = equilibria::multihomogeneous_number(input.system, input.grouping);
        if (of_file < bounds.multihomogeneous) bounds.multihomogeneous = of_file, bounds.grouping = input.grouping;
    }
    const auto start = equilibria::choose_start(std::move(bounds), asked);
    const auto tracking = Clock::now();
    Solution y{start, equilibria::solve_from_start(input.system, start, run, {}, equilibria::more_digits), {}, 0, 0};
    y.tracking_seconds = seconds_since(tracking);
    if (prove)
        y.proof = equilibria::prove(input.system, y.found, equilibria::proved_bounds(input.system),
                                    {.executor = run.executor, .ranks = run.ranks});
    y.seconds = seconds_since(begin);
    return y;
}

}  // namespace solve
