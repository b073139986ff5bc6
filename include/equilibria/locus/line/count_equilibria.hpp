/// \file
/// The equilibria that searches for events and loci count at run time.
#pragma once

#include <algorithm>
#include <optional>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/locus/line/searched_model.hpp>

namespace equilibria {

/// How many equilibria a model at run time has at p. With coordinates, where paths of a total-degree start diverge or
/// fail, a polyhedral start is tried as well, and the enumeration with more regular roots counts.
template <RuntimeModel T>
EquilibriaCount count_equilibria(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {}) {
    const auto set = enumerate(model, p, run);
    return detail::fuller_count(set, [&]() -> std::optional<RootSet<RuntimeUnknowns>> {
        if (std::ranges::count(exact_terms(model, p).degrees(), 0) > 0) return {};
        return enumerate_from<Polyhedral>(model, p, run);
    });
}

}  // namespace equilibria
