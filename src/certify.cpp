#include <equilibria/certify/detail/enclosure_definitions.hpp>
#include <equilibria/certify/detail/refine_root_definitions.hpp>
