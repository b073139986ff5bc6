/// \file
/// What a result has to know of the model that it belongs to: of a type, or of a model whose numbers are known at run
/// time.
#pragma once

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// M: the model, or RuntimeUnknowns.
template <class M>
struct ModelProperties {
    static constexpr Sizes<M> sizes{};
    static constexpr bool has_potential = PotentialModel<M>;
    static constexpr bool reflection_symmetric = Formulation<M>::reflection_symmetric;  ///< under theta -> -theta
};
template <>
struct ModelProperties<RuntimeUnknowns> {
    RuntimeSizes sizes;
    bool has_potential = false, reflection_symmetric = false;
};

}  // namespace equilibria
