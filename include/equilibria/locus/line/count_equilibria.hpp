/// \file
/// The equilibria that searches for events and loci count at run time.
#pragma once

#include <optional>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/system/runtime_formulation.hpp>

namespace equilibria {

/// How many equilibria a model at run time has at p. With coordinates, where paths of a total-degree start diverge or
/// fail, a polyhedral start is tried as well, and the enumeration with more regular roots counts.
template <RuntimeModel T>
EquilibriaCount count_equilibria(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {}) {
    const auto set = enumerate(model, p, run);
    return detail::fuller_count(set, [&]() -> std::optional<RootSet<RuntimeUnknowns>> {
        const RuntimeFormulation formulation(model);
        if (!detail::system_of_terms(sizes_of(model), formulation.terms(model, p))) return {};  // an equation vanishes
        return enumerate_from<Polyhedral>(model, p, run);
    });
}

}  // namespace equilibria
