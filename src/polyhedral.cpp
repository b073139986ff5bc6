#include <equilibria/polyhedral/detail/affine_supports_definitions.hpp>
#include <equilibria/polyhedral/detail/mixed_cells_definitions.hpp>
#include <equilibria/polyhedral/detail/supports_definitions.hpp>
