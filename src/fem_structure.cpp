#include <optional>

#include <equilibria/fem/detail/loose_motion_definitions.hpp>
#include <equilibria/fem/detail/structure_definitions.hpp>
#include <equilibria/fem/detail/structure_symmetries_definitions.hpp>
#include <equilibria/fem/detail/symmetry_definitions.hpp>

namespace equilibria::fem {

template class BasicStructure<true>;
template class BasicStructure<false>;
template std::optional<LooseMotion> loose_motion(const Structure&, const StructureState&, double);
template std::optional<LooseMotion> loose_motion(const NonconservativeStructure&, const StructureState&, double);

}  // namespace equilibria::fem
