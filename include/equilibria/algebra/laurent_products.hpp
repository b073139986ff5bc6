/// \file
/// Products of cosines, sines and powers as Laurent polynomials, at run time: cos(k theta) = (z^k + z^-k) / 2 and
/// sin(k theta) = (z^k - z^-k) / 2i with z = exp(i theta). Of a model as a type: laurent.hpp.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>

namespace equilibria::detail {

/// Of the product of a factor an unknown, given by their codes (see Monomial), the first `angles` of them of angles.
/// Each coefficient is real or imaginary, and a power of two: exact.
inline std::vector<PolynomialTerm<std::complex<double>>> laurent_products(std::span<const int> codes, int angles) {
    using Number = std::complex<double>;
    std::vector<PolynomialTerm<Number>> y{{1, std::vector<int>(codes.begin(), codes.end())}};
    for (std::size_t u = 0; u < static_cast<std::size_t>(angles); ++u) {
        const int code = codes[u];
        const std::size_t before = y.size();
        for (std::size_t k = 0; code != 0 && k < before; ++k) {
            y[k].exponents[u] = std::abs(code);
            y[k].coefficient *= code > 0 ? Number(0.5) : Number(0, -0.5);
            auto other = y[k];
            other.exponents[u] = -std::abs(code);
            if (code < 0) other.coefficient = -other.coefficient;
            y.push_back(std::move(other));
        }
    }
    return y;
}

}  // namespace equilibria::detail
