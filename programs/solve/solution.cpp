// Bounds, start, paths and proofs of solve.
#include "solve/solution.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/system/laurent_terms.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace solve {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::optional<std::uint64_t> mixed_volume_of(const equilibria::SparseSystem& system) {
    try {
        return equilibria::mixed_volume(equilibria::affine_supports(system)).value;
    } catch (const equilibria::InvalidArgument&) {
        return {};  // 2^64 or more
    }
}

Bounds bounds_of(const Input& input) {
    Bounds y{equilibria::total_degree_count(input.system), equilibria::smallest_multihomogeneous_number(input.system),
             mixed_volume_of(input.system)};
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
        case Start::polyhedral: return equilibria::solve_polyhedral(input.system, run, {}, equilibria::more_digits);
        default: return equilibria::solve_total_degree(input.system, run, {}, equilibria::more_digits);
    }
}

}  // namespace

Choice choose(const Bounds& bounds, std::optional<Start> asked) {
    if (asked) return {*asked, "as --start says"};
    const auto cost = [](const equilibria::PathCount& paths) {
        return paths.saturated ? std::numeric_limits<double>::infinity() : static_cast<double>(paths.value);
    };
    const double degree = cost(bounds.total_degree), groups = cost(bounds.multihomogeneous.number);
    if (bounds.mixed_volume) {
        // two stages, and cells to be found: as many steps as two or three paths take from other starts
        const double polyhedral = 2.5 * static_cast<double>(*bounds.mixed_volume) + 20;
        if (polyhedral < std::min(degree, groups))
            return {Start::polyhedral, "the mixed volume is so much smaller that two stages of paths cost less"};
    }
    if (groups < degree) return {Start::multihomogeneous, "fewer paths than the total degree"};
    return {Start::total_degree, "no other start that was compared is predicted to cost less"};
}

Solution solve(const Input& input, std::optional<Start> asked, bool prove, const equilibria::RunOptions& run) {
    const auto begin = Clock::now();
    const Bounds bounds = bounds_of(input);
    const Choice choice = choose(bounds, asked);
    equilibria::require(choice.start == Start::polyhedral || !bounds.multihomogeneous.number.saturated, "system",
                        "a number of paths above 2^62", "must have fewer paths than can be numbered");
    const auto tracking = Clock::now();
    Solution y{bounds, choice, track(choice.start, input, bounds, run), {}, 0, 0};
    y.tracking_seconds = seconds_since(tracking);
    if (prove)
        y.proof = equilibria::prove(input.system, y.found, equilibria::proved_bounds(input.system),
                                    {.executor = run.executor});
    y.seconds = seconds_since(begin);
    return y;
}

}  // namespace solve
