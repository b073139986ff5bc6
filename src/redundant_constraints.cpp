#include <equilibria/continuation/factorization/detail/redundant_constraints_definitions.hpp>
