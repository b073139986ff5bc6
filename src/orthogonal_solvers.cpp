#include <equilibria/core/detail/orthogonal_solvers_definitions.hpp>
