#include <equilibria/paths/detail/choose_start_definitions.hpp>
#include <equilibria/paths/detail/generic_instance_definitions.hpp>
#include <equilibria/paths/detail/predicted_work_definitions.hpp>
#include <equilibria/start/detail/binomial_system_definitions.hpp>
#include <equilibria/start/detail/polyhedral_start_definitions.hpp>
