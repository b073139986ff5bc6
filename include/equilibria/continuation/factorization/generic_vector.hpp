/// \file
/// A vector that is no solution of anything by chance.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace equilibria::detail {

/// Entries in [-1, 1] without a pattern that a structure could share; number k of such vectors.
inline Eigen::VectorXd generic_vector(Eigen::Index size, Eigen::Index k = 0) {
    Eigen::VectorXd v(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const Eigen::Index m = (i + k) % 7919;
        v(i) = std::cos(1.0 + static_cast<double>(m * m % 7919));
    }
    return v;
}

}  // namespace equilibria::detail
