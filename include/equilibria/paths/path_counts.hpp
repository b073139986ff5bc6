/// \file
/// How many paths ended how: the account that every result gives of its paths.
#pragma once

#include <cstdint>

namespace equilibria {

/// The paths of an enumeration. finite + at_infinity + singular + failed + cancelled == total, always.
struct PathCounts {
    std::uint64_t total = 0;        ///< the bound: all paths, those known by symmetry included
    std::uint64_t finite = 0;       ///< ended at a regular solution
    std::uint64_t at_infinity = 0;  ///< went to infinity
    std::uint64_t singular = 0;     ///< ended at a singular solution, or one that is not isolated
    std::uint64_t failed = 0;       ///< undecided: lost on the way or at the end, see FailureReason
    std::uint64_t cancelled = 0;    ///< not finished, since the run was cancelled: 0 for every run that was not
    std::uint64_t tracked = 0;      ///< paths that were computed; the others are their mirror images, or rest
    std::uint64_t retracked = 0;    ///< paths tracked again, more carefully
    std::uint64_t crossed = 0;      ///< among those: paths that had run into another one's endpoint
    std::uint64_t in_double =
        0;  ///< tracked paths that single precision left to double, those of more_digits not counted
    std::uint64_t more_digits = 0;  ///< paths tracked with more digits than double has (enumerate/more_digits.hpp)
    std::uint64_t steps = 0;        ///< predictor-corrector steps, refused ones included
    /// With so many of the finite paths counted as singular: their endpoints are not isolated.
    PathCounts with_singular(std::uint64_t moved) const {
        PathCounts y = *this;
        y.finite -= moved;
        y.singular += moved;
        return y;
    }
    /// Adds the paths of another run, how they ended and what they took.
    void add(const PathCounts& other) {
        total += other.total, finite += other.finite, at_infinity += other.at_infinity, singular += other.singular;
        failed += other.failed, cancelled += other.cancelled, tracked += other.tracked, retracked += other.retracked;
        crossed += other.crossed, in_double += other.in_double, more_digits += other.more_digits, steps += other.steps;
    }
    /// The sum that must hold.
    bool accounted_for() const { return finite + at_infinity + singular + failed + cancelled == total; }
};

}  // namespace equilibria
