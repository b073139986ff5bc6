#include <equilibria/enumerate/detail/proof_of_roots_definitions.hpp>
#include <equilibria/enumerate/detail/prove_complex_roots_definitions.hpp>
#include <equilibria/enumerate/detail/prove_definitions.hpp>
