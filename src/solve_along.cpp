#include <equilibria/paths/detail/monodromy_definitions.hpp>
#include <equilibria/paths/detail/solve_along_definitions.hpp>
