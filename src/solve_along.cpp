#include <equilibria/paths/detail/solve_along_definitions.hpp>
