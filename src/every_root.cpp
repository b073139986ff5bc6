#include <equilibria/enumerate/detail/every_equilibrium_definitions.hpp>
#include <equilibria/enumerate/detail/every_root_definitions.hpp>
#include <equilibria/enumerate/detail/named_families_definitions.hpp>
#include <equilibria/homotopy/detail/local_multiplicity_definitions.hpp>
#include <equilibria/homotopy/detail/nearby_solution_definitions.hpp>
#include <equilibria/homotopy/detail/path_limit_definitions.hpp>
