/// \file
/// See enumerate/prove_complex_roots.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/system/path_bounds.hpp>

namespace equilibria {

EQUILIBRIA_INLINE ExactTerms exact_terms(const SparseSystem& system) {
    ExactTerms y;
    y.sizes = system.sizes();
    for (const auto& t : system.terms()) {
        const auto first = static_cast<int>(y.factors.size());
        for (int u = 0; u < y.sizes.unknowns; ++u)
            if (const int code = t.monomial.code(u); code != 0) y.factors.push_back({u, code});
        y.terms.push_back({t.equation, first, static_cast<int>(y.factors.size()), ExactBall(t.coefficient)});
    }
    return y;
}

EQUILIBRIA_INLINE std::vector<ProvedBound> bezout_bounds(const SparseSystem& system) {
    std::vector<ProvedBound> y;
    const auto total = total_degree_bound(exact_terms(system));
    if (total) y.push_back(*total);
    const PathCount other = smallest_multihomogeneous_number(system).number;
    const auto value = static_cast<std::uint64_t>(other.value);
    if (!other.saturated && (!total || value < total->value))
        y.push_back({value, "multihomogeneous Bezout number", "Bezout's"});
    return y;
}

EQUILIBRIA_INLINE std::vector<ProvedBound> proved_bounds(const SparseSystem& system) {
    auto y = bezout_bounds(system);
    if (const auto volume = mixed_volume_bound(exact_terms(system))) y.push_back(*volume);
    return y;
}

EQUILIBRIA_INLINE ProofOfRoots prove(const SparseSystem& system, const ComplexRoots<>& found,
                                     const std::vector<ProvedBound>& bounds, const RunOptions& run,
                                     const ProveOptions& options) {
    options.validate();
    run.require_whole("a proof");
    std::optional<ProvedBound> smallest;
    for (const auto& bound : bounds)
        if (!smallest || bound.value < smallest->value) smallest = bound;
    detail::RootsToProve task{
        .equations = exact_terms(system), .roots = {}, .equilibria = {}, .bound = smallest, .smallest_bound = [&] {
            return smallest;
        }};
    for (const auto& root : found.roots) {
        const bool singular = !may_be_regular(root);
        task.roots.push_back({{root.q.begin(), root.q.end()}, root.path, singular});
        if (is_real(root)) task.equilibria.push_back({root.path, -1, singular});
    }
    return detail::prove_roots(task, run, options);
}

}  // namespace equilibria
