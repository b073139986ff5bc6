/// \file
/// What is proved of an enumeration as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include <equilibria/certify/certificate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/json.hpp>

namespace equilibria {

/// "exists", "distinct", "reality" (real, non-real, undecided), "index_proved", "index", "radius" (radians), "digits".
inline Json json_of(const Certificate& c) {
    return {{"exists", c.exists},         {"distinct", c.distinct},
            {"reality", name(c.reality)}, {"index_proved", c.index_proved},
            {"index", c.index},           {"radius", json_of(c.radius)},
            {"digits", c.digits}};
}

/// The value of the bound, or null.
inline Json bound_json(const std::optional<ProvedBound>& bound) { return bound ? Json(bound->value) : Json(nullptr); }

/// An object of its own, beside the counts that the enumeration itself gives.
inline Json json_of(const ProofOfRoots& p) {
    return {{"complete", p.complete},
            {"reason", p.reason},
            {"bound", bound_json(p.bound)},
            {"distinct", p.distinct},
            {"real", p.real},
            {"non_real", p.non_real},
            {"undecided", p.undecided},
            {"duplicates", p.duplicates},
            {"index", p.index},
            {"contradictions", p.contradictions},
            {"more_digits", p.more_digits},
            {"by_index", p.by_index},
            {"seconds", p.seconds}};
}

/// Keys of a document that holds the enumeration's as well: "complete", "reason", "proved_bound", "proved_distinct",
/// "proved_real", "proved_non_real", "undecided", "duplicates", "proved_index", "contradictions",
/// "proved_with_more_digits", "proved_by_index", "proving_seconds".
inline void add_proof(Json& out, const ProofOfRoots& p) {
    add_keys(out, {{"complete", p.complete},
                   {"reason", p.reason},
                   {"proved_bound", bound_json(p.bound)},
                   {"proved_distinct", p.distinct},
                   {"proved_real", p.real},
                   {"proved_non_real", p.non_real},
                   {"undecided", p.undecided},
                   {"duplicates", p.duplicates},
                   {"proved_index", p.index},
                   {"contradictions", p.contradictions},
                   {"proved_with_more_digits", p.more_digits},
                   {"proved_by_index", p.by_index},
                   {"proving_seconds", p.seconds}});
}

/// Gives each entry of "equilibria" its "certificate": that of the root to which the same path led.
inline void add_certificates(Json& equilibria, const ProofOfRoots& p) {
    std::unordered_map<std::uint64_t, const Certificate*> of_path(2 * p.certificates.size());
    for (const auto& c : p.certificates) of_path.emplace(c.path, &c);
    for (auto& e : equilibria)
        if (const auto at = of_path.find(e.at("path").get<std::uint64_t>()); at != of_path.end())
            e["certificate"] = json_of(*at->second);
}

}  // namespace equilibria
