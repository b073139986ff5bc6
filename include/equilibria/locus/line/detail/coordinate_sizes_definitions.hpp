/// \file
/// See locus/line/coordinate_sizes.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <equilibria/locus/line/coordinate_sizes.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<double> coordinate_sizes(const SearchedModel& model, const RuntimeArray<double>& p,
                                                       std::span<const RuntimeArray<double>> equilibria) {
    const RuntimeSizes sizes = model.sizes();
    const auto units = unit_scaling(sparse_system(model.polynomials->equations(p, {}, {}, sizes.coordinates), sizes));
    std::vector<double> y;
    for (int u = sizes.angles; u < sizes.unknowns; ++u) {
        double largest = 0;
        for (const auto& q : equilibria) largest = std::max(largest, std::abs(q[u]));
        const double unit = std::ldexp(1.0, units.unknown[static_cast<std::size_t>(u)]);
        y.push_back(largest > 1e-6 * unit ? largest : unit);
    }
    return y;
}

}  // namespace equilibria
