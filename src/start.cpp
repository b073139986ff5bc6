#include <equilibria/start/detail/linear_product_definitions.hpp>
#include <equilibria/start/detail/solved_instance_definitions.hpp>
