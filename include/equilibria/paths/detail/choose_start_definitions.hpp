/// \file
/// See paths/choose_start.hpp.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/monodromy.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/system/laurent_terms.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

namespace detail {

/// What a path of the mixed volume costs, in paths of a total-degree start: its two stages, and the cells. The constant
/// is what liftings take where there are few paths.
inline constexpr double polyhedral_path_cost = 1.2, polyhedral_cost = 20;

EQUILIBRIA_INLINE double cost_of(const PathCount& paths) {
    return paths.saturated ? std::numeric_limits<double>::infinity() : static_cast<double>(paths.value);
}
EQUILIBRIA_INLINE double least_cost_of_degrees(const StartBounds& bounds) {
    return std::min(cost_of(bounds.total_degree), cost_of(bounds.multihomogeneous));
}

/// The largest mixed volume that is predicted to pay.
EQUILIBRIA_INLINE std::uint64_t largest_that_pays(const StartBounds& bounds) {
    const double most = (least_cost_of_degrees(bounds) - polyhedral_cost) / polyhedral_path_cost;
    constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
    return !(most > 0) ? 0 : most < static_cast<double>(largest) ? static_cast<std::uint64_t>(most) : largest;
}

/// Nothing above `most`, or 2^64.
EQUILIBRIA_INLINE std::optional<std::uint64_t> mixed_volume_up_to(std::uint64_t most, const Supports& supports,
                                                                  const RunOptions& run) {
    if (most == 0) return {};
    try {
        const auto volume = mixed_volume(
            supports,
            {.executor = run.executor, .most_volume = most, .cancel = run.ranks.several() ? nullptr : run.cancel});
        return volume.complete ? std::optional(volume.value) : std::nullopt;
    } catch (const InvalidArgument&) {
        return {};  // 2^64 or more
    }
}

}  // namespace detail

EQUILIBRIA_INLINE StartBounds start_bounds(const SparseSystem& system, const std::vector<std::vector<int>>& groupings,
                                           bool all_bounds, const RunOptions& run) {
    StartBounds y;
    y.total_degree = y.multihomogeneous = total_degree_count(system);
    y.highest_degree = *std::ranges::max_element(system.degrees());
    y.grouping.assign(system.degrees().size(), 0);
    const auto compare = [&](const PathCount& number, const std::vector<int>& grouping) {
        if (number < y.multihomogeneous) y.multihomogeneous = number, y.grouping = grouping;
    };
    if (groupings.empty()) {
        const auto smallest = smallest_multihomogeneous_number(system);
        compare(smallest.number, smallest.grouping);
    }
    for (const auto& grouping : groupings) compare(multihomogeneous_number(system, grouping), grouping);
    y.mixed_volume = detail::mixed_volume_up_to(
        all_bounds ? std::numeric_limits<std::uint64_t>::max() : detail::largest_that_pays(y), affine_supports(system),
        run);
    return y;
}

EQUILIBRIA_INLINE StartBounds polyhedral_bounds(const SparseSystem& system, const PathCount& tracked,
                                                std::uint64_t most, const RunOptions& run) {
    StartBounds y;
    y.total_degree = y.multihomogeneous = tracked;
    y.mixed_volume = detail::mixed_volume_up_to(most, affine_supports(system), run);
    return y;
}

EQUILIBRIA_INLINE StartChoice choose_start(StartBounds bounds, std::optional<StartKind> asked) {
    const double degree = detail::cost_of(bounds.total_degree), groups = detail::cost_of(bounds.multihomogeneous);
    const auto choice = [&]() -> std::pair<StartKind, std::string> {
        if (asked) return {*asked, "asked for"};
        if (bounds.mixed_volume) {
            const auto volume = static_cast<double>(*bounds.mixed_volume);
            if (detail::polyhedral_path_cost * volume + detail::polyhedral_cost < std::min(degree, groups))
                return {StartKind::polyhedral,
                        "the mixed volume is so much smaller that two stages of paths are predicted to cost less"};
        }
        if (groups < degree) return {StartKind::multihomogeneous, "fewer paths than the total degree"};
        return {StartKind::total_degree, "no other start that was compared is predicted to cost less"};
    };
    auto [kind, why] = choice();
    return {kind, std::move(why), std::move(bounds)};
}

EQUILIBRIA_INLINE StartChoice fewest_paths(StartBounds bounds, std::optional<StartKind> asked) {
    constexpr double few = 2000;  // then cells cost little
    const double degrees = detail::least_cost_of_degrees(bounds);
    // of as many paths those in logarithms, where degrees are high
    constexpr double cells_cost_little = 200;
    const double most = bounds.highest_degree > 30     ? degrees
                        : degrees <= cells_cost_little ? degrees - 1
                                                       : 0.8 * degrees;
    if (!asked && bounds.mixed_volume && degrees <= few && static_cast<double>(*bounds.mixed_volume) <= most &&
        *bounds.mixed_volume > 0)
        return {StartKind::polyhedral, "the mixed volume is the smallest number of paths", std::move(bounds)};
    if (!asked && bounds.mixed_volume == 0 && !bounds.total_degree.saturated)
        return {StartKind::total_degree, "its paths lead to curves of solutions, and no root is isolated",
                std::move(bounds)};
    return choose_start(std::move(bounds), asked);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_from_start(const SparseSystem& system, const StartChoice& start,
                                                  const RunOptions& run, const TrackerOptions& options,
                                                  MoreDigits<> resort) {
    if (start.kind == StartKind::polyhedral) return solve_polyhedral(system, run, options, resort);
    if (start.kind == StartKind::monodromy) {
        const SystemFamily family = constants_family(system);
        const auto constants = constants_of(system);
        const auto generic = monodromy(family, constants, run, {}, options);
        auto found = solve_from(generic, family, constants, run, options);
        found.start = to_string(start.kind);
        found.caution = generic.sentence();
        return found;
    }
    if (start.kind == StartKind::total_degree) return solve_total_degree(system, run, options, resort);
    require(!start.bounds.multihomogeneous.saturated, "system", "a multihomogeneous number above 2^62",
            "must have fewer paths than can be numbered");
    return solve_multihomogeneous(system, start.bounds.grouping, run, options, resort);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_least_cost(const SparseSystem& system, const std::vector<int>& grouping,
                                                  const RunOptions& run, const TrackerOptions& options,
                                                  MoreDigits<> resort) {
    return solve_from_start(system, choose_start(start_bounds(system, {grouping}, false, run)), run, options, resort);
}

}  // namespace equilibria
