// Bounds, start, paths and proofs of solve.
#include "solve/solution.hpp"

#include <chrono>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace solve {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

Bounds bounds_of(const Input& input) {
    Bounds y{equilibria::total_degree_count(input.system), equilibria::smallest_multihomogeneous_number(input.system)};
    if (input.grouping.empty()) return y;
    const auto number = equilibria::multihomogeneous_number(input.system, input.grouping);
    if (number < y.multihomogeneous.number)
        y.multihomogeneous.number = number, y.multihomogeneous.grouping = input.grouping;
    return y;
}

/// Here each start begins its paths.
equilibria::ComplexRoots<> track(Start start, const Input& input, const Bounds& bounds,
                                 const equilibria::RunOptions& run) {
    switch (start) {
        case Start::multihomogeneous:
            return equilibria::solve_multihomogeneous(input.system, bounds.multihomogeneous.grouping, run, {},
                                                      equilibria::more_digits);
        default: return equilibria::solve_total_degree(input.system, run, {}, equilibria::more_digits);
    }
}

}  // namespace

Choice choose(const Bounds& bounds, std::optional<Start> asked) {
    if (asked) return {*asked, "as --start says"};
    if (bounds.multihomogeneous.number < bounds.total_degree)
        return {Start::multihomogeneous, "fewer paths than the total degree"};
    return {Start::total_degree, "no grouping of the unknowns that was compared has fewer paths"};
}

Solution solve(const Input& input, std::optional<Start> asked, bool prove, const equilibria::RunOptions& run) {
    const auto begin = Clock::now();
    const Bounds bounds = bounds_of(input);
    const Choice choice = choose(bounds, asked);
    equilibria::require(!bounds.multihomogeneous.number.saturated, "system", "a number of paths above 2^62",
                        "must have fewer paths than can be numbered");
    const auto tracking = Clock::now();
    Solution y{bounds, choice, track(choice.start, input, bounds, run), {}, 0, 0};
    y.tracking_seconds = seconds_since(tracking);
    if (prove)
        y.proof = equilibria::prove(input.system, y.found, equilibria::bezout_bounds(input.system),
                                    {.executor = run.executor});
    y.seconds = seconds_since(begin);
    return y;
}

}  // namespace solve
