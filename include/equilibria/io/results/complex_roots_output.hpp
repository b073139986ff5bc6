/// \file
/// The complex roots of a system as JSON: the account of the paths, how many roots there are, and each root by the
/// names of its unknowns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/paths/complex_roots.hpp>

namespace equilibria {

/// "unknowns" (of each its name: [real part, imaginary part]), "residual", "condition", "path", "multiplicity",
/// "singular", "real". names: one for each unknown.
inline Json json_of(const Root<RuntimeUnknowns>& root, std::span<const std::string> names) {
    require(names.size() == static_cast<std::size_t>(root.q.size()), "names", names.size(),
            "must be one for each unknown");
    Json unknowns = Json::object();
    int u = 0;
    for (const auto& name : names) unknowns[name] = json_of(root.q[u++]);
    return {{"unknowns", std::move(unknowns)},
            {"residual", json_of(root.residual)},
            {"condition", json_of(root.condition)},
            {"path", root.path},
            {"multiplicity", root.paths},
            {"singular", root.status == PathStatus::singular},
            {"real", is_real(root)}};
}

/// The keys of the paths, "distinct" and "real" (regular roots, and the real ones among them), "singular_roots" (where
/// singular paths end), "failures" and "roots".
inline Json json_of(const ComplexRoots<>& found, std::span<const std::string> names) {
    Json out = Json::object(), roots = Json::array(), failures = Json::array();
    std::uint64_t distinct = 0, real = 0;
    for (const auto& root : found.roots) {
        roots.push_back(json_of(root, names));
        if (root.status == PathStatus::singular) continue;
        ++distinct;
        real += is_real(root);
    }
    for (const auto& failed : found.failures)
        failures.push_back({{"path", failed.path}, {"reason", to_string(failed.reason)}});
    add_paths(out, found.paths);
    out["distinct"] = distinct;
    out["real"] = real;
    out["singular_roots"] = found.roots.size() - distinct;
    out["failures"] = std::move(failures);
    out["roots"] = std::move(roots);
    return out;
}

/// Gives each of "roots" its "certificate".
inline void add_root_certificates(Json& roots, const ProofOfRoots& proof) {
    require(roots.size() == proof.certificates.size(), "roots", roots.size(), "must be those that the proof is of");
    std::size_t k = 0;
    for (auto& root : roots) root["certificate"] = json_of(proof.certificates[k++]);
}

}  // namespace equilibria
