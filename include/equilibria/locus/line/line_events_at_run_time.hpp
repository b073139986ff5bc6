/// \file
/// `find_events` for models whose numbers of unknowns are known at run time alone.
#pragma once

#include <equilibria/locus/line/count_equilibria.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/model/runtime_model_functions.hpp>
#include <equilibria/system/runtime_model_polynomials.hpp>

namespace equilibria {

/// All events with the parameter number `active` in `range`, the others those of p. As of a Model; throws
/// InvalidArgument also where there is no such parameter.
template <RuntimeModel T>
LineEvents<RuntimeUnknowns> find_events(const T& model, const RuntimeArray<double>& p, int active,
                                        const Interval& range, const RunOptions& run = {}) {
    require(active >= 0 && active < model.parameters(), "active", active, "must be the number of a parameter");
    const RuntimeModelFunctions<T> functions(model);
    const RuntimeModelPolynomials<T> polynomials(model);
    const SearchedModel searched{&functions, &polynomials, [&](const RuntimeArray<double>& at, const RunOptions& how) {
                                     return count_equilibria(model, at, how);
                                 }};
    return find_events(searched, p, active, range, run);
}

}  // namespace equilibria
