#include <equilibria/dynamics/detail/adaptive_integrator_definitions.hpp>
#include <equilibria/dynamics/detail/dense_output_integrator_definitions.hpp>
#include <equilibria/dynamics/detail/motion_formulation_definitions.hpp>
#include <equilibria/dynamics/detail/motion_integration_definitions.hpp>
