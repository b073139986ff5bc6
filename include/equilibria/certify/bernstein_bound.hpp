/// \file
/// Bernstein's bound: the mixed volume of the Newton polytopes of the Laurent system in z = exp(i theta) and the
/// coordinates, in exact arithmetic, bounds the number of isolated roots.
///
/// Every complex angle is a z other than 0. A coordinate may be 0 at a root: where the terms of the equations do not
/// rule that out, the exponent 0 is added to each equation, whose mixed volume bounds all isolated roots. Sources:
/// Bernstein, The number of roots of a system of equations, Funct. Anal. Appl. 9 (1975); Li, Wang, The BKK root count
/// in C^n, Math. Comp. 65 (1996).
///
/// The theorem is about exact numbers, and so is the computation; against a fault of the program it is done twice, the
/// equations taken in another order and their tables lifted otherwise, and a bound that the two do not share is none.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria {

/// The exponents of each equation in z_1 .. z_n and the coordinates, those whose coefficients cancel exactly left out,
/// and with 0 added as above. Nothing where an equation vanishes identically.
std::optional<Supports> bernstein_supports(const ExactTerms& system);

/// The mixed volume, or nothing: where an equation vanishes identically, where the volume is 0 (then there may be
/// curves of roots; where isolated roots are as many as a bound that is not 0 there are none), where it does not fit
/// into 64 bits, or where two computations disagree.
std::optional<std::uint64_t> bernstein_bound(const ExactTerms& system);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/bernstein_bound_definitions.hpp>
#endif
