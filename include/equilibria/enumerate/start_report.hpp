/// \file
/// Which start an enumeration took, and why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace equilibria {

/// The start that an enumeration took.
struct StartReport {
    std::string name;  ///< total degree, reflected, polyhedral, a solved instance
    std::string why;   ///< why it was taken, in words
    /// Of the Laurent system (of affine_supports), where the choice needed it.
    std::optional<std::uint64_t> mixed_volume;
};

/// Asks `enumerate` for the start of the least predicted cost: its paths times what a path costs, of a total-degree
/// start (reflected where that suits the model) and of a polyhedral one. A set of roots that is not all regular is
/// enumerated from the total degree, whose paths lead to every curve and surface of solutions, or to its infinity.
struct LeastCost {};
/// Asks `enumerate` for a polyhedral start.
struct Polyhedral {};

}  // namespace equilibria
