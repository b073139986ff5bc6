/// \file
/// An enumeration whose roots were handed on, as JSON: its counts.
#pragma once

#include <equilibria/enumerate/stream.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>

namespace equilibria {

/// The keys of a RootSet's document but for what is known of all roots together or of each: "start", "multiplicities",
/// "winding_numbers", "families", "equilibria" and "roots" are not there.
template <class M>
Json json_of(const StreamedRoots<M>& set) {
    Json out{{"parameters", parameters_json<M>(set.parameters)}, {"seed", set.seed}};
    add_paths(out, set.paths);
    add_keys(
        out,
        {{"distinct", set.distinct}, {"real", set.real}, {"by_index", set.by_index}, {"degenerate", set.degenerate}});
    add_verdict(out, set);
    return out;
}

}  // namespace equilibria
