#include <equilibria/system/detail/sparse_system_definitions.hpp>
