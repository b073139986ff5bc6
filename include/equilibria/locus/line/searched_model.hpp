/// \file
/// What searches for events and for loci need of a model, whatever the model: they are compiled once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

#include <equilibria/core/sized_array.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/model_polynomials.hpp>

namespace equilibria {

/// How many equilibria an enumeration found.
struct EquilibriaCount {
    std::uint64_t real = 0;                  ///< equilibria
    std::vector<std::int64_t> by_index;      ///< those of index 0, 1, .. n
    bool clean = false;                      ///< nothing speaks against it (RootSet::clean)
    std::vector<RuntimeArray<double>> at{};  ///< each, angles (radians), then coordinates
};

/// The count of a root set.
template <class M>
EquilibriaCount count_of(const RootSet<M>& set) {
    EquilibriaCount y{set.real(), set.by_index(), set.clean(), {}};
    for (const auto& e : set.equilibria)
        if constexpr (std::is_same_v<M, RuntimeUnknowns>)
            y.at.push_back(e.q);
        else
            y.at.push_back(runtime_array(e.q));
    return y;
}

namespace detail {

/// The count of a set; where it may lack roots far out, that of `again()`, if it has more of them. again: an
/// enumeration from a polyhedral start, or nothing.
template <class M, class Again>
EquilibriaCount fuller_count(const RootSet<M>& set, const Again& again) {
    const bool doubtful = set.model.sizes.coordinates > 0 && set.start.name != "polyhedral" && set.families.empty() &&
                          set.paths.at_infinity + set.paths.failed > 0;
    if (!doubtful) return count_of(set);
    const std::optional<RootSet<M>> other = again();
    return count_of(other && other->paths.finite > set.paths.finite ? *other : set);
}

}  // namespace detail

/// A model's functions, its polynomials and its enumeration.
struct SearchedModel {
    const ModelFunctions<>* functions;    ///< with derivatives
    const ModelPolynomials* polynomials;  ///< its equations as polynomials
    std::function<EquilibriaCount(const RuntimeArray<double>& p, const RunOptions& run)> count;  ///< enumerates at p
    MoreDigits<> more_digits = nullptr;   ///< for paths to points of a plane that fail in double
    std::uint64_t systems_in_double = 4;  ///< start systems of a plane that are tried before

    const RuntimeSizes& sizes() const { return functions->sizes(); }   ///< numbers of angles and of coordinates
    int unknowns() const { return functions->unknowns(); }             ///< angles and coordinates together
    bool has_potential() const { return functions->has_potential(); }  ///< without one there is no index
    /// Equilibria come in mirror pairs, theta and -theta.
    bool reflection_symmetric() const { return polynomials->reflection_symmetric(); }
};

/// Of the model M.
template <Model M>
SearchedModel searched_model() {
    return {&functions_of<M>(), &polynomials_of<M>(), [](const RuntimeArray<double>& p, const RunOptions& run) {
                const auto at = parameters_from<M>(p);
                const auto set = enumerate<M>(at, run);
                if constexpr (n_coordinates<M> == 0)
                    return count_of(set);
                else
                    return detail::fuller_count(set, [&]() -> std::optional<RootSet<M>> {
                        if (!detail::system_of(ModelSystem<M>(at))) return {};  // an equation vanishes
                        return enumerate<M, Polyhedral>(at, run);
                    });
            }};
}

}  // namespace equilibria
