/// \file
/// Roots with a coordinate 0, which mixed volumes do not count: whether the supports rule them out, and supports that
/// count them.
///
/// Source: Li, Wang, The BKK root count in C^n, Math. Comp. 65 (1996).
#pragma once

#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria {

/// Adds the exponent 0 to each equation where a root with an unknown 0 cannot be ruled out; the mixed volume bounds all
/// isolated roots then. Unknowns from number `first` on may be 0. Such roots are ruled out where, whichever of them are
/// 0, an equation has a single term left; of more than 20 nothing is ruled out.
void add_origin(int first, std::vector<std::vector<Supports::Point>>& equations);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/polyhedral/detail/affine_supports_definitions.hpp>
#endif
