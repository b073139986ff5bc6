// Structures loaded, or driven, from their unloaded state on.
#pragma once

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/structure.hpp>

#include "support/catch.hpp"

namespace states {

using namespace equilibria;
using namespace equilibria::fem;

/// The branch from the unloaded state, with growing parameter, until this leaves its range.
template <class S>
Branch<S> loaded(const S& structure, double low, double high,
                 const BranchOptions& options = {.first_step = 0.02, .largest_step = 0.1}) {
    const auto branch =
        continue_branch(structure, structure.initial(), 0, 1, {.branch = options, .range = {low, high}});
    CHECK(branch.end == BranchEnd::window);
    CHECK(branch.unexplained.empty());
    return branch;
}

}  // namespace states
