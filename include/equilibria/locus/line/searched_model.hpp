/// \file
/// What searches for events and for loci need of a model, whatever the model: they are compiled once.
#pragma once

#include <cstdint>
#include <functional>
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
                return count_of(enumerate<M>(parameters_from<M>(p), run));
            }};
}

}  // namespace equilibria
