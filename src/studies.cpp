#include <equilibria/studies/rotating_body_beam/detail/beam_collocation_definitions.hpp>
#include <equilibria/studies/rotating_body_beam/detail/chebyshev_integrals_definitions.hpp>
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_boundary_definitions.hpp>
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_equations_definitions.hpp>
#include <equilibria/studies/rotating_body_beam/detail/rotating_body_beam_stepper_definitions.hpp>
