#include <equilibria/enumerate/detail/prove_definitions.hpp>
