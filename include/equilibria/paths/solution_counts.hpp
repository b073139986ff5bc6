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
        paths.add(other.paths);
        searches += other.searches, attempts += other.attempts, solutions += other.solutions;
    }
    /// Adds paths alone, see PathCounts::add.
    void add(const PathCounts& other) { paths.add(other); }
};

}  // namespace equilibria
