/// \file
/// An enumeration whose roots were handed on, as JSON: its counts.
#pragma once

#include <utility>

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
    Json failures = Json::array();
    for (const auto& f : set.failures) failures.push_back({{"path", f.path}, {"reason", to_string(f.reason)}});
    add_keys(out, {{"distinct", set.distinct},
                   {"real", set.real},
                   {"by_index", set.by_index},
                   {"degenerate", set.degenerate},
                   {"clean", set.clean()},
                   {"alarms", set.alarms.sentences()},
                   {"morse_applies", set.morse_applies()},
                   {"morse", set.morse()},
                   {"tracking_seconds", set.tracking_seconds},
                   {"seconds", set.seconds},
                   {"failures", std::move(failures)}});
    return out;
}

}  // namespace equilibria
