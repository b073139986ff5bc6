/// \file
/// A term of a homotopy as a Laurent monomial whose coefficient moves.
#pragma once

#include <complex>
#include <vector>

namespace equilibria {

/// The term ((1 - t) from + t to) z^exponents of one equation: z = exp(i theta) of an angle, a coordinate as it is.
struct LaurentColumn {
    int equation;                ///< from 0
    std::vector<int> exponents;  ///< one an unknown; not negative of a coordinate
    std::complex<double> from;   ///< coefficient at t = 0
    std::complex<double> to;     ///< coefficient at t = 1; 0 where the target lacks the term
};

}  // namespace equilibria
