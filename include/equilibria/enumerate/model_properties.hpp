/// \file
/// What a result has to know of the model that it belongs to: of a type, or of a model whose numbers are known at run
/// time.
#pragma once

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// What an enumeration tells of its model. M: the model, or RuntimeUnknowns.
template <class M>
struct ModelProperties {
    static constexpr Sizes<M> sizes{};                        ///< numbers of angles and of coordinates
    static constexpr bool has_potential = PotentialModel<M>;  ///< the equations are its gradient
    static constexpr bool reflection_symmetric = Formulation<M>::reflection_symmetric;  ///< under theta -> -theta
};
/// Of a model whose numbers are known at run time.
template <>
struct ModelProperties<RuntimeUnknowns> {
    RuntimeSizes sizes;                 ///< numbers of angles and of coordinates
    bool has_potential = false;         ///< the equations are its gradient
    bool reflection_symmetric = false;  ///< under theta -> -theta
};

}  // namespace equilibria
