/// \file
/// What text of a polynomial system may ask for.
#pragma once

#include <cstddef>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// Sums in parentheses are multiplied out.
struct PolynomialLimits {
    std::size_t bytes = std::size_t{64} << 20;  ///< of the text
    int equations = 1'000;                      ///< of the system
    int variables = 1'000;                      ///< of the system
    int exponent = 10'000;                      ///< absolute value, of one variable in one term
    int nesting = 100;                          ///< parentheses in parentheses
    int products = 2'000'000;                   ///< of two terms, in the whole text: what its expansion takes

    /// Throws InvalidArgument for a limit below 1.
    void validate() const {
        const auto positive = [](const char* name, int value) {
            require(value >= 1, name, value, "must be at least 1");
        };
        require(bytes >= 1, "bytes", bytes, "must be at least 1");
        positive("equations", equations);
        positive("variables", variables);
        positive("exponent", exponent);
        positive("nesting", nesting);
        positive("products", products);
    }
};

}  // namespace equilibria
