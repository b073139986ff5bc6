// Sums of the accounts of several searches.
#include <equilibria/paths/solution_counts.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Each number another one; the ends are the total.
PathCounts counts_of(std::uint64_t unit) {
    PathCounts n;
    n.finite = unit, n.at_infinity = 2 * unit, n.singular = 3 * unit, n.failed = 4 * unit, n.cancelled = 5 * unit;
    n.total = 15 * unit, n.tracked = 6 * unit, n.retracked = 7 * unit, n.crossed = 8 * unit, n.in_double = 9 * unit;
    n.more_digits = 10 * unit, n.steps = 11 * unit;
    return n;
}

void check_counts(const PathCounts& n, std::uint64_t unit) {
    CHECK(n.accounted_for());
    CHECK(n.total == 15 * unit);
    CHECK(n.finite == unit);
    CHECK(n.at_infinity == 2 * unit);
    CHECK(n.singular == 3 * unit);
    CHECK(n.failed == 4 * unit);
    CHECK(n.cancelled == 5 * unit);
    CHECK(n.tracked == 6 * unit);
    CHECK(n.retracked == 7 * unit);
    CHECK(n.crossed == 8 * unit);
    CHECK(n.in_double == 9 * unit);
    CHECK(n.more_digits == 10 * unit);
    CHECK(n.steps == 11 * unit);
}

}  // namespace

TEST_CASE("counts of searches that were cancelled add up, what their paths took as well") {
    SolutionCounts first;
    first.add(counts_of(1));
    first.searches = 1, first.attempts = 2, first.solutions = 3;
    check_counts(first.paths, 1);

    SolutionCounts second;
    second.add(counts_of(100));
    second.searches = 10, second.attempts = 20, second.solutions = 30;
    first.add(second);
    check_counts(first.paths, 101);
    CHECK(first.searches == 11);
    CHECK(first.attempts == 22);
    CHECK(first.solutions == 33);
}
