/// \file
/// Which roots of an enumeration lie on families of solutions.
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria::detail {

/// A root that is worse conditioned than this is probed, even if it passed for regular.
inline constexpr double suspect_condition = 1e5;

/// The families that some of a number of roots lie on.
struct FoundFamilies {
    std::vector<Family<RuntimeUnknowns>> families;  ///< surfaces first, then by path
    std::vector<std::uint8_t> on_one;               ///< which of the roots lie on a family
    std::uint64_t regular_paths = 0;                ///< of those that had passed for regular
};
/// Each root is probed, and those on a family connected by walks on it. homotopy: to the system whose roots they are.
FoundFamilies find_families(const PolynomialHomotopy& homotopy, const std::vector<Root<RuntimeUnknowns>>& roots,
                            const Executor& executor);

/// The roots that are isolated, and the families that the others lie on.
struct RootFamilies {
    std::vector<Root<RuntimeUnknowns>> isolated;    ///< in the order of the roots
    std::vector<Family<RuntimeUnknowns>> families;  ///< as of FoundFamilies
    std::uint64_t regular_paths = 0;
};

/// Tells the roots that lie on families of solutions from those that are isolated. homotopy: as of find_families.
RootFamilies split_families(std::vector<Root<RuntimeUnknowns>> roots, const PolynomialHomotopy& homotopy,
                            const Executor& executor);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/families_definitions.hpp>
#endif
