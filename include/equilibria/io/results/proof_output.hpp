/// \file
/// What is proved of an enumeration as JSON.
#pragma once

#include <optional>

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

/// The certificate of the root that the path number `path` led to; nothing where there is none.
inline std::optional<Certificate> certificate_of(const ProofOfRoots& p, std::uint64_t path) {
    for (const auto& c : p.certificates)
        if (c.path == path) return c;
    return std::nullopt;
}

/// Gives each entry of "equilibria" its "certificate".
inline void add_certificates(Json& equilibria, const ProofOfRoots& p) {
    for (auto& e : equilibria)
        if (const auto c = certificate_of(p, e.at("path").get<std::uint64_t>())) e["certificate"] = json_of(*c);
}

}  // namespace equilibria
