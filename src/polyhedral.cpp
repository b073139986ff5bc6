#include <equilibria/polyhedral/detail/mixed_cells_definitions.hpp>
#include <equilibria/polyhedral/detail/supports_definitions.hpp>
