/// \file
/// Upper bounds of the number of isolated complex roots that hold as theorems, for the equations at given parameters
/// in exact arithmetic.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <equilibria/algebra/bounds.hpp>
#include <equilibria/certify/bernstein_bound.hpp>
#include <equilibria/certify/exact_system.hpp>

namespace equilibria {

/// A bound of the number of isolated complex roots, and which theorem it is.
struct ProvedBound {
    std::uint64_t value;  ///< the bound
    std::string name;     ///< of the theorem's number
    std::string theorem;  ///< that it is a bound
    /// Solutions on curves and surfaces count too: there are none where as many isolated roots are known.
    bool counts_curves = false;

    /// What as many proved roots mean, in words.
    std::string no_other() const {
        return "by " + theorem + " theorem there is no other" + (counts_curves ? "" : " that is isolated");
    }
};

/// The total degree of the equations in (cos, sin) with the circle equations: by Bezout's theorem the number of roots
/// in affine space, each counted with its multiplicity and each component of positive dimension with its degree, is at
/// most that. Nothing where an equation vanishes identically, or the number does not fit.
inline std::optional<ProvedBound> total_degree_bound(const ExactTerms& system) {
    PathCount bound{1, false};
    const auto degrees = system.degrees();
    for (int i = 0; i < system.sizes.unknowns; ++i) {
        const int degree = degrees[static_cast<std::size_t>(i)];
        if (degree == 0) return {};
        bound = bound * PathCount{static_cast<std::int64_t>(degree) * (i < system.sizes.angles ? 2 : 1), false};
    }
    if (bound.saturated) return {};
    return ProvedBound{static_cast<std::uint64_t>(bound.value), "total degree", "Bezout's", true};
}

/// Of a model's system.
template <Model M>
std::optional<ProvedBound> total_degree_bound(const ExactSystem<M>& system) {
    return total_degree_bound(ExactTerms(system));
}

/// Bernstein's bound, by its name. Nothing as bernstein_bound says.
inline std::optional<ProvedBound> mixed_volume_bound(const ExactTerms& system) {
    const auto value = bernstein_bound(system);
    if (!value) return {};
    return ProvedBound{*value, system.sizes.angles > 0 ? "Laurent mixed volume" : "mixed volume", "Bernstein's"};
}

/// The smallest bound that the library knows: the total degree, a multihomogeneous Bezout number, or the mixed volume.
template <Model M>
[[gnu::cold]] std::optional<ProvedBound> smallest_proved_bound(const ExactSystem<M>& system) {
    auto bound = total_degree_bound<M>(system);
    if (!bound) return bound;
    if (system.within_support()) {
        const auto other = smallest_multihomogeneous_number<M>().number;
        const auto value = static_cast<std::uint64_t>(other.value);
        if (!other.saturated && value < bound->value) bound = {value, "multihomogeneous Bezout number", "Bezout's"};
    }
    if (const auto other = mixed_volume_bound(system); other && other->value < bound->value) bound = other;
    return bound;
}

}  // namespace equilibria
