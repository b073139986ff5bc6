#include <equilibria/start/detail/linear_product_definitions.hpp>
#include <equilibria/start/detail/solved_instance_definitions.hpp>
#include <equilibria/start/detail/total_degree_start_definitions.hpp>
#include <equilibria/start/detail/total_degree_system_definitions.hpp>
