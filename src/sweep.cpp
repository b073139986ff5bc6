#include <equilibria/enumerate/detail/parameter_points_definitions.hpp>
#include <equilibria/enumerate/detail/sweep_definitions.hpp>
