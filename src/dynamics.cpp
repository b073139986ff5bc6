#include <equilibria/dynamics/detail/adaptive_integrator_definitions.hpp>
