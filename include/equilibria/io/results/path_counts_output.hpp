/// \file
/// The account of the paths as JSON: nested under a key of its own, or as keys of the document.
#pragma once

#include <equilibria/io/results/json.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/solution_counts.hpp>

namespace equilibria {

/// All but the sum: finite + at_infinity + singular + failed + cancelled is the number of paths.
inline Json json_of_ends(const PathCounts& n) {
    return {
        {"finite", n.finite},       {"at_infinity", n.at_infinity}, {"singular", n.singular},   {"failed", n.failed},
        {"cancelled", n.cancelled}, {"tracked", n.tracked},         {"retracked", n.retracked}, {"crossed", n.crossed},
        {"in_double", n.in_double}, {"more_digits", n.more_digits}, {"steps", n.steps}};
}

/// An object of its own: the sum is "total".
inline Json json_of(const PathCounts& n) {
    Json out{{"total", n.total}};
    add_keys(out, json_of_ends(n));
    return out;
}

/// Keys of the document: the sum is "paths".
inline void add_paths(Json& out, const PathCounts& n) {
    out["paths"] = n.total;
    add_keys(out, json_of_ends(n));
}

/// The evidence of a search for all complex solutions: "paths", "searches", "attempts", "solutions".
inline Json json_of(const SolutionCounts& n) {
    return {
        {"paths", json_of(n.paths)}, {"searches", n.searches}, {"attempts", n.attempts}, {"solutions", n.solutions}};
}

}  // namespace equilibria
