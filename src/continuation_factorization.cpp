#include <equilibria/continuation/factorization/detail/bordered_definitions.hpp>
#include <equilibria/continuation/factorization/detail/redundant_constraints_definitions.hpp>
#include <equilibria/continuation/factorization/detail/sparse_ldlt_definitions.hpp>
