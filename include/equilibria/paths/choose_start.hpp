/// \file
/// Which start system: that of the least predicted cost, of those that reach every isolated solution of a system.
///
/// A total-degree start needs nothing but degrees, and its paths that go to infinity are most of them where equations
/// are sparse; a linear-product start has fewer of them, where unknowns form groups; a polyhedral start has as many
/// paths as the mixed volume, in two stages. What is compared is the number of paths times what a path costs on the
/// average, in paths from a total-degree start to finite solutions. Where the mixed volume is not needed to be known it
/// is not computed to its end: the walk over its cells stops when it is too large to pay.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Where the paths begin.
enum class StartKind {
    total_degree,      ///< products of random lines; of a model that is odd under theta -> -theta an odd system
    multihomogeneous,  ///< products of linear forms, for groups of unknowns
    polyhedral,        ///< the roots of a system with the same supports and generic coefficients
    monodromy  ///< all roots from one, by loops of the constants; never chosen, since nothing bounds what it may miss
};

/// The kind in words, as results name it.
constexpr std::string_view to_string(StartKind kind) {
    constexpr std::array names{"total degree", "multihomogeneous", "polyhedral", "monodromy"};
    return names[static_cast<std::size_t>(kind)];
}

/// Upper bounds of the number of isolated solutions, each the number of paths from a start.
struct StartBounds {
    PathCount total_degree;      ///< number of Bezout
    PathCount multihomogeneous;  ///< of `grouping`
    std::vector<int> grouping;   ///< the group of each unknown
    int highest_degree = 0;      ///< of an equation
    /// Of the supports that count solutions with coordinates 0 as well (affine_supports); nothing where it was not
    /// needed, or is 2^64 or more.
    std::optional<std::uint64_t> mixed_volume;
};

/// A start, and why it was taken.
struct StartChoice {
    StartKind kind = StartKind::total_degree;  ///< the kind of start
    std::string why;                           ///< the numbers of paths that were compared, in a sentence
    StartBounds bounds;                        ///< those the choice was made from
};

/// groupings: to be compared; none: the smallest number of those that smallest_multihomogeneous_number compares. Unless
/// all bounds are asked for, the mixed volume is counted as far as it may pay; a cancelled run counts none. Throws
/// InvalidArgument for a grouping without a group for each unknown.
StartBounds start_bounds(const SparseSystem& system, const std::vector<std::vector<int>>& groupings = {},
                         bool all_bounds = false, const RunOptions& run = {});

/// Of a system whose start from degrees has `tracked` paths to track: that number for both bounds of degrees, and the
/// mixed volume where it is at most `most`.
StartBounds polyhedral_bounds(const SparseSystem& system, const PathCount& tracked, std::uint64_t most,
                              const RunOptions& run = {});

/// The start of the least predicted cost; or the one that is asked for.
StartChoice choose_start(StartBounds bounds, std::optional<StartKind> asked = {});

/// The start of clearly the fewest paths, where these are few; else of the least predicted cost. Fewer paths leave less
/// to be explained: with a mixed volume of 0 no root is isolated, and the total degree is taken, which meets all
/// curves.
StartChoice fewest_paths(StartBounds bounds, std::optional<StartKind> asked = {});

/// Every isolated solution of the system, from that start; of monodromy those that it found, with a caution. Throws
/// InvalidArgument where there are more paths than can be numbered.
ComplexRoots<> solve_from_start(const SparseSystem& system, const StartChoice& start, const RunOptions& run = {},
                                const TrackerOptions& options = {}, MoreDigits<> resort = nullptr);

/// The same from the least costly of a total-degree start, one for that grouping, and a polyhedral start.
ComplexRoots<> solve_least_cost(const SparseSystem& system, const std::vector<int>& grouping,
                                const RunOptions& run = {}, const TrackerOptions& options = {},
                                MoreDigits<> resort = nullptr);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/choose_start_definitions.hpp>
#endif
