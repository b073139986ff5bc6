/// \file
/// The evidence of searches for all complex solutions of systems.
#pragma once

#include <cstdint>

#include <equilibria/paths/path_counts.hpp>

namespace equilibria {

/// The evidence of one search for all complex solutions.
struct SolutionCounts {
    PathCounts paths;  ///< of the last attempt; of several searches their sum
    std::uint64_t searches = 0;
    std::uint64_t attempts = 0;   ///< start systems tried until no path failed
    std::uint64_t solutions = 0;  ///< regular complex ones

    void add(const SolutionCounts& other) {
        add(other.paths);
        searches += other.searches, attempts += other.attempts, solutions += other.solutions;
    }
    void add(const PathCounts& p) {
        paths.total += p.total, paths.finite += p.finite, paths.at_infinity += p.at_infinity;
        paths.singular += p.singular, paths.failed += p.failed;
    }
};

}  // namespace equilibria
