/// \file
/// See system/mixed_volumes.hpp.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/polyhedral/affine_supports.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/system/laurent_terms.hpp>
#include <equilibria/system/mixed_volumes.hpp>

namespace equilibria {

namespace detail {
EQUILIBRIA_INLINE std::optional<std::int64_t> counted_mixed_volume(const Supports& supports) {
    try {
        const std::uint64_t value = mixed_volume(supports).value;
        if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return {};
        return static_cast<std::int64_t>(value);
    } catch (const InvalidArgument&) {
        return {};  // 2^64 or more
    }
}
}  // namespace detail

EQUILIBRIA_INLINE MixedVolumes mixed_volumes(const SparseSystem& system) {
    const auto polynomials = polynomial_system(system);
    std::vector<std::vector<Supports::Point>> exponents;
    for (const auto& equation : polynomials.equations) {
        exponents.emplace_back();
        for (const auto& term : equation) exponents.back().push_back(term.exponents);
    }
    const auto unknowns = static_cast<int>(polynomials.variables.size());
    add_origin(0, exponents);
    return {detail::counted_mixed_volume(Supports(unknowns, std::move(exponents))),
            detail::counted_mixed_volume(affine_supports(system))};
}

}  // namespace equilibria
