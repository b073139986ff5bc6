/// \file
/// The evidence of searches for all complex solutions of systems.
#pragma once

#include <cstdint>

#include <equilibria/paths/path_counts.hpp>

namespace equilibria {

/// The evidence of one search for all complex solutions.
struct SolutionCounts {
    PathCounts paths;             ///< of the last attempt; of several searches their sum
    std::uint64_t searches = 0;   ///< how many were added up
    std::uint64_t attempts = 0;   ///< start systems tried until no path failed
    std::uint64_t solutions = 0;  ///< regular complex ones

    /// Adds the numbers of other searches.
    void add(const SolutionCounts& other) {
        add(other.paths);
        searches += other.searches, attempts += other.attempts, solutions += other.solutions;
    }
    /// Adds how many paths there are and how they ended; what they took is not added up.
    void add(const PathCounts& p) {
        paths.total += p.total, paths.finite += p.finite, paths.at_infinity += p.at_infinity;
        paths.singular += p.singular, paths.failed += p.failed;
    }
};

}  // namespace equilibria
