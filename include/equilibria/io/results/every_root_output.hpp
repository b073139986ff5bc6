/// \file
/// All roots of a system as JSON, with what is proved of them and the verdict on their completeness.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/homotopy/path_limit.hpp>
#include <equilibria/io/results/complex_roots_output.hpp>
#include <equilibria/io/results/proof_output.hpp>

namespace equilibria {

/// The keys "complete", "completeness", "reason", "missing_at_most" (null: unknown) and "verdict".
inline void add_verdict(Json& out, const RootsVerdict& v) {
    add_keys(out, {{"complete", v.completeness == Completeness::complete},
                   {"completeness", to_string(v.completeness)},
                   {"reason", v.sentence},
                   {"missing_at_most", v.missing_at_most ? Json(*v.missing_at_most) : Json(nullptr)},
                   {"verdict", in_words(v)}});
}

/// Of each direction "direction", "paths" and "residual".
inline Json json_of(const std::vector<DivergingPaths>& at_infinity) {
    Json out = Json::array();
    for (const auto& away : at_infinity)
        out.push_back(
            {{"direction", direction_in_words(away.direction)}, {"paths", away.paths}, {"residual", away.residual}});
    return out;
}

/// The keys of complex roots, of their proof and of the verdict, with "families" (of each "dimension", "degree" (null:
/// not counted), "kind", "paths", "point", "real"), "directions_at_infinity" ("direction", "paths", "residual"),
/// "starts", "tracking_seconds" and "seconds". Of each root "multiplicity_proved", and "certificate" where it is
/// regular. Real is what is proved real; without a proof, what has no imaginary part above rounding. names: one for
/// each unknown.
inline Json json_of(const EveryRoot& s, std::span<const std::string> names) {
    Json out = json_of(s.found, names);
    const bool proved = !s.proof.certificates.empty() || s.found.roots.empty();
    std::size_t k = 0;
    std::uint64_t real = 0;
    for (auto& root : out["roots"]) {
        if (k < s.seems_real.size()) root["real"] = s.seems_real[k] != 0;
        root["multiplicity_proved"] = s.confirmed[k] != 0;
        if (proved && !root["singular"] && k < s.proof.certificates.size()) {
            root["certificate"] = json_of(s.proof.certificates[k]);
            root["real"] = s.proof.certificates[k].reality == Reality::real;
        }
        real += !root["singular"] && root["real"];
        ++k;
    }
    out["real"] = real;
    if (proved) {
        out["real"] = s.proof.real;
        add_proof(out, s.proof);
    }
    out["families"] = Json::array();
    for (const auto& family : s.families) {
        Json point = Json::object();
        int u = 0;
        for (const auto& name : names) point[name] = json_of(family.points.front().q[u++]);
        out["families"].push_back(
            {{"dimension", family.dimension},
             {"degree", family.degree > 0 ? Json(family.degree) : Json(nullptr)},
             {"kind", (family.real() ? "a real " : "a ") + family_kind(family.dimension) + " of solutions"},
             {"paths", family.paths()},
             {"real", family.real()},
             {"point", std::move(point)}});
    }
    out["directions_at_infinity"] = json_of(s.at_infinity);
    out["starts"] = s.starts;
    add_verdict(out, s.verdict);
    out["tracking_seconds"] = s.tracking_seconds;
    out["seconds"] = s.seconds;
    return out;
}

}  // namespace equilibria
