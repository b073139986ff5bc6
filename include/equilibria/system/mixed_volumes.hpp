/// \file
/// Mixed volumes of a system in both its forms: bounds of the number of isolated solutions (Bernstein, The number of
/// roots of a system of equations, Funct. Anal. Appl. 9 (1975)), beside those that degrees give (bounds.hpp).
///
/// In exp(i theta) there are half the unknowns and no circle equations, and the mixed volume is the smaller one: in
/// (cos, sin) the supports do not tell that the points lie on circles.
#pragma once

#include <cstdint>
#include <optional>

#include <equilibria/algebra/bounds.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Nothing where a number is 2^63 or more. Supports count solutions with coordinates 0 as well (affine_supports).
struct MixedVolumes {
    std::optional<std::int64_t> in_cosines_and_sines;  ///< in (cos, sin), with the circle equations
    std::optional<std::int64_t> in_exponentials;       ///< in exp(i theta)
};
/// Both for the supports of this system, whose coefficients do not count.
MixedVolumes mixed_volumes(const SparseSystem& system);

/// What degrees say of a model (`bounds`), and its mixed volumes at generic parameters.
template <Model M>
Bounds bounds_with_mixed_volumes() {
    Bounds y = bounds<M>();
    const auto volumes = mixed_volumes(sparse_system<M>(detail::generic_parameters<M>()));
    if (volumes.in_cosines_and_sines) y.mixed_volume = PathCount{*volumes.in_cosines_and_sines, false};
    if (volumes.in_exponentials) y.laurent_mixed_volume = PathCount{*volumes.in_exponentials, false};
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/mixed_volumes_definitions.hpp>
#endif
