// A model that is not the chain, as a user writes it. It includes nothing of the library, so that bench/compile can
// weigh it alone.
#pragma once

#include <cmath>

namespace models {

/// Two rods of length and weight 1 on each other, upright, each tip held by a horizontal spring relaxed at x = offset.
struct SpringLoadedDoublePendulum {
    static constexpr int n_angles = 2;
    enum Parameter { stiffness, offset, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto x1 = sin(theta[0]), x2 = x1 + sin(theta[1]);
        const auto stretch1 = x1 - p[offset], stretch2 = x2 - p[offset];
        return 2 * cos(theta[0]) + cos(theta[1]) + 0.5 * p[stiffness] * (stretch1 * stretch1 + stretch2 * stretch2);
    }
};

}  // namespace models
