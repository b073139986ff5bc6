#include <equilibria/continuation/detail/bordered_definitions.hpp>
#include <equilibria/continuation/detail/redundant_constraints_definitions.hpp>
#include <equilibria/continuation/detail/sparse_ldlt_definitions.hpp>
