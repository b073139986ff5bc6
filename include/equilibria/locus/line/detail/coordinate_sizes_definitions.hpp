/// \file
/// See locus/line/coordinate_sizes.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <equilibria/locus/line/coordinate_sizes.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<double> coordinate_sizes(const SearchedModel& model, const RuntimeArray<double>& p,
                                                       std::span<const RuntimeArray<double>> equilibria) {
    const RuntimeSizes sizes = model.sizes();
    const auto equations = model.polynomials->equations(p, {}, {}, sizes.coordinates);
    std::vector<int> exponents(static_cast<std::size_t>(sizes.unknowns));
    // an equation that has lost its unknowns at p tells no size
    if (std::ranges::none_of(equations, [](const auto& f) { return f.pruned().is_constant(); }))
        exponents = unit_scaling(sparse_system(equations, sizes)).unknown;
    std::vector<double> y;
    for (int u = sizes.angles; u < sizes.unknowns; ++u) {
        double largest = 0;
        for (const auto& q : equilibria) largest = std::max(largest, std::abs(q[u]));
        const double unit = std::ldexp(1.0, exponents[static_cast<std::size_t>(u)]);
        y.push_back(largest > 1e-6 * unit ? largest : unit);
    }
    return y;
}

EQUILIBRIA_INLINE std::vector<double> coordinate_sizes(const SearchedModel& model,
                                                       std::span<const RuntimeArray<double>> points,
                                                       const RunOptions& run) {
    std::vector<RuntimeArray<double>> equilibria;
    for (const auto& p : points) std::ranges::move(model.count(p, run).at, std::back_inserter(equilibria));
    return coordinate_sizes(model, points.front(), equilibria);
}

}  // namespace equilibria
